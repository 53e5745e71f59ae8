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
constexpr double k_outside = 0.003, k_before = 0.01;
/// Where a contour goes behind something is found to this part of the way between two of its points: 2^-6.
constexpr int k_halvings = 6;
/// Hidden for less than this, share of the model's size, it is drawn on: facets of a coarse surface stand out so far.
constexpr double k_silhouette_gap = 0.006, k_apart_px = 4.0;
/// A ray looks through so many facets beside the contour.
constexpr int k_most_facets = 6;

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

/// Contours of a posed mesh and what hides them.
class ContourWalk {
 public:
  ContourWalk(const geometry::Camera& camera, const mesh::TriangleMesh& mesh, std::span<const ModelPoint> positions,
              const geometry::TriangleBvh& tree, double size, double least_px)
      : camera_(camera),
        mesh_(mesh),
        positions_(positions),
        tree_(tree),
        size_(size),
        least_px_(least_px),
        normals_(normals_of(mesh, positions)),
        facing_(facing_of(camera, mesh, positions, normals_)) {}

  [[nodiscard]] std::vector<std::vector<Edge>> chains() const { return Chains(segments_of(mesh_, facing_)).all(); }

  /// The seen parts of a chain.
  void add(const std::vector<Edge>& chain, std::vector<SurfaceLine>& out) const {
    SurfaceLine points;
    for (const Edge& edge : chain) points.push_back(point_on(edge));
    if (points.size() < 2 || length_px(points) < least_px_) return;
    const bool closed = chain.front() == chain.back();
    std::vector<bool> seen = seen_of(points, chain);
    close_gaps(points, seen);
    if (closed) begin_hidden(points, seen);
    SurfaceLine part;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i > 0 && seen[i] != seen[i - 1]) part.push_back(border(points[i - 1], points[i], seen[i - 1]));
      if (seen[i]) part.push_back(points[i]);
      if (part.size() >= 2 && (!seen[i] || i + 1 == points.size())) out.push_back(ordered(std::move(part)));
      if (!seen[i]) part.clear();
    }
  }
  [[nodiscard]] double length_px(const SurfaceLine& line) const {
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
      const auto a = camera_.project(place_of(line[i - 1], positions_));
      const auto b = camera_.project(place_of(line[i], positions_));
      if (a && b) length += geometry::distance(*a, *b);
    }
    return length;
  }

 private:
  [[nodiscard]] posing::CurvePoint point_on(const Edge& edge) const {
    const double a = std::abs(facing_[edge.first]);
    const double b = std::abs(facing_[edge.second]);
    const double share = a + b > 0.0 ? a / (a + b) : 0.5;
    return {{edge.first, edge.second, 0}, {1.0 - share, share, 0.0}};
  }
  /// What lies before a place hides it, but not the facets beside it. `edge`: of the contour, next to it.
  [[nodiscard]] bool is_seen(const posing::CurvePoint& point, const Edge& edge) const {
    const ModelVector out = geometry::normalized(place_of(point, normals_), ModelVector{0}) * (k_outside * size_);
    const ModelPoint place = place_of(point, positions_) + out;
    if (!camera_.project(place)) return false;
    const ModelVector way = place - camera_.eye();
    const double distance = geometry::length(way);
    const ModelVector direction = geometry::normalized(way);
    double from = 0;
    for (int k = 0; k < k_most_facets; ++k) {
      const auto hit = tree_.nearest_hit({camera_.eye() + direction * from, direction});
      if (!hit || from + hit->distance > distance - k_before * size_) return true;
      if (!beside(hit->triangle, edge)) return false;
      from += hit->distance + 1e-6 * size_;
    }
    return true;
  }
  [[nodiscard]] bool beside(std::uint32_t triangle, const Edge& edge) const {
    const mesh::Triangle& corners = mesh_.triangles()[triangle];
    return std::any_of(corners.begin(), corners.end(), [&](std::uint32_t v) {
      return mesh_.weld()[v] == edge.first || mesh_.weld()[v] == edge.second;
    });
  }
  /// Whether each point is seen. Between two that are k_apart_px apart and alike all others are like them.
  [[nodiscard]] std::vector<bool> seen_of(const SurfaceLine& points, const std::vector<Edge>& chain) const {
    std::vector<bool> seen(points.size());
    seen[0] = is_seen(points[0], chain[0]);
    std::size_t last = 0;
    auto from = camera_.project(place_of(points[0], positions_));
    for (std::size_t i = 1; i < points.size(); ++i) {
      const auto at = camera_.project(place_of(points[i], positions_));
      if (from && at && geometry::distance(*from, *at) < k_apart_px && i + 1 < points.size()) continue;
      seen[i] = is_seen(points[i], chain[i]);
      for (std::size_t k = last + 1; k < i; ++k)
        seen[k] = seen[i] == seen[last] ? seen[i] : is_seen(points[k], chain[k]);
      last = i;
      from = at;
    }
    return seen;
  }
  void close_gaps(const SurfaceLine& points, std::vector<bool>& seen) const {
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      if (seen[i] || !seen[i - 1]) continue;
      double gap = 0;
      std::size_t end = i;
      while (end < points.size() && !seen[end]) {
        gap += geometry::distance(place_of(points[end - 1], positions_), place_of(points[end], positions_));
        ++end;
      }
      if (end == points.size()) return;
      if (gap < k_silhouette_gap * size_)
        std::fill(seen.begin() + static_cast<std::ptrdiff_t>(i), seen.begin() + static_cast<std::ptrdiff_t>(end), true);
    }
  }
  /// A closed line whose beginning is seen begins where it is hidden instead, if it is anywhere.
  static void begin_hidden(SurfaceLine& points, std::vector<bool>& seen) {
    const auto hidden = std::find(seen.begin(), seen.end(), false);
    if (!seen.front() || hidden == seen.end()) return;
    const auto by = hidden - seen.begin();
    points.pop_back();
    seen.pop_back();
    std::rotate(points.begin(), points.begin() + by, points.end());
    std::rotate(seen.begin(), seen.begin() + by, seen.end());
    points.push_back(points.front());
    seen.push_back(seen.front());
  }
  /// Where a line goes behind something between two of its points.
  [[nodiscard]] posing::CurvePoint border(const posing::CurvePoint& from, const posing::CurvePoint& to,
                                          bool from_seen) const {
    double low = 0, high = 1;
    for (int k = 0; k < k_halvings; ++k) {
      const double middle = 0.5 * (low + high);
      const bool seen = is_seen(point_between(from, to, middle), {to.vertex[0], to.vertex[1]});
      (seen == from_seen ? low : high) = middle;
    }
    return point_between(from, to, from_seen ? low : high);
  }
  /// With the side that faces the camera always on the same side of its way in the picture.
  [[nodiscard]] SurfaceLine ordered(SurfaceLine line) const {
    double side = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
      const ModelVector along = place_of(line[i], positions_) - place_of(line[i - 1], positions_);
      const ModelVector outwards = place_of(line[i], normals_);
      side += glm::dot(glm::cross(along, outwards), camera_.forward());
    }
    if (side < 0.0) std::reverse(line.begin(), line.end());
    return line;
  }

  const geometry::Camera& camera_;
  const mesh::TriangleMesh& mesh_;
  std::span<const ModelPoint> positions_;
  const geometry::TriangleBvh& tree_;
  double size_, least_px_;
  std::vector<ModelVector> normals_;
  std::vector<double> facing_;
};

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

posing::CurvePoint point_between(const posing::CurvePoint& from, const posing::CurvePoint& to, double share) {
  posing::CurvePoint out{{0, 0, 0}, {0, 0, 0}};
  std::size_t count = 0;
  const auto add = [&](const posing::CurvePoint& point, double factor) {
    for (std::size_t k = 0; k < point.vertex.size(); ++k) {
      if (point.weight[k] == 0.0) continue;
      std::size_t at = 0;
      while (at < count && out.vertex[at] != point.vertex[k]) ++at;
      if (at == out.vertex.size()) continue;
      out.vertex[at] = point.vertex[k];
      out.weight[at] += factor * point.weight[k];
      count = std::max(count, at + 1);
    }
  };
  add(from, 1.0 - share);
  add(to, share);
  return out;
}

std::vector<SurfaceLine> silhouette(const geometry::Camera& camera, const mesh::TriangleMesh& mesh,
                                    std::span<const ModelPoint> positions, const geometry::TriangleBvh& tree,
                                    double least_px) {
  const ContourWalk walk(camera, mesh, positions, tree, size_of(positions), least_px);
  std::vector<SurfaceLine> lines;
  for (const std::vector<Edge>& chain : walk.chains()) walk.add(chain, lines);
  std::vector<std::pair<double, std::size_t>> lengths;
  for (std::size_t i = 0; i < lines.size(); ++i) lengths.emplace_back(walk.length_px(lines[i]), i);
  std::stable_sort(lengths.begin(), lengths.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<SurfaceLine> sorted;
  for (const auto& [length, i] : lengths) sorted.push_back(std::move(lines[i]));
  return sorted;
}

}  // namespace penpose::portrait
