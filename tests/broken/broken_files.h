// SPDX-License-Identifier: Apache-2.0
// COLLADA files that are broken, each in a way of its own, made from a whole one: the same on every machine.
#pragma once
#include <string>
#include <vector>

namespace twinray::test {

struct BrokenFile {
  std::string name;  ///< What is broken: "number 1,5 in xfov".
  std::string text;
  bool must_speak = true;  ///< Reading it gives an error or a warning; others may happen to be whole.
  std::string said;        ///< What stands in that error or warning; empty: nothing that is tested.
};

/// All of them, of every kind: cut off, bits flipped, nested, with entities, with wrong numbers, indices,
/// counts, references, transforms and cameras, and with parts left out.
std::vector<BrokenFile> broken_files();

/// The whole file that they were made from: it is read without a warning.
std::string whole_file();

}  // namespace twinray::test
