#include "core/portrait/silhouette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <utility>

namespace penpose::portrait {
namespace {

using geometry::ModelPoint;
using geometry::ModelVector;

/// Facets hide a contour that is drawn across them, so that places a little outside of it are looked at. What hides
/// them lies this far before them. Shares of the model's size.
constexpr double k_outside = 0.003;
constexpr double k_before = 0.01;

/// An edge, low vertex first.
using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// The way of a contour through one triangle.
struct Segment {
  std::array<Edge, 2> ends;
};

/// Normals of unit length, welded vertices alike.
std::vector<ModelVector> normals_of(const mesh::TriangleMesh& mesh, std::span<const ModelPoint> positions) {
  std::vector<ModelVector> normals(positions.size(), ModelVector{0});
  const auto weld = mesh.weld();
  for (const mesh::Triangle& t : mesh.triangles()) {
    const ModelVector normal = glm::cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]);
    for (const std::uint32_t v : t) normals[weld[v]] += normal;
  }
  for (ModelVector& normal : normals) normal = geometry::normalized(normal, ModelVector{0});
  for (std::size_t v = 0; v < normals.size(); ++v) normals[v] = normals[weld[v]];
  return normals;
}

/// How much each vertex faces the camera. 0 counts as facing it.
std::vector<double> facing_of(const geometry::Camera& camera, const mesh::TriangleMesh& mesh,
                              std::span<const ModelPoint> positions, std::span<const ModelVector> normals) {
  const auto weld = mesh.weld();
  std::vector<double> facing(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    facing[v] = glm::dot(normals[v], camera.eye() - positions[weld[v]]);
  }
  return facing;
}

std::vector<Segment> segments_of(const mesh::TriangleMesh& mesh, const std::vector<double>& facing) {
  std::vector<Segment> segments;
  for (const mesh::Triangle& t : mesh.triangles()) {
    std::array<Edge, 3> crossed;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = mesh.weld()[t[i]];
      const std::uint32_t b = mesh.weld()[t[(i + 1) % 3]];
      if ((facing[a] < 0.0) != (facing[b] < 0.0)) crossed[count++] = {std::min(a, b), std::max(a, b)};
    }
    if (count == 2) segments.push_back({{crossed[0], crossed[1]}});
  }
  return segments;
}

/// Segments joined at their edges, open chains before closed ones.
class Chains {
 public:
  explicit Chains(std::vector<Segment> segments) : segments_(std::move(segments)), used_(segments_.size(), false) {
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      for (const Edge& edge : segments_[s].ends) ends_.emplace_back(edge, s);
    }
    std::stable_sort(ends_.begin(), ends_.end());
    for (std::size_t i = 0; i < ends_.size();) {
      std::size_t end = i + 1;
      while (end < ends_.size() && ends_[end].first == ends_[i].first) ++end;
      if (end == i + 1) add(ends_[i].second, ends_[i].first);
      i = end;
    }
    for (std::size_t s = 0; s < segments_.size(); ++s) add(s, segments_[s].ends[0]);
  }
  [[nodiscard]] const std::vector<std::vector<Edge>>& all() const { return chains_; }

 private:
  void add(std::size_t segment, Edge edge) {
    if (used_[segment]) return;
    auto& chain = chains_.emplace_back();
    chain.push_back(edge);
    for (;;) {
      used_[segment] = true;
      const Segment& s = segments_[segment];
      edge = s.ends[0] == edge ? s.ends[1] : s.ends[0];
      chain.push_back(edge);
      const auto first = std::lower_bound(ends_.begin(), ends_.end(), std::pair<Edge, std::size_t>{edge, 0});
      auto next = first;
      while (next != ends_.end() && next->first == edge && used_[next->second]) ++next;
      if (next == ends_.end() || next->first != edge) return;
      segment = next->second;
    }
  }

  std::vector<Segment> segments_;
  std::vector<bool> used_;
  std::vector<std::pair<Edge, std::size_t>> ends_;  ///< sorted; with the number of the segment
  std::vector<std::vector<Edge>> chains_;
};

bool is_seen(const geometry::Camera& camera, const geometry::TriangleBvh& tree, const ModelPoint& place,
             double before) {
  if (!camera.project(place)) return false;
  const ModelVector way = place - camera.eye();
  const double distance = geometry::length(way);
  const auto hit = tree.nearest_hit({camera.eye(), geometry::normalized(way)});
  return !hit || hit->distance > distance - before;
}

double length_px(const geometry::Camera& camera, const SurfaceLine& line, std::span<const ModelPoint> positions) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const auto a = camera.project(place_of(line[i - 1], positions));
    const auto b = camera.project(place_of(line[i], positions));
    if (a && b) length += geometry::distance(*a, *b);
  }
  return length;
}

double size_of(std::span<const ModelPoint> positions) {
  geometry::Box box;
  for (const ModelPoint& p : positions) box.add(p);
  return box.diagonal();
}

}  // namespace

ModelPoint place_of(const posing::CurvePoint& point, std::span<const ModelPoint> positions) {
  ModelPoint place(0);
  for (std::size_t k = 0; k < point.vertex.size(); ++k) place += positions[point.vertex[k]] * point.weight[k];
  return place;
}

std::vector<SurfaceLine> seen_parts(const geometry::Camera& camera, const SurfaceLine& line,
                                    std::span<const ModelPoint> positions, const geometry::TriangleBvh& tree) {
  const double before = k_before * size_of(positions);
  std::vector<SurfaceLine> parts;
  SurfaceLine part;
  const auto keep = [&] {
    if (part.size() >= 2) parts.push_back(std::move(part));
    part.clear();
  };
  for (const posing::CurvePoint& point : line) {
    if (is_seen(camera, tree, place_of(point, positions), before)) {
      part.push_back(point);
    } else {
      keep();
    }
  }
  keep();
  return parts;
}

std::vector<SurfaceLine> silhouette(const geometry::Camera& camera, const mesh::TriangleMesh& mesh,
                                    std::span<const ModelPoint> positions, const geometry::TriangleBvh& tree) {
  const std::vector<ModelVector> normals = normals_of(mesh, positions);
  const std::vector<double> facing = facing_of(camera, mesh, positions, normals);
  const double size = size_of(positions);
  std::vector<std::pair<double, SurfaceLine>> lines;
  const auto keep = [&](SurfaceLine& line) {
    if (line.size() >= 2) lines.emplace_back(length_px(camera, line, positions), std::move(line));
    line.clear();
  };
  const Chains chains(segments_of(mesh, facing));
  for (const std::vector<Edge>& chain : chains.all()) {
    SurfaceLine line;
    for (const Edge& edge : chain) {
      const double a = std::abs(facing[edge.first]);
      const double b = std::abs(facing[edge.second]);
      const double share = a + b > 0.0 ? a / (a + b) : 0.5;
      const posing::CurvePoint point{{edge.first, edge.second, 0}, {1.0 - share, share, 0.0}};
      const ModelVector out = geometry::normalized(place_of(point, normals), ModelVector{0}) * (k_outside * size);
      if (is_seen(camera, tree, place_of(point, positions) + out, k_before * size)) {
        line.push_back(point);
      } else {
        keep(line);
      }
    }
    keep(line);
  }
  std::stable_sort(lines.begin(), lines.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<SurfaceLine> sorted;
  for (auto& [length, line] : lines) sorted.push_back(std::move(line));
  return sorted;
}

}  // namespace penpose::portrait
