// SPDX-License-Identifier: Apache-2.0
// What --denoise does once a picture is rendered.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/render_arguments.h"
#include "integrators/denoise/open_image_denoise.h"
#include "integrators/half_films.h"

namespace twinray {

/// A picture without its noise.
struct DenoisedPicture {
  Image image;
  /// The film's light groups without their noise, where its halves have them: the picture is their sum,
  /// whatever the order.
  std::vector<Image> light_groups;
  std::string denoiser;  ///< "Open Image Denoise 2.5.1"
  double seconds = 0;    ///< Wall-clock time.
};

/// The denoiser that was asked for. Made before a render begins, so that what is missing is said at once.
class Denoising {
 public:
  /// Throws Error where it asks for Open Image Denoise and that is not found, or does not work.
  /// `threads`, 0: as many as the process may use.
  Denoising(DenoiserKind kind, int threads);

  std::string name() const;
  /// Of the halves of a render, which have albedo and normal; nothing once `is_stopped` says true, which is
  /// asked many times a second, from any thread.
  std::optional<DenoisedPicture> denoise(const HalfFilms& halves,
                                         const std::function<bool()>& is_stopped = {}) const;
  /// The root of the relative mean squared error (check/picture_error.h) that the denoised picture has, as
  /// far as the halves tell; light groups are not looked at.
  double estimated_error(const HalfFilms& halves) const;

 private:
  std::unique_ptr<const OpenImageDenoise> library_;  ///< Null: our own filter.
  int threads_;
};

/// Throws Error where a picture of so few samples cannot be denoised: the halves of one sample are none.
void check_samples_for_denoising(const RenderArguments& arguments);

}  // namespace twinray
