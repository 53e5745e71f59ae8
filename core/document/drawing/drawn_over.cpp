#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/curve/bend.h"
#include "core/curve/pairing.h"
#include "core/curve/polyline.h"
#include "core/document/drawing/target_line.h"

namespace penpose::document {
namespace {

using curve::PxPoint;
using geometry::ModelPoint;

/// Over so many times the gap between a stroke's end and the line the stroke is led over to it.
constexpr double k_lead = 3;

PxPoint at_length(std::span<const PxPoint> line, std::span<const double> cumulative, double length) {
  const auto place = curve::place_at(cumulative, std::clamp(length / cumulative.back(), 0.0, 1.0));
  const PxPoint& from = line[place.segment];
  return from + (line[std::min(place.segment + 1, line.size() - 1)] - from) * place.fraction;
}

/// The part of the target that is drawn anew, in px of its length from its start. It begins behind its end where the
/// part of a closed target runs over the seam.
struct Part {
  double from = 0;
  double to = 0;
  bool over_seam = false;

  [[nodiscard]] double length(double all) const { return over_seam ? all - from + to : to - from; }
  /// How far into the part a place lies; nothing outside of it.
  [[nodiscard]] std::optional<double> into(double at, double all) const {
    if (!over_seam) return at >= from && at <= to ? std::optional(at - from) : std::nullopt;
    if (at >= from) return at - from;
    return at <= to ? std::optional(all - from + at) : std::nullopt;
  }
};

/// The stroke, turned to run as the target does, with its ends led over to the target where that goes on.
class Patch {
 public:
  Patch(std::span<const PxPoint> stroke, bool turned) : line_(stroke.begin(), stroke.end()) {
    if (turned) std::reverse(line_.begin(), line_.end());
    cumulative_ = curve::cumulative_length(std::span<const PxPoint>(line_));
  }
  [[nodiscard]] double length() const { return cumulative_.back(); }
  [[nodiscard]] std::span<const PxPoint> line() const { return line_; }
  [[nodiscard]] PxPoint at(double share) const { return at_length(line_, cumulative_, share * length()); }

  void lead(std::optional<PxPoint> start, std::optional<PxPoint> end) {
    const std::vector<PxPoint> drawn = line_;
    const auto pull = [&](PxPoint to, PxPoint from, bool at_end) {
      const PxPoint gap = to - from;
      const double reach = std::min(k_lead * geometry::distance(to, from), 0.5 * length());
      for (std::size_t i = 0; i < line_.size(); ++i) {
        const double along = at_end ? length() - cumulative_[i] : cumulative_[i];
        if (along < reach) line_[i] = line_[i] + gap * (1 - along / reach);
      }
    };
    if (start) pull(*start, drawn.front(), false);
    if (end) pull(*end, drawn.back(), true);
  }

 private:
  std::vector<PxPoint> line_;
  std::vector<double> cumulative_;  ///< of the stroke as it was drawn
};

Part part_of(std::span<const PxPoint> seen, std::span<const double> cumulative, std::span<const PxPoint> stroke,
             double near_px, bool& turned) {
  const bool closed = curve::is_closed(seen, near_px);
  const double all = cumulative.back();
  // A stroke that ends about at the target's end redraws that, too.
  const auto place = [&](PxPoint end) {
    const double at = curve::nearest_along(seen, cumulative, end);
    const double reach = std::max(near_px, 0.5 * geometry::distance(end, at_length(seen, cumulative, at)));
    if (closed || std::min(at, all - at) > reach) return at;
    return at < 0.5 * all ? 0 : all;
  };
  const double first = place(stroke.front());
  const double last = place(stroke.back());
  turned = last < first;
  Part part{std::min(first, last), std::max(first, last), false};
  if (!closed) return part;
  // Of the two ways around the one that the stroke's middle lies at.
  const double middle = curve::nearest_along(seen, cumulative, stroke[stroke.size() / 2]);
  if (part.into(middle, cumulative.back())) return part;
  turned = !turned;
  return {part.to, part.from, true};
}

/// The target's line as it is now, for drawing it: its points outside of the part and the patch between them.
void draw_line(DrawnTarget& target, std::span<const PxPoint> seen, std::span<const double> cumulative, const Part& part,
               const Patch& patch, double hardest) {
  std::vector<PxPoint> line;
  std::vector<double> pressure;
  const double strongest = *std::max_element(target.weights.begin(), target.weights.end());
  const auto pressed = [&](std::size_t i) { return strongest > 0 ? target.weights[i] / strongest * hardest : hardest; };
  bool patched = false;
  double last = hardest;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    last = pressed(i);
    if (!part.into(cumulative[i], cumulative.back())) {
      line.push_back(seen[i]);
      pressure.push_back(last);
    } else if (!std::exchange(patched, true)) {
      line.insert(line.end(), patch.line().begin(), patch.line().end());
      pressure.insert(pressure.end(), patch.line().size(), last);
    }
  }
  if (auto even = curve::resample(std::span<const PxPoint>(line), k_line_points)) {
    const auto old = curve::cumulative_length(std::span<const PxPoint>(line));
    target.line = std::move(*even);
    target.pressure.clear();
    for (std::size_t i = 0; i < k_line_points; ++i) {
      const auto place = curve::place_at(old, static_cast<double>(i) / static_cast<double>(k_line_points - 1));
      const double a = pressure[place.segment];
      const double b = pressure[std::min(place.segment + 1, pressure.size() - 1)];
      target.pressure.push_back(std::clamp(a + (b - a) * place.fraction, 0.0, 1.0));
    }
  }
}

}  // namespace

base::Result<DrawnTarget> drawn_over(const DrawnTarget& before, std::span<const ModelPoint> reference, const View& view,
                                     std::span<const PxPoint> stroke) {
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  if (!camera) return camera.error();
  const base::Error short_stroke{"the line has no length", "line", "draw a longer one"};
  if (stroke.size() < 2) return short_stroke;
  if (before.points.size() != reference.size() || before.weights.size() != reference.size() ||
      before.pressure.empty()) {
    return base::Error{"the target does not fit its curve", "curve", "draw the target again"};
  }
  std::vector<PxPoint> seen;
  for (const ModelPoint& point : before.points) {
    const auto px = camera->project(point);
    if (!px) return base::Error{"the target lies behind the camera", "view", "look at it and draw again"};
    seen.push_back(*px);
  }
  const auto cumulative = curve::cumulative_length(std::span<const PxPoint>(seen));
  if (seen.size() < 2 || !(cumulative.back() > 0)) {
    return base::Error{"the target has no length in this view", "view", "turn the view so that it is visible"};
  }
  bool turned = false;
  const Part part = part_of(seen, cumulative, stroke, curve::pairing_distance_px(view.viewport), turned);
  Patch patch(stroke, turned);
  if (!(patch.length() > 0) || !std::isfinite(patch.length())) return short_stroke;
  // An end of the target that is drawn anew goes where it was drawn; elsewhere the target goes on.
  const double all = cumulative.back();
  const auto join = [&](double at, bool end) {
    return end ? std::nullopt : std::optional(at_length(seen, cumulative, at));
  };
  patch.lead(join(part.from, !part.over_seam && part.from <= 0), join(part.to, !part.over_seam && part.to >= all));
  DrawnTarget target = before;
  target.view = view;
  bool changed = false;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const auto into = part.into(cumulative[i], all);
    if (!into) continue;
    const double share = part.length(all) > 0 ? *into / part.length(all) : 0.5;
    target.points[i] = curve::lift(patch.at(share), reference[i], *camera);
    changed = true;
  }
  if (!changed || !(part.length(all) > 0)) {
    return base::Error{"the line runs along no part of the target", "line", "draw over the part that should change"};
  }
  const double hardest = *std::max_element(before.pressure.begin(), before.pressure.end());
  draw_line(target, seen, cumulative, part, patch, hardest);
  return target;
}

}  // namespace penpose::document
