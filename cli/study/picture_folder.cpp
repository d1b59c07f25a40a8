// SPDX-License-Identifier: Apache-2.0
#include "cli/study/picture_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "cli/progress.h"
#include "cli/render_command.h"
#include "cli/render_command_line.h"
#include "cli/shell_text.h"
#include "cli/version.h"
#include "core/error.h"
#include "core/image.h"
#include "io/output_file.h"
#include "io/picture/image_file.h"

namespace twinray::study {
namespace {

namespace fs = std::filesystem;

/// Tests per ray are a mean over rays: a small picture knows them well enough.
constexpr int counting_width = 120;
constexpr std::uint32_t counting_samples = 4;

/// The bytes of a file; none where it cannot be read.
std::optional<std::string> read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string{std::istreambuf_iterator<char>(file), {}};
}

void append(const Words& more, Words& words) { words.insert(words.end(), more.begin(), more.end()); }

/// Takes down what a render took; a line on standard error shows how far a long one is.
class RecordingTalk final : public RenderTalk {
 public:
  explicit RecordingTalk(Record& record) : record_(record), line_(progress_line(true)) {}
  void rendering() override { line_ = progress_line(true); }
  void progress(const RenderProgress& progress) override {
    if (line_.is_due()) line_.show(progress_text(progress, line_.elapsed_seconds()));
  }
  void rendered(const RenderResult&) override { line_.finish(); }
  void finished(const RenderArguments& arguments, const AccelStats& accel,
                const RenderResult& result) override {
    record_.engine = engine_name(arguments);
    record_.build_seconds = accel.build_seconds();
    record_.render_seconds = result.seconds;
    record_.rays = result.rays.total();
    record_.camera_rays = result.rays.camera;
    picture_ = mean_image(result.film);
  }
  const Image& picture() const { return picture_; }

 private:
  Record& record_;
  ProgressLine line_;
  Image picture_;
};

/// Takes down the tests of a render's rays.
class CountingTalk final : public RenderTalk {
 public:
  void finished(const RenderArguments&, const AccelStats&, const RenderResult& result) override {
    tests_per_ray_ =
        double(result.rays.queries.primitives) / double(std::max<std::uint64_t>(1, result.rays.total()));
  }
  double tests_per_ray() const { return tests_per_ray_; }

 private:
  double tests_per_ray_ = 0;
};

}  // namespace

PictureFolder::PictureFolder(std::string path, const Scale& scale, int threads)
    : path_(std::move(path)), scale_(scale), threads_(threads) {}

std::string PictureFolder::file(const Picture& picture, const std::string& ending) const {
  return fmt::format("{}/{}{}", path_, picture.name, ending);
}

Words PictureFolder::words(const Picture& picture) const {
  Words all{picture.scene, "--view=whole"};
  // The one sample of a pixel lies in its middle, whatever the filter.
  if (picture.samples > 1) all.push_back("--filter=box");
  append({"-r", fmt::format("{}", scale_.width), fmt::format("{}", scale_.height)}, all);
  if (threads_ > 0) append({"-t", fmt::format("{}", threads_)}, all);
  append({"-s", fmt::format("{}", picture.samples)}, all);
  append(picture.options, all);
  return all;
}

Words PictureFolder::typed_words(const Picture& picture) const {
  Words all = words(picture);
  append(picture.adaptive, all);
  append({"-o", picture.name + ".png"}, all);
  return all;
}

std::string PictureFolder::command(const Picture& picture) const {
  return "twinray render " + shell_text(typed_words(picture));
}

std::uint64_t PictureFolder::scene_hash(const std::string& scene) const {
  const auto [entry, is_new] = scene_hashes_.try_emplace(scene, 0);
  if (!is_new) return entry->second;
  const std::optional<std::string> bytes = read(scene);
  if (!bytes) throw Error(fmt::format("{}: cannot be read", scene));
  entry->second = hash_of(*bytes);
  return entry->second;
}

std::optional<Record> PictureFolder::old_record(const Picture& picture) const {
  const std::optional<std::string> text = read(file(picture, ".json"));
  return text ? parse_record(*text) : std::nullopt;
}

bool PictureFolder::is_of(const Record& record, const Picture& picture) const {
  return record.command == command(picture) && record.program == version_name() &&
         record.scene_hash == scene_hash(picture.scene);
}

bool PictureFolder::is_outdated(const Picture& picture) const {
  const std::optional<Record> record = old_record(picture);
  return record && !is_of(*record, picture);
}

std::optional<Record> PictureFolder::finished(const Picture& picture) const {
  const std::optional<Record> record = old_record(picture);
  if (!record || !is_of(*record, picture)) return std::nullopt;
  return files_hash(picture) == record->files_hash ? record : std::nullopt;
}

std::optional<std::uint64_t> PictureFolder::files_hash(const Picture& picture) const {
  Words endings{".png", ".exr"};
  if (!picture.adaptive.empty()) endings.push_back("_rate.png");
  std::string hashes;
  for (const std::string& ending : endings) {
    const std::optional<std::string> bytes = read(file(picture, ending));
    if (!bytes) return std::nullopt;
    hashes += fmt::format("{} ", hash_of(*bytes));
  }
  return hash_of(hashes);
}

double PictureFolder::count_tests(const Picture& picture) const {
  const int width = std::min(scale_.width, counting_width);
  const int height = std::max(1, scale_.height * width / scale_.width);
  Words counting = words(picture);
  append({"-r", fmt::format("{}", width), fmt::format("{}", height), "-s",
          fmt::format("{}", std::min(picture.samples, counting_samples)), "--count", "-o", "/dev/null"},
         counting);
  CountingTalk talk;
  render_command(parse_render_arguments(counting), counting, talk);
  return talk.tests_per_ray();
}

int PictureFolder::make(const Picture& picture) const {
  fs::remove(file(picture, ".json"));
  Words rendering = words(picture);
  append(picture.adaptive, rendering);
  append({"-o", file(picture, ".png")}, rendering);
  Record record{.command = command(picture),
                .program = version_name(),
                .scene_hash = scene_hash(picture.scene),
                .tests_per_ray = count_tests(picture)};
  RecordingTalk talk(record);
  const int code = render_command(parse_render_arguments(rendering), typed_words(picture), talk);
  if (code != 0) return code;
  write_exr(file(picture, ".exr"), talk.picture());
  record.files_hash = files_hash(picture).value_or(0);
  write_file(file(picture, ".json"), record_text(record));
  return 0;
}

}  // namespace twinray::study
