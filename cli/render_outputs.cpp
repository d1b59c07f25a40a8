// SPDX-License-Identifier: Apache-2.0
#include "cli/render_outputs.h"

#include <fmt/format.h>

#include <filesystem>

#include "cli/console.h"
#include "cli/film/saved_film.h"
#include "cli/layered_picture.h"
#include "cli/outputs.h"
#include "io/cs184/picture.h"
#include "io/destination.h"
#include "io/display/color_scale.h"

namespace twinray {
namespace {

/// Whether the name has an ending that could be a format's; in "spheres_0.05" there is none.
bool has_ending(const std::string& name) {
  const std::string ending = std::filesystem::path(name).extension().string();
  return ending.size() > 1 && !(ending[1] >= '0' && ending[1] <= '9');
}

/// The name may be empty.
void check_replaceable(const std::string& name, const char* reason) {
  if (!name.empty() && destination_of(name).kind != Destination::Kind::file)
    throw Error(fmt::format("{}: {}", name, reason));
}

/// Pictures of CS184's program need no ending.
void check_name(const RenderArguments& arguments) {
  if (is_cs184(arguments) && !has_ending(arguments.output)) return;
  check_image_name(arguments.output);
}

std::string rate_name(const RenderArguments& arguments) {
  return is_cs184(arguments) ? cs184_rate_name(arguments.output) : name_beside(arguments.output, "_rate.png");
}

/// "a/b.tiff" -> "a/b_noisy.tiff"
std::string noisy_name(const std::string& picture) {
  const std::string ending = std::filesystem::path(picture).extension().string();
  return name_beside(picture, "_noisy" + (has_ending(picture) ? ending : ".png"));
}

void write_color(const std::string& name, const RenderArguments& arguments, const Image& image,
                 const PictureNotes& notes) {
  if (is_linear(output_format(name))) return write_linear(name, image, notes.metadata, notes.frame);
  write_display(name, is_cs184(arguments) ? encode_cs184(image) : displayed(image, arguments.display),
                notes.metadata);
}

ImageMetadata with_layers(const PictureNotes& notes, const FilmContents& contents) {
  ImageMetadata metadata = notes.metadata;
  for (auto& entry : layer_metadata(contents, notes.names)) metadata.push_back(std::move(entry));
  return metadata;
}

void write_colors(const RenderOutputs& outputs, const RenderArguments& arguments,
                  const RenderedPicture& rendered, const PictureNotes& notes) {
  const auto& [film, denoised] = rendered;
  if (keeps_layers(outputs.picture)) {
    LayeredImage image = layered_picture(film, notes.names, denoised);
    image.compression = arguments.compression;
    if (image.compression == ExrCompression::dwab && !fits_dwab(image)) {
      console::warn(
          "--exr-compression: dwab holds radiance up to 65504, and there is more: zip packs the picture");
      image.compression = ExrCompression::zip;
    }
    return write_exr(outputs.picture, image, with_layers(notes, film.contents()), notes.frame);
  }
  const Image mean = mean_image(film);
  write_color(outputs.picture, arguments, denoised ? denoised->image : mean, notes);
  if (outputs.noisy.empty()) return;
  PictureNotes noisy = notes;
  std::erase_if(noisy.metadata, [](const auto& entry) { return entry.first == "twinray:denoiser"; });
  write_color(outputs.noisy, arguments, mean, noisy);
}

ByteImage rate_image(const RenderArguments& arguments, const Film& film) {
  const std::uint32_t most = arguments.render.samples;
  return is_cs184(arguments) ? cs184_rate_image(film, most) : sample_rate_image(film, most);
}

/// Costs as colours with their legend; linear formats keep the numbers.
void write_costs(const RenderOutputs& outputs, const Film& film, const PictureNotes& notes) {
  const Image costs = mean_image(film);
  const std::uint32_t end = scale_end(costs);
  if (is_linear(output_format(outputs.picture)))
    write_linear(outputs.picture, costs, notes.metadata, notes.frame);
  else
    write_display(outputs.picture, scaled_image(costs, end), notes.metadata);
  if (!outputs.legend.empty())
    write_png(outputs.legend, legend_image(end), metadata_showing("legend", notes));
}

}  // namespace

const char* output_word(const std::string& output) { return is_film_name(output) ? "Film" : "Picture"; }

bool keeps_layers(const std::string& output) {
  return output_format(output) == OutputFormat::exr || is_film_name(output);
}

std::vector<std::string> RenderOutputs::names() const {
  return given_names({picture, film, rates, legend, differences, noisy, statistics, metrics, checkpoint});
}

std::vector<std::string> all_names(std::initializer_list<RenderOutputs> all) {
  std::vector<std::string> names;
  for (const RenderOutputs& outputs : all)
    for (std::string& name : outputs.names()) names.push_back(std::move(name));
  return names;
}

RenderOutputs named_outputs(const RenderArguments& arguments) {
  const std::string& picture = arguments.output;
  RenderOutputs outputs{.statistics = arguments.stats_file,
                        .metrics = arguments.metrics_file,
                        .checkpoint = arguments.checkpoint};
  if (is_film_name(picture)) {
    outputs.film = picture;
    return outputs;
  }
  outputs.picture = picture;
  if (arguments.render.adaptive) outputs.rates = rate_name(arguments);
  if (arguments.integrator == IntegratorKind::cost) outputs.legend = name_beside(picture, "_legend.png");
  if (arguments.check_with) outputs.differences = name_beside(picture, "_differences.png");
  if (arguments.denoiser && !keeps_layers(picture)) outputs.noisy = noisy_name(picture);
  return outputs;
}

RenderOutputs render_outputs(const RenderArguments& arguments) {
  check_replaceable(arguments.checkpoint, "a checkpoint is a file that can be replaced and read again");
  check_replaceable(arguments.metrics_file, "metrics are a file that can be replaced");
  RenderOutputs outputs = named_outputs(arguments);
  if (!outputs.film.empty()) return outputs;
  check_name(arguments);
  if (!arguments.display.ocio_view.empty())
    displayed(Image(1, 1), arguments.display);  // Is there such a view?
  const std::string& picture = outputs.picture;
  if (destination_of(picture).kind == Destination::Kind::file) return outputs;
  for (std::string* name : {&outputs.rates, &outputs.legend, &outputs.differences, &outputs.noisy})
    if (!std::exchange(*name, "").empty())
      console::warn(
          fmt::format("{} is no file: the picture that would stand beside it is not written", picture));
  return outputs;
}

void write_pictures(const RenderOutputs& outputs, const RenderArguments& arguments,
                    const RenderedPicture& rendered, const PictureNotes& notes) {
  const Film& film = rendered.film;
  if (arguments.integrator == IntegratorKind::cost)
    write_costs(outputs, film, notes);
  else
    write_colors(outputs, arguments, rendered, notes);
  if (!outputs.rates.empty())
    write_png(outputs.rates, rate_image(arguments, film), metadata_showing("sample rates", notes));
}

}  // namespace twinray
