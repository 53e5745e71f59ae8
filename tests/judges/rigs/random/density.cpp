#include "tests/judges/rigs/random/density.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace penpose::judges {
namespace {

constexpr std::uint32_t k_gone = 0xffffffffU;

/// Triangles of which vertices are drawn to their neighbours.
class Thinning {
 public:
  explicit Thinning(const Parts& parts)
      : places_(parts.rest().begin(), parts.rest().end()),
        triangles_(parts.mesh->triangles().begin(), parts.mesh->triangles().end()),
        of_(places_.size()),
        stays_(places_.size(), false),
        gone_(places_.size(), false),
        left_(places_.size()) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        of_[triangles_[t][k]].push_back(t);
        ++edges[std::minmax(triangles_[t][k], triangles_[t][(k + 1) % 3])];
      }
    }
    for (const auto& [edge, count] : edges) {
      if (count != 2) stays_[edge.first] = stays_[edge.second] = true;
    }
    for (const FaceLine& line : parts.lines) {
      for (const std::uint32_t v : line.vertices) stays_[v] = true;
    }
    for (const auto& [side, ball] : parts.eyes) {
      for (const std::uint32_t v : ball) stays_[v] = true;
    }
  }

  /// `share` of the vertices that may go stay.
  void to(double share) {
    const auto may_go = static_cast<double>(std::count(stays_.begin(), stays_.end(), false));
    const std::size_t count = left_ - static_cast<std::size_t>((1 - share) * may_go);
    for (int pass = 0; pass < 8 && left_ > count; ++pass) {
      const std::size_t before = left_;
      for (const auto& [length, from, into] : shortest_first()) {
        if (left_ <= count) break;
        if (!gone_[from] && !gone_[into]) draw_together(from, into);
      }
      if (before - left_ < before / 100) break;
    }
  }
  [[nodiscard]] bool is_gone(std::uint32_t v) const { return gone_[v]; }
  /// Of a triangle of the whole mesh; k_gone of one that has no area any more.
  [[nodiscard]] mesh::Triangle triangle(std::uint32_t t) const { return triangles_[t]; }

 private:
  [[nodiscard]] std::vector<std::tuple<double, std::uint32_t, std::uint32_t>> shortest_first() const {
    std::vector<std::tuple<double, std::uint32_t, std::uint32_t>> edges;
    for (const mesh::Triangle& t : triangles_) {
      if (t[0] == k_gone) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        for (const auto& [from, into] : {std::pair{t[k], t[(k + 1) % 3]}, std::pair{t[(k + 1) % 3], t[k]}}) {
          if (!stays_[from]) edges.emplace_back(geometry::distance(places_[from], places_[into]), from, into);
        }
      }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
  }

  [[nodiscard]] std::vector<std::uint32_t> neighbours(std::uint32_t v) const {
    std::vector<std::uint32_t> all;
    for (const std::uint32_t t : of_[v]) {
      for (const std::uint32_t other : triangles_[t]) {
        if (other != v) all.push_back(other);
      }
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  [[nodiscard]] ModelVector area(const mesh::Triangle& t) const {
    return glm::cross(places_[t[1]] - places_[t[0]], places_[t[2]] - places_[t[0]]);
  }

  /// Unless the surface would fold or lose its form.
  void draw_together(std::uint32_t from, std::uint32_t into) {
    const auto around = neighbours(from);
    const auto beyond = neighbours(into);
    if (!std::binary_search(around.begin(), around.end(), into)) return;
    std::vector<std::uint32_t> common;
    std::set_intersection(around.begin(), around.end(), beyond.begin(), beyond.end(), std::back_inserter(common));
    if (common.size() != 2) return;
    const auto moved = [&](std::uint32_t t) {
      mesh::Triangle triangle = triangles_[t];
      std::replace(triangle.begin(), triangle.end(), from, into);
      return triangle;
    };
    const auto falls = [&](std::uint32_t t) {
      return std::find(triangles_[t].begin(), triangles_[t].end(), into) != triangles_[t].end();
    };
    for (const std::uint32_t t : of_[from]) {
      if (falls(t)) continue;
      const ModelVector before = area(triangles_[t]);
      const ModelVector after = area(moved(t));
      if (glm::dot(before, after) <= 0.5 * geometry::length(before) * geometry::length(after)) return;
    }
    for (const std::uint32_t t : std::vector<std::uint32_t>(of_[from])) {
      if (falls(t)) {
        for (const std::uint32_t v : triangles_[t]) std::erase(of_[v], t);
        triangles_[t] = {k_gone, k_gone, k_gone};
      } else {
        triangles_[t] = moved(t);
        of_[into].push_back(t);
      }
    }
    of_[from].clear();
    gone_[from] = true;
    --left_;
  }

  std::vector<ModelPoint> places_;
  std::vector<mesh::Triangle> triangles_;
  std::vector<std::vector<std::uint32_t>> of_;  ///< triangles of each vertex
  std::vector<bool> stays_, gone_;
  std::size_t left_;
};

}  // namespace

Parts thinned(const Parts& parts, double share) {
  Thinning thin(parts);
  const std::size_t count = parts.rest().size();
  thin.to(share);
  std::vector<std::uint32_t> renumbered(count, k_gone);
  std::vector<std::uint32_t> kept;
  for (std::uint32_t v = 0; v < count; ++v) {
    if (thin.is_gone(v)) continue;
    renumbered[v] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(v);
  }
  mesh::MeshSource source;
  for (const std::uint32_t v : kept) source.positions.push_back(parts.rest()[v]);
  for (const mesh::Part& part : parts.mesh->parts()) {
    mesh::Part own = part;
    own.first_vertex =
        static_cast<std::uint32_t>(std::lower_bound(kept.begin(), kept.end(), part.first_vertex) - kept.begin());
    own.vertex_count =
        static_cast<std::uint32_t>(std::lower_bound(kept.begin(), kept.end(), part.first_vertex + part.vertex_count) -
                                   kept.begin()) -
        own.first_vertex;
    own.first_triangle = static_cast<std::uint32_t>(source.triangles.size());
    for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
      const mesh::Triangle triangle = thin.triangle(t);
      if (triangle[0] != k_gone)
        source.triangles.push_back({renumbered[triangle[0]], renumbered[triangle[1]], renumbered[triangle[2]]});
    }
    own.triangle_count = static_cast<std::uint32_t>(source.triangles.size()) - own.first_triangle;
    source.parts.push_back(std::move(own));
  }
  Parts out = parts;
  out.mesh = mesh::TriangleMesh::build(std::move(source)).value();
  const auto keep = [&](auto& of_vertices) {
    for (std::size_t k = 0; k < kept.size(); ++k) of_vertices[k] = of_vertices[kept[k]];
    of_vertices.resize(kept.size());
  };
  for (auto& [name, field] : out.fields) keep(field);
  keep(out.jaw_share);
  for (FaceLine& line : out.lines) {
    for (std::uint32_t& v : line.vertices) v = renumbered[v];
  }
  for (auto& [side, ball] : out.eyes) {
    for (std::uint32_t& v : ball) v = renumbered[v];
  }
  return out;
}

}  // namespace penpose::judges
