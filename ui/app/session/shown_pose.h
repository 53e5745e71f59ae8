#pragma once

#include <memory>
#include <optional>

#include "core/drawing/editor.h"
#include "replay/session/pen_input.h"
#include "ui/app/face/face_follow.h"
#include "ui/app/session/live_follow.h"
#include "ui/app/session/sketch_preview.h"

namespace penpose::app {

class EditingSession;

/// The pose and the model that are shown, before they are a command: what follows the pen, what a slider or the
/// timeline shows, and the control that is being sketched.
class ShownPose {
 public:
  explicit ShownPose(EditingSession& editing) : editing_(editing), face_(editing) {}

  [[nodiscard]] const rig::Pose& pose() const;
  /// The document's model, or the one with the control that is being drawn.
  [[nodiscard]] const std::shared_ptr<const document::Model>& model() const;

  /// Shows a pose in place of the document's until another or none is given.
  void preview(std::optional<rig::Pose> pose) { preview_ = std::move(pose); }
  [[nodiscard]] bool previews() const { return preview_.has_value(); }

  /// Takes a target in hand, moved by px of the view as it is: the face follows. Nothing: it is let go.
  void hold_target(std::optional<document::CurveId> curve, geometry::PxPoint by = {},
                   const std::optional<PullHold>& pull = std::nullopt);
  /// Takes a place of the model in hand, to be pulled by px of the view as it is: the face follows. False: nothing that
  /// is free moves it, or it is not seen.
  bool hold_place(const PulledPlace& place);
  /// How far it is pulled by now. Precondition: it is held.
  void pull_place(geometry::PxPoint by) { placed_by_ = by; }
  void let_place_go();
  /// Takes a control's target in hand, pulled so far; nothing: it is let go. The face follows with follow_pen.
  void hold_control_target(std::optional<document::PullBetween> pull);
  /// Brings the pose up to the pen. Call it after a batch of reports, at the latest for every frame.
  void follow_pen();
  /// The pose stays as it is shown while the pen goes on; it is brought up with the next call after that.
  void hold_still(bool on) { still_ = on; }
  /// The pose that follows the pen. Precondition: live() or face() is active.
  [[nodiscard]] const rig::Pose& pen_pose() const { return mirrored_ ? *mirrored_ : *followed(); }
  /// From now on a target in hand is pulled as by a string (LiveFollow::begin_drag).
  void pull_as_string(bool on) { string_ = on; }
  /// Shows a pose in place of the one that follows the pen, as long as one does.
  void stage(std::optional<rig::Pose> pose) { staged_ = std::move(pose); }
  [[nodiscard]] const LiveFollow& live() const { return follow_; }
  /// A line of the face under the pen.
  [[nodiscard]] const FaceFollow& face() const { return face_; }
  /// Measures once for a rig what its controls do to the whole model.
  [[nodiscard]] const intent::WholeModel& whole_model();

  [[nodiscard]] SketchPreview& sketch() { return sketch_; }
  [[nodiscard]] const SketchPreview& sketch() const { return sketch_; }

  /// No stroke is being drawn: the document is shown again.
  void end_stroke();
  /// Another document is opened.
  void forget();

 private:
  void follow_stroke();
  /// The pose that follows the pen, as it was read; null: none does.
  [[nodiscard]] const rig::Pose* followed() const {
    return follow_.active() ? &follow_.pose() : face_.active() ? &face_.pose() : nullptr;
  }

  EditingSession& editing_;
  bool still_ = false;
  bool string_ = false;
  std::optional<rig::Pose> preview_;
  std::optional<rig::Pose> staged_;
  std::optional<rig::Pose> mirrored_;  ///< of the pose that follows the pen
  LiveFollow follow_;
  FaceFollow face_;
  SketchPreview sketch_;
  bool stroke_seen_ = false;
  std::optional<document::CurveId> held_;
  geometry::PxPoint held_by_;
  std::optional<PullHold> held_pull_;
  std::optional<document::PullBetween> held_control_;
  bool control_shown_ = false;
  std::optional<geometry::PxPoint> placed_by_;  ///< how far a place of the model is pulled; nothing: none is held
  geometry::PxPoint followed_by_;
  std::size_t followed_ = 0;
};

/// Whether strokes of the tool are drawn on the model at rest.
[[nodiscard]] bool sketches(const drawing::Tool& tool);

}  // namespace penpose::app
