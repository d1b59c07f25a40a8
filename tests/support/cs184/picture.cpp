// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cs184/picture.h"

#include <algorithm>
#include <limits>

#include "tests/support/cs184/scene.h"

namespace twinray::test::cs184 {
namespace {

class Renderer {
 public:
  Renderer(const Scene& scene, int width, int height)
      : scene_(scene), width_(width), height_(height), nearest_(std::size_t(width) * std::size_t(height)) {
    place_camera();
    const double h = std::tan(scene.lens.xfov * M_PI / 360), v = std::tan(scene.lens.yfov * M_PI / 360);
    const double half_height = h / v < 4.0 / 3 ? v : h * 3 / 4;
    screen_distance_ = 600 / (2 * half_height);
    std::fill(nearest_.begin(), nearest_.end(), std::numeric_limits<double>::infinity());
    colors_.resize(nearest_.size());
  }

  Picture picture() {
    for (const Face& face : scene_.faces) draw(face);
    for (const Ball& ball : scene_.balls) draw(ball);
    Picture result{width_, height_, {}, {}};
    for (int y = height_ - 1; y >= 0; --y)
      for (int x = 0; x < width_; ++x) {
        const std::size_t i = index(x, y);
        const P n = colors_[i];
        const bool hit = std::isfinite(nearest_[i]);
        result.is_hit.push_back(hit);
        if (hit)
          result.pixels.push_back({tone(0.5 * n.x + 0.5), tone(0.5 * n.y + 0.5), tone(0.5 * n.z + 0.5)});
        else
          result.pixels.push_back({0, 0, 0});
      }
    return result;
  }

 private:
  std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(width_) + std::size_t(x); }

  void place_camera() {
    const P c = scene_.view;
    const P target = (scene_.lower + scene_.upper) * 0.5;
    const double canonical = 1.5 * norm(scene_.upper - scene_.lower) / 2, r = 2 * canonical;
    double phi = std::acos(c.y);
    const double theta = std::atan2(c.x, c.z);
    if (std::sin(phi) == 0) phi += 1e-5f;
    const P offset = P{std::sin(phi) * std::sin(theta), std::cos(phi), std::sin(phi) * std::cos(theta)} * r;
    position_ = target + offset;
    x_ = unit(cross({0, std::sin(phi) > 0 ? 1.0 : -1.0, 0}, offset));
    y_ = unit(cross(offset, x_));
    z_ = unit(offset);
  }

  static std::uint8_t tone(double value) {
    const double v = std::pow(value * double(1.41421356f), double(1 / 2.2f));
    return std::uint8_t(255 * float(std::clamp(std::isnan(v) ? 0 : v, 0.0, 1.0)));
  }

  /// Through the centre of a pixel, counted from the bottom left.
  P direction(int x, int y) const {
    const double a = (2 * (x + 0.5) / width_ - 1) * width_ / (2 * screen_distance_);
    const double b = (2 * (y + 0.5) / height_ - 1) * height_ / (2 * screen_distance_);
    return unit(x_ * a + y_ * b - z_);
  }

  void keep(std::size_t pixel, double t, P normal) {
    if (!(t >= scene_.lens.near && t <= scene_.lens.far && t < nearest_[pixel])) return;
    nearest_[pixel] = t;
    colors_[pixel] = normal;
  }

  void draw(const Face& face) {
    double low_x = 0, low_y = 0, high_x = width_ - 1, high_y = height_ - 1;
    double left = 1e9, bottom = 1e9, right = -1e9, top = -1e9;
    bool in_front = true;
    for (const P& p : face.position) {
      const P d = p - position_;
      const double depth = -dot(d, z_);
      in_front = in_front && depth > 1e-6;
      const double px = dot(d, x_) / depth * screen_distance_ + 0.5 * width_;
      const double py = dot(d, y_) / depth * screen_distance_ + 0.5 * height_;
      left = std::min(left, px), right = std::max(right, px);
      bottom = std::min(bottom, py), top = std::max(top, py);
    }
    if (in_front) {
      low_x = std::max(low_x, left - 2), high_x = std::min(high_x, right + 2);
      low_y = std::max(low_y, bottom - 2), high_y = std::min(high_y, top + 2);
    }
    for (int y = int(low_y); y <= high_y; ++y)
      for (int x = int(low_x); x <= high_x; ++x) meet(face, index(x, y), direction(x, y));
  }

  void meet(const Face& face, std::size_t pixel, P d) {
    const P e1 = face.position[1] - face.position[0], e2 = face.position[2] - face.position[0];
    const P q = cross(d, e2);
    const double det = dot(e1, q);
    if (det == 0) return;
    const P s = position_ - face.position[0];
    const double u = dot(s, q) / det;
    const P r = cross(s, e1);
    const double v = dot(d, r) / det;
    if (u < 0 || v < 0 || u + v > 1) return;
    keep(pixel, dot(e2, r) / det, face.normal[0] * (1 - u - v) + face.normal[1] * u + face.normal[2] * v);
  }

  void draw(const Ball& ball) {
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) {
        const P d = direction(x, y), o = position_ - ball.center;
        const double b = dot(o, d), disc = b * b - dot(o, o) + ball.radius * ball.radius;
        if (disc < 0) continue;
        const double t1 = -b - std::sqrt(disc), t2 = -b + std::sqrt(disc);
        const double t = t1 >= scene_.lens.near ? t1 : t2;
        keep(index(x, y), t, unit(o + d * t));
      }
  }

  const Scene& scene_;
  int width_, height_;
  P position_, x_, y_, z_;
  double screen_distance_ = 1;
  std::vector<double> nearest_;
  std::vector<P> colors_;
};

}  // namespace

Picture normals_picture(const std::string& collada, int width, int height) {
  const Scene scene = read_scene(collada);
  return Renderer(scene, width, height).picture();
}

}  // namespace twinray::test::cs184
