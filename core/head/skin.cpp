#include "core/head/skin.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/head/sculpt.h"

namespace penpose::head {
namespace {

constexpr std::uint32_t k_unnumbered = 0xffffffffU;
constexpr std::size_t k_kinds = 7;
constexpr double k_lip_gap = 0.02;

struct Pair {
  mesh::QuadMesh shape;
  mesh::QuadMesh marks;
};

/// Both halves of the cage, so that subdivision knows both sides of the mirror plane.
Pair whole(const Cage& cage) {
  Pair pair;
  std::vector<std::uint32_t> other(cage.points.size());
  pair.shape.positions = cage.points;
  pair.marks.positions = cage.marks;
  for (std::uint32_t v = 0; v < cage.points.size(); ++v) {
    other[v] = v;
    if (cage.points[v].x == 0) continue;
    other[v] = static_cast<std::uint32_t>(pair.shape.positions.size());
    pair.shape.positions.emplace_back(-cage.points[v].x, cage.points[v].y, cage.points[v].z);
    pair.marks.positions.push_back(cage.marks[v]);
  }
  pair.shape.quads = cage.quads;
  for (const mesh::Quad& q : cage.quads)
    pair.shape.quads.push_back({other[q[3]], other[q[2]], other[q[1]], other[q[0]]});
  pair.marks.quads = pair.shape.quads;
  return pair;
}

void lift_off_eye(Half& half) {
  const ModelPoint center{k_eye_center[0], k_eye_center[1], k_eye_center[2]};
  for (std::size_t v = 0; v < half.points.size(); ++v) {
    const double loop = half.marks[v].x;
    if (loop > 4.5) continue;
    const ModelVector away = half.points[v] - center;
    const double distance = geometry::length(away);
    // Lids slide on a film. The upper lid's lies outside the lower lid, edge and all, so that it closes over a lower
    // lid that is raised. Further out the skin has its thickness.
    const double upper = ramp(-1.0, 1.0, half.marks[v].z) * ramp(-1.0, 0.0, loop);
    const double film = 1.012 + 0.026 * upper;
    const double thickness = 0.018 + 0.02 * upper;
    const double least = k_eye_radius * (film + thickness * ramp(0.0, 1.0, loop) + 0.03 * ramp(-1.1, -2.0, loop));
    if (distance < least) half.points[v] = center + away * (least / distance);
  }
}

/// Both lips meet in a flat seam: whatever reaches over their line is pressed back to it.
void close_lips(Half& half) {
  for (std::size_t v = 0; v < half.points.size(); ++v) {
    const LoopMark& mark = half.marks[v];
    if (mark.y < -1.5 || mark.y > 2) continue;
    ModelPoint& p = half.points[v];
    const double line = seam_height(p.z);
    if (mark.z > 1e-6) {
      p.y = std::max(p.y, line + k_lip_gap / 2);
    } else if (mark.z < -1e-6) {
      p.y = std::min(p.y, line - k_lip_gap / 2);
    } else if (mark.y > -0.5 && mark.y < 0.5) {
      p.y = line;
    }
  }
}

/// The quads of the half, those of one coarser quad together.
std::vector<std::vector<std::size_t>> quads_by_coarser(const Half& half) {
  std::vector<std::pair<std::uint32_t, std::size_t>> order;
  for (std::size_t q = 0; q < half.quads.size(); ++q) order.emplace_back(half.coarser[q], q);
  std::stable_sort(order.begin(), order.end());
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || order[i].first != order[i - 1].first) groups.emplace_back();
    groups.back().push_back(order[i].second);
  }
  return groups;
}

void add_fan(std::vector<mesh::Triangle>& triangles, std::span<const std::uint32_t> polygon) {
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) triangles.push_back({polygon[0], polygon[i], polygon[i + 1]});
}

/// The vertices that triangles of the half use, and their mirror images.
Surface mirrored_part(const Half& half, std::vector<mesh::Triangle> triangles) {
  std::vector<std::uint32_t> number(half.points.size(), k_unnumbered);
  std::vector<ModelPoint> points;
  for (mesh::Triangle& t : triangles) {
    for (std::uint32_t& v : t) {
      if (number[v] == k_unnumbered) {
        number[v] = static_cast<std::uint32_t>(points.size());
        points.push_back(half.points[v]);
      }
      v = number[v];
    }
  }
  return mirrored(points, triangles);
}

}  // namespace

base::Result<Half> make_half() {
  const Cage cage = make_cage();
  Pair pair = whole(cage);
  std::vector<std::uint32_t> cage_quad;
  std::vector<std::uint32_t> coarser;
  for (int level = 0; level < 2; ++level) {
    auto shape = mesh::catmull_clark(pair.shape);
    if (!shape) return shape.error();
    auto marks = mesh::catmull_clark(pair.marks);
    if (!marks) return marks.error();
    pair.shape = std::move(shape).value();
    pair.marks = std::move(marks).value();
    if (level == 0) {
      cage_quad = pair.shape.parents;
      // Features are carved here, and rounded by the last level.
      for (std::size_t v = 0; v < pair.shape.positions.size(); ++v) {
        ModelPoint& p = pair.shape.positions[v];
        const double side = p.x < 0 ? -1 : 1;
        p = carved({std::abs(p.x) < 1e-9 ? 0 : std::abs(p.x), p.y, p.z}, pair.marks.positions[v]);
        p.x *= side;
      }
    } else {
      coarser = pair.shape.parents;
    }
  }
  Half half;
  std::vector<std::uint32_t> number(pair.shape.positions.size(), k_unnumbered);
  for (std::size_t q = 0; q < pair.shape.quads.size(); ++q) {
    const std::uint32_t of_cage = cage_quad[coarser[q]];
    if (of_cage >= cage.quads.size()) continue;
    mesh::Quad quad = pair.shape.quads[q];
    for (std::uint32_t& v : quad) {
      if (number[v] == k_unnumbered) {
        number[v] = static_cast<std::uint32_t>(half.points.size());
        ModelPoint p = pair.shape.positions[v];
        if (std::abs(p.x) < 1e-9) p.x = 0;
        half.points.push_back(p);
        half.marks.push_back(pair.marks.positions[v]);
      }
      v = number[v];
    }
    half.quads.push_back(quad);
    half.coarser.push_back(coarser[q]);
    half.kinds.push_back(cage.kinds[of_cage]);
  }
  for (std::size_t v = 0; v < half.points.size(); ++v) {
    half.points[v] = with_brow(half.points[v], half.marks[v]);
  }
  lift_off_eye(half);
  close_lips(half);
  return half;
}

Surface mirrored(const std::vector<ModelPoint>& points, const std::vector<mesh::Triangle>& triangles) {
  Surface surface{points, triangles};
  std::vector<std::uint32_t> other(points.size());
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    other[v] = v;
    if (points[v].x == 0) continue;
    other[v] = static_cast<std::uint32_t>(surface.points.size());
    surface.points.emplace_back(-points[v].x, points[v].y, points[v].z);
  }
  for (const mesh::Triangle& t : triangles) surface.triangles.push_back({other[t[0]], other[t[2]], other[t[1]]});
  return surface;
}

Skin make_skin(const Half& half) {
  // Four quads of a coarse one become one polygon: its corners, and those middles of its edges that a finer neighbour
  // needs. Corners 1 and 3 of a quad are such middles, corner 2 is the corner of the coarse quad.
  std::vector<bool> needed(half.points.size(), false);
  for (std::size_t q = 0; q < half.quads.size(); ++q) {
    if (is_coarse(half.kinds[q])) continue;
    for (const std::uint32_t v : half.quads[q]) needed[v] = true;
  }
  std::array<std::vector<mesh::Triangle>, k_kinds> triangles;
  for (const auto& group : quads_by_coarser(half)) {
    auto& mine = triangles[static_cast<std::size_t>(half.kinds[group[0]])];
    if (!is_coarse(half.kinds[group[0]])) {
      for (const std::size_t q : group) add_fan(mine, half.quads[q]);
      continue;
    }
    // Around the middle: every quad of the group runs middle, edge point, corner, edge point.
    std::vector<std::uint32_t> around;
    std::size_t at = group[0];
    for (std::size_t turn = 0; turn < group.size(); ++turn) {
      const mesh::Quad& q = half.quads[at];
      if (needed[q[1]]) around.push_back(q[1]);
      around.push_back(q[2]);
      const auto next =
          std::find_if(group.begin(), group.end(), [&](std::size_t g) { return half.quads[g][1] == q[3]; });
      if (next != group.end()) at = *next;
    }
    if (around.size() == group.size()) {
      add_fan(mine, around);
      continue;
    }
    // Beside a finer neighbour: around the middle, so that no triangle is a sliver whose shading shows as a line.
    const std::uint32_t middle = half.quads[group[0]][0];
    for (std::size_t i = 0; i < around.size(); ++i) {
      mine.push_back({middle, around[i], around[(i + 1) % around.size()]});
    }
  }
  const auto of = [&](QuadKind kind) { return triangles[static_cast<std::size_t>(kind)]; };
  auto bare = of(QuadKind::skin);
  const auto coarse = of(QuadKind::coarse_skin);
  bare.insert(bare.end(), coarse.begin(), coarse.end());
  auto lining = of(QuadKind::lining);
  const auto inner_lip = of(QuadKind::inner_lip);
  lining.insert(lining.end(), inner_lip.begin(), inner_lip.end());
  return {mirrored_part(half, bare), mirrored_part(half, of(QuadKind::lip)), mirrored_part(half, of(QuadKind::brow)),
          mirrored_part(half, lining), mirrored_part(half, of(QuadKind::lash))};
}

}  // namespace penpose::head
