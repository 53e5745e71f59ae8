#include "core/curve/sheet_line.h"

#include <algorithm>
#include <optional>

#include "core/curve/internal/sheet_walk.h"
#include "core/curve/polyline.h"

namespace penpose::curve {
namespace {

using sheet_walk::Candidate;
using sheet_walk::Walk;

/// A part of a drawn line that sticks to the surface: of each sample from `first` on the place, and where the pen was
/// taken to.
struct Stuck {
  std::size_t first = 0;
  std::vector<Candidate> taken;
  std::vector<PxPoint> line;

  [[nodiscard]] double length() const { return arc_length<PxPoint>(line); }
  [[nodiscard]] Stuck part(std::size_t from, std::size_t to) const {
    const auto at = [](auto& list, std::size_t i) { return list.begin() + static_cast<std::ptrdiff_t>(i); };
    return {first + from, {at(taken, from), at(taken, to)}, {at(line, from), at(line, to)}};
  }
};

/// A point of the result.
struct Placed {
  Candidate here;
  std::size_t nearer = 0;  ///< sample
  bool on_sample = false;  ///< it is that sample
};

/// The point at a share of the line: what lies between two samples is on their sheet.
Placed placed_at(Walk& walk, const Stuck& stuck, std::span<const double> cumulative, PxPoint px, double share) {
  const PolylinePlace place = place_at(cumulative, share);
  const std::size_t nearer = place.segment + (place.fraction > 0.5 ? 1 : 0);
  Placed placed{stuck.taken[nearer], nearer, true};
  const double step = geometry::distance(stuck.line[place.segment], stuck.line[place.segment + 1]);
  if (place.fraction > 0.0 && place.fraction < 1.0) {
    placed.on_sample = !walk.on_sheet(px, stuck.taken[nearer], step, placed.here);
  }
  return placed;
}

/// Even points along a line. A point that is not beside the one before is the sample next to it.
base::Result<std::vector<Placed>> evenly(Walk& walk, const Stuck& stuck, std::size_t count) {
  const auto even = resample<PxPoint>(stuck.line, count);
  if (!even) return even.error();
  const auto cumulative = cumulative_length<PxPoint>(stuck.line);
  std::vector<Placed> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    Placed placed = placed_at(walk, stuck, cumulative, (*even)[i], share);
    if (i > 0) {
      const std::size_t segment = place_at(cumulative, share).segment;
      const double step = geometry::distance(stuck.line[segment], stuck.line[segment + 1]);
      if (!walk.joined(points.back().here, placed.here, step)) {
        placed = {stuck.taken[placed.nearer], placed.nearer, true};
      }
    }
    points.push_back(placed);
  }
  return points;
}

/// Between which samples from one to another a line leaves its sheet: the first two that are no neighbours, else those
/// that are farthest apart.
std::size_t parting(Walk& walk, const Stuck& stuck, std::size_t from, std::size_t to) {
  std::size_t widest = from;
  double most = -1;
  for (std::size_t i = from; i < to; ++i) {
    if (!walk.neighbours(stuck.taken[i], stuck.taken[i + 1], geometry::distance(stuck.line[i], stuck.line[i + 1]))) {
      return i;
    }
    const double apart = geometry::distance(stuck.taken[i].position, stuck.taken[i + 1].position);
    if (apart > most) {
      most = apart;
      widest = i;
    }
  }
  return widest;
}

/// Where two points that follow each other are no neighbours the samples next to them are taken,
/// and where those are none either the line is cut, and its longer part kept.
base::Result<std::vector<Placed>> firmly(Walk& walk, Stuck& stuck, std::size_t count) {
  for (;;) {
    auto points = evenly(walk, stuck, count);
    if (!points) return points;
    const double step = stuck.length() / static_cast<double>(count - 1);
    std::optional<std::size_t> cut;
    for (bool changed = true; changed && !cut;) {
      changed = false;
      for (std::size_t i = 1; i < count && !cut; ++i) {
        Placed& before = (*points)[i - 1];
        Placed& here = (*points)[i];
        if (walk.neighbours(before.here, here.here, step)) continue;
        if (before.on_sample && here.on_sample) {
          cut = parting(walk, stuck, before.nearer, here.nearer);
          continue;
        }
        for (Placed* const one : {&before, &here}) *one = {stuck.taken[one->nearer], one->nearer, true};
        changed = true;
      }
    }
    if (!cut) return points;
    const Stuck begin = stuck.part(0, *cut + 1), end = stuck.part(*cut + 1, stuck.taken.size());
    stuck = begin.length() >= end.length() ? begin : end;
    if (stuck.taken.size() < 2 || !(stuck.length() > 0.0)) {
      return base::Error{"the line stays on no sheet of the surface", "", "draw it along the surface"};
    }
  }
}

/// Whether each point of a line under the pen is a neighbour of the next.
bool holds(Walk& walk, const ProjectedStroke& drawn, double length) {
  const double step = length / static_cast<double>(drawn.points.size() - 1);
  for (std::size_t i = 1; i < drawn.points.size(); ++i) {
    const Candidate before{drawn.points[i - 1], drawn.positions[i - 1], {}, 0, 0, 0, false};
    const Candidate here{drawn.points[i], drawn.positions[i], {}, 0, 0, 0, false};
    if (!walk.neighbours(before, here, step)) return false;
  }
  return true;
}

/// What of a line sticks to one sheet, where the samples under the pen are not all on one.
base::Result<ProjectedStroke> stuck_curve(Walk& walk, std::span<const PxPoint> stroke, std::size_t count,
                                          const geometry::Camera& camera, const SheetSurface& surface,
                                          SheetChoice choice) {
  walk.widen();
  Walk::Run run = walk.longest();
  if (choice == SheetChoice::other) {
    walk.leave(run);
    run = walk.longest();
    if (run.taken.size() < 2 || !(run.length > 0.0)) {
      return base::Error{"there is no other sheet of the surface near the line", "",
                         "draw the line nearer to the other sheet"};
    }
  }
  if (run.taken.size() < 2 || !(run.length > 0.0)) {
    auto drawn = surface_curve(stroke, count, camera, surface.tree);
    if (!drawn || holds(walk, *drawn, arc_length<PxPoint>(stroke))) return drawn;
    return base::Error{"the line stays on no sheet of the surface", "", "draw it along the surface"};
  }
  Stuck stuck{run.first, {}, {}};
  for (std::size_t i = 0; i < run.taken.size(); ++i) {
    const sheet_walk::Node& node = walk.nodes[run.first + i];
    stuck.taken.push_back(node.candidates[run.taken[i]]);
    walk.refine(node, stuck.taken.back());
  }
  walk.keep_beside(run, stuck.taken);
  for (std::size_t i = 0; i < stuck.taken.size(); ++i) {
    stuck.line.push_back(walk.nodes[run.first + i].px + stuck.taken[i].offset);
  }
  const auto points = firmly(walk, stuck, count);
  if (!points) return points.error();
  ProjectedStroke result;
  for (const Placed& placed : *points) {
    result.points.push_back(placed.here.point);
    result.positions.push_back(placed.here.position);
    const PxPoint off = stuck.taken[placed.nearer].offset;
    const double unit = camera.units_per_px(camera.depth(placed.here.position));
    result.aside.push_back(camera.right() * (-off.x * unit) + camera.up() * (off.y * unit));
    const double share = static_cast<double>(stuck.first + placed.nearer) / static_cast<double>(walk.nodes.size() - 1);
    result.samples.push_back(static_cast<std::size_t>(share * static_cast<double>(stroke.size() - 1)));
  }
  const bool under =
      std::all_of(stuck.taken.begin(), stuck.taken.end(), [](const Candidate& one) { return one.offset == PxPoint{}; });
  if (under) result.aside.clear();
  const double kept = static_cast<double>(stuck.taken.size()) / static_cast<double>(walk.nodes.size());
  result.dropped = stroke.size() - static_cast<std::size_t>(kept * static_cast<double>(stroke.size()));
  return result;
}

}  // namespace

base::Result<ProjectedStroke> sheet_curve(std::span<const PxPoint> stroke, std::size_t count,
                                          const geometry::Camera& camera, const SheetSurface& surface,
                                          SheetChoice choice) {
  Walk walk(camera, surface);
  const bool set_up = walk.set_up(stroke);
  if (!set_up || (choice == SheetChoice::nearer && walk.whole())) {
    auto drawn = surface_curve(stroke, count, camera, surface.tree);
    if (!set_up || !drawn || holds(walk, *drawn, arc_length<PxPoint>(stroke))) return drawn;
  }
  auto stuck = stuck_curve(walk, stroke, count, camera, surface, choice);
  for (int far = 2; far <= k_farthest_stick && (!stuck || stuck->dropped > 0); far *= 2) {
    walk.stick(far);
    auto farther = stuck_curve(walk, stroke, count, camera, surface, choice);
    if (farther && farther->dropped == 0) return farther;
  }
  return stuck;
}

}  // namespace penpose::curve
