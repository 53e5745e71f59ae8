#include "ui/app/session/shown_pose.h"

#include <utility>

#include "ui/app/session/editing_session.h"
#include "ui/app/tools/tool.h"

namespace penpose::app {

bool sketches(const drawing::Tool& tool) { return window_tool(tool.kind).preview == ToolPreview::sketch; }

const rig::Pose& ShownPose::pose() const {
  const rig::Pose& posed = editing_.document().pose;
  if (followed() != nullptr) return staged_ ? *staged_ : pen_pose();
  if (preview_ && preview_->size() == posed.size() && !sketch_.model()) return *preview_;
  if (sketch_.pose()) return *sketch_.pose();
  return posed;
}

const std::shared_ptr<const document::Model>& ShownPose::model() const {
  return sketch_.model() ? sketch_.model() : editing_.document().model;
}

void ShownPose::hold_target(std::optional<document::CurveId> curve, geometry::PxPoint by,
                            const std::optional<PullHold>& pull) {
  held_pull_ = pull;
  held_ = curve;
  held_by_ = by;
  if (held_) return;
  follow_.end();
  mirrored_.reset();
}

bool ShownPose::hold_place(const PulledPlace& place) {
  preview_.reset();
  if (!follow_.begin_pull(editing_.document(), editing_.editor().view(), place)) return false;
  placed_by_.emplace();
  followed_by_ = {};
  return true;
}

void ShownPose::let_place_go() {
  if (!placed_by_) return;
  placed_by_.reset();
  follow_.end();
  mirrored_.reset();
}

void ShownPose::hold_control_target(std::optional<document::PullBetween> pull) {
  if (held_control_ == pull) return;
  if (!pull) sketch_.end();
  held_control_ = std::move(pull);
  control_shown_ = false;
}

void ShownPose::follow_pen() {
  if (still_) return;
  follow_stroke();
  mirrored_.reset();
  const rig::Pose* followed_pose = followed();
  if (!editing_.habits().mirrors || followed_pose == nullptr) return;
  const document::Document& document = editing_.document();
  mirrored_ = on_both_sides(document.model->rig->parameters(), editing_.two_sided_pairs(), document.pose,
                            *followed_pose, document::weight_count(*document.model));
}

void ShownPose::follow_stroke() {
  const document::Document& document = editing_.document();
  const drawing::Tool& tool = editing_.editor().tool();
  if (held_) {
    if (!follow_.active() || !(follow_.curve() == *held_)) {
      follow_.begin_drag(document, *held_, editing_.editor().view(), held_pull_, string_);
      followed_by_ = {};
    }
    // What is performed settles where the pen rests.
    if (staged_ || !(followed_by_ == held_by_)) follow_.drag(held_by_);
    followed_by_ = held_by_;
    return;
  }
  if (placed_by_) {
    // What is performed settles where the pen rests; before the pen has moved nothing does.
    const bool moved = !(followed_by_ == *placed_by_);
    if (moved || (staged_ && !(*placed_by_ == geometry::PxPoint{}))) follow_.drag(*placed_by_);
    followed_by_ = *placed_by_;
    return;
  }
  if (held_control_) {
    if (!std::exchange(control_shown_, true)) sketch_.pull(document, *held_control_);
    return;
  }
  const replay::DrawnStroke* stroke = editing_.session().pens().current();
  if (stroke == nullptr || !stroke->on_canvas || stroke->eraser) {
    if (stroke == nullptr) {
      follow_.end();
      face_.end();
    }
    if (sketches(tool)) sketch_.show(document, tool);
    return;
  }
  if (!stroke_seen_) {
    stroke_seen_ = true;
    followed_ = 0;
    preview_.reset();
    follow_.begin(document, tool, stroke->view, stroke->samples);
  }
  if (!staged_ && stroke->samples.size() == followed_) return;
  if (tool.kind == drawing::ToolKind::draw && !drawing::is_tap(stroke->samples, stroke->view.viewport)) {
    if (face_.follow(stroke->view, curve::positions_of(stroke->samples))) followed_ = stroke->samples.size();
    return;
  }
  followed_ = stroke->samples.size();
  follow_.follow(stroke->samples);
  if (sketches(tool)) sketch_.follow(document, tool, stroke->view, stroke->samples);
}

const intent::WholeModel& ShownPose::whole_model() { return follow_.whole_of(editing_.document()); }

void ShownPose::end_stroke() {
  follow_.end();
  face_.end();
  sketch_.stroke_ended();
  stroke_seen_ = false;
  mirrored_.reset();
}

void ShownPose::forget() {
  follow_.end();
  face_.end();
  sketch_.end();
  preview_.reset();
  staged_.reset();
  mirrored_.reset();
  held_.reset();
  held_control_.reset();
  placed_by_.reset();
  stroke_seen_ = false;
}

}  // namespace penpose::app
