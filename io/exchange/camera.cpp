// SPDX-License-Identifier: Apache-2.0
#include "io/exchange/camera.h"

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace twinray {
namespace {

void read_lens_system(const Entry& entry, Camera& camera) {
  if (camera.projection != Projection::perspective || camera.lens_radius != 0)
    entry.fail("goes with a \"perspective\" camera whose \"lens_radius\" is 0");
  std::vector<LensSurface> surfaces;
  entry.for_each("surfaces", [&](const Entry& each) {
    const auto number = [&](const char* key) { return each.real(key, each.at(key)); };
    surfaces.push_back(
        {number("curvature_radius"), number("thickness"), number("ior"), number("aperture_radius")});
  });
  const double film_radius = entry.real("film_radius", entry.at("film_radius"));
  at_place(entry.place(),
           [&] { camera.lenses = std::make_shared<const LensSystem>(std::move(surfaces), film_radius); });
}

void read_aperture(const Entry& entry, Camera& camera) {
  camera.aperture_blades = int(entry.whole("blades", entry.at("blades"), 3, 1000));
  const MemberReader visit(entry);
  visit("turns", camera.aperture_turns, Valid::part);
}

/// A camera whose frame, fitted to the picture, is that of the file to the bit: of its sides the
/// one that fit_frame() made of the other is a bit short.
void set_frame(const RenderDefaults::Resolution& size, Camera& camera) {
  const float aspect = float(size.width) / float(size.height);
  if (camera.tan_half_width == camera.tan_half_height * aspect)
    camera.tan_half_width = std::nextafter(camera.tan_half_width, 0.0f);
  else if (camera.tan_half_height == camera.tan_half_width / aspect)
    camera.tan_half_height = std::nextafter(camera.tan_half_height, 0.0f);
  else
    camera.is_stretched = true;
}

Json lens_system_json(const LensSystem& lens) {
  Json surfaces = Json::array();
  for (const LensSurface& surface : lens.surfaces())
    surfaces.push_back({{"curvature_radius", surface.curvature_radius},
                        {"thickness", surface.thickness},
                        {"ior", surface.ior},
                        {"aperture_radius", surface.aperture_radius}});
  return {{"film_radius", lens.film_radius()}, {"surfaces", std::move(surfaces)}};
}

}  // namespace

Json exchange_camera_json(const Camera& camera) {
  const bool is_at_distance = camera.projection == Projection::perspective;
  Json json{{"type", projection_name(camera.projection)},
            {"position", json_of(camera.position)},
            {"right", json_of(camera.right)},
            {"up", json_of(camera.up)},
            {"forward", json_of(camera.forward)},
            {is_at_distance ? "tan_half_width" : "half_width", json_of(camera.tan_half_width)},
            {is_at_distance ? "tan_half_height" : "half_height", json_of(camera.tan_half_height)},
            {"lens_radius", json_of(camera.lens_radius)},
            {"focal_distance", json_of(camera.focal_distance)},
            {"clip_near", json_of(camera.clip_near)}};
  if (camera.frame_center != Vec2{0, 0}) json["frame_center"] = json_of(camera.frame_center);
  if (camera.aperture_blades > 0)
    json["aperture"] = {{"blades", camera.aperture_blades}, {"turns", json_of(camera.aperture_turns)}};
  if (camera.lenses) json["lens_system"] = lens_system_json(*camera.lenses);
  if (std::isfinite(camera.clip_far)) json["clip_far"] = json_of(camera.clip_far);
  json["clip_along"] = camera.clips_by_distance || is_panorama(camera.projection) ? "ray" : "forward";
  return json;
}

Camera read_exchange_camera(const Entry& entry, const RenderDefaults::Resolution& size) {
  const MemberReader visit(entry);
  Camera camera;
  std::vector<std::pair<std::string, Projection>> projections;
  for (const Projection each : {Projection::perspective, Projection::orthographic,
                                Projection::latitude_longitude, Projection::fisheye, Projection::equal_area})
    projections.emplace_back(projection_name(each), each);
  camera.projection = entry.named("type", projections);
  const bool is_at_distance = camera.projection == Projection::perspective;
  visit("position", camera.position);
  visit.direction("right", camera.right);
  visit.direction("up", camera.up);
  visit.direction("forward", camera.forward);
  if (!is_right_angle(camera.right, camera.up) || !is_right_angle(camera.right, camera.forward) ||
      !is_right_angle(camera.up, camera.forward))
    entry.fail("\"right\", \"up\" and \"forward\" must be at right angles");
  visit(is_at_distance ? "tan_half_width" : "half_width", camera.tan_half_width, Valid::positive);
  visit(is_at_distance ? "tan_half_height" : "half_height", camera.tan_half_height, Valid::positive);
  visit.later("lens_radius", camera.lens_radius, Valid::not_negative);
  visit.later("focal_distance", camera.focal_distance, Valid::positive);
  visit.later("clip_near", camera.clip_near, Valid::not_negative);
  if (entry.has("frame_center")) visit("frame_center", camera.frame_center);
  if (entry.has("aperture"))
    entry.within("aperture", [&](const Entry& aperture) { read_aperture(aperture, camera); });
  if (entry.has("lens_system"))
    entry.within("lens_system", [&](const Entry& lens) { read_lens_system(lens, camera); });
  if (entry.has("clip_far")) visit("clip_far", camera.clip_far, Valid::positive);
  if (camera.clip_far <= camera.clip_near) entry.fail("\"clip_far\" must lie beyond \"clip_near\"");
  camera.clips_by_distance = entry.has("clip_along") &&
                             entry.named<bool>("clip_along", {{"forward", false}, {"ray", true}}) &&
                             !is_panorama(camera.projection);
  set_frame(size, camera);
  return camera;
}

}  // namespace twinray
