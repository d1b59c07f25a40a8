// SPDX-License-Identifier: Apache-2.0
// Options that several subcommands have, and where a scene is seen from.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "cli/options/limits.h"
#include "cli/options/options.h"
#include "core/film.h"
#include "core/scene.h"
#include "io/scene_file.h"

namespace twinray {

/// Where the picture is seen from.
enum class View {
  file,   ///< The scene file's camera, or that of a camera settings file.
  whole,  ///< The same direction and field of view, from where the whole scene is seen.
};

/// "file", "whole".
std::string view_name(View view);

/// The scene's camera, moved as the view says for a frame of this size.
Camera camera_of(const Scene& scene, View view, int width, int height);

inline constexpr Range<std::uint32_t> sample_counts{1, Film::max_samples};
inline constexpr Range<std::uint32_t> light_sample_counts{1, 65536};
inline constexpr Range<double> time_limits{1e-3, 1e9};  // Seconds.
inline constexpr Range<int> thread_counts{1, 1024};

/// The help gives width and height as they are.
void add_resolution(OptionGroup& group, int& width, int& height, const std::string& description);
/// Without the option there is none: the scene file's, or another, as the description says.
void add_resolution(OptionGroup& group, std::optional<RenderDefaults::Resolution>& resolution,
                    const std::string& description);
void add_view(OptionGroup& group, View& view);
void add_threads(OptionGroup& group, int& threads);
/// The engines that --accel may name: auto, which leaves it to the scene, and those of this build.
Choices<std::string> engine_choices();
/// --instances: what becomes of shapes that a scene file shows more than once.
void add_instances(OptionGroup& group, LoadOptions& load);
/// That option for the end of a command line, behind a space; empty for the default.
std::string instances_words(InstanceUse use);

/// --sandbox[=PLACE:...]: what is not trusted reaches nothing else. The word stays empty where it is not
/// given.
void add_sandbox(OptionGroup& group, const std::string& description, std::string& word);
/// The places of that word; none where it was not given.
std::optional<std::vector<std::string>> sandbox_places(const std::string& word);
/// --memory, and --time-limit with this description.
void add_limits(OptionGroup& group, const std::string& time_description, ProcessLimits& limits);

/// Loads the scene and prints the warnings of its file, in quiet runs too. Throws Error.
LoadedScene load_with_warnings(const std::string& path, const LoadOptions& options = {});

}  // namespace twinray
