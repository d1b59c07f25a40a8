// SPDX-License-Identifier: Apache-2.0
// Where the bytes of an output go: links followed, devices and pipes told from files.
#pragma once
#include <string>
#include <vector>

namespace twinray {

/// What the name of an output stands for.
struct Destination {
  enum class Kind {
    file,        ///< A regular file, or nothing yet: written anew as a whole.
    special,     ///< A device, a FIFO or a socket: written into.
    descriptor,  ///< A descriptor that is open in this process, such as standard output: written into.
  };
  Kind kind = Kind::file;
  std::string name;     ///< As it was given, for messages.
  std::string path;     ///< Of a file or special file, with every link followed.
  int descriptor = -1;  ///< Of a descriptor.
};

/// "-" is standard output, and so are /dev/stdout and its like. Throws Error for a folder, a folder that is
/// not there, a link that leads back to itself, and a name that is too long.
Destination destination_of(const std::string& name);

/// Whether it is standard output.
bool is_standard_output(const std::string& name);

/// Words for where it is: two destinations that have one in common are the same place.
std::vector<std::string> keys_of(const Destination& destination);

/// Whether what is written to one would overwrite the other, or be mixed with it: the same file under two
/// names, the same pipe. A device such as /dev/null takes any number of outputs.
bool is_same_place(const Destination& a, const Destination& b);

}  // namespace twinray
