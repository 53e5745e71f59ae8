#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "core/curve/polyline.h"
#include "core/curve/sheet_line.h"

namespace penpose::curve::sheet_walk {

// Parts of sheet_curve (sheet_line.h): the samples of a line, the candidates of each, and the cheapest sequence.

inline constexpr double k_spacing_px = 2.0;  ///< of samples, at 1000 px high
inline constexpr std::size_t k_fewest = 32, k_most = 128;
inline constexpr int k_layers = 4;       ///< most hits along one ray
inline constexpr double k_hidden = 0.7;  ///< cost of each surface in front
inline constexpr double k_from_behind = 1.5;
/// Cost of crossing to a part that touches. Crossing to a part and on to another sheet costs more than a leap, which it
/// is.
inline constexpr double k_other_part = 20.5;
inline constexpr double k_leap = 40.0;  ///< cost of crossing to a part that does not touch, or is far over the surface
inline constexpr double k_reach = 2.0;  ///< how far a path may deviate, in steps between samples
inline constexpr double k_touch = 2.0;  ///< how far parts that touch may be from each other, reaches

struct Candidate {
  mesh::MeshPoint point;
  ModelPoint position;
  PxPoint offset;   ///< from the pen
  double cost = 0;  ///< of taking it
  double best = 0;  ///< of the cheapest sequence up to it
  std::size_t from = 0;
  bool cut = false;  ///< that sequence leaps here
};

struct Node {
  PxPoint px;
  double step = 0;  ///< to the sample before, px
  std::vector<Candidate> candidates;
};

class Walk {
 public:
  Walk(const geometry::Camera& camera, const SheetSurface& surface)
      : camera_(camera), surface_(surface), scale_(camera.viewport().height / 1000.0) {}

  /// How far from the pen to search for a sheet, times k_stick_px.
  void stick(double far) { stick_px_ = far * k_stick_px * scale_; }

  std::vector<Node> nodes;

  bool set_up(std::span<const PxPoint> stroke) {
    std::vector<PxPoint> finite;
    for (const PxPoint& p : stroke) {
      if (std::isfinite(p.x) && std::isfinite(p.y)) finite.push_back(p);
    }
    const double length = arc_length<PxPoint>(finite);
    const double wanted =
        std::clamp(length / (k_spacing_px * scale_) + 1.0, static_cast<double>(k_fewest), static_cast<double>(k_most));
    const auto even = resample<PxPoint>(finite, static_cast<std::size_t>(wanted));
    if (!even) return false;
    for (std::size_t i = 0; i < even->size(); ++i) {
      nodes.push_back({(*even)[i], i > 0 ? geometry::distance((*even)[i - 1], (*even)[i]) : 0.0, {}});
      layers(nodes.back(), 1);
    }
    // A model that is wound inside out still shows its front.
    std::size_t behind = 0, hits = 0;
    for (const Node& node : nodes) {
      hits += node.candidates.size();
      for (const Candidate& one : node.candidates) behind += one.cost > 0.0 ? 1U : 0U;
    }
    turned_ = 2 * behind > hits;
    if (turned_) {
      for (Node& node : nodes) {
        for (Candidate& one : node.candidates) one.cost = one.cost > 0.0 ? 0.0 : k_from_behind;
      }
    }
    return true;
  }

  /// Whether the first hits already are one path over the surface.
  bool whole() {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto& here = nodes[i].candidates;
      if (here.empty() || here[0].cost > 0) return false;
      if (i > 0 && !joined(nodes[i - 1].candidates[0], here[0], nodes[i].step)) return false;
    }
    return true;
  }

  void widen() {
    for (Node& node : nodes) {
      node.candidates.clear();
      layers(node, k_layers);
      around(node);
    }
  }

  /// The longest run of one cheapest sequence: first node, and the candidate of each from there on.
  struct Run {
    std::size_t first = 0;
    std::vector<std::size_t> taken;
    double length = -1;
  };
  Run longest() {
    Run best;
    std::size_t end = 0;
    for (std::size_t begin = 0; begin < nodes.size(); begin = end + 1) {
      for (end = begin; end < nodes.size() && !nodes[end].candidates.empty();) ++end;
      if (end > begin) keep_longest(begin, end, best);
    }
    return best;
  }

  /// Removes the sheet of a run: everything joined to it is no longer a candidate, nor is anything hidden behind it or
  /// seen from behind, which is its own other side.
  void leave(const Run& run) {
    for (std::size_t i = 0; i < run.taken.size(); ++i) {
      Node& node = nodes[run.first + i];
      const Candidate taken = node.candidates[run.taken[i]];
      std::erase_if(node.candidates, [&](const Candidate& one) {
        return one.cost >= k_from_behind || joined(taken, one, 2.0 * stick_px_);
      });
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (i < run.first || i >= run.first + run.taken.size()) nodes[i].candidates.clear();
    }
  }

  /// Moves candidates next to the pen as near to it as their sheet comes.
  void refine(const Node& node, Candidate& taken) {
    if (taken.offset == PxPoint{}) return;
    double near = 0.0, far = 1.0;
    for (int k = 0; k < 6; ++k) {
      const double share = 0.5 * (near + far);
      Node probe{node.px, node.step, {}};
      hit_beside(probe, taken.offset * share);
      if (!probe.candidates.empty() && joined(probe.candidates[0], taken, stick_px_)) {
        far = share;
        taken = probe.candidates[0];
        taken.offset = taken.offset * (1.0 / share);
      } else {
        near = share;
      }
    }
    taken.offset = taken.offset * far;
  }

  /// Moves those back that are no longer next to their neighbours, until all are.
  void keep_beside(const Run& run, std::vector<Candidate>& taken) {
    const auto as_found = [&](std::size_t i) -> const Candidate& {
      return nodes[run.first + i].candidates[run.taken[i]];
    };
    const auto beside = [&](std::size_t i) {
      const double step = nodes[run.first + i].step;
      return taken[i - 1].point.triangle == taken[i].point.triangle || joined(taken[i - 1], taken[i], step) ||
             (surface_.sheets.component(taken[i - 1].point.triangle) !=
                  surface_.sheets.component(taken[i].point.triangle) &&
              geometry::distance(taken[i - 1].position, taken[i].position) <= reach(taken[i - 1], taken[i], step));
    };
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t i = 1; i < taken.size(); ++i) {
        if ((taken[i - 1].offset == as_found(i - 1).offset && taken[i].offset == as_found(i).offset) || beside(i)) {
          continue;
        }
        taken[i - 1] = as_found(i - 1);
        taken[i] = as_found(i);
        changed = true;
      }
    }
  }

  [[nodiscard]] bool joined(const Candidate& a, const Candidate& b, double px) {
    return surface_.sheets.joined({a.point.triangle, a.position}, {b.point.triangle, b.position}, reach(a, b, px),
                                  surface_.positions);
  }

  /// Whether two places of a line are neighbours on the surface: one sheet, or parts that touch.
  [[nodiscard]] bool neighbours(const Candidate& a, const Candidate& b, double px) {
    if (joined(a, b, px)) return true;
    const bool parts = surface_.sheets.component(a.point.triangle) != surface_.sheets.component(b.point.triangle);
    return parts && geometry::distance(a.position, b.position) <= k_touch * reach(a, b, px);
  }

  /// The surface at a place of the picture that is on the sheet of a known place.
  bool on_sheet(PxPoint px, const Candidate& known, double step, Candidate& out) {
    Node probe{px, step, {}};
    layers(probe, k_layers);
    for (const Candidate& one : probe.candidates) {
      if (!joined(known, one, std::max(step, k_spacing_px * scale_))) continue;
      out = one;
      return true;
    }
    return false;
  }

 private:
  [[nodiscard]] double reach(const Candidate& a, const Candidate& b, double px) const {
    const double depth = std::min(camera_.depth(a.position), camera_.depth(b.position));
    return k_reach * std::max(px, k_spacing_px * scale_) * camera_.units_per_px(depth);
  }

  [[nodiscard]] bool from_behind(std::uint32_t triangle, const geometry::ModelVector& direction) const {
    const auto& t = surface_.triangles[triangle];
    const ModelPoint a(surface_.positions[t[0]]), b(surface_.positions[t[1]]), c(surface_.positions[t[2]]);
    return (glm::dot(glm::cross(b - a, c - a), direction) > 0.0) != turned_;
  }

  void layers(Node& node, int most) {
    geometry::Ray ray = camera_.ray(node.px);
    const ModelPoint eye = ray.origin;
    double passed = 0;
    std::uint32_t last = geometry::TriangleBvh::k_no_hint;
    for (int layer = 0; layer < most; ++layer) {
      const auto hit = surface_.tree.nearest_hit(ray, layer == 0 ? hint_ : geometry::TriangleBvh::k_no_hint);
      if (!hit) return;
      if (layer == 0) hint_ = hit->triangle;
      passed += hit->distance;
      if (hit->triangle != last) {
        Candidate one{{hit->triangle, hit->barycentric}, eye + ray.direction * passed, {}, 0, 0, 0, false};
        one.cost = k_hidden * layer + (from_behind(hit->triangle, ray.direction) ? k_from_behind : 0.0);
        node.candidates.push_back(one);
      }
      last = hit->triangle;
      passed += 1e-5 * passed;
      ray.origin = eye + ray.direction * passed;
    }
  }

  void hit_beside(Node& node, PxPoint offset) {
    const geometry::Ray ray = camera_.ray(node.px + offset);
    const auto hit = surface_.tree.nearest_hit(ray, hint_);
    if (!hit) return;
    const double share = geometry::distance({}, offset) / stick_px_;
    Candidate one{
        {hit->triangle, hit->barycentric}, ray.origin + ray.direction * hit->distance, offset, 0, 0, 0, false};
    one.cost = share * share + (from_behind(hit->triangle, ray.direction) ? k_from_behind : 0.0);
    node.candidates.push_back(one);
  }

  /// Candidates near the pen on sheets that it does not hit itself.
  void around(Node& node) {
    constexpr double k_diagonal = 0.70710678118654752;
    constexpr PxPoint k_ways[] = {{1, 0},
                                  {0, 1},
                                  {-1, 0},
                                  {0, -1},
                                  {k_diagonal, k_diagonal},
                                  {-k_diagonal, k_diagonal},
                                  {-k_diagonal, -k_diagonal},
                                  {k_diagonal, -k_diagonal}};
    for (const double share : {0.25, 0.5, 1.0}) {
      for (const PxPoint& way : k_ways) {
        Node probe{node.px, node.step, {}};
        hit_beside(probe, way * (share * stick_px_));
        if (probe.candidates.empty()) continue;
        const Candidate& found = probe.candidates[0];
        const bool known = std::any_of(node.candidates.begin(), node.candidates.end(), [&](const Candidate& other) {
          return other.cost <= found.cost && joined(other, found, share * stick_px_);
        });
        if (!known) node.candidates.push_back(found);
      }
    }
  }

  /// The cost of a crossing.
  double step_cost(const Candidate& a, const Candidate& b, double px) {
    if (joined(a, b, px)) return 0.0;
    const bool near = geometry::distance(a.position, b.position) <= reach(a, b, px);
    const bool parts = surface_.sheets.component(a.point.triangle) != surface_.sheets.component(b.point.triangle);
    return near && parts ? k_other_part : k_leap;
  }

  void keep_longest(std::size_t begin, std::size_t end, Run& best) {
    for (Candidate& one : nodes[begin].candidates) one.best = one.cost;
    for (std::size_t i = begin + 1; i < end; ++i) {
      const auto& before = nodes[i - 1].candidates;
      for (Candidate& one : nodes[i].candidates) {
        for (std::size_t k = 0; k < before.size(); ++k) {
          // A crossing costs something or nothing; most need not be computed.
          if (k > 0 && before[k].best + one.cost >= one.best) continue;
          const double over = step_cost(before[k], one, nodes[i].step);
          const double cost = before[k].best + over + one.cost;
          if (k > 0 && cost >= one.best) continue;
          one.best = cost;
          one.from = k;
          one.cut = over == k_leap;
        }
      }
    }
    const auto& last = nodes[end - 1].candidates;
    std::size_t at = 0;
    for (std::size_t k = 1; k < last.size(); ++k) {
      if (last[k].best < last[at].best) at = k;
    }
    Run run{end - 1, {}, 0};
    for (std::size_t i = end; i-- > begin;) {
      run.first = i;
      run.taken.insert(run.taken.begin(), at);
      const bool cut = i > begin && nodes[i].candidates[at].cut;
      if (i == begin || cut) {
        if (run.length > best.length) best = run;
        run = {i, {}, 0};
      } else {
        run.length += nodes[i].step;
      }
      at = nodes[i].candidates[at].from;
    }
  }

  const geometry::Camera& camera_;
  const SheetSurface& surface_;
  double scale_;
  double stick_px_ = k_stick_px * scale_;
  bool turned_ = false;
  std::uint32_t hint_ = geometry::TriangleBvh::k_no_hint;
};

}  // namespace penpose::curve::sheet_walk
