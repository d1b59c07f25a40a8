// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cs184/scene.h"

#include <algorithm>
#include <map>
#include <set>

#include "tests/support/cs184/xml.h"

namespace twinray::test::cs184 {
namespace {

using Polygon = std::vector<int>;

/// The faces around a vertex by the vertex that follows it: at[v][n] is the vertex before v in that face.
using Turns = std::vector<std::map<int, int>>;

/// Whether the polygons form an oriented manifold; fills in the turns.
bool is_manifold(const std::vector<Polygon>& polygons, Turns& turns) {
  for (const Polygon& polygon : polygons)
    for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
      const int v = polygon[i];
      if (std::count(polygon.begin(), polygon.end(), v) != 1) return false;
      if (!turns[std::size_t(v)].emplace(polygon[(i + 1) % n], polygon[(i + n - 1) % n]).second) return false;
    }
  for (const auto& turn : turns) {
    if (turn.empty()) continue;
    std::set<int> before;
    for (const auto& [next, previous] : turn) before.insert(previous);
    int at = turn.begin()->first, seen = 0;
    for (const auto& [next, previous] : turn)
      if (!before.count(next)) at = next;
    const int first = at;
    for (auto found = turn.find(at); found != turn.end(); found = turn.find(at)) {
      ++seen;
      at = found->second;
      if (at == first) break;
    }
    if (seen != int(turn.size())) return false;
  }
  return true;
}

P flat_sum(int v, const std::vector<const Polygon*>& polygons, const std::vector<P>& points) {
  P sum;
  for (const Polygon* each : polygons) {
    const Polygon& polygon = *each;
    const auto at = std::find(polygon.begin(), polygon.end(), v);
    const std::size_t i = std::size_t(at - polygon.begin()), n = polygon.size();
    const P a = points[std::size_t(v)];
    sum = sum +
          cross(points[std::size_t(polygon[(i + 1) % n])] - a, points[std::size_t(polygon[(i + 2) % n])] - a);
  }
  return sum;
}

std::vector<P> vertex_normals(const std::vector<Polygon>& polygons, const std::vector<P>& points) {
  Turns turns(points.size());
  const bool manifold = is_manifold(polygons, turns);
  std::vector<std::vector<const Polygon*>> around(points.size());
  for (const Polygon& polygon : polygons)
    for (const int v : std::set<int>(polygon.begin(), polygon.end()))
      around[std::size_t(v)].push_back(&polygon);
  std::vector<P> normals(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    P n = flat_sum(int(v), around[v], points);
    for (std::size_t i = 0; manifold && i < around[v].size(); ++i) {
      const Polygon& polygon = *around[v][i];
      const auto at = std::find(polygon.begin(), polygon.end(), int(v));
      const int w = at == polygon.begin() ? polygon.back() : *(at - 1);
      if (turns[v].count(w)) continue;  // some face has the edge from v to w
      std::set<int> neighbours;
      for (const auto& [next, previous] : turns[std::size_t(w)]) neighbours.insert({next, previous});
      P sum;
      for (const int k : neighbours) sum = sum + (points[std::size_t(k)] - points[v]);
      n = cross(points[std::size_t(w)] - points[v], sum);
      break;
    }
    normals[v] = unit(n);
  }
  return normals;
}

class SceneReader {
 public:
  explicit SceneReader(const Element& root) {
    index(root);
    const Element* axis = root.at({"asset", "up_axis"});
    Matrix up;
    if (axis && axis->text.find("Z_UP") != std::string::npos)
      up = {{{-1, 0, 0, 0}, {0, 0, 1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1}}};
    if (axis && axis->text.find("X_UP") != std::string::npos)
      up = {{{0, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, -1, 0}, {0, 0, 0, 1}}};
    for (const auto& node : by_url(*root.at({"scene", "instance_visual_scene"})).children)
      if (node->name == "node") visit(*node, up);
  }

  Scene scene;

 private:
  void index(const Element& element) {
    if (element.attributes.count("id")) ids_.emplace(element.attributes.at("id"), &element);
    for (const auto& each : element.children) index(*each);
  }
  const Element& by_url(const Element& from, const char* attribute = "url") const {
    return *ids_.at(from.attributes.at(attribute).substr(1));
  }
  void extend(P p) {
    P &low = scene.lower, &high = scene.upper;
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }

  /// Rodrigues' formula, column by column.
  static Matrix rotation(const std::vector<double>& v) {
    const P axis = unit({v[0], v[1], v[2]});
    const double s = std::sin(v[3] * M_PI / 180), c = std::cos(v[3] * M_PI / 180);
    Matrix result;
    for (int j = 0; j < 3; ++j) {
      const P e{double(j == 0), double(j == 1), double(j == 2)};
      const P turned = e * c + cross(axis, e) * s + axis * (dot(axis, e) * (1 - c));
      result.m[0][j] = turned.x, result.m[1][j] = turned.y, result.m[2][j] = turned.z;
    }
    return result;
  }

  static Matrix transform_of(const Element& node) {
    Matrix result;
    for (const auto& each : node.children) {
      Matrix next;
      if (each->name == "matrix") {
        std::vector<double> v = numbers(*each);
        v.resize(16);
        for (int i = 0; i < 16; ++i) next.m[i / 4][i % 4] = v[std::size_t(i)];
        return result * next;
      }
      if (each->name == "translate")
        for (int i = 0; i < 3; ++i) next.m[i][3] = numbers(*each)[std::size_t(i)];
      if (each->name == "scale")
        for (int i = 0; i < 3; ++i) next.m[i][i] = numbers(*each)[std::size_t(i)];
      if (each->name == "rotate") next = rotation(numbers(*each));
      result = result * next;
    }
    return result;
  }

  void visit(const Element& node, const Matrix& parent) {
    const Matrix matrix = parent * transform_of(node);
    for (const auto& each : node.children)
      if (each->name == "node") visit(*each, matrix);
    if (const Element* camera = node.child("instance_camera"))
      read_camera(by_url(*camera), matrix);
    else if (const Element* geometry =
                 node.child("instance_light") ? nullptr : node.child("instance_geometry"))
      read_geometry(by_url(*geometry), matrix);
  }

  void read_camera(const Element& camera, const Matrix& matrix) {
    const Element& perspective = *camera.at({"optics", "technique_common", "perspective"});
    const auto value = [&](const char* name, double missing) {
      const Element* element = perspective.child(name);
      return element ? double(float(numbers(*element)[0])) : missing;
    };
    scene.lens.xfov = value("xfov", 50);
    const double half = std::tan(scene.lens.xfov * M_PI / 360) / value("aspect_ratio", 1e9);
    scene.lens.yfov = value("yfov", 360 / M_PI * std::atan(half));
    scene.lens.near = value("znear", 0.001);
    scene.lens.far = value("zfar", 1000);
    scene.view = unit(matrix.times({0, 0, -1}, 1));
  }

  void read_geometry(const Element& geometry, const Matrix& matrix) {
    if (const Element* mesh = geometry.child("mesh")) return read_mesh(*mesh, matrix);
    const Element* extra = geometry.child("extra");
    const Element* radius = extra ? extra->at({"technique", "sphere", "radius"}) : nullptr;
    if (!radius) return;
    const Ball ball{matrix.times({}, 1), float(numbers(*radius)[0]) * norm(matrix.times({1, 0, 0}, 0))};
    const P r{ball.radius, ball.radius, ball.radius};
    extend(ball.center - r);
    extend(ball.center + r);
    scene.balls.push_back(ball);
  }

  void read_mesh(const Element& mesh, const Matrix& matrix) {
    const Element* list = mesh.child("polylist") ? mesh.child("polylist") : mesh.child("triangles");
    std::set<std::string> semantics;
    int vertex_offset = 0;
    for (const auto& input : list->children) {
      if (input->name != "input") continue;
      const std::string& semantic = input->attributes.at("semantic");
      semantics.insert(semantic);
      if (semantic == "VERTEX") vertex_offset = std::atoi(input->attributes.at("offset").c_str());
    }
    std::vector<P> points = read_points(mesh, matrix);
    const std::vector<double> indices = numbers(*list->child("p"));
    std::vector<double> counts(indices.size() / semantics.size() / 3, 3);
    if (list->child("vcount")) counts = numbers(*list->child("vcount"));
    std::vector<Polygon> polygons;
    std::size_t at = std::size_t(vertex_offset);
    for (const double count : counts) {
      Polygon& polygon = polygons.emplace_back();
      for (int i = 0; i < int(count); ++i, at += semantics.size()) polygon.push_back(int(indices[at]));
    }
    add_faces(polygons, points);
  }

  std::vector<P> read_points(const Element& mesh, const Matrix& matrix) {
    const Element* position = nullptr;
    for (const auto& input : mesh.child("vertices")->children)
      if (input->attributes["semantic"] == "POSITION") position = &by_url(*input, "source");
    const std::vector<double> values = numbers(*position->child("float_array"));
    std::vector<P> points;
    for (std::size_t i = 0; i + 2 < values.size(); i += 3)
      points.push_back(matrix.times({float(values[i]), float(values[i + 1]), float(values[i + 2])}, 1));
    return points;
  }

  void add_faces(const std::vector<Polygon>& polygons, const std::vector<P>& points) {
    const std::vector<P> normals = vertex_normals(polygons, points);
    for (const Polygon& polygon : polygons) {
      for (const int v : polygon) extend(points[std::size_t(v)]);
      Face face;
      const int kept[3] = {polygon.back(), polygon[0], polygon[1]};
      for (int i = 0; i < 3; ++i) {
        face.position[i] = points[std::size_t(kept[i])];
        face.normal[i] = normals[std::size_t(kept[i])];
      }
      scene.faces.push_back(face);
    }
  }

  std::map<std::string, const Element*> ids_;
};

}  // namespace

Scene read_scene(const std::string& collada) { return SceneReader(Xml(collada).root()).scene; }

}  // namespace twinray::test::cs184
