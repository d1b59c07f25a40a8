// SPDX-License-Identifier: Apache-2.0
// What a study consists of: parts, their sections, and the pictures of each. A plan is made before anything
// is rendered, and depends on the scenes that are there and on the scale alone.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/options.h"
#include "cli/study/scale.h"
#include "cli/study/scene_folder.h"

namespace twinray::study {

/// A picture that `twinray render` makes. Pictures of one name are the same.
struct Picture {
  std::string name;            ///< Of its files, without an ending.
  std::string scene;           ///< The path of its file.
  std::size_t primitives = 0;  ///< Of the scene.
  std::uint32_t samples = 1;   ///< Per pixel.
  Words options;               ///< All others, but those that all pictures of a study share.
  Words adaptive;              ///< Those of adaptive sampling; empty: none.
};

/// A picture where it stands in the page.
struct Figure {
  Picture picture;
  std::string group;                 ///< What is compared with each other: the scene, mostly.
  std::string label;                 ///< Which of the group it is.
  std::optional<Picture> converged;  ///< What its error is measured against.
  double x = 0;                      ///< Where it stands in the section's plot; 0: nowhere.
  bool is_pictured = true;           ///< Else it is a row of the section's table alone.
};

/// The table below a section's pictures.
enum class Comparison {
  none,
  hierarchy,  ///< Pairs: without and with a hierarchy.
  splits,     ///< Groups, each led by the split that the others are compared with.
  errors,     ///< Time and error.
  adaptive,   ///< Groups, each led by the picture that takes all samples.
};

struct Section {
  std::string title, text;  ///< The text is HTML.
  std::vector<Figure> figures;
  Comparison comparison = Comparison::none;
  std::string x_label;  ///< Of the plot of errors; empty: no plot.
};

struct Part {
  int number = 0;
  std::string title;
  std::vector<Section> sections;
  std::vector<std::string> missing;  ///< Scenes that belong to it and are not there, in words.
};

/// What a part is planned with.
struct Setting {
  const SceneFolder& folder;
  Scale scale;
};

// One for each part of the assignment.
Part plan_rays(const Setting& setting);
Part plan_hierarchy(const Setting& setting);
Part plan_direct_light(const Setting& setting);
Part plan_global_light(const Setting& setting);
Part plan_adaptive(const Setting& setting);

/// All of them, in order.
std::vector<Part> plan_study(const Setting& setting);

/// Every picture of a part once, those that others are compared with included, in the order of the page.
std::vector<Picture> pictures_of(const Part& part);

// What the plans of the parts are made of.

/// A scene that a part wants, and what may stand in for it.
struct Wanted {
  const char* name;
  const char* stand_in = nullptr;
};

/// Those of the wanted scenes that are there; the others are named in the part, each once.
std::vector<const FoundScene*> choose_scenes(const Setting& setting, const std::vector<Wanted>& wanted,
                                             Part& part);

/// A picture of this scene, called after it and `tag`.
Picture picture_of(const FoundScene& scene, const std::string& tag, std::uint32_t samples, Words options);

/// Shading normals.
Picture normals_of(const FoundScene& scene);

}  // namespace twinray::study
