#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "core/curve/polyline.h"
#include "core/intent/solve.h"
#include "tests/support/models/test_rigs.h"

namespace penpose::tests {

using Line = std::vector<geometry::PxPoint>;
using Points = std::vector<posing::CurvePoint>;

/// A bulged sheet of 41 x 41 vertices over -1..1 x -1..1, seen from the front, with the controls that a test asks for.
struct Face {
  static constexpr std::uint32_t k_side = 41;

  std::shared_ptr<const mesh::TriangleMesh> mesh;
  std::vector<rig::BlendShape> shapes;
  std::shared_ptr<const rig::CharacterRig> rig;
  geometry::Camera front;
  double size;

  explicit Face(double unit = 1)
      : front(geometry::Camera::make({{0, 0, 5 * unit}, {0, 0, 0}, {0, 1, 0}, 30}, {1000, 1000}).value()), size(unit) {
    mesh::MeshSource source;
    for (std::uint32_t r = 0; r < k_side; ++r) {
      for (std::uint32_t c = 0; c < k_side; ++c) {
        const double x = -1.0 + 2.0 * c / (k_side - 1);
        const double y = -1.0 + 2.0 * r / (k_side - 1);
        source.positions.emplace_back(x * unit, y * unit, 0.2 * (1 - x * x - y * y) * unit);
      }
    }
    for (std::uint32_t r = 0; r + 1 < k_side; ++r) {
      for (std::uint32_t c = 0; c + 1 < k_side; ++c) {
        const std::uint32_t i = r * k_side + c;
        source.triangles.push_back({i, i + 1, i + k_side + 1});
        source.triangles.push_back({i, i + k_side + 1, i + k_side});
      }
    }
    mesh = mesh::TriangleMesh::build(std::move(source)).value();
  }

  /// A control that moves each vertex by `way` of its place (x and y of a face of size one).
  template <typename Way>
  Face& control(const std::string& name, Way way, double minimum = 0, double maximum = 1) {
    rig::BlendShape shape;
    shape.parameter = {name, 0, minimum, maximum};
    for (std::uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      const geometry::ModelVector d = way(mesh->positions()[v].x / size, mesh->positions()[v].y / size);
      if (d == geometry::ModelVector{0}) continue;
      shape.vertices.push_back(v);
      shape.deltas.emplace_back(d * size);
    }
    shapes.push_back(std::move(shape));
    return *this;
  }
  /// A smooth bump about a place.
  Face& bump(const std::string& name, double x, double y, geometry::ModelVector way, double reach = 0.35,
             double minimum = 0) {
    return control(
        name,
        [=](double px, double py) {
          const double d = ((px - x) * (px - x) + (py - y) * (py - y)) / (reach * reach);
          return d >= 1 ? geometry::ModelVector{0} : way * ((1 - d) * (1 - d));
        },
        minimum);
  }
  /// A control that does what others do, each times a factor.
  Face& sum(const char* name, const std::vector<std::pair<std::size_t, double>>& parts) {
    std::vector<geometry::ModelVector> ways(mesh->vertex_count(), geometry::ModelVector{0});
    for (const auto& [number, by] : parts) {
      const rig::BlendShape& one = shapes[number];
      for (std::size_t i = 0; i < one.vertices.size(); ++i)
        ways[one.vertices[i]] += geometry::ModelVector(one.deltas[i]) * by;
    }
    std::uint32_t v = 0;
    return control(name, [&](double, double) { return ways[v++]; });
  }
  Face& ready(std::shared_ptr<const rig::Skeleton> skeleton = nullptr) {
    rig =
        rig::CharacterRig::make(mesh, {rig::BlendShapes::make(shapes, mesh->vertex_count()).value()}, skeleton).value();
    return *this;
  }

  [[nodiscard]] static Points row(std::uint32_t r, std::uint32_t from, std::uint32_t to) {
    Points points;
    for (std::uint32_t c = from; c <= to; ++c) points.push_back(posing::at_vertex(r * k_side + c));
    return points;
  }
  /// The line of the mouth, y = -0.4, from x = -0.4 to 0.4: some 300 px.
  [[nodiscard]] static Points mouth() { return row(12, 12, 28); }
  /// y = 0.5, x = -0.65 to -0.15, and its mirror image: some 190 px each.
  [[nodiscard]] static Points left_brow() { return row(30, 7, 17); }
  [[nodiscard]] static Points right_brow() { return row(30, 23, 33); }

  [[nodiscard]] std::size_t number(const std::string& name) const {
    return rig::find_parameter(rig->parameters(), name).value();
  }
  [[nodiscard]] rig::Pose pose(const std::vector<std::pair<std::string, double>>& values) const {
    rig::Pose pose = rig::rest_pose(*rig);
    for (const auto& [name, value] : values) pose[number(name)] = value;
    return pose;
  }
  [[nodiscard]] std::vector<geometry::ModelPoint> at(const Points& points, const rig::Pose& pose) const {
    const auto all = all_positions(*rig, pose);
    std::vector<geometry::ModelPoint> out;
    for (const auto& p : points) out.push_back(all[p.vertex[0]]);
    return out;
  }
  [[nodiscard]] Line seen(const Points& points, const rig::Pose& pose, const geometry::Camera& camera) const {
    Line line;
    for (const auto& p : at(points, pose)) line.push_back(camera.project(p).value());
    return line;
  }
  [[nodiscard]] Line seen(const Points& points, const rig::Pose& pose) const { return seen(points, pose, front); }
  [[nodiscard]] intent::DrawnCurve drawn(const Points& points, const Line& line) const {
    return {points, front, line, intent::k_doubt_px, {}};
  }
  /// Everything may move, from rest.
  [[nodiscard]] intent::IntentProblem problem(std::vector<intent::DrawnCurve> curves) const {
    intent::IntentProblem problem;
    problem.drawn = std::move(curves);
    problem.start = rig::rest_pose(*rig);
    problem.free.resize(problem.start.size());
    std::iota(problem.free.begin(), problem.free.end(), std::size_t{0});
    return problem;
  }
  [[nodiscard]] intent::Solution solve(const intent::IntentProblem& problem) const {
    intent::SolveWorkspace work;
    return intent::solve(*rig, intent::measure_whole_model(*rig), problem, {}, work).value();
  }
  /// What a line is read as that was drawn for these points.
  [[nodiscard]] intent::Solution read(const Points& points, const Line& line) const {
    return solve(problem({drawn(points, line)}));
  }
  /// Mean distance of all vertices between two poses, as a share of how far the second lies from rest.
  [[nodiscard]] double error(const rig::Pose& pose, const rig::Pose& truth) const {
    const auto a = all_positions(*rig, pose);
    const auto b = all_positions(*rig, truth);
    const auto rest = all_positions(*rig, rig::rest_pose(*rig));
    double off = 0;
    double way = 0;
    for (std::size_t v = 0; v < a.size(); ++v) {
      off += geometry::distance(a[v], b[v]);
      way += geometry::distance(b[v], rest[v]);
    }
    return off / way;
  }
};

/// A face with the controls that faces have: sides, a jaw that carries the mouth, opposed ones, and one that moves all.
inline Face usual_face(double unit = 1) {
  Face face(unit);
  face.bump("cornerLeft", -0.35, -0.4, {-0.03, 0.2, 0});
  face.bump("cornerRight", 0.35, -0.4, {0.03, 0.2, 0});
  face.bump("browLeft", -0.4, 0.5, {0, 0.15, 0});
  face.bump("browRight", 0.4, 0.5, {0, 0.15, 0});
  face.bump("lipUp", 0, -0.4, {0, 0.15, 0.02});
  const auto below = [](double y) { return y < 0 ? y * y * (1 + y / 2) : 0.0; };
  face.control("jawOpen", [=](double, double y) { return geometry::ModelVector{0, -0.8 * below(y), -0.1 * below(y)}; });
  face.control("jawLeft", [=](double, double y) { return geometry::ModelVector{-2 * below(y), 0, 0}; });
  face.control("jawRight", [=](double, double y) { return geometry::ModelVector{2 * below(y), 0, 0}; });
  face.control("swell", [](double x, double y) { return geometry::ModelVector{0.2 * x, 0.2 * y, 0.2}; });
  return face.ready();
}

/// What an unsteady hand makes of a line: slow waves of `px` root mean square across and along.
inline Line shaken(Line line, double px, std::uint64_t seed) {
  Random random(seed);
  line = curve::resample<geometry::PxPoint>(line, 60).value();
  std::vector<double> x(line.size());
  std::vector<double> y(line.size());
  for (int wave = 1; wave <= 6; ++wave) {
    for (auto* axis : {&x, &y}) {
      const double phase = random(0, 6.28);
      const double size = px / std::sqrt(3.0);
      for (std::size_t i = 0; i < line.size(); ++i)
        (*axis)[i] += size * std::sin(phase + 3.14 * wave * static_cast<double>(i) / 59.0);
    }
  }
  for (std::size_t i = 0; i < line.size(); ++i) line[i] = line[i] + geometry::PxPoint{x[i], y[i]};
  return line;
}

/// A part of a line; beyond 0..1 it runs straight on.
inline Line part(const Line& line, double from, double to, std::size_t count = 60) {
  std::vector<double> shares;
  for (std::size_t i = 0; i < count; ++i)
    shares.push_back(
        std::clamp(from + (to - from) * static_cast<double>(i) / static_cast<double>(count - 1), 0.0, 1.0));
  Line out = curve::resample_at<geometry::PxPoint>(line, shares).value();
  const double length = curve::arc_length<geometry::PxPoint>(line);
  const auto onward = [&](geometry::PxPoint end, geometry::PxPoint before, double share) {
    const geometry::PxPoint d = end - before;
    return end + d * (share * length / geometry::distance(d, {}));
  };
  if (from < 0) out.insert(out.begin(), onward(line[0], line[1], -from));
  if (to > 1) out.push_back(onward(line[line.size() - 1], line[line.size() - 2], to - 1));
  return out;
}

inline Line backwards(Line line) {
  std::reverse(line.begin(), line.end());
  return line;
}

/// 1 at no distance, smooth to 0 at 0.25.
inline double fade(double distance) {
  return std::abs(distance) < 0.25 ? std::pow(1 - std::pow(distance / 0.25, 2), 2) : 0.0;
}

/// Brows, a lip, its corners where wanted, and a smile that lifts the whole mouth, its corners more.
inline Face smiling_face(bool with_corners) {
  Face face;
  face.bump("browLeft", -0.4, 0.5, {0, 0.15, 0});
  face.bump("browRight", 0.4, 0.5, {0, 0.15, 0});
  face.bump("lipUp", 0, -0.4, {0, 0.15, 0.02});
  if (with_corners) {
    face.bump("cornerLeft", -0.4, -0.4, {0, 0.12, 0});
    face.bump("cornerRight", 0.4, -0.4, {0, 0.12, 0});
  }
  face.control("smile", [](double x, double y) {
    return geometry::ModelVector{0, (0.06 + x * x) * fade(y + 0.4) * (std::abs(x) < 0.6 ? 1.0 : 0.0), 0};
  });
  face.ready();
  return face;
}

}  // namespace penpose::tests
