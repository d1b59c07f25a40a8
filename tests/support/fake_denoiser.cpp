// SPDX-License-Identifier: Apache-2.0
// A library with Open Image Denoise's interface and arithmetic that a test can follow. FAKE_DENOISER=old says
// that it is of version 1, =broken that it fails, =interrupt that Ctrl-C is pressed while it works,
// =interrupt-twice that it is pressed once more.
#include <signal.h>

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace {

struct FilterData {
  std::map<std::string, float*> images;
  std::set<std::string> flags;
  std::size_t floats = 0;
  bool (*goes_on)(void* user, double done) = nullptr;
  void* user = nullptr;
};

bool is_mode(const char* mode) {
  const char* const set = std::getenv("FAKE_DENOISER");
  return set && std::strcmp(set, mode) == 0;
}

bool has_failed = false, is_cancelled = false, is_used = false;

}  // namespace

extern "C" {

void* oidnNewDevice(int type) { return type == 1 ? &has_failed : nullptr; }
void oidnReleaseDevice(void*) {}
void oidnSetDeviceInt(void*, const char*, int) {}
int oidnGetDeviceInt(void*, const char* name) {
  if (std::strcmp(name, "versionMajor") == 0) return is_mode("old") ? 1 : 2;
  return std::strcmp(name, "versionMinor") == 0 ? 4 : 3;
}
void oidnCommitDevice(void*) {}
int oidnGetDeviceError(void*, const char** message) {
  if (is_cancelled) {
    is_cancelled = false;
    *message = "execution was cancelled";
    return 6;
  }
  if (!has_failed) return 0;
  has_failed = false;
  *message = "out of memory";
  return 4;
}
void* oidnNewFilter(void*, const char* type) {
  return std::strcmp(type, "RT") == 0 ? new FilterData : nullptr;
}
void oidnReleaseFilter(void* filter) { delete static_cast<FilterData*>(filter); }
void oidnSetSharedFilterImage(void* filter, const char* name, void* pixels, int, std::size_t width,
                              std::size_t height, std::size_t, std::size_t, std::size_t) {
  auto& data = *static_cast<FilterData*>(filter);
  data.images[name] = static_cast<float*>(pixels);
  data.floats = 3 * width * height;
}
void oidnSetFilterBool(void* filter, const char* name, bool value) {
  if (value) static_cast<FilterData*>(filter)->flags.insert(name);
}
void oidnSetFilterProgressMonitorFunction(void* filter, bool (*function)(void*, double), void* user) {
  static_cast<FilterData*>(filter)->goes_on = function;
  static_cast<FilterData*>(filter)->user = user;
}
void oidnCommitFilter(void*) {}

/// Albedo or normal alone are doubled; a picture becomes color + 10 albedo + 100 normal, if both are said to
/// be clean and the picture to be radiance.
void oidnExecuteFilter(void* filter) {
  has_failed = is_mode("broken");
  const bool is_first = !std::exchange(is_used, true);
  if (is_first && (is_mode("interrupt") || is_mode("interrupt-twice"))) raise(SIGINT);
  if (is_first && is_mode("interrupt-twice")) raise(SIGINT);
  auto& [images, flags, floats, goes_on, user] = *static_cast<FilterData*>(filter);
  is_cancelled = goes_on && !goes_on(user, 0);
  if (is_cancelled) return;
  float* const output = images.at("output");
  const bool is_picture =
      images.count("color") == 1 && flags.count("hdr") == 1 && flags.count("cleanAux") == 1;
  for (std::size_t i = 0; i < floats; ++i) {
    if (is_picture)
      output[i] = images.at("color")[i] + 10 * images.at("albedo")[i] + 100 * images.at("normal")[i];
    else
      output[i] = 2 * (images.count("albedo") == 1 ? images.at("albedo") : images.at("normal"))[i];
  }
}

}  // extern "C"
