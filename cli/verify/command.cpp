// SPDX-License-Identifier: Apache-2.0
#include "cli/verify/command.h"

#include <algorithm>
#include <chrono>

#include <memory>

#include "cli/console.h"
#include "cli/interrupt.h"
#include "cli/options/common.h"
#include "cli/render_scene.h"
#include "cli/resources.h"
#include "cli/sandbox/child.h"
#include "cli/sandbox/sandbox.h"
#include "cli/verify/claim_check.h"
#include "cli/verify/tile_check.h"
#include "cli/version.h"
#include "core/error.h"
#include "integrators/allocation.h"
#include "io/picture/image_file.h"

namespace twinray {
namespace {

constexpr Range<std::uint32_t> tile_counts{1, 1u << 24};
/// So many of the tiles that differ are named.
constexpr std::size_t most_named = 5;

void add_options(CLI::App& app, VerifyArguments& arguments, std::string& sandbox) {
  add_file(app, "PICTURE", arguments.picture, "What render or merge has written: .png or .exr");
  OptionGroup group(app, "Options");
  group.add_number({"--tiles", "N", "So many tiles of 16 x 16 pixels are rendered again, at most"},
                   arguments.tiles, tile_counts);
  group.add_number({"--seed", "N", "Which tiles (others each time)"}, arguments.seed, seeds);
  group.add_word({"--scene", "FILE", "Where the scene is now (as the picture says)"}, arguments.scene);
  group.add_choice<std::string>("--accel", arguments.accel, engine_choices(),
                                "The engine (another one than made the picture)", "NAME");
  add_threads(group, arguments.threads);
  add_sandbox(group, "Read the folders of the picture and of --scene, and these", sandbox);
  add_limits(group, "End after so many seconds", arguments.limits);
  group.add_flag("-q,--quiet", arguments.quiet, "Print errors, warnings and differences only");
}

/// A picture that another engine makes again says more; but what an engine does by itself it does again.
/// Empty: the one that the words of the command say.
std::string engine_for(const PictureClaim& claim) {
  const RenderArguments arguments = arguments_of(claim);
  if (depends_on_engine(arguments)) return "";
  return find_engine("embree") && !claim.engine.starts_with("embree") ? "embree" : "bvh";
}

/// Why no part of the picture has the bits of the whole; empty: it has.
std::string loss_of(const RenderArguments& arguments, const PictureClaim& claim,
                    const StoredLayers& picture) {
  const OutputFormat format = output_format(arguments.output);
  if (format == OutputFormat::exr && arguments.compression == ExrCompression::dwab)
    return "its compression, dwab, keeps no bits of what was rendered";
  if (arguments.render.allocation == Allocation::error && arguments.render.samples > SampleAllocation::pilot)
    return "how many samples a pixel has depends on the whole picture, by --allocation=error";
  if (arguments.integrator == IntegratorKind::cost && !is_linear(format))
    return "the scale of its colors is that of the whole picture";
  const bool has_noisy = std::any_of(picture.channels.begin(), picture.channels.end(),
                                     [](const auto& channel) { return channel.name == "noisy.R"; });
  return claim.is_denoised && !has_noisy
             ? "denoised pixels depend on all others; the noisy picture beside it can be verified"
             : "";
}

void check_format(const std::string& path) {
  if (output_format(path) == OutputFormat::jpeg)
    throw Error(path + ": a JPEG keeps no bits of what was rendered");
}

RenderArguments render_arguments(const VerifyArguments& asked, PictureClaim claim) {
  const std::string engine = !asked.accel.empty() ? asked.accel : claim.is_cs184 ? "" : engine_for(claim);
  // A triangle test that changed nothing with the picture's engine changes nothing here.
  if (!engine.empty() && !has_other_triangle_test(arguments_of(claim)) &&
      !word_of_option(claim.words, {"--triangle-test"}).empty())
    claim.words.insert(claim.words.end(), {"--triangle-test", "woop"});
  if (!engine.empty()) claim.words.insert(claim.words.end(), {"--accel", engine});
  RenderArguments arguments = arguments_of(claim);
  arguments.output = asked.picture;
  arguments.render.threads = asked.threads;
  if (!asked.scene.empty()) arguments.scene = asked.scene;
  arguments.load.files = std::make_shared<std::vector<std::string>>();
  return arguments;
}

void check_inputs(const VerifyArguments& asked, const PictureClaim& claim, const RenderArguments& arguments) {
  const std::string difference = file_difference(claim.inputs, input_files(arguments), "here");
  if (!difference.empty()) throw Error(fmt::format("{}: {}", asked.picture, difference));
}

/// Of the files that the command names: another one may be no scene any more, and its faults say little.
/// Those that the scene names in turn are known once it is read.
void check_named_inputs(const VerifyArguments& asked, const PictureClaim& claim, RenderArguments arguments) {
  arguments.load.files = std::make_shared<std::vector<std::string>>(1, arguments.scene);
  for (const auto& [name, hash] : input_files(arguments)) {
    const auto said = claim.inputs.find(name);
    if (hash != "none" && said != claim.inputs.end() && said->second != hash)
      throw Error(fmt::format("{}: {} is another file here", asked.picture, name));
  }
}

void check_size(const std::string& path, const StoredLayers& picture, const PixelRect& window) {
  if (picture.width != window.width() || picture.height != window.height())
    throw Error(fmt::format("{}: it has {} x {} pixels, and its command asks for {} x {}", path,
                            picture.width, picture.height, window.width(), window.height()));
  const bool has_place = output_format(path) == OutputFormat::exr;
  if (has_place && (picture.frame.x != window.x0 || picture.frame.y != window.y0))
    throw Error(fmt::format("{}: it lies at {} {} of its frame, and its command asks for {} {}", path,
                            picture.frame.x, picture.frame.y, window.x0, window.y0));
}

/// What the picture names, its scene, is read only where it lies in one of the places.
SandboxNeeds needs_of(const VerifyArguments& asked, const ScratchFolder& folder) {
  SandboxNeeds needs;
  std::vector<std::string>& read = needs.places.read;
  read = *asked.sandbox;
  check_places(read);
  for (const std::string& file : {asked.picture, asked.scene})
    if (!file.empty()) read.insert(read.end(), {folder_of(file), file});
  needs.places.scratch.push_back(folder.path());
  return needs;
}

/// Before anything of the picture is read.
void protect_the_machine(const VerifyArguments& asked, const ScratchFolder& folder) {
  limit_process(asked.limits);
  if (!asked.sandbox) return;
  const std::string open = enter_sandbox(needs_of(asked, folder));
  if (!asked.quiet) console::print("Sandbox        {}\n", open);
}

std::uint64_t seed_of(const VerifyArguments& asked) {
  return asked.seed.value_or(std::uint64_t(std::chrono::system_clock::now().time_since_epoch().count()));
}

std::string value_text(const std::optional<float>& value) {
  return value ? fmt::format("{}", *value) : "absent";
}

void print_differences(const std::vector<WrongTile>& differences) {
  for (std::size_t i = 0; i < std::min(most_named, differences.size()); ++i) {
    const auto& [tile, pixels] = differences[i];
    console::print_error("tile at {} {}: {} pixels differ, the first at {} {}: {} is {} there, and {} here\n",
                         tile.x0, tile.y0, pixels.pixels, pixels.x, pixels.y, pixels.channel,
                         value_text(pixels.there), value_text(pixels.here));
  }
  if (differences.size() > most_named)
    console::print_error("and {} more tiles\n", differences.size() - most_named);
}

}  // namespace

std::function<VerifyArguments()> add_verify_options(CLI::App& app) {
  const auto arguments = std::make_shared<VerifyArguments>();
  const auto sandbox = std::make_shared<std::string>();
  add_options(app, *arguments, *sandbox);
  return [arguments, sandbox] {
    arguments->sandbox = sandbox_places(*sandbox);
    return *arguments;
  };
}

int verify_command(const VerifyArguments& asked) {
  check_format(asked.picture);
  const ScratchFolder folder;
  if (asked.sandbox || asked.limits.seconds)  // Whoever waits removes the folder.
    if (const std::optional<int> code = go_on_in_child()) return *code;
  const InterruptGuard guard({});  // Whatever ends it says so.
  protect_the_machine(asked, folder);
  const StoredLayers picture = read_picture(asked.picture);
  if (const std::string parts = unread_parts(asked.picture); !parts.empty()) console::warn(parts);
  const PictureClaim claim = read_claim(asked.picture, picture.metadata);
  if (claim.program != version_name())
    console::warn(
        fmt::format("{}: it was made by {}, and this is {}", asked.picture, claim.program, version_name()));
  RenderArguments arguments = render_arguments(asked, claim);
  if (const std::string loss = loss_of(arguments, claim, picture); !loss.empty())
    throw Error(fmt::format("{}: {}", asked.picture, loss));
  check_named_inputs(asked, claim, arguments);
  RenderTalk nobody;
  const LoadedScene loaded = load_for_render(arguments, nobody);
  check_inputs(asked, claim, arguments);
  check_claim(asked.picture, picture.metadata, claim, arguments);
  if (const std::string doubt = engine_doubt(claim, *loaded.scene.geometry); !doubt.empty())
    console::warn(fmt::format("{}: {}", asked.picture, doubt));
  choose_engine(*loaded.scene.geometry, arguments);
  check_memory(memory_needs(arguments.backend, arguments.build, loaded.scene.geometry->primitive_count()));
  const PixelRect window = window_of(arguments.render);
  check_size(asked.picture, picture, window);
  const std::uint64_t seed = seed_of(asked);
  const std::vector<PixelRect> tiles = chosen_tiles(window, asked.tiles, seed);
  const std::vector<WrongTile> differences =
      check_tiles({picture, claim.is_denoised}, arguments, loaded, tiles, folder);
  print_differences(differences);
  const std::uint32_t all = tile_grid(window, tile_size).count();
  if (!asked.quiet || !differences.empty())
    console::print(
        "Picture        {}\nMade by        {}, engine {}, {} samples a pixel\nFiles          {}, as they "
        "were\n"
        "Rendered again {} of {} tiles by engine {}, seed {}\nSame bits      {} of {} tiles{}\n",
        asked.picture, claim.program, claim.engine, claim.samples, claim.inputs.size(), tiles.size(), all,
        engine_name(arguments), seed, tiles.size() - differences.size(), tiles.size(),
        claim.is_denoised ? ", of the noisy channels: those without noise are not compared" : "");
  return differences.empty() ? 0 : 1;
}

}  // namespace twinray
