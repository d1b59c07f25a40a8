// SPDX-License-Identifier: Apache-2.0
#include "io/picture/image_codec.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <system_error>
#include <thread>

#include "core/error.h"

namespace twinray {
namespace {

/// Found beside the program as it was built or installed (its RPATH), or in LD_LIBRARY_PATH.
constexpr const char* library = TWINRAY_IMAGE_CODEC;

[[noreturn]] void fail(const std::string& reason) {
  throw Error(fmt::format("JPEG, TIFF and HDR pictures cannot be written, nor HDR ones read: {}", reason));
}

const ImageCodec& load_codec() {
  const std::lock_guard lock(library_loading());
  void* const loaded = dlopen(library, RTLD_LAZY | RTLD_LOCAL);
  if (!loaded) fail(dlerror());
  const auto codec = reinterpret_cast<ImageCodecFunction>(dlsym(loaded, TWINRAY_CODEC_FUNCTION));
  if (!codec) fail(fmt::format("{} is of another version of twinray", library));
  return *codec();
}

}  // namespace

std::mutex& library_loading() {
  static std::mutex mutex;
  return mutex;
}

bool codec_reads(const std::string& path) { return known_picture_format(path) == PictureFormat::hdr; }

bool codec_writes(const std::string& path) {
  const OutputFormat format = output_format(path);
  return format == OutputFormat::jpeg || format == OutputFormat::tiff || format == OutputFormat::hdr;
}

const ImageCodec& image_codec() {
  static const ImageCodec& codec = load_codec();
  return codec;
}

std::jthread load_image_codec_early() {
  const auto load = [] {
    try {
      image_codec();
    } catch (const Error&) {  // Said where a picture needs it.
    }
  };
  try {
    return std::jthread(load);
  } catch (const std::system_error&) {  // No thread can be made: it is loaded when it is needed.
    return {};
  }
}

}  // namespace twinray
