// SPDX-License-Identifier: Apache-2.0
#include "cli/denoising.h"

#include <chrono>
#include <span>

#include "cli/version.h"
#include "core/error.h"
#include "core/exact_parts.h"
#include "core/parallel.h"
#include "integrators/denoise/denoise.h"
#include "integrators/denoise/filtered_error.h"

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

Image mean_of(std::span<const Plane> a, std::span<const Plane> b, const HalfPictures& pictures) {
  return image_of(means_of_halves(a, b, pictures.second_weight));
}

SurfaceFeatures features_of(const HalfPictures& pictures) {
  const auto feature = [&](std::size_t first) {
    const auto& [a, b] = pictures.halves;
    return mean_of(std::span(a.features).subspan(first, 3), std::span(b.features).subspan(first, 3),
                   pictures);
  };
  return {feature(0), feature(3)};
}

/// Each half by itself, with the features of both, which have less noise.
FilteredHalves denoised_halves(const OpenImageDenoise& library, const HalfPictures& pictures) {
  const SurfaceFeatures clean = library.denoised(features_of(pictures));
  FilteredHalves filtered;
  for (std::size_t half = 0; half < 2; ++half)
    filtered[half] = color_of(library.denoised(image_of(pictures.halves[half].color), clean));
  return filtered;
}

/// The sum of pictures, whose pixels then add up to it in any order.
Image exact_sum(std::vector<Image>& parts) {
  Image sum(parts.front().width, parts.front().height);
  std::vector<float> values(parts.size());
  for (std::size_t i = 0; i < sum.pixels.size(); ++i)
    for (float Rgb::*const channel : {&Rgb::r, &Rgb::g, &Rgb::b}) {
      double whole = 0;
      for (std::size_t part = 0; part < parts.size(); ++part)
        whole += double(values[part] = parts[part].pixels[i].*channel);
      sum.pixels[i].*channel = float(whole);
      make_exact(float(whole), values);
      for (std::size_t part = 0; part < parts.size(); ++part) parts[part].pixels[i].*channel = values[part];
    }
  return sum;
}

}  // namespace

Denoising::Denoising(DenoiserKind kind, int threads)
    : library_(library_for(kind, threads)), threads_(threads) {}

std::string Denoising::name() const {
  return library_ ? "Open Image Denoise " + library_->version() : version_name() + ", own filter";
}

std::optional<DenoisedPicture> Denoising::denoise(const HalfFilms& halves,
                                                  const std::function<bool()>& is_stopped) const {
  const auto start = std::chrono::steady_clock::now();
  HalfPictures pictures = half_pictures(halves);
  const SurfaceFeatures clean =
      library_ ? library_->denoised(features_of(pictures), is_stopped) : SurfaceFeatures{};
  const auto denoised = [&] {
    const auto& [a, b] = pictures.halves;
    return library_ ? library_->denoised(mean_of(a.color, b.color, pictures), clean, is_stopped)
                    : picture_of(denoised_halves(pictures, is_stopped), pictures.second_weight);
  };
  DenoisedPicture made;
  with_threads(threads_, [&] {
    const std::size_t groups = halves.first.contents().parts[std::size_t(Division::groups)];
    for (std::size_t group = 0; group < groups && !(is_stopped && is_stopped()); ++group) {
      take_light_group(halves, group, pictures);
      made.light_groups.push_back(denoised());
    }
    if (is_stopped && is_stopped()) return;
    made.image = groups > 0 ? exact_sum(made.light_groups) : denoised();
  });
  if (is_stopped && is_stopped()) return std::nullopt;
  made.denoiser = name();
  made.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return made;
}

double Denoising::estimated_error(const HalfFilms& halves) const {
  const HalfPictures pictures = half_pictures(halves);
  double error = 0;
  with_threads(threads_, [&] {
    error = estimated_relative_error(
        pictures, library_ ? denoised_halves(*library_, pictures) : denoised_halves(pictures));
  });
  return error;
}

void check_samples_for_denoising(const RenderArguments& arguments) {
  if (arguments.denoiser && arguments.render.samples < 2)
    throw Error("--denoise: a single sample per pixel says nothing of the noise; -s takes 2 or more");
}

}  // namespace twinray
