#include "core/mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <tuple>

namespace penpose::mesh {
namespace {

std::uint32_t find_root(std::vector<std::uint32_t>& parent, std::uint32_t v) {
  while (parent[v] != v) {
    parent[v] = parent[parent[v]];
    v = parent[v];
  }
  return v;
}

/// Joins two sets; the lower root wins, so that a set is named by its lowest vertex.
void join(std::vector<std::uint32_t>& parent, std::uint32_t a, std::uint32_t b) {
  a = find_root(parent, a);
  b = find_root(parent, b);
  if (a < b) parent[b] = a;
  if (b < a) parent[a] = b;
}

bool collapses(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

/// A border edge of a part, from the corner with the lower position to the other.
struct Rim {
  ModelPoint low;
  ModelPoint high;
  std::uint32_t low_vertex = 0;
  std::uint32_t high_vertex = 0;
  std::uint32_t part = 0;
  bool forward = true;  ///< the triangle runs from low to high
};

auto place_of(const Rim& r) { return std::tie(r.low.x, r.low.y, r.low.z, r.high.x, r.high.y, r.high.z); }

std::vector<Rim> border_edges(const MeshSource& source, std::span<const std::uint32_t> weld) {
  std::vector<Triangle> welded = source.triangles;
  for (Triangle& t : welded) {
    for (std::uint32_t& v : t) v = weld[v];
  }
  std::vector<Rim> rims;
  const auto edges = sorted_edges(welded, source.positions.size());
  for (std::size_t i = 0, next = 0; i < edges.size(); i = next) {
    for (next = i + 1; next < edges.size() && edges[next].low == edges[i].low && edges[next].high == edges[i].high;) {
      ++next;
    }
    if (next != i + 1 || edges[i].low == edges[i].high) continue;
    const Triangle& t = welded[edges[i].triangle];
    std::size_t k = 0;
    while (std::minmax(t[k], t[(k + 1) % 3]) != std::minmax(edges[i].low, edges[i].high)) ++k;
    const auto part =
        std::upper_bound(source.parts.begin(), source.parts.end(), edges[i].triangle,
                         [](std::uint32_t triangle, const Part& p) { return triangle < p.first_triangle; });
    Rim rim{source.positions[t[k]],
            source.positions[t[(k + 1) % 3]],
            t[k],
            t[(k + 1) % 3],
            static_cast<std::uint32_t>(part - source.parts.begin()),
            true};
    if (std::tie(rim.high.x, rim.high.y, rim.high.z) < std::tie(rim.low.x, rim.low.y, rim.low.z)) {
      std::swap(rim.low, rim.high);
      std::swap(rim.low_vertex, rim.high_vertex);
      rim.forward = false;
    }
    rims.push_back(rim);
  }
  return rims;
}

/// One surface in two materials comes as two parts whose borders run along each other: exactly the same edge, the other
/// way round. Such borders become one; a border that merely touches another surface does not.
void weld_seams(const MeshSource& source, std::vector<std::uint32_t>& weld) {
  if (source.parts.size() < 2) return;
  std::vector<Rim> rims = border_edges(source, weld);
  std::stable_sort(rims.begin(), rims.end(), [](const Rim& a, const Rim& b) {
    if (place_of(a) != place_of(b)) return place_of(a) < place_of(b);
    return std::tie(a.part, a.low_vertex, a.high_vertex) < std::tie(b.part, b.low_vertex, b.high_vertex);
  });
  std::vector<std::uint32_t> joined = weld;
  bool any = false;
  for (std::size_t i = 0, next = 0; i < rims.size(); i = next) {
    for (next = i + 1; next < rims.size() && place_of(rims[next]) == place_of(rims[i]);) ++next;
    const bool seam = next == i + 2 && rims[i].part != rims[i + 1].part && rims[i].forward != rims[i + 1].forward;
    if (!seam) continue;
    join(joined, rims[i].low_vertex, rims[i + 1].low_vertex);
    join(joined, rims[i].high_vertex, rims[i + 1].high_vertex);
    any = true;
  }
  if (!any) return;
  std::vector<Triangle> welded = source.triangles;
  for (Triangle& t : welded) {
    for (std::uint32_t& v : t) v = find_root(joined, v);
    if (collapses(t)) return;
  }
  if (first_non_manifold_triangle(welded, source.positions.size())) return;
  for (std::uint32_t v = 0; v < weld.size(); ++v) weld[v] = find_root(joined, v);
}

/// The mesh without some of its triangles.
MeshSource without(const MeshSource& source, std::span<const std::uint32_t> extra) {
  MeshSource kept;
  kept.positions = source.positions;
  auto next = extra.begin();
  for (Part part : source.parts) {
    const std::uint32_t end = part.first_triangle + part.triangle_count;
    std::uint32_t t = part.first_triangle;
    part.first_triangle = static_cast<std::uint32_t>(kept.triangles.size());
    for (; t < end; ++t) {
      if (next != extra.end() && *next == t) {
        ++next;
      } else {
        kept.triangles.push_back(source.triangles[t]);
      }
    }
    part.triangle_count = static_cast<std::uint32_t>(kept.triangles.size()) - part.first_triangle;
    kept.parts.push_back(std::move(part));
  }
  return kept;
}

/// Chooses the triangles of an edge that belong to the surface.
class EdgeCutter {
 public:
  EdgeCutter(std::span<const Triangle> triangles, std::span<const ModelPoint> positions)
      : triangles_(triangles), positions_(positions), extra_(triangles.size(), 0) {}

  void drop_repeated(std::vector<std::uint32_t> at_full_edges) {
    const auto corners = [&](std::uint32_t t) {
      Triangle sorted = triangles_[t];
      std::stable_sort(sorted.begin(), sorted.end());
      return sorted;
    };
    std::stable_sort(at_full_edges.begin(), at_full_edges.end());
    at_full_edges.erase(std::unique(at_full_edges.begin(), at_full_edges.end()), at_full_edges.end());
    std::stable_sort(at_full_edges.begin(), at_full_edges.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return corners(a) < corners(b); });
    for (std::size_t i = 1; i < at_full_edges.size(); ++i) {
      if (corners(at_full_edges[i]) == corners(at_full_edges[i - 1])) extra_[at_full_edges[i]] = 1;
    }
  }

  /// All uses of one edge.
  void cut(std::span<const EdgeUse> uses) {
    here_.clear();
    for (const EdgeUse& use : uses) {
      if (extra_[use.triangle] == 0) here_.push_back(use.triangle);
    }
    if (here_.size() <= 2) return;
    const auto [first, second] = best_pair(uses.front());
    for (const std::uint32_t triangle : here_) {
      if (triangle != first && triangle != second) extra_[triangle] = 1;
    }
  }

  [[nodiscard]] std::vector<std::uint32_t> extra() const {
    std::vector<std::uint32_t> all;
    for (std::uint32_t t = 0; t < extra_.size(); ++t) {
      if (extra_[t] != 0) all.push_back(t);
    }
    return all;
  }

 private:
  static constexpr std::size_t k_most_compared = 16;

  [[nodiscard]] bool forward(std::uint32_t triangle, const EdgeUse& edge) const {
    const Triangle& t = triangles_[triangle];
    for (std::size_t k = 0; k < 3; ++k) {
      if (t[k] == edge.low && t[(k + 1) % 3] == edge.high) return true;
    }
    return false;
  }
  [[nodiscard]] geometry::ModelVector normal(std::uint32_t triangle) const {
    const Triangle& t = triangles_[triangle];
    return geometry::normalized(glm::cross(positions_[t[1]] - positions_[t[0]], positions_[t[2]] - positions_[t[0]]),
                                geometry::ModelVector(0));
  }

  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> best_pair(const EdgeUse& edge) const {
    std::pair<std::uint32_t, std::uint32_t> best{here_[0], here_[1]};
    if (here_.size() > k_most_compared) {
      for (const std::uint32_t other : here_) {
        if (forward(other, edge) != forward(here_[0], edge)) return {here_[0], other};
      }
      return best;
    }
    double flattest = -10;
    for (std::size_t i = 0; i < here_.size(); ++i) {
      const bool along = forward(here_[i], edge);
      const auto across = normal(here_[i]);
      for (std::size_t k = i + 1; k < here_.size(); ++k) {
        const bool opposite = forward(here_[k], edge) != along;
        const double flat = glm::dot(across, normal(here_[k]));
        // One that is turned round lies flat where the normals are opposed, and comes after all that are not.
        const double score = opposite ? flat : -flat - 4;
        if (score > flattest) {
          flattest = score;
          best = {here_[i], here_[k]};
        }
      }
    }
    return best;
  }

  std::span<const Triangle> triangles_;
  std::span<const ModelPoint> positions_;
  std::vector<std::uint8_t> extra_;
  std::vector<std::uint32_t> here_;
};

/// The edges of one vertex: by insertion while they are few, which needs no memory.
void sort_run(std::span<EdgeUse> run) {
  constexpr std::size_t k_few = 32;
  const auto before = [](const EdgeUse& a, const EdgeUse& b) {
    return a.high != b.high ? a.high < b.high : a.triangle < b.triangle;
  };
  if (run.size() > k_few) return std::stable_sort(run.begin(), run.end(), before);
  for (std::size_t i = 1; i < run.size(); ++i) {
    const EdgeUse edge = run[i];
    std::size_t k = i;
    for (; k > 0 && before(edge, run[k - 1]); --k) run[k] = run[k - 1];
    run[k] = edge;
  }
}

}  // namespace

std::vector<EdgeUse> sorted_edges(std::span<const Triangle> triangles, std::size_t vertex_count) {
  // A counting sort by the lower vertex, then small sorts within: edges of one vertex are few.
  std::vector<std::uint32_t> start(vertex_count + 1, 0);
  const auto each_edge = [&](const auto& use) {
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
        use(EdgeUse{low, high, t});
      }
    }
  };
  each_edge([&](const EdgeUse& edge) { ++start[edge.low + 1]; });
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<EdgeUse> edges(triangles.size() * 3);
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  each_edge([&](const EdgeUse& edge) { edges[next[edge.low]++] = edge; });
  for (std::size_t v = 0; v < vertex_count; ++v) {
    sort_run(std::span(edges).subspan(start[v], start[v + 1] - start[v]));
  }
  return edges;
}

std::optional<std::uint32_t> first_non_manifold_triangle(std::span<const Triangle> triangles,
                                                         std::size_t vertex_count) {
  const auto edges = sorted_edges(triangles, vertex_count);
  std::optional<std::uint32_t> first;
  for (std::size_t i = 2; i < edges.size(); ++i) {
    const bool third = edges[i].low == edges[i - 2].low && edges[i].high == edges[i - 2].high;
    if (third && (!first || edges[i].triangle < *first)) first = edges[i].triangle;
  }
  return first;
}

std::vector<std::uint32_t> extra_triangles(std::span<const Triangle> triangles, std::span<const ModelPoint> positions) {
  const auto edges = sorted_edges(triangles, positions.size());
  std::vector<std::span<const EdgeUse>> full;
  std::vector<std::uint32_t> beside;
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    for (end = i + 1; end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high;) ++end;
    if (end - i < 3) continue;
    full.push_back(std::span(edges).subspan(i, end - i));
    for (const EdgeUse& use : full.back()) beside.push_back(use.triangle);
  }
  if (full.empty()) return {};
  EdgeCutter cutter(triangles, positions);
  cutter.drop_repeated(std::move(beside));
  for (const auto& uses : full) cutter.cut(uses);
  return cutter.extra();
}

std::string note_of_extra_triangles(const TriangleMesh& mesh) {
  const std::size_t count = extra_triangles(mesh.triangles(), mesh.positions()).size();
  if (count == 0) return {};
  if (count == 1) return "1 triangle lies on another one or on an edge that has two already: it is a sheet of its own";
  return std::to_string(count) +
         " triangles lie on others or on edges that have two already: they are sheets of their own";
}

std::vector<std::uint32_t> weld_coincident(const MeshSource& source, std::span<const std::uint32_t> extra) {
  std::vector<std::uint32_t> weld(source.positions.size());
  std::iota(weld.begin(), weld.end(), 0U);
  if (!extra.empty()) {
    auto of_surface = weld_coincident(without(source, extra));
    const bool collapsed = std::any_of(extra.begin(), extra.end(), [&](std::uint32_t triangle) {
      const Triangle& t = source.triangles[triangle];
      return collapses({of_surface[t[0]], of_surface[t[1]], of_surface[t[2]]});
    });
    return collapsed ? weld : of_surface;
  }
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    const ModelPoint& p = source.positions[a];
    const ModelPoint& q = source.positions[b];
    return std::tie(p.x, p.y, p.z, a) < std::tie(q.x, q.y, q.z, b);
  };
  std::vector<std::uint32_t> order;
  std::vector<Triangle> welded;
  for (const Part& part : source.parts) {
    order.resize(part.vertex_count);
    std::iota(order.begin(), order.end(), part.first_vertex);
    std::stable_sort(order.begin(), order.end(), before);
    bool any = false;
    for (std::size_t i = 1; i < order.size(); ++i) {
      if (source.positions[order[i]] == source.positions[order[i - 1]]) {
        weld[order[i]] = weld[order[i - 1]];
        any = true;
      }
    }
    if (!any) continue;
    welded.assign(source.triangles.begin() + part.first_triangle,
                  source.triangles.begin() + part.first_triangle + part.triangle_count);
    // Numbered from the part's first vertex: what a part costs must not grow with the others.
    bool collapsed = false;
    for (Triangle& t : welded) {
      for (std::uint32_t& v : t) v = weld[v] - part.first_vertex;
      collapsed |= collapses(t);
    }
    if (collapsed || first_non_manifold_triangle(welded, part.vertex_count)) {
      std::iota(weld.begin() + part.first_vertex, weld.begin() + part.first_vertex + part.vertex_count,
                part.first_vertex);
    }
  }
  weld_seams(source, weld);
  return weld;
}

std::vector<std::uint32_t> smoothing_groups(const MeshSource& source, std::span<const std::uint32_t> weld) {
  std::vector<std::uint32_t> group(weld.begin(), weld.end());
  if (source.normals.empty()) return group;
  // Vertices of one weld are compared with the first of each smoothing group of that weld; such groups are few.
  std::vector<std::vector<std::uint32_t>> firsts;
  std::vector<std::uint32_t> slot(weld.size(), 0);
  for (std::uint32_t v = 0; v < weld.size(); ++v) {
    if (weld[v] == v) continue;
    std::uint32_t& index = slot[weld[v]];
    if (index == 0) {
      firsts.push_back({weld[v]});
      index = static_cast<std::uint32_t>(firsts.size());
    }
    auto& leaders = firsts[index - 1];
    const auto same = std::find_if(leaders.begin(), leaders.end(), [&](std::uint32_t leader) {
      const glm::vec3 d = source.normals[v] - source.normals[leader];
      return d.x * d.x + d.y * d.y + d.z * d.z < 1e-6F;
    });
    if (same != leaders.end()) {
      group[v] = *same;
    } else {
      group[v] = v;
      leaders.push_back(v);
    }
  }
  return group;
}

Components label_components(std::span<const Triangle> triangles, std::span<const std::uint32_t> weld) {
  std::vector<std::uint32_t> parent(weld.begin(), weld.end());
  for (const Triangle& t : triangles) {
    join(parent, t[0], t[1]);
    join(parent, t[1], t[2]);
  }
  Components result;
  result.component.resize(parent.size());
  std::vector<std::uint32_t> number(parent.size(), 0);
  for (std::uint32_t v = 0; v < parent.size(); ++v) {
    const std::uint32_t root = find_root(parent, v);
    if (root == v) number[v] = static_cast<std::uint32_t>(result.count++);
    result.component[v] = number[root];
  }
  return result;
}

}  // namespace penpose::mesh
