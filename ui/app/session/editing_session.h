#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "replay/session/live_session.h"
#include "replay/session/virtual_pen.h"
#include "ui/app/input/side_pairs.h"
#include "ui/app/session/live_follow.h"
#include "ui/app/session/sketch_preview.h"
#include "ui/app/session/step_list.h"

namespace penpose::app {

/// A parameter that the last stroke moved.
struct Movement {
  std::string name;
  double by = 0;
  bool at_limit = false;  ///< it stands at an end of its range
};

/// What is done besides with a change of the pose.
struct Habits {
  bool mirrors = false;                                ///< what a stroke does on one side is done on both
  std::optional<std::pair<double, std::string>> keys;  ///< the pose is keyed at a moment, under a name
};

/// The document being worked on and what is shown of it: a session, the pose under the pen before it is a command, and
/// what there is to say. Knows neither window nor panels.
class EditingSession {
 public:
  /// Microseconds of a clock that never goes back.
  using Clock = std::function<std::int64_t()>;
  /// Tells somebody something; `is_error` where it did not work.
  using Tell = std::function<void(std::string text, bool is_error)>;

  EditingSession(Clock clock, Tell tell, const decode::TabletTable* own = nullptr);

  /// Begins a session on a document. `writer` may be null and must outlive the session.
  void open(document::Document document, replay::SessionWriter* writer, const std::string& path);

  /// Goes on with a session that was read from what `writer` adds to, and that ended at `last_us`. It counts as
  /// unsaved.
  void resume(replay::Session session, replay::SessionWriter* writer, std::int64_t last_us);

  [[nodiscard]] const drawing::Editor& editor() const { return live_->session().editor(); }
  [[nodiscard]] const document::Document& document() const { return editor().document(); }
  [[nodiscard]] const replay::Session& session() const { return live_->session(); }
  [[nodiscard]] document::DocumentState state() { return live_->session().editor().state(); }
  [[nodiscard]] bool pen_is_drawing() const { return session().pens().current() != nullptr; }

  // What the user does. What is refused is told, and changes nothing.
  bool perform(const document::Command& command);
  /// The same as a part of what was performed before it: one step of undo takes back both.
  bool perform_with(const document::Command& command);
  /// One step, as an animator counts them (step_list.h), and the moves in time on the way.
  void undo();
  void redo();
  /// Undoes or redoes until so many commands are done.
  void go_to_step(std::size_t commands);
  [[nodiscard]] std::size_t can_undo() const { return commands_to_undo(editor().history(), joined_); }
  [[nodiscard]] std::size_t can_redo() const { return commands_to_redo(editor().history(), joined_); }
  [[nodiscard]] std::vector<ListedStep> steps() const { return listed_steps(editor().history(), joined_); }
  /// What is done besides with every change of the pose from now on.
  void set_habits(const Habits& habits) { habits_ = habits; }
  /// Controls of one side and the other that do the same, by their numbers (side_pairs.h).
  [[nodiscard]] const std::vector<std::size_t>& two_sided_pairs();
  void set_tool(drawing::Tool tool);
  void set_view(const document::View& view);
  void set_tablet(int device, const replay::TabletSetting& setting);
  /// Whether strokes that begin from now on draw.
  void place_pen(bool on_canvas);
  /// A line of a session that is being played.
  void play(const replay::SessionLine& line) { act(line); }

  /// The pointer that is no tablet.
  std::vector<replay::PenMoment> pen(const replay::VirtualPenState& state);
  void connect(int device, const decode::DeviceIdentity& identity);
  /// Its stroke ends.
  void disconnect(int device);
  /// Which lights are on beside the dials of a tablet.
  void see_lights(int device, const decode::Lights& lights);
  std::vector<replay::PenMoment> report(int device, base::Bytes bytes);
  /// The same of a report that came at a moment of the clock.
  std::vector<replay::PenMoment> report_at(int device, std::int64_t received_us, base::Bytes bytes);
  /// Brings the preview up to the pen. Call it after a batch of reports, at the latest for every frame.
  void follow_pen();

  /// A target in hand, moved by px of the view as it is: the face follows. Nothing: it was let go.
  void hold_target(std::optional<document::CurveId> curve, geometry::PxPoint by = {},
                   const std::optional<PullHold>& pull = std::nullopt);
  /// How a control's target is pulled so far; nothing: it is not in hand. The face follows with follow_pen.
  void hold_control_target(std::optional<document::PullBetween> pull);

  /// A pose to show in place of the document's until another or none is given: a slider or the timeline in hand.
  void preview(std::optional<rig::Pose> pose) { preview_ = std::move(pose); }
  [[nodiscard]] bool previews() const { return preview_.has_value(); }
  [[nodiscard]] const rig::Pose& shown_pose() const;
  /// The pose that follows the pen. Precondition: live() is active.
  [[nodiscard]] const rig::Pose& pen_pose() const { return mirrored_ ? *mirrored_ : follow_.pose(); }
  /// A pose to show in place of the one that follows the pen, as long as one does.
  void stage(std::optional<rig::Pose> pose) { staged_ = std::move(pose); }
  /// The model that is shown: the document's, or with the deformer that is being drawn.
  [[nodiscard]] const std::shared_ptr<const document::Model>& shown_model() const;
  [[nodiscard]] const LiveFollow& live() const { return follow_; }
  [[nodiscard]] SketchPreview& sketch() { return sketch_; }
  [[nodiscard]] const SketchPreview& sketch() const { return sketch_; }

  /// What the last stroke that solved moved, the most first.
  [[nodiscard]] const std::vector<Movement>& movements() const { return movements_; }
  /// px that the last stroke that solved leaves between its curve and its target, in the mean; negative: not known.
  [[nodiscard]] double left_px() const { return left_px_; }
  /// Whether the newest thing that happened is a target that was drawn and solved for.
  [[nodiscard]] bool last_is_solved() const;
  /// What is to be said in place of what the last stroke moved, until something else happens.
  void say_outcome(std::string text);
  /// That; empty: nothing.
  [[nodiscard]] std::string outcome() const { return outcome_revision_ == revision_ ? outcome_ : std::string(); }
  /// Locks parameters against the solver, or frees them. Where one is locked that the last stroke moved ("not this
  /// one"), or one is given back, that stroke is solved again.
  void lock(const std::vector<std::string>& names, bool locked);
  /// Grows with every change of the document.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// Whether anything was changed since `mark_saved`.
  [[nodiscard]] bool unsaved() const { return revision_ != saved_revision_; }
  void mark_saved() { saved_revision_ = revision_; }

 private:
  [[nodiscard]] std::int64_t now() const { return clock_() - began_us_; }
  void forget();
  void follow_stroke();
  bool act(const replay::SessionLine& line);
  void after_steps(const document::Document& before, bool solved = true);
  void follow_habits(const document::Document& before, bool solved);
  void measure_left();
  /// Says so where a new reference is but a part of what was drawn for it.
  void tell_of_cut(const document::Document& before, const replay::DrawnStroke& drawn);

  Clock clock_;
  Tell tell_;
  const decode::TabletTable* own_;
  std::int64_t began_us_ = 0;
  std::unique_ptr<replay::LiveSession> live_;
  std::optional<rig::Pose> preview_;
  std::optional<rig::Pose> staged_;
  Habits habits_;
  JoinedCommands joined_;
  bool joins_ = false;                                   ///< what is performed now belongs to what was before it
  std::shared_ptr<const rig::CharacterRig> paired_rig_;  ///< what pairs_ were found on
  std::vector<std::size_t> pairs_;
  std::optional<rig::Pose> mirrored_;  ///< of the pose that follows the pen
  LiveFollow follow_;
  SketchPreview sketch_;
  bool stroke_seen_ = false;
  std::optional<document::CurveId> held_;
  geometry::PxPoint held_by_;
  std::optional<PullHold> held_pull_;
  std::optional<document::PullBetween> held_pull_between_;
  bool control_target_shown_ = false;
  geometry::PxPoint followed_by_;
  std::size_t followed_ = 0;
  std::vector<Movement> movements_;
  double left_px_ = -1;
  document::CurveId solved_curve_;     ///< whose target that was; null: several
  std::uint64_t solved_revision_ = 0;  ///< what revision_ was when movements_ were found
  std::string outcome_;
  std::uint64_t outcome_revision_ = 0;  ///< what revision_ was when that was said
  std::uint64_t revision_ = 0;
  std::uint64_t saved_revision_ = 0;
};

}  // namespace penpose::app
