#include "ui/app/playback/ghosts.h"

#include <algorithm>
#include <cmath>

#include "core/document/time/timeline_editing.h"
#include "ui/app/face/feature_words.h"
#include "ui/app/playback/frames.h"

namespace penpose::app {
namespace {

/// A place farther from all ghosts than this share of the view's height is about none of them.
constexpr double k_ghost_near_share = 0.06;
/// Less is no change, as a share of a control's range.
constexpr double k_ghost_moved_share = 1e-4;

}  // namespace

double share_left(double time_s, double changed_s, double from_s, double to_s) {
  const double end_s = time_s < changed_s ? from_s : to_s;
  if (time_s == changed_s) return 1;
  if (end_s == changed_s) return 0;
  const double u = std::clamp((time_s - end_s) / (changed_s - end_s), 0.0, 1.0);
  return u * u * (3 - 2 * u);
}

std::optional<GhostEdit> ghost_edit(const document::Document& document, double time_s, const rig::Pose& posed) {
  const document::Timeline& timeline = *document.timeline;
  const auto parameters = document.model->rig->parameters();
  const rig::Pose was = document::pose_at(document, time_s);
  GhostEdit edit;
  edit.time_s = edit.from_s = edit.to_s = time_s;
  for (std::size_t p = 0; p < posed.size(); ++p) {
    const double by = posed[p] - was[p];
    if (std::abs(by) <= k_ghost_moved_share * (parameters[p].maximum - parameters[p].minimum)) continue;
    edit.controls.push_back(p);
    edit.by.push_back(by);
  }
  if (edit.controls.empty()) return std::nullopt;
  const std::size_t place = document::first_from(timeline, time_s);
  if (place > 0) edit.from_s = timeline.keys[place - 1].time_s;
  const std::size_t next = document::key_at(timeline, time_s) ? place + 1 : place;
  if (next < timeline.keys.size()) edit.to_s = timeline.keys[next].time_s;
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

void GhostHand::follow(std::optional<double> time_s, std::optional<PxPoint> pen) {
  if (!time_s) {
    faces_.forget();
    drawings_ = {};
    veil_.reset();
    draws_veil_.reset();
    lit_.reset();
    made_ = {};
    return;
  }
  EditingSession& editing = parts_.editing;
  const document::View view{parts_.canvas.view().camera, parts_.canvas.window()};
  const render::GhostLook& look = parts_.look.ghosts;
  // A line that is being drawn keeps the ghost on which it began.
  if (!editing.pen_is_drawing()) lit_.reset();
  faces_.look_at({editing.document(), editing.features(), view, *time_s, static_cast<double>(parts_.playback.rate())},
                 look);
  if (pen && !editing.pen_is_drawing()) lit_ = place_at(*pen);
  const auto scale = static_cast<float>(parts_.canvas.scale());
  Made now{faces_.number(), parts_.canvas.surface().pose_number(), view, look.style, scale, lit_};
  if (now == made_) return;
  // A veil takes as long as a picture or two: it waits until the view rests and the pen is lifted.
  const bool waits = editing.pen_is_drawing() && faces_.settled() && look.style == made_.style;
  made_ = std::move(now);
  drawings_.clear();
  if (!waits) veil_.reset();
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  if (!camera || faces_.ghosts().empty()) return;
  const auto positions = parts_.canvas.surface().positions();
  drawings_ = render::ghost_drawings(faces_.ghosts(), positions, *camera, {scale, lit_});
  if (look.style != render::GhostStyle::faces) {
    draws_veil_.reset();
  } else if (!waits && faces_.settled()) {
    draw_veil(*camera);
  }
  if (waits) made_.pose = 0;
}

void GhostHand::draw_veil(const geometry::Camera& camera) {
  if (!draws_veil_) draws_veil_ = std::make_unique<render::GhostVeil>();
  const PosedSurface& surface = parts_.canvas.surface();
  veil_ = draws_veil_->draw(faces_.ghosts(),
                            {*surface.model().mesh, surface.appearance(), surface.shape_number(), surface.positions()},
                            camera, {made_.scale, lit_});
}

std::optional<render::GhostPlace> GhostHand::place_at(PxPoint at) const {
  return render::ghost_near(faces_.ghosts(), at, k_ghost_near_share * parts_.canvas.window().height);
}

std::optional<double> GhostHand::lit_s() const {
  if (!lit_ || lit_->ghost >= faces_.ghosts().size()) return std::nullopt;
  return faces_.ghosts()[lit_->ghost].moment.time_s;
}

std::string GhostHand::hint() const {
  if (parts_.editing.document().timeline->keys.size() < 2)
    return "Key two poses first: then the face before and after is seen as ghosts";
  if (faces_.ghosts().empty()) return "No ghosts here: go to a moment between keys, or show more of them (Onion)";
  const auto at_s = lit_s();
  if (!at_s) return "Come near a line of a ghost, before (violet) or after (cyan), and draw it as it should be";
  const auto& lines = faces_.ghosts()[lit_->ghost].lines;
  const std::string feature = lit_->line < lines.size() ? lines[lit_->line].feature : std::string();
  return "A line here poses frame " + frame_text(*at_s, parts_.playback.rate()) +
         (*at_s < parts_.playback.time_s() ? " (before)" : " (after)") +
         (feature.empty() ? std::string() : ", near its " + feature_words(feature));
}

std::optional<rig::Pose> GhostHand::solved(const render::Ghost& ghost, const render::GhostLine& near,
                                           std::span<const PxPoint> line) {
  EditingSession& editing = parts_.editing;
  document::Document at = editing.document();
  at.time_s = ghost.moment.time_s;
  at.pose = ghost.pose;
  at.moment = nullptr;
  // Lines that were drawn at that moment are read on with.
  if (at.face && at.face->time_s != at.time_s) at.face = nullptr;
  const document::View& view = editing.editor().view();
  const std::vector<PxPoint> points(line.begin(), line.end());
  const auto* curve = near.curve ? document::find_curve(at, *near.curve) : nullptr;
  if (curve == nullptr) {
    const auto after = editing.after(at, document::DrawFaceLine{{view, points}});
    return after ? std::optional(after->pose) : std::nullopt;
  }
  document::PoseCurve reference = *curve;
  reference.target.reset();
  at.curves = {std::make_shared<const document::PoseCurve>(std::move(reference))};
  const auto after = editing.after(at, document::DrawTarget{*near.curve, view, points, {}});
  return after ? std::optional(after->pose) : std::nullopt;
}

void GhostHand::draw(std::span<const PxPoint> line) {
  if (line.size() < 2) return;
  const auto ghosts = faces_.ghosts();
  const auto place = place_at(line.front());
  if (!place || place->ghost >= ghosts.size()) {
    return parts_.notices.tell(
        ghosts.empty() ? "There is no ghost here: key poses before or after this moment, or show more ghosts (Onion)"
                       : "Nothing changed: begin the line near a line of a ghost");
  }
  const render::Ghost& ghost = ghosts[place->ghost];
  const auto posed = solved(ghost, ghost.lines[place->line], line);
  const auto edit =
      posed ? ghost_edit(parts_.editing.document(), ghost.moment.time_s, *posed) : std::optional<GhostEdit>();
  if (!edit) return parts_.notices.tell("Nothing changed: draw a lip, a lid or a brow of the ghost where it should be");
  if (!perform(*edit)) return;
  const int rate = parts_.playback.rate();
  parts_.notices.tell("Frame " + frame_text(edit->time_s, rate) + " was changed, from frame " +
                      frame_text(edit->from_s, rate) + " to " + frame_text(edit->to_s, rate) +
                      "; drag the bar over the timeline to change how far it goes");
}

bool GhostHand::perform(const GhostEdit& edit) {
  const document::Document& document = parts_.editing.document();
  const bool keyed = document.pose == document::pose_at(document, document.time_s);
  const double now_s = document.time_s;
  last_.reset();
  if (!parts_.editing.perform(command_of(document, edit))) return false;
  // Between two keys the pose goes along; one that is not keyed stays.
  if (keyed) parts_.editing.perform_with(document::GoToTime{now_s});
  last_ = edit;
  revision_ = parts_.editing.revision();
  return true;
}

void GhostHand::reach(double from_s, double to_s) {
  if (last() == nullptr) return;
  GhostEdit edit = *last_;
  edit.from_s = std::clamp(from_s, 0.0, edit.time_s);
  edit.to_s = std::clamp(to_s, edit.time_s, document::k_latest_key_s);
  if (edit.from_s == last_->from_s && edit.to_s == last_->to_s) return;
  parts_.editing.steps().undo();
  perform(edit);
}

}  // namespace penpose::app
