// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

namespace twinray {

/// To be called before the work: throws Error unless all these outputs could be written and none is one of
/// the files that are `read`, and leaves standard output to them alone where one of them is standard output.
/// Empty names are none. What a command reads to its end before it writes may be written over.
void prepare_outputs(const std::vector<std::string>& names, const std::vector<std::string>& read);

/// Throws Error where one of the files that are read would be written over.
void check_not_read(const std::vector<std::string>& written, const std::vector<std::string>& read);

/// Those of the names that are not empty: of the outputs that are asked for.
std::vector<std::string> given_names(std::vector<std::string> names);

/// The name of what stands beside an output: "a/b.exr" with "_rate.png" is "a/b_rate.png".
std::string name_beside(const std::string& name, const std::string& ending);

/// The name of what there is of an output after an interruption: "a/b.exr" -> "a/b_partial.exr"; one that
/// would become too long loses its end. Empty for the empty name.
std::string partial_name(const std::string& name);

}  // namespace twinray
