// SPDX-License-Identifier: Apache-2.0
#include "cli/sandbox/render_sandbox.h"

#include <filesystem>

#include "io/destination.h"
#include "io/film/film_file.h"
#include "io/generated/generated.h"

namespace twinray {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> places_of_the_scene(const RenderArguments& arguments) {
  std::vector<std::string> places = *arguments.sandbox;
  check_places(places);
  if (!generated::is_generated(arguments.scene)) {
    places.push_back(folder_of(arguments.scene));
    places.push_back(arguments.scene);  // It may be a link to elsewhere.
  }
  for (const std::string& file : {arguments.environment, arguments.camera_file})
    if (!file.empty()) places.push_back(file);
  for (const std::string& film : {arguments.resumed, arguments.checkpoint})
    if (!film.empty()) places.insert(places.end(), {film, earlier_film_name(film)});
  return places;
}

}  // namespace

SandboxNeeds needs_of_render(const RenderArguments& arguments, const std::vector<std::string>& outputs) {
  SandboxNeeds needs;
  needs.strict = arguments.load.strict;
  if (arguments.viewer || arguments.server) needs.network = Network::open;
  OpenPlaces& places = needs.places;
  places.read = places_of_the_scene(arguments);
  for (const std::string& output : outputs) {
    const Destination to = destination_of(output);
    if (to.kind == Destination::Kind::special) places.write.push_back(to.path);
    if (to.kind == Destination::Kind::file) places.write.push_back(folder_of(to.path));
  }
  if (arguments.texture_bytes) {
    std::error_code error;
    places.scratch.push_back(fs::temp_directory_path(error).string());
  }
  return needs;
}

}  // namespace twinray
