// SPDX-License-Identifier: Apache-2.0
// The tests' one door to JSON. Its templates are compiled once, in json.cpp: else every file that reads some
// compiles a reader of its own.
#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace twinray::test {

using JsonText = nlohmann::detail::iterator_input_adapter<std::string::const_iterator>;

}  // namespace twinray::test

extern template class nlohmann::basic_json<>;
extern template class nlohmann::detail::parser<nlohmann::json, twinray::test::JsonText>;
extern template class nlohmann::detail::serializer<nlohmann::json>;
