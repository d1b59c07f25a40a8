// SPDX-License-Identifier: Apache-2.0
#include "integrators/denoise/open_image_denoise.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"

namespace twinray {

/// The library's interface in C (oidn.h), as far as it is needed here.
namespace oidn {

using Device = void*;
using Filter = void*;
constexpr int processor_device = 1;  ///< OIDN_DEVICE_TYPE_CPU
constexpr int three_floats = 3;      ///< OIDN_FORMAT_FLOAT3
constexpr int cancelled = 6;         ///< OIDN_ERROR_CANCELLED
/// Whether to go on; `done` is from 0 to 1.
using ProgressMonitor = bool (*)(void* user, double done);

struct Functions {
  Device (*new_device)(int type);
  void (*release_device)(Device);
  void (*set_device_int)(Device, const char* name, int value);
  int (*get_device_int)(Device, const char* name);
  void (*commit_device)(Device);
  int (*get_device_error)(Device, const char** message);  ///< 0: there was none.
  Filter (*new_filter)(Device, const char* type);
  void (*release_filter)(Filter);
  void (*set_shared_image)(Filter, const char* name, void* pixels, int format, std::size_t width,
                           std::size_t height, std::size_t byte_offset, std::size_t pixel_stride,
                           std::size_t row_stride);
  void (*set_bool)(Filter, const char* name, bool value);
  void (*set_progress_monitor)(Filter, ProgressMonitor, void* user);
  void (*commit_filter)(Filter);
  void (*execute_filter)(Filter);
};

}  // namespace oidn

namespace {

using namespace oidn;
namespace fs = std::filesystem;

constexpr const char* library_name = "libOpenImageDenoise.so.2";
constexpr int known_version = 2;
constexpr int deepest = 8;  ///< Folders within a folder in which the library is looked for.

template <class Function>
void find_function(void* library, const char* name, const std::string& path, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (!function)
    throw Error(
        fmt::format("{}: this is not Open Image Denoise {}: it has no {}", path, known_version, name));
}

Functions find_functions(void* library, const std::string& path) {
  Functions found{};
  const auto find = [&](const char* name, auto& function) { find_function(library, name, path, function); };
  find("oidnNewDevice", found.new_device);
  find("oidnReleaseDevice", found.release_device);
  find("oidnSetDeviceInt", found.set_device_int);
  find("oidnGetDeviceInt", found.get_device_int);
  find("oidnCommitDevice", found.commit_device);
  find("oidnGetDeviceError", found.get_device_error);
  find("oidnNewFilter", found.new_filter);
  find("oidnReleaseFilter", found.release_filter);
  find("oidnSetSharedFilterImage", found.set_shared_image);
  find("oidnSetFilterBool", found.set_bool);
  find("oidnSetFilterProgressMonitorFunction", found.set_progress_monitor);
  find("oidnCommitFilter", found.commit_filter);
  find("oidnExecuteFilter", found.execute_filter);
  return found;
}

bool goes_on(void* is_stopped, double) { return !(*static_cast<const std::function<bool()>*>(is_stopped))(); }

/// The library within a folder: of several the first by name; empty where there is none.
std::string library_within(const fs::path& folder) {
  std::vector<std::string> found;
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error), end;
       !error && at != end; at.increment(error)) {
    if (at.depth() >= deepest) at.disable_recursion_pending();
    if (at->path().filename() == library_name) found.push_back(at->path().string());
  }
  return found.empty() ? "" : *std::min_element(found.begin(), found.end());
}

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value ? value : "";
}

/// The file that the environment names; empty where it names none.
std::string named_library() {
  const std::string named = variable("TWINRAY_OIDN");
  std::error_code error;
  if (named.empty() || !fs::is_directory(named, error)) return named;
  const std::string found = library_within(named);
  if (found.empty()) throw Error(fmt::format("TWINRAY_OIDN: there is no {} in {}", library_name, named));
  return found;
}

}  // namespace

/// The loaded library and its device. It stays in memory, as it has threads of its own.
class OpenImageDenoise::Library {
 public:
  Library(void* loaded, const std::string& path, int threads)
      : functions_(find_functions(loaded, path)),
        device_(functions_.new_device(processor_device), functions_.release_device) {
    check(path.c_str());
    if (!device_) throw Error(fmt::format("{}: this processor cannot be used", path));
    if (functions_.get_device_int(device_.get(), "versionMajor") != known_version)
      throw Error(fmt::format("{}: this is version {} of Open Image Denoise; {} is needed", path, version(),
                              known_version));
    functions_.set_device_int(device_.get(), "numThreads", threads > 0 ? threads : available_threads());
    functions_.commit_device(device_.get());
    check(path.c_str());
  }

  std::string version() const {
    const auto part = [&](const char* name) { return functions_.get_device_int(device_.get(), name); };
    return fmt::format("{}.{}.{}", part("versionMajor"), part("versionMinor"), part("versionPatch"));
  }

  /// An image that a filter reads or writes. It reads it alone, but its interface does not say so.
  struct Binding {
    const char* name;
    const Image* image;
  };
  /// Runs the filter for ray traced pictures. With `flags` set.
  Image filtered(std::span<const Binding> inputs, std::span<const char* const> flags,
                 std::function<bool()> is_stopped) const {
    const std::unique_ptr<void, void (*)(Filter)> filter(functions_.new_filter(device_.get(), "RT"),
                                                         functions_.release_filter);
    check("Open Image Denoise");
    const Image& first = *inputs.front().image;
    Image output(first.width, first.height);
    for (const Binding& input : inputs) bind(filter.get(), input.name, *input.image);
    bind(filter.get(), "output", output);
    for (const char* const flag : flags) functions_.set_bool(filter.get(), flag, true);
    if (is_stopped) functions_.set_progress_monitor(filter.get(), goes_on, &is_stopped);
    functions_.commit_filter(filter.get());
    functions_.execute_filter(filter.get());
    check("Open Image Denoise");
    return output;
  }

 private:
  void bind(Filter filter, const char* name, const Image& image) const {
    functions_.set_shared_image(filter, name, const_cast<Rgb*>(image.pixels.data()), three_floats,
                                std::size_t(image.width), std::size_t(image.height), 0, sizeof(Rgb), 0);
  }
  /// Throws what the library complains of, but for an end that it was asked for.
  void check(const char* who) const {
    const char* message = nullptr;
    const int code = functions_.get_device_error(device_.get(), &message);
    if (code != 0 && code != cancelled)
      throw Error(fmt::format("{}: {}", who, message ? message : "an error without a message"));
  }

  const Functions functions_;
  const std::unique_ptr<void, void (*)(Device)> device_;
};

OpenImageDenoise::OpenImageDenoise(std::unique_ptr<const Library> library) : library_(std::move(library)) {}
OpenImageDenoise::~OpenImageDenoise() = default;

std::unique_ptr<const OpenImageDenoise> OpenImageDenoise::find(int threads) {
  const std::string named = named_library();
  std::string path = named.empty() ? library_name : named;
  void* loaded = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!loaded && !named.empty()) throw Error(fmt::format("TWINRAY_OIDN: {}", dlerror()));
  if (const std::string active = variable("VIRTUAL_ENV"); !loaded && !active.empty()) {
    path = library_within(active);
    if (!path.empty()) loaded = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  }
  if (!loaded) return nullptr;
  return std::unique_ptr<const OpenImageDenoise>(
      new OpenImageDenoise(std::make_unique<const Library>(loaded, path, threads)));
}

std::string OpenImageDenoise::version() const { return library_->version(); }

SurfaceFeatures OpenImageDenoise::denoised(const SurfaceFeatures& noisy,
                                           const std::function<bool()>& is_stopped) const {
  const auto alone = [&](const char* name, const Image& image) {
    const std::array inputs{Library::Binding{name, &image}};
    return library_->filtered(inputs, {}, is_stopped);
  };
  return {alone("albedo", noisy.albedo), alone("normal", noisy.normal)};
}

Image OpenImageDenoise::denoised(const Image& color, const SurfaceFeatures& clean,
                                 const std::function<bool()>& is_stopped) const {
  const std::array inputs{Library::Binding{"color", &color}, Library::Binding{"albedo", &clean.albedo},
                          Library::Binding{"normal", &clean.normal}};
  constexpr std::array flags{"hdr", "cleanAux"};
  Image denoised = library_->filtered(inputs, flags, is_stopped);
  for (Rgb& pixel : denoised.pixels)
    pixel = {std::max(0.0f, pixel.r), std::max(0.0f, pixel.g), std::max(0.0f, pixel.b)};
  return denoised;
}

}  // namespace twinray
