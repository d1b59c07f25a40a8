// SPDX-License-Identifier: Apache-2.0
#include "cli/study/page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "cli/version.h"
#include "io/html/page.h"
#include "io/html/picture_address.h"
#include "io/machine.h"
#include "io/picture/image_file.h"

namespace twinray::study {
namespace {

/// Below this width a picture is shown by its pixels, sharp.
constexpr int fine_width = 300;

/// Linear pictures, each read once.
class LinearPictures {
 public:
  explicit LinearPictures(const PictureFolder& pictures) : pictures_(pictures) {}
  const Image& of(const Picture& picture) {
    const auto [entry, is_new] = all_.try_emplace(picture.name);
    if (is_new) entry->second = read_image(pictures_.file(picture, ".exr"));
    return entry->second;
  }

 private:
  const PictureFolder& pictures_;
  std::map<std::string, Image> all_;
};

std::vector<Result> results_of(const Section& section, const PictureFolder& pictures) {
  LinearPictures linear(pictures);
  std::vector<Result> results;
  for (const Figure& figure : section.figures) {
    Result result{&figure, pictures.finished(figure.picture), std::nullopt};
    if (result.record && figure.converged && pictures.finished(*figure.converged))
      result.error = shown_error(linear.of(figure.picture), linear.of(*figure.converged));
    results.push_back(std::move(result));
  }
  return results;
}

std::string image_html(const std::string& path, const std::string& words, const Scale& scale) {
  return fmt::format("<img{} width=\"{}\" height=\"{}\" alt=\"{}\" src=\"{}\">",
                     scale.width < fine_width ? " class=\"fine\"" : "", scale.width, scale.height,
                     html::escaped(words), html::picture_address(path));
}

std::string measured_html(const Result& result) {
  const Record& record = *result.record;
  std::vector<std::pair<std::string, std::string>> rows{
      {"render", seconds_text(record.render_seconds)},
      {"build", fmt::format("{}, {}", seconds_text(record.build_seconds), record.engine)},
      {"rays", count_text(double(record.rays))},
      {"rays per second", count_text(rays_per_second(record))},
      {"tests per ray", tests_text(record.tests_per_ray)}};
  if (result.error) rows.emplace_back("error", error_text(result.error));
  std::string html;
  for (const auto& [name, value] : rows)
    html += fmt::format("<dt>{}</dt><dd>{}</dd>", name, html::escaped(value));
  return fmt::format("<dl class=\"measured\">{}</dl>", html);
}

std::string figure_html(const Result& result, const Study& study) {
  const Figure& figure = *result.figure;
  const std::string words = fmt::format("{}: {}", figure.group, figure.label);
  std::string body = fmt::format("<figcaption>{}</figcaption>", html::whole_words(words));
  if (!result.record) return fmt::format("<figure>{}<p>Not made yet.</p></figure>\n", body);
  std::string images = image_html(study.pictures.file(figure.picture, ".png"), words, study.scale);
  if (!figure.picture.adaptive.empty())
    images +=
        image_html(study.pictures.file(figure.picture, "_rate.png"), words + ", sample rates", study.scale);
  return fmt::format("<figure>{}{}{}{}</figure>\n", images, body, command_html(result.record->command),
                     measured_html(result));
}

/// The pictures in rows; a group of several begins a row of its own.
std::string gallery_html(const std::vector<Result>& results, const Study& study) {
  std::string html, group;
  std::size_t in_row = 0;
  for (const Result& result : results) {
    if (!result.figure->is_pictured) continue;
    if (in_row == 0 || (in_row > 1 && result.figure->group != group)) {
      html += in_row == 0 ? "<div class=\"pictures\">\n" : "</div>\n<div class=\"pictures\">\n";
      in_row = 0;
    }
    in_row = result.figure->group == group || in_row == 0 ? in_row + 1 : 1;
    group = result.figure->group;
    html += figure_html(result, study);
  }
  return html + "</div>\n";
}

std::string section_html(const Section& section, const Study& study) {
  const std::vector<Result> results = results_of(section, study.pictures);
  std::string html = fmt::format("<h3>{}</h3>\n<p>{}</p>\n", html::escaped(section.title), section.text);
  if (results.empty()) return html + "<p>None of its scenes is in the folder.</p>\n";
  return html + gallery_html(results, study) + comparison_table(section, results) +
         error_plot(section, results);
}

std::string notes_html(const std::string& notes) {
  return notes.empty() ? "" : fmt::format("<div class=\"notes\">\n{}</div>\n", notes);
}

std::string part_html(const Part& part, const Study& study) {
  std::string html = fmt::format("<section id=\"part{}\">\n<h2>Part {}: {}</h2>\n", part.number, part.number,
                                 html::escaped(part.title));
  html += notes_html(study.notes.parts[std::size_t(part.number - 1)]);
  if (!part.missing.empty())
    html += fmt::format("<p class=\"missing\">Not in the folder: {}.</p>\n",
                        html::escaped(fmt::format("{}", fmt::join(part.missing, ", "))));
  for (const Section& section : part.sections) html += section_html(section, study);
  return html + "</section>\n";
}

std::string contents_html(const std::vector<Part>& parts) {
  std::string html = "<nav>";
  for (const Part& part : parts)
    html += fmt::format("<a href=\"#part{0}\">Part {0}: {1}</a>", part.number, html::escaped(part.title));
  return html + "</nav>\n";
}

std::string unreadable_html(const SceneFolder& folder) {
  if (folder.unreadable.empty()) return "";
  std::string html = "<div class=\"missing\">These scenes cannot be read:\n";
  for (const UnreadableScene& scene : folder.unreadable)
    html += fmt::format("<pre>{}</pre>\n", html::escaped(scene.reason));
  return html + "</div>\n";
}

std::string introduction(const Study& study) {
  auto facts = describe_machine();
  std::erase_if(facts, [](const auto& fact) { return fact.second == "unknown"; });
  facts.insert(facts.begin(),
               {{"program", version_name()},
                {"scenes", fmt::format("{} in {}", study.folder.scenes.size(), study.folder.path)},
                {"scale", fmt::format("{}: {} x {} pixels", study.scale.name, study.scale.width,
                                      study.scale.height)}});
  return html::facts(facts) +
         "<p>Beside every picture stand the command that makes it and what it took. <b>Render</b> is the "
         "wall-clock time of the sampling, <b>build</b> that of the ray engine, whose name follows. <b>Tests "
         "per ray</b> are primitives that a ray is tested against; they are counted in a smaller picture by "
         "the same command, in the binary tree unless the command names another engine, for counting takes "
         "time. An <b>error</b> is the root mean square difference in luminance, up to white, from a "
         "converged "
         "picture of another seed, over its mean.</p>\n";
}

Image clipped(Image image) {
  for (Rgb& pixel : image.pixels)
    pixel = {std::min(pixel.r, 1.0f), std::min(pixel.g, 1.0f), std::min(pixel.b, 1.0f)};
  return image;
}

}  // namespace

ImageError shown_error(const Image& image, const Image& converged) {
  return {image_error(clipped(image), clipped(converged)).relative, image_error(image, converged).brightness};
}

std::string study_page(const Study& study) {
  std::string body = introduction(study) + unreadable_html(study.folder) + contents_html(study.parts);
  body += notes_html(study.notes.head);
  for (const Part& part : study.parts) body += part_html(part, study);
  return html::page("Path tracing: a study", body + notes_html(study.notes.end));
}

}  // namespace twinray::study
