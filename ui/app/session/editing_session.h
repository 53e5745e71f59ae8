#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "replay/session/live_session.h"
#include "ui/app/controls/known_words.h"
#include "ui/app/input/side_pairs.h"
#include "ui/app/playback/curve_moments.h"
#include "ui/app/session/last_stroke.h"
#include "ui/app/session/session_input.h"
#include "ui/app/session/shown_pose.h"
#include "ui/app/session/step_history.h"

namespace penpose::app {

/// What is done besides with a change of the pose.
struct Habits {
  bool mirrors = false;                                ///< what a stroke does on one side is done on both
  std::optional<std::pair<double, std::string>> keys;  ///< the pose is keyed at a moment, under a name
};

/// A document with its session and its steps while another one is worked on.
struct SessionAside {
  std::unique_ptr<replay::LiveSession> live;
  JoinedCommands joined;
  CurveMoments moments;
  std::int64_t began_us = 0;  ///< of the clock
  bool unsaved = false;

  [[nodiscard]] const document::Document& document() const { return live->session().editor().document(); }
};

/// The document being worked on, and the session that records how. Knows neither window nor panels.
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

  /// Gives what is worked on away, whole. Afterwards nothing may be asked before `open`, `resume` or `take_up`.
  /// Precondition: no pen is drawing.
  [[nodiscard]] SessionAside set_aside();
  /// Goes on with what was set aside.
  void take_up(SessionAside aside);
  /// Does something to what was set aside, as `act` does.
  base::Status act_aside(SessionAside& aside, const replay::SessionLine& line);

  [[nodiscard]] const drawing::Editor& editor() const { return live_->session().editor(); }
  [[nodiscard]] const document::Document& document() const { return editor().document(); }
  [[nodiscard]] const replay::Session& session() const { return live_->session(); }
  [[nodiscard]] document::DocumentState state() { return live_->session().editor().state(); }
  [[nodiscard]] bool pen_is_drawing() const { return session().pens().current() != nullptr; }

  /// Microseconds since the session began.
  [[nodiscard]] std::int64_t now_us() const { return now(); }
  /// The document as a command would make it, which changes nothing. Errors: those of the command.
  [[nodiscard]] base::Result<document::Document> after(const document::Command& command) {
    return live_->session().editor().after(command);
  }
  /// The same of another document, such as this one at another moment.
  [[nodiscard]] base::Result<document::Document> after(const document::Document& other,
                                                       const document::Command& command) {
    return live_->session().editor().after(other, command);
  }

  /// The features of the document's face; empty: none are found. Valid until the next call.
  [[nodiscard]] std::span<const portrait::FeatureCurve> features() const {
    return live_->session().editor().features();
  }

  /// The same with those that are not sure.
  [[nodiscard]] const document::FeatureCurves& all_features() const { return live_->session().editor().all_features(); }
  /// What each control does, in words, one a parameter. Valid until the next call.
  [[nodiscard]] std::span<const document::ControlWords> words();
  /// Those of the parameter of a name; the name where there is none.
  [[nodiscard]] std::string words_of(const std::string& parameter);

  // What the user does. What is refused is told, and changes nothing.
  bool perform(const document::Command& command);
  /// The same as a part of what was performed before it: one step of undo takes back both.
  bool perform_with(const document::Command& command);
  void set_tool(const drawing::Tool& tool);
  void set_view(const document::View& view);
  /// A line of a session, as it is recorded.
  bool act(const replay::SessionLine& line);

  /// What is done besides with every change of the pose from now on.
  [[nodiscard]] Habits& habits() { return habits_; }
  /// Finds controls of one side and the other that do the same, by their numbers (side_pairs.h).
  [[nodiscard]] const std::vector<std::size_t>& two_sided_pairs();

  /// Pens, and other things on a tablet.
  [[nodiscard]] SessionInput& input() { return input_; }
  [[nodiscard]] StepHistory& steps() { return steps_; }
  [[nodiscard]] ShownPose& shown() { return shown_; }
  [[nodiscard]] const ShownPose& shown() const { return shown_; }
  /// Of which moments curves are, and which of them are shown.
  [[nodiscard]] CurveMoments& moments() { return moments_; }
  [[nodiscard]] const CurveMoments& moments() const { return moments_; }
  [[nodiscard]] LastStroke& last_stroke() { return last_; }
  [[nodiscard]] const LastStroke& last_stroke() const { return last_; }

  /// Grows with every change of the document.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// Whether anything was changed since `mark_saved`. To go to another moment is no change.
  [[nodiscard]] bool unsaved() const { return revision_ != saved_revision_; }
  void mark_saved() { saved_revision_ = revision_; }

 private:
  friend class SessionInput;

  [[nodiscard]] std::int64_t now() const { return clock_() - began_us_; }
  void forget();
  void after_steps(const document::Document& before, bool solved = true);
  void follow_habits(const document::Document& before, bool solved);
  /// Says so where a new reference is but a part of what was drawn for it.
  void tell_of_cut(const document::Document& before, const replay::DrawnStroke& drawn);

  Clock clock_;
  Tell tell_;
  const decode::TabletTable* own_;
  std::int64_t began_us_ = 0;
  std::unique_ptr<replay::LiveSession> live_;
  Habits habits_;
  bool joins_ = false;                                   ///< what is performed now belongs to what was before it
  std::shared_ptr<const rig::CharacterRig> paired_rig_;  ///< what pairs_ were found on
  std::vector<std::size_t> pairs_;
  KnownWords words_;
  SessionInput input_{*this};
  StepHistory steps_{*this};
  ShownPose shown_{*this};
  LastStroke last_;
  CurveMoments moments_;
  std::uint64_t revision_ = 0;
  std::uint64_t saved_revision_ = 0;
};

/// Locks parameters against the solver, or frees them. Where one is locked that the last stroke moved ("not this one"),
/// or one is given back, that stroke is solved again.
void lock_parameters(EditingSession& editing, const std::vector<std::string>& names, bool locked);

}  // namespace penpose::app
