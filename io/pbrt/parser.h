// SPDX-License-Identifier: Apache-2.0
// The statements of pbrt's text format, one after the other, those of included files among them.
#pragma once
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "io/pbrt/files.h"
#include "io/pbrt/lexer.h"
#include "io/pbrt/parameters.h"

namespace twinray {

enum class PbrtDirective {
  accelerator,
  active_transform,
  area_light_source,
  attribute,
  attribute_begin,
  attribute_end,
  camera,
  color_space,
  concat_transform,
  coord_sys_transform,
  coordinate_system,
  film,
  identity,
  import,   ///< import_begin and import_end are what a reader sees of it.
  include,  ///< Never seen by a reader.
  integrator,
  light_source,
  look_at,
  make_named_material,
  make_named_medium,
  material,
  medium_interface,
  named_material,
  object_begin,
  object_end,
  object_instance,
  option,
  pixel_filter,
  reverse_orientation,
  rotate,
  sampler,
  scale,
  shape,
  texture,
  transform,
  transform_begin,
  transform_end,
  transform_times,
  translate,
  world_begin,
  import_begin,
  import_end
};

/// A statement; its parts are those that its directive has.
struct PbrtStatement {
  PbrtDirective directive = PbrtDirective::identity;
  std::string_view name;  ///< "Shape"
  PbrtPlace place;
  std::array<double, 16> numbers{};
  std::vector<std::string> words;  ///< Quoted or not.
  PbrtParameters parameters;
};

class PbrtParser {
 public:
  /// Included files may lie up to max_depth deep, and must not include themselves. `files` must outlive it.
  PbrtParser(PbrtFile file, const PbrtFiles& files);

  /// Reads the next statement over `statement`, whose memory it uses again; false at the end of the file.
  /// Throws Error where it is none.
  bool next(PbrtStatement& statement);

  static constexpr std::size_t max_depth = 30, max_files = 100'000;

 private:
  struct OpenFile {
    PbrtLexer lexer;
    bool is_import;
  };
  void open(const PbrtStatement& statement);

  const PbrtFiles& disk_;
  std::vector<std::unique_ptr<PbrtFile>> files_;  ///< All that were opened: places point to them.
  std::vector<OpenFile> open_;                    ///< The one that is read last.
};

}  // namespace twinray
