// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#include <string>
#include <vector>

namespace twinray::test::cs184 {

struct P {
  double x = 0, y = 0, z = 0;
};
inline P operator+(P a, P b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline P operator-(P a, P b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline P operator*(P a, double s) { return {a.x * s, a.y * s, a.z * s}; }
inline double dot(P a, P b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline P cross(P a, P b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double norm(P a) { return std::sqrt(dot(a, a)); }
inline P unit(P a) { return a * (1 / norm(a)); }

struct Matrix {
  double m[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};

  Matrix operator*(const Matrix& b) const {
    Matrix c;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        c.m[i][j] = 0;
        for (int k = 0; k < 4; ++k) c.m[i][j] += m[i][k] * b.m[k][j];
      }
    return c;
  }
  P times(P p, double w) const {
    const auto row = [&](int i) { return m[i][0] * p.x + m[i][1] * p.y + m[i][2] * p.z + m[i][3] * w; };
    return {row(0), row(1), row(2)};
  }
};

struct Face {
  P position[3], normal[3];
};
struct Ball {
  P center;
  double radius;
};

struct Lens {
  double xfov = 50, yfov = 35, near = 0.01, far = 100;
};

/// A scene as CS184's program reads it, in world space.
struct Scene {
  std::vector<Face> faces;
  std::vector<Ball> balls;
  P lower{1e300, 1e300, 1e300}, upper{-1e300, -1e300, -1e300};
  P view;  ///< Towards the point one unit in front of the camera; zero without a camera.
  Lens lens;
};

Scene read_scene(const std::string& collada);

}  // namespace twinray::test::cs184
