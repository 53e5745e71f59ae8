#include "tests/sketches/other_meshes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <set>

#include "tests/support/models/articulation_models.h"

namespace penpose::sketches {
namespace {

mesh::MeshSource source_of(std::vector<ModelPoint> positions, std::vector<mesh::Triangle> triangles) {
  mesh::MeshSource source;
  source.parts.push_back(
      {"other", 0, static_cast<std::uint32_t>(positions.size()), 0, static_cast<std::uint32_t>(triangles.size())});
  source.positions = std::move(positions);
  source.triangles = std::move(triangles);
  return source;
}

std::vector<mesh::Triangle> welded(const Canvas& canvas) {
  std::vector<mesh::Triangle> out;
  for (mesh::Triangle t : canvas.mesh().triangles()) {
    for (std::uint32_t& v : t) v = canvas.mesh().weld()[v];
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) out.push_back(t);
  }
  return out;
}

std::shared_ptr<const Canvas> compact(std::span<const ModelPoint> all, std::vector<mesh::Triangle> triangles) {
  std::vector<std::uint32_t> number(all.size(), ~0U);
  std::vector<ModelPoint> positions;
  for (mesh::Triangle& t : triangles) {
    for (std::uint32_t& v : t) {
      if (number[v] == ~0U) {
        number[v] = static_cast<std::uint32_t>(positions.size());
        positions.push_back(all[v]);
      }
      v = number[v];
    }
  }
  return tests::canvas_of(source_of(std::move(positions), std::move(triangles)));
}

}  // namespace

Warp::Warp(const Canvas& canvas) {
  geometry::Box box;
  for (const ModelPoint& p : canvas.positions()) box.add(p);
  middle_ = (box.minimum + box.maximum) * 0.5;
  size_ = box.diagonal();
}

ModelPoint Warp::operator()(const ModelPoint& p) const {
  ModelPoint q = (p - middle_) / size_;
  q.y *= q.y < 0 ? 1.25 + 0.2 * q.y : 1.0;
  q.x *= 1.0 + 0.35 * std::tanh(3 * q.y);
  q.x += 0.35 * q.y * q.y;
  q.z += 0.12 * std::sin(7 * q.x + 1) * std::cos(5 * q.y);
  const double twist = 0.5 * q.y;
  return middle_ + ModelPoint{q.x * std::cos(twist) + q.z * std::sin(twist), q.y + 0.04 * std::sin(9 * q.x),
                              q.z * std::cos(twist) - q.x * std::sin(twist)} *
                       size_;
}

std::shared_ptr<const Canvas> warped(const Canvas& canvas, const Warp& warp) {
  std::vector<ModelPoint> positions;
  for (const ModelPoint& p : canvas.positions()) positions.push_back(warp(p));
  return compact(positions, welded(canvas));
}

std::shared_ptr<const Canvas> coarser(const Canvas& canvas, double share) {
  std::vector<ModelPoint> at(canvas.positions().begin(), canvas.positions().end());
  std::vector<mesh::Triangle> triangles = welded(canvas);
  std::vector<std::set<std::uint32_t>> star(at.size());
  std::set<std::uint32_t> alive;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (const std::uint32_t v : triangles[t]) {
      star[v].insert(t);
      alive.insert(v);
    }
  }
  const auto wanted = static_cast<std::size_t>(share * static_cast<double>(alive.size()));
  std::vector<bool> gone(triangles.size(), false);
  const auto ring = [&](std::uint32_t v) {
    std::set<std::uint32_t> out;
    for (const std::uint32_t t : star[v]) out.insert(triangles[t].begin(), triangles[t].end());
    out.erase(v);
    return out;
  };
  using Entry = std::tuple<double, std::uint32_t, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> edges;
  const auto offer = [&](std::uint32_t v) {
    for (const std::uint32_t o : ring(v)) {
      edges.emplace(geometry::distance(at[v], at[o]), std::min(v, o), std::max(v, o));
    }
  };
  for (const std::uint32_t v : alive) offer(v);
  while (alive.size() > wanted && !edges.empty()) {
    const auto [length, a, b] = edges.top();
    edges.pop();
    if (!alive.contains(a) || !alive.contains(b) || geometry::distance(at[a], at[b]) != length) continue;
    const auto of_a = ring(a);
    const auto of_b = ring(b);
    // An inner edge whose ends have but two neighbours in common, and whose vertices have whole fans.
    std::vector<std::uint32_t> common;
    std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::back_inserter(common));
    if (!of_a.contains(b) || common.size() != 2 || star[a].size() != of_a.size() || star[b].size() != of_b.size() ||
        of_a.size() + of_b.size() > 14) {
      continue;
    }
    const ModelPoint middle = (at[a] + at[b]) * 0.5;
    bool turns = false;
    for (const std::uint32_t v : {a, b}) {
      for (const std::uint32_t t : star[v]) {
        const auto& triangle = triangles[t];
        if (star[a].contains(t) && star[b].contains(t)) continue;
        std::array<ModelPoint, 3> was{at[triangle[0]], at[triangle[1]], at[triangle[2]]};
        auto is = was;
        for (std::size_t k = 0; k < 3; ++k) {
          if (triangle[k] == v) is[k] = middle;
        }
        const auto normal = [](const std::array<ModelPoint, 3>& c) {
          const ModelPoint e = c[1] - c[0], f = c[2] - c[0];
          return geometry::normalized(ModelPoint{e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x},
                                      {0, 0, 0});
        };
        const ModelPoint m = normal(was), n = normal(is);
        turns = turns || m.x * n.x + m.y * n.y + m.z * n.z < 0.3;
      }
    }
    if (turns) continue;
    at[a] = middle;
    for (const std::uint32_t t : std::set<std::uint32_t>(star[b])) {
      const bool both = star[a].contains(t);
      for (const std::uint32_t v : triangles[t]) {
        if (both) star[v].erase(t);
      }
      if (both) {
        gone[t] = true;
        continue;
      }
      std::replace(triangles[t].begin(), triangles[t].end(), b, a);
      star[a].insert(t);
    }
    star[b].clear();
    alive.erase(b);
    offer(a);
  }
  std::vector<mesh::Triangle> left;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!gone[t]) left.push_back(triangles[t]);
  }
  return compact(at, std::move(left));
}

}  // namespace penpose::sketches
