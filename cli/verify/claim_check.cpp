// SPDX-License-Identifier: Apache-2.0
#include "cli/verify/claim_check.h"

#include <fmt/format.h>

#include "cli/picture_metadata.h"
#include "core/error.h"

namespace twinray {
namespace {

/// Entries that repeat what the command line and the scene say, wherever that is now.
constexpr const char* repeated[] = {"twinray:seed", "twinray:filter", "twinray:biased_by"};

std::string text_of(const std::string& value) { return value.empty() ? "none" : value; }

}  // namespace

void check_claim(const std::string& path, const ImageMetadata& metadata, const PictureClaim& claim,
                 const RenderArguments& loaded) {
  const RenderArguments arguments = arguments_of(claim);
  const auto check = [&](const char* name, const std::string& said, const std::string& asked) {
    if (said != asked)
      throw Error(fmt::format("{}: its {} is {}, and its command asks for {}", path, name, text_of(said),
                              text_of(asked)));
  };
  check("twinray:scene", value_of(metadata, "twinray:scene"), arguments.scene);
  const ImageMetadata asked = option_metadata(loaded, claim.words);
  for (const char* name : repeated) check(name, value_of(metadata, name), value_of(asked, name));
  const std::string engine = engine_name(arguments);
  if (!arguments.is_auto && !engines_in(claim.engine).contains(engine))
    check("twinray:engine", claim.engine, engine);
}

std::string engine_doubt(const PictureClaim& claim, const Geometry& geometry) {
  RenderArguments arguments = arguments_of(claim);
  if (!arguments.is_auto) return "";
  choose_engine(geometry, arguments);
  const std::string engine = engine_name(arguments);
  if (engines_in(claim.engine).contains(engine)) return "";
  return fmt::format("its twinray:engine is {}, and --accel=auto chooses {} here", text_of(claim.engine),
                     engine);
}

}  // namespace twinray
