// SPDX-License-Identifier: Apache-2.0
#include "io/obj/lines.h"

#include "tests/support/catch.h"

namespace twinray::test {

TEST_CASE("lines are objects of an OBJ file, whose vertices are numbered through from 1") {
  const LineObject objects[] = {{"path", {{{0, 1, 2}, {0.5f, -1, 0.1f}, {1e-7f, 3, 4}}}},
                                {"normals", {{{1, 1, 1}, {2, 2, 2}}, {{3, 3, 3}, {4, 4, 4}}}}};
  CHECK(obj_text(objects) ==
        "o path\n"
        "v 0 1 2\n"
        "v 0.5 -1 0.1\n"
        "v 1e-07 3 4\n"
        "l 1 2 3\n"
        "o normals\n"
        "v 1 1 1\n"
        "v 2 2 2\n"
        "l 4 5\n"
        "v 3 3 3\n"
        "v 4 4 4\n"
        "l 6 7\n");
  CHECK(obj_text({}).empty());
}

}  // namespace twinray::test
