#include "ui/app/playback/ghosts.h"

#include <algorithm>
#include <cmath>

#include "core/curve/distance.h"
#include "core/document/commands/apply.h"
#include "core/document/time/timeline_editing.h"
#include "ui/app/playback/frames.h"

namespace penpose::app {
namespace {

constexpr double k_ghost_same_s = 1e-6;
/// A line farther from all ghosts than this share of the view's height is about none of them.
constexpr double k_ghost_near_share = 0.12;
/// Less is no change, as a share of a control's range.
constexpr double k_ghost_moved_share = 1e-4;

/// How far the line is from the curve, and the curve from the line, px.
double px_apart(std::span<const PxPoint> line, std::span<const PxPoint> curve) {
  const auto mean = [](std::span<const PxPoint> from, std::span<const PxPoint> to) {
    double sum = 0;
    for (const PxPoint& at : from) sum += curve::distance_to(to, at);
    return sum / static_cast<double>(from.size());
  };
  return 0.5 * (mean(line, curve) + mean(curve, line));
}

/// The document as at the ghost's moment, with its curve alone, brought to the line.
std::optional<rig::Pose> solved_at(const document::Document& document, const Ghost& ghost, const document::View& view,
                                   std::span<const PxPoint> line) {
  document::Document at = document;
  at.time_s = ghost.time_s;
  at.pose = document::pose_at(document, ghost.time_s);
  at.face = nullptr;
  at.moment = nullptr;
  at.curves = {std::make_shared<const document::PoseCurve>(ghost.curve)};
  at.last_curve = std::max(at.last_curve, ghost.curve.id.value);
  document::ApplyWorkspace work;
  const auto after =
      document::apply(at, document::DrawTarget{ghost.curve.id, view, {line.begin(), line.end()}, {}}, work);
  if (!after) return std::nullopt;
  return after->pose;
}

}  // namespace

double share_left(double time_s, double changed_s, double from_s, double to_s) {
  const double end_s = time_s < changed_s ? from_s : to_s;
  if (time_s == changed_s) return 1;
  if (end_s == changed_s) return 0;
  const double u = std::clamp((time_s - end_s) / (changed_s - end_s), 0.0, 1.0);
  return u * u * (3 - 2 * u);
}

std::vector<Ghost> ghosts_of(const document::Document& document, const document::View& view) {
  std::vector<Ghost> ghosts;
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  const document::PoseKey* before = nullptr;
  const document::PoseKey* after = nullptr;
  for (const document::PoseKey& key : document.timeline->keys) {
    if (key.time_s < document.time_s - k_ghost_same_s) before = &key;
    if (key.time_s > document.time_s + k_ghost_same_s && after == nullptr) after = &key;
  }
  std::vector<document::PoseCurve> curves;
  for (const auto& curve : document.curves) {
    if (curve->role != document::PoseCurveRole::reference || curve->points.size() < 2) continue;
    curves.push_back(*curve);
    curves.back().target.reset();
  }
  if (document.curves.empty()) {
    for (const auto& curve : document.model->curves) {
      if (curve.points.size() < 2) continue;
      document::PoseCurve reference;
      reference.id = {document.last_curve + 1};
      reference.points = curve.points;
      curves.push_back(std::move(reference));
    }
  }
  for (const document::PoseKey* key : {before, after}) {
    if (key == nullptr || !camera) continue;
    document::Document at = document;
    at.pose = document::pose_at(document, key->time_s);
    for (const document::PoseCurve& curve : curves) {
      Ghost ghost{key->time_s, curve, {}};
      for (const auto& point : document::positions_of(at, curve.points)) {
        if (const auto px = camera->project(point)) ghost.places.push_back(*px);
      }
      if (ghost.places.size() == curve.points.size()) ghosts.push_back(std::move(ghost));
    }
  }
  return ghosts;
}

std::optional<GhostEdit> ghost_meant(const document::Document& document, const document::View& view,
                                     std::span<const PxPoint> line) {
  if (line.size() < 2) return std::nullopt;
  const std::vector<Ghost> ghosts = ghosts_of(document, view);
  const Ghost* nearest = nullptr;
  double least = k_ghost_near_share * view.viewport.height;
  for (const Ghost& ghost : ghosts) {
    const double px = px_apart(line, ghost.places);
    if (px >= least) continue;
    least = px;
    nearest = &ghost;
  }
  if (nearest == nullptr) return std::nullopt;
  const auto posed = solved_at(document, *nearest, view, line);
  if (!posed) return std::nullopt;
  const double time_s = nearest->time_s;
  const document::Timeline& timeline = *document.timeline;
  const auto parameters = document.model->rig->parameters();
  const rig::Pose was = document::pose_at(document, time_s);
  GhostEdit edit;
  edit.time_s = edit.from_s = edit.to_s = time_s;
  for (std::size_t p = 0; p < posed->size(); ++p) {
    const double by = (*posed)[p] - was[p];
    if (std::abs(by) <= k_ghost_moved_share * (parameters[p].maximum - parameters[p].minimum)) continue;
    edit.controls.push_back(p);
    edit.by.push_back(by);
  }
  if (edit.controls.empty()) return std::nullopt;
  const std::size_t place = document::first_from(timeline, time_s);
  if (place > 0) edit.from_s = timeline.keys[place - 1].time_s;
  if (place + 1 < timeline.keys.size()) edit.to_s = timeline.keys[place + 1].time_s;
  return edit;
}

document::Command command_of(const document::Document& document, const GhostEdit& edit) {
  const document::Timeline& timeline = *document.timeline;
  const auto parameters = document.model->rig->parameters();
  const auto has = [&](double time_s, std::size_t p) {
    const auto place = document::key_at(timeline, time_s);
    return place && timeline.keys[*place].controls.has(p);
  };
  const auto has_all = [&](double time_s) {
    return std::all_of(edit.controls.begin(), edit.controls.end(), [&](std::size_t p) { return has(time_s, p); });
  };
  std::vector<double> moments{edit.time_s};
  for (const double end_s : {edit.from_s, edit.to_s}) {
    if (end_s != edit.time_s && !has_all(end_s)) moments.push_back(end_s);
  }
  for (const document::PoseKey& key : timeline.keys) {
    const bool within = key.time_s > edit.from_s && key.time_s < edit.to_s && key.time_s != edit.time_s;
    if (within &&
        std::any_of(edit.controls.begin(), edit.controls.end(), [&](std::size_t p) { return key.controls.has(p); }))
      moments.push_back(key.time_s);
  }
  std::sort(moments.begin(), moments.end());
  document::KeyPoses keys;
  document::SetKeyValues values;
  for (const std::size_t p : edit.controls) keys.names.push_back(parameters[p].name);
  for (const double time_s : moments) {
    const rig::Pose pose = document::pose_at(document, time_s);
    const double share = share_left(time_s, edit.time_s, edit.from_s, edit.to_s);
    for (std::size_t c = 0; c < edit.controls.size(); ++c) {
      const rig::Parameter& range = parameters[edit.controls[c]];
      const double value = std::clamp(pose[edit.controls[c]] + share * edit.by[c], range.minimum, range.maximum);
      keys.values.push_back(value);
      values.values.push_back(value);
      values.times_s.push_back(time_s);
      values.names.push_back(range.name);
    }
  }
  keys.times_s = moments;
  // Keys that are there go on as they did.
  if (std::all_of(moments.begin(), moments.end(), has_all)) return values;
  return keys;
}

void GhostHand::draw(std::span<const PxPoint> line) {
  const document::Document& document = editing_.document();
  const auto edit = ghost_meant(document, editing_.editor().view(), line);
  if (!edit) {
    return notices_.tell(ghosts_of(document, editing_.editor().view()).empty()
                             ? "there is no ghost here: key poses before or after this moment, and draw a feature"
                             : "Nothing changed: draw where a line of a ghost should be, near to it");
  }
  if (!perform(*edit)) return;
  notices_.tell("frame " + frame_text(edit->time_s, playback_.rate()) + " was changed, from frame " +
                frame_text(edit->from_s, playback_.rate()) + " to " + frame_text(edit->to_s, playback_.rate()) +
                "; the bar over the timeline sets how far it goes");
}

bool GhostHand::perform(const GhostEdit& edit) {
  const document::Document& document = editing_.document();
  const bool keyed = document.pose == document::pose_at(document, document.time_s);
  const double now_s = document.time_s;
  last_.reset();
  if (!editing_.perform(command_of(document, edit))) return false;
  // Between two keys the pose goes along; one that is not keyed stays.
  if (keyed) editing_.perform_with(document::GoToTime{now_s});
  last_ = edit;
  revision_ = editing_.revision();
  return true;
}

void GhostHand::reach(double from_s, double to_s) {
  if (last() == nullptr) return;
  GhostEdit edit = *last_;
  edit.from_s = std::clamp(from_s, 0.0, edit.time_s);
  edit.to_s = std::clamp(to_s, edit.time_s, document::k_latest_key_s);
  if (edit.from_s == last_->from_s && edit.to_s == last_->to_s) return;
  editing_.steps().undo();
  perform(edit);
}

}  // namespace penpose::app
