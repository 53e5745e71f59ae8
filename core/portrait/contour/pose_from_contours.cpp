#include "core/portrait/contour/pose_from_contours.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/curve/polyline.h"
#include "core/portrait/contour/contour_solver.h"

namespace penpose::portrait {
namespace {

constexpr std::size_t k_most_contour_lines = 60;
/// Points of lines, px of the picture, and how many at most.
constexpr double k_spacing_px = 6.0, k_most_points = 260.0;
/// What it costs to lay a sheet on by the box of its lines, and for each hundredth by which these are shorter than so
/// much of all contours: a part of an outline has no box that tells.
constexpr double k_by_box = 12.0, k_outline = 0.7, k_part = 3.0;
/// Then it lies less exactly, by this factor.
constexpr double k_ease_by_box = 4.0;
/// Lines that are so many times as long as all contours are none, however often they were drawn over.
constexpr double k_most_drawn = 4.0;
/// Where two ways to lay it on differ by no more, both are solved for.
constexpr double k_close = 40.0;
/// A line is explained where so much of it lies so near to a contour, px.
constexpr double k_explained = 0.6, k_explained_px = 14.0;
/// Where less of all lines does, they are no contours of this model.
constexpr double k_explained_of_all = 0.5;

base::Result<PxBox> box_of(const ContourDrawing& drawing) {
  if (drawing.lines.empty()) return base::Error{"it has no lines", "", "draw contours of the model as lines"};
  if (drawing.lines.size() > k_most_contour_lines) {
    return base::Error{std::to_string(drawing.lines.size()) + " contour lines are more than 60", "",
                       "draw fewer, longer lines"};
  }
  PxBox box;
  for (std::size_t i = 0; i < drawing.lines.size(); ++i) {
    const std::string place = "line " + std::to_string(i);
    for (const PxPoint& p : drawing.lines[i]) {
      if (!(std::abs(p.x) < 1e9 && std::abs(p.y) < 1e9))
        return base::Error{"a point is not on a sheet", place, "use numbers of px"};
      box.add(p);
    }
    if (drawing.lines[i].size() < 2 || !(curve::arc_length<PxPoint>(drawing.lines[i]) > 0.0))
      return base::Error{"a line has no length", place, "leave dots out"};
  }
  if (!drawing.placement &&
      !(drawing.width > 0.0 && drawing.height > 0.0 && std::isfinite(drawing.width + drawing.height)))
    return base::Error{"the sheet has no size", "", "give its width and height in px"};
  return box;
}

double length_of(const ContourDrawing& drawing) {
  double length = 0;
  for (const auto& line : drawing.lines) length += curve::arc_length<PxPoint>(line);
  return length;
}

std::vector<EvenLine> even_lines(const ContourDrawing& drawing, double scale) {
  const double spacing = std::max(k_spacing_px / scale, length_of(drawing) / k_most_points);
  std::vector<EvenLine> out;
  for (const auto& line : drawing.lines) {
    const double own = curve::arc_length<PxPoint>(line);
    const auto count = static_cast<std::size_t>(std::max(1.0, std::round(own / spacing))) + 1;
    auto points = curve::resample<PxPoint>(line, count);
    out.push_back({points ? std::move(*points) : line, own / static_cast<double>(count - 1)});
  }
  return out;
}

struct Laid {
  Placement placement;
  double charge = 0;
  double ease = 1;  ///< of the sheet
};

double length_of(const SeenContours& contours) {
  double length = 0;
  for (const SeenContour& contour : contours.lines()) length += contour.lengths.back();
  return length;
}

/// Ways to lay the sheet on a view in which contours are seen.
std::vector<Laid> ways_to_lay(const ContourDrawing& drawing, const PxBox& drawn, const SeenContours& contours) {
  if (drawing.placement) return {{*drawing.placement}};
  const PxBox seen = contours.box();
  const double scale = contours.camera().viewport().height / drawing.height;
  std::vector<Laid> out{{{scale, 0, {0, 0}}}};
  const PxPoint goal = seen.high - seen.low;
  const PxPoint size = (drawn.high - drawn.low);
  const double by_box = std::sqrt(geometry::dot(goal, goal) / geometry::dot(size, size));
  const double length = length_of(drawing);
  const double outline = length_of(contours);
  for (const double one : {by_box, goal.y / size.y}) {
    if (!(std::isfinite(one) && one > 0.0)) continue;
    const double missing = std::max(0.0, k_outline - one * length / outline);
    out.push_back({{one, 0, (seen.low + seen.high) * 0.5 - (drawn.low + drawn.high) * (0.5 * one)},
                   k_by_box + 100.0 * k_part * missing,
                   k_ease_by_box});
  }
  return out;
}

/// One way to see the drawing.
struct View {
  std::size_t number = 0;
  double charge = 0;
  std::vector<EvenLine> lines;
  ContourReading still;
};

/// Which lines lie beside contours, each and all together: scribbles cross some contour somewhere.
std::vector<bool> explained_lines(std::span<const EvenLine> lines, const ContourReading& reading) {
  std::vector<bool> out;
  double beside = 0, all = 0;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    double near = 0;
    for (std::size_t i = 0; i < lines[l].points.size(); ++i) {
      const auto& place = reading.matches[l].places[i];
      near += place && geometry::distance(reading.sheet(lines[l].points[i]), place->px) < k_explained_px ? 1.0 : 0.0;
    }
    const auto points = static_cast<double>(lines[l].points.size());
    out.push_back(near >= k_explained * points);
    beside += near * lines[l].spacing;
    all += points * lines[l].spacing;
  }
  if (beside < k_explained_of_all * all) out.assign(lines.size(), false);
  return out;
}

}  // namespace

base::Result<ContourPose> pose_from_contours(const rig::Rig& rig, const mesh::TriangleMesh& mesh,
                                             const intent::WholeModel& whole, const ContourDrawing& drawing,
                                             std::span<const geometry::Camera> views, const rig::Pose& start,
                                             std::span<const std::size_t> free) {
  const auto drawn = box_of(drawing);
  if (!drawn) return drawn.error();
  std::vector<SeenContours> seen;
  std::vector<ContourControls> controls;
  for (const geometry::Camera& camera : views) {
    seen.emplace_back(rig, mesh, camera);
    controls.emplace_back(rig, whole, start, free, camera);
  }
  std::vector<View> ways;
  bool any_contour = false;
  for (std::size_t v = 0; v < views.size(); ++v) {
    seen[v].look(start);
    if (seen[v].lines().empty()) continue;
    any_contour = true;
    const double most = k_most_drawn * length_of(seen[v]);
    for (const Laid& laid : ways_to_lay(drawing, *drawn, seen[v])) {
      if (laid.placement.scale() * length_of(drawing) > most) continue;
      View one{v, laid.charge, even_lines(drawing, laid.placement.scale()), {}};
      ContourSolver solver(rig, controls[v], seen[v], one.lines, drawing.kept, start);
      one.still = solver.still({laid.placement, laid.placement((drawn->low + drawn->high) * 0.5), laid.ease});
      ways.push_back(std::move(one));
    }
  }
  if (!any_contour)
    return base::Error{"the model has no contour in this view", "", "turn the view or choose a model with a surface"};
  if (ways.empty()) return ContourPose{start, std::vector<bool>(drawing.lines.size(), false), 0, 0};
  const auto energy = [](const View& view) { return view.still.energy + view.charge; };
  std::stable_sort(ways.begin(), ways.end(), [&](const View& a, const View& b) { return energy(a) < energy(b); });
  ContourReading best;
  const View* taken = nullptr;
  double least = 1e300;
  for (std::size_t i = 0; i < std::min<std::size_t>(2, ways.size()); ++i) {
    if (energy(ways[i]) > energy(ways[0]) + k_close) break;
    const std::size_t v = ways[i].number;
    ContourSolver solver(rig, controls[v], seen[v], ways[i].lines, drawing.kept, start);
    ContourReading one = solver.solve(ways[i].still);
    if (one.energy + ways[i].charge >= least) continue;
    least = one.energy + ways[i].charge;
    best = std::move(one);
    taken = &ways[i];
  }
  ContourPose out;
  out.view = taken->number;
  out.energy = least;
  out.explained = explained_lines(taken->lines, best);
  const bool any = std::find(out.explained.begin(), out.explained.end(), true) != out.explained.end();
  out.pose = any ? controls[out.view].pose_of(best.choice) : start;
  return out;
}

}  // namespace penpose::portrait
