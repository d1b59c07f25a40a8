// SPDX-License-Identifier: Apache-2.0
#include "cli/denoising.h"

#include <chrono>
#include <span>

#include "cli/version.h"
#include "core/error.h"
#include "core/parallel.h"
#include "integrators/denoise/denoise.h"

namespace twinray {
namespace {

std::unique_ptr<const OpenImageDenoise> library_for(DenoiserKind kind, int threads) {
  if (kind == DenoiserKind::own) return nullptr;
  std::unique_ptr<const OpenImageDenoise> library = OpenImageDenoise::find(threads);
  if (!library && kind == DenoiserKind::open_image_denoise)
    throw Error(
        "--denoise=oidn: libOpenImageDenoise.so.2 is not found; TWINRAY_OIDN may name it, or a folder that "
        "has it within");
  return library;
}

NoisyFeatures noisy_features(const HalfPictures& pictures) {
  const auto& [a, b] = pictures.halves;
  const auto feature = [&](std::size_t first) {
    return image_of(means_of_halves(std::span(a.features).subspan(first, 3),
                                    std::span(b.features).subspan(first, 3), pictures.second_weight));
  };
  return {image_of(means_of_halves(a.color, b.color, pictures.second_weight)), feature(0), feature(3)};
}

}  // namespace

Denoising::Denoising(DenoiserKind kind, int threads)
    : library_(library_for(kind, threads)), threads_(threads) {}

std::string Denoising::name() const {
  return library_ ? "Open Image Denoise " + library_->version() : version_name() + ", own filter";
}

DenoisedPicture Denoising::denoise(const HalfFilms& halves) const {
  const auto start = std::chrono::steady_clock::now();
  const HalfPictures pictures = half_pictures(halves);
  Image image;
  if (library_)
    image = library_->denoised(noisy_features(pictures));
  else
    with_threads(threads_, [&] { image = denoised(pictures); });
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  return {std::move(image), name(), taken.count()};
}

void check_samples_for_denoising(const RenderArguments& arguments) {
  if (arguments.denoiser && arguments.render.samples < 2)
    throw Error("--denoise: a single sample per pixel says nothing of the noise; -s takes 2 or more");
}

}  // namespace twinray
