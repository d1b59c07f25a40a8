// SPDX-License-Identifier: Apache-2.0
// Intel's Open Image Denoise, a neural network, where its library is found when the program runs. Nothing of
// it is needed to build.
#pragma once
#include <functional>
#include <memory>
#include <string>

#include "core/image.h"

namespace twinray {

/// Means of albedo and normal, of one size.
struct SurfaceFeatures {
  Image albedo, normal;
};

/// The library, with its device: the processor. Its pictures are the same on one machine each time; on others
/// they may differ in their last bits.
class OpenImageDenoise {
 public:
  /// Looks in what the environment's TWINRAY_OIDN names, the library or a folder that has it somewhere within
  /// (a virtual environment with the package pyoidn does); without one, where the loader looks, and in the
  /// virtual environment that is active (VIRTUAL_ENV). Null where there is none. Throws Error where
  /// TWINRAY_OIDN names no library, or one that is found does not work or is of another version than 2.
  /// `threads`, 0: as many as the process may use.
  static std::unique_ptr<const OpenImageDenoise> find(int threads = 0);
  ~OpenImageDenoise();

  /// "2.5.1"
  std::string version() const;
  /// Albedo and normal without noise, as a picture needs them. `is_stopped`, if set, is asked now and then,
  /// from any thread: once it says true, what is returned is of no use. Throws Error with the library's words
  /// where it fails.
  SurfaceFeatures denoised(const SurfaceFeatures& noisy, const std::function<bool()>& is_stopped = {}) const;
  /// The picture without noise, of the size of its features, which have none. Never negative. `is_stopped`
  /// and errors as above.
  Image denoised(const Image& color, const SurfaceFeatures& clean,
                 const std::function<bool()>& is_stopped = {}) const;

 private:
  class Library;
  explicit OpenImageDenoise(std::unique_ptr<const Library> library);

  std::unique_ptr<const Library> library_;
};

}  // namespace twinray
