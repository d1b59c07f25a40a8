// SPDX-License-Identifier: Apache-2.0
#include "tests/support/json.h"

template class nlohmann::basic_json<>;
template class nlohmann::detail::parser<nlohmann::json, twinray::test::JsonText>;
template class nlohmann::detail::serializer<nlohmann::json>;
