#include "core/document/drawing/moment.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "core/curve/distance.h"
#include "core/document/commands/apply.h"
#include "core/document/drawing/pose_problem.h"

namespace penpose::document {
namespace {

/// Views whose directions differ by no more than this see the same: cosine of 20 degrees.
constexpr double k_same_view = 0.94;
/// Who draws a reference again comes this near to the first one, in doubts of the hand, as both were before the moment.
constexpr double k_covers = 4.0;
/// And as they are now: two lips that are pressed together come apart a little.
constexpr double k_covers_now = 5.0;

bool has_target(const PoseCurve* curve) {
  return curve != nullptr && curve->role == PoseCurveRole::reference && curve->target && !curve->target->line.empty();
}

geometry::ModelVector direction_of(const View& view) {
  return geometry::normalized(view.camera.look_at - view.camera.eye);
}

/// Where a view shows the points of a reference at the document's pose; empty where it does not.
std::vector<PxPoint> seen_in(const geometry::Camera& camera, const Document& document, const PoseCurve& curve) {
  std::vector<PxPoint> out;
  for (const geometry::ModelPoint& p : positions_of(document, curve.points)) {
    const auto px = camera.project(p);
    if (!px) return {};
    out.push_back(*px);
  }
  return out;
}

/// Marks what of an earlier line's reference the last one covers: what lies along it both before the moment and now, so
/// that a closed mouth is one line and an open one two, whichever lip a line is on.
void cover(const Document& document, const rig::Pose& base, Moment::Line& line, const PoseCurve& last) {
  const PoseCurve& earlier = *find_curve(document, line.curve);
  const View& view = last.target->view;
  if (glm::dot(direction_of(earlier.target->view), direction_of(view)) < k_same_view) return;
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  if (!camera) return;
  const double hand = hand_px(document, view.viewport);
  Document before = document;
  before.pose = base;
  line.covered.resize(earlier.points.size(), false);
  std::vector<bool> covers(earlier.points.size(), true);
  const std::pair<const Document*, double> looks[] = {{&document, k_covers_now}, {&before, k_covers}};
  for (const auto& [posed, reach] : looks) {
    const auto over = seen_in(*camera, *posed, last);
    const auto points = seen_in(*camera, *posed, earlier);
    if (over.empty() || points.empty()) return;
    for (std::size_t i = 0; i < points.size(); ++i)
      covers[i] = covers[i] && curve::distance_to(over, points[i]) <= reach * hand;
  }
  for (std::size_t i = 0; i < covers.size(); ++i) line.covered[i] = line.covered[i] || covers[i];
}

/// Where the reference of a curve stands in the picture of its target; empty where it cannot be seen.
std::vector<PxPoint> seen_now(const Document& document, const PoseCurve& curve) {
  const auto camera = geometry::Camera::make(curve.target->view.camera, curve.target->view.viewport);
  if (!camera) return {};
  auto points = positions_of(document, curve.points);
  std::vector<PxPoint> out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!curve.aside.empty()) points[i] += curve.aside[i];
    const auto px = camera->project(points[i]);
    if (!px) return {};
    out.push_back(*px);
  }
  return out;
}

/// A moment that begins with the pose as it is.
Moment begun(const Document& document) {
  Moment moment;
  moment.rig = document.model->rig;
  moment.time_s = document.time_s;
  moment.base = moment.posed = document.pose;
  return moment;
}

/// The moment that goes on or begins, without the line that was just drawn.
Moment moment_before(const Document& document, CurveId drawn) {
  if (!document.moment || document.moment->time_s != document.time_s) return begun(document);
  const Moment& before = *document.moment;
  const bool whole = std::all_of(before.lines.begin(), before.lines.end(),
                                 [&](const auto& line) { return has_target(find_curve(document, line.curve)); });
  if (before.rig == document.model->rig && whole) {
    Moment moment = before;
    std::erase_if(moment.lines, [&](const auto& line) { return line.curve == drawn; });
    const auto parameters = document.model->rig->parameters();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      // What was set by hand, or is held by it, is no question any more.
      const bool locked = std::binary_search(document.locked.begin(), document.locked.end(), parameters[i].name);
      if (locked || document.pose[i] != before.posed[i]) moment.base[i] = document.pose[i];
    }
    return moment;
  }
  Moment moment = begun(document);
  for (const Moment::Line& line : before.lines) {
    const PoseCurve* curve = find_curve(document, line.curve);
    if (!has_target(curve) || line.curve == drawn) continue;
    Moment::Line held = line;
    held.held = seen_now(document, *curve);
    if (!held.held.empty()) moment.lines.push_back(std::move(held));
  }
  return moment;
}

}  // namespace

Moment moment_of(const Document& document, CurveId drawn) {
  Moment moment = moment_before(document, drawn);
  for (Moment::Line& line : moment.lines) cover(document, moment.base, line, *find_curve(document, drawn));
  moment.lines.push_back({drawn, {}, {}});
  return moment;
}

Moment lone_moment(const Document& document, CurveId drawn) {
  Moment moment = begun(document);
  moment.lines.push_back({drawn, {}, {}});
  return moment;
}

std::shared_ptr<const Moment> moment_of_all(const Document& document, rig::Pose posed) {
  Moment moment = begun(document);
  moment.posed = std::move(posed);
  for (const auto& curve : document.curves) {
    if (has_target(curve.get())) moment.lines.push_back({curve->id, {}, {}});
  }
  if (moment.lines.empty()) return nullptr;
  return std::make_shared<const Moment>(std::move(moment));
}

bool is_last_line(const Document& document, CurveId curve) {
  const Moment* moment = document.moment.get();
  return moment != nullptr && !moment->lines.empty() && moment->lines.back().curve == curve &&
         moment->rig == document.model->rig && moment->time_s == document.time_s &&
         has_target(find_curve(document, curve));
}

rig::Pose pose_of_reading(const Document& document, std::size_t which) {
  const Moment& moment = *document.moment;
  const rig::Pose& reading = moment.others[which].pose;
  rig::Pose pose = document.pose;
  for (std::size_t i = 0; i < pose.size(); ++i) {
    if (reading[i] != moment.posed[i]) pose[i] = reading[i];
  }
  return pose;
}

std::vector<CurveId> drawn_anew(const Moment& moment) {
  std::vector<CurveId> anew;
  for (const Moment::Line& line : moment.lines) {
    const auto covered = static_cast<double>(std::count(line.covered.begin(), line.covered.end(), true));
    if (!line.covered.empty() && covered >= k_drawn_anew * static_cast<double>(line.covered.size()))
      anew.push_back(line.curve);
  }
  return anew;
}

}  // namespace penpose::document
