#include "core/mesh/vertex_rings.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace penpose::mesh {
namespace {

/// Triangles at a vertex of any mesh that was made to be posed.
constexpr std::size_t k_most_compared = 64;

/// The side of a triangle that lies opposite its vertex, in the triangle's direction.
struct Side {
  std::uint32_t from;
  std::uint32_t to;
};

/// Of two triangles that are one the other way round, the second: their areas would leave nothing to light.
void drop_turned(std::vector<Side>& sides) {
  for (std::size_t i = 0; i < sides.size() && sides.size() <= k_most_compared; ++i) {
    const auto turned = std::find_if(sides.begin() + static_cast<std::ptrdiff_t>(i) + 1, sides.end(),
                                     [&](const Side& s) { return s.from == sides[i].to && s.to == sides[i].from; });
    if (turned != sides.end()) sides.erase(turned);
  }
}

/// Chains sides into polygons: closed rings, or open fans that the centre closes. Appends their quads. Uses up `sides`.
void append_polygons(std::uint32_t center, std::vector<Side>& sides, std::vector<std::uint32_t>& ring,
                     std::vector<VertexRings::Quad>& quads) {
  const auto take = [&](auto matches) -> std::optional<Side> {
    const auto found = std::find_if(sides.begin(), sides.end(), matches);
    if (found == sides.end()) return std::nullopt;
    const Side taken = *found;
    sides.erase(found);
    return taken;
  };
  while (!sides.empty()) {
    ring = {sides.front().from, sides.front().to};
    sides.erase(sides.begin());
    while (const auto next = take([&](const Side& s) { return s.from == ring.back(); })) ring.push_back(next->to);
    const bool closed = ring.front() == ring.back();
    if (closed) {
      ring.pop_back();
    } else {
      while (const auto before = take([&](const Side& s) { return s.to == ring.front(); }))
        ring.insert(ring.begin(), before->from);
      if (ring.front() == ring.back()) {
        ring.pop_back();
      } else {
        ring.push_back(center);
      }
    }
    for (std::size_t i = 1; i + 1 < ring.size(); i += 2) {
      quads.push_back({ring[0], ring[i], ring[i + 1], i + 2 < ring.size() ? ring[i + 2] : ring[i + 1]});
    }
  }
}

}  // namespace

VertexRings::VertexRings(const TriangleMesh& mesh) : leader_(mesh.smoothing().begin(), mesh.smoothing().end()) {
  const std::size_t count = mesh.vertex_count();
  const auto triangles = mesh.triangles();
  std::vector<std::uint32_t> first_corner(count + 1, 0);
  for (const Triangle& t : triangles) {
    for (const std::uint32_t v : t) ++first_corner[v + 1];
  }
  std::partial_sum(first_corner.begin(), first_corner.end(), first_corner.begin());
  std::vector<Side> side_of(triangles.size() * 3);
  std::vector<std::uint32_t> next(first_corner.begin(), first_corner.end() - 1);
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) side_of[next[t[k]]++] = {t[(k + 1) % 3], t[(k + 2) % 3]};
  }

  // Followers' fans belong to their leader; they are few, so a sorted list of them will do.
  std::vector<std::uint32_t> followers;
  for (std::uint32_t v = 0; v < count; ++v) {
    if (leader_[v] != v) followers.push_back(v);
  }
  std::stable_sort(followers.begin(), followers.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return leader_[a] < leader_[b]; });
  std::size_t follower = 0;
  std::vector<Side> sides;
  std::vector<std::uint32_t> ring;
  quads_.reserve(triangles.size() + count);
  first_.reserve(count + 1);
  const auto append = [&](std::uint32_t v) {
    sides.assign(side_of.begin() + first_corner[v], side_of.begin() + first_corner[v + 1]);
    drop_turned(sides);
    append_polygons(v, sides, ring, quads_);
  };
  for (std::uint32_t v = 0; v < count; ++v) {
    first_.push_back(static_cast<std::uint32_t>(quads_.size()));
    if (leader_[v] != v) continue;
    append(v);
    for (; follower < followers.size() && leader_[followers[follower]] == v; ++follower) append(followers[follower]);
  }
  first_.push_back(static_cast<std::uint32_t>(quads_.size()));
}

}  // namespace penpose::mesh
