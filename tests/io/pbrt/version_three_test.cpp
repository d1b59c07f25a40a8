// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/version_three.h"

#include "tests/support/catch.h"
#include "tests/support/pbrt_text.h"
#include "tests/support/text.h"

namespace twinray {

TEST_CASE("words of pbrt-v3 get a hint how its files become those of pbrt-v4") {
  const std::string hint = "; the file is pbrt-v3's, which `pbrt --upgrade` of pbrt-v4 rewrites";
  for (const char* const text : {"Material \"matte\"", "Material \"uber\" \"rgb Kd\" [1 1 1]",
                                 "Texture \"t\" \"color\" \"constant\"", "WorldEnd"}) {
    CAPTURE(text);
    CHECK(test::contains(test::pbrt_error(text), hint));
  }
  CHECK(version_three_hint("image") == hint);
  CHECK(version_three_hint("difuse").empty());
  CHECK_FALSE(test::contains(test::pbrt_error("Material \"difuse\""), "pbrt-v3"));
}

}  // namespace twinray
