#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/articulation/sketched_deformers.h"
#include "ui/app/canvas/canvas.h"
#include "ui/app/notices.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/tools/lent_tool.h"

namespace penpose::app {

/// What is done with controls: values of all of them, and those that are sketched.
class Controls {
 public:
  Controls(EditingSession& editing, Notices& notices, Canvas& canvas, PanelState& panels);

  /// Of the sketched ones the one that is selected; empty: none is.
  [[nodiscard]] const std::string& selected() const { return selected_; }
  void select(const std::string& control) { selected_ = control; }
  /// The one that is selected while the panel of sketched controls is shown; else empty.
  [[nodiscard]] std::string shown() const;

  void preview_parameter(std::size_t parameter, double value);
  void set_parameter(std::size_t parameter, double value);

  // A new one.
  /// Begins to sketch it.
  void begin();
  [[nodiscard]] articulation::Mode new_mode() const { return new_mode_; }
  [[nodiscard]] const articulation::Surface& new_surface() const { return new_surface_; }
  /// How the control that is being sketched, or the next one, moves and what it slides over. Strokes that are drawn
  /// already are drawn again.
  void choose_for_new(articulation::Mode mode, const articulation::Surface& surface);
  /// Begins to correct the pose as it stands.
  void correct_pose();

  // One that there is.
  /// What is taken for one line of it.
  [[nodiscard]] LentTool& lent() { return lent_; }
  /// The next stroke draws a curve of it again; regions in the view in which they were drawn.
  void redraw(const std::string& deformer, articulation::CurveRole role);
  /// The next stroke draws another target of it, at the value that it shows.
  void draw_between(const std::string& deformer, double value);
  /// Makes the same control on the other side, and takes it in hand.
  void mirror(const std::string& deformer);
  void rename(const std::string& deformer, const std::string& to);

  /// The control in hand plays to and fro.
  [[nodiscard]] bool swings() const { return swings_; }
  void set_swing(bool on);
  /// Swings to a moment of the clock, microseconds.
  void swing(std::int64_t now_us);

  /// Selects a control that was just made, and says so. The face shows it at its target (trial).
  void show_new();
  /// The control that was just made and is seen at its target, while its value is still at rest: until a line is drawn
  /// or something else is shown; null: none.
  [[nodiscard]] const std::string* trial() const;
  /// Shows it at rest again.
  void end_trial();
  /// Leaves it at its target, as a step.
  void take_trial();
  /// Says what is doubtful of a control that was changed and was not before.
  void tell_new_doubts();
  /// Says so before the target is drawn where the feature that was found may not be the one that is meant.
  void tell_doubt_of_feature();
  /// Another document was opened.
  void open_document();

 private:
  EditingSession& editing_;
  Notices& notices_;
  Canvas& canvas_;
  PanelState& panels_;
  LentTool lent_;
  std::string selected_;
  articulation::Mode new_mode_ = articulation::Mode::automatic;
  articulation::Surface new_surface_;
  bool swings_ = false;
  std::string trial_;                                       ///< the control that is seen at its target; empty: none
  std::shared_ptr<const document::PendingSketch> doubted_;  ///< whose feature that was said of
  std::size_t deformer_count_ = 0;                          ///< to tell a new one
  std::size_t correction_count_ = 0;                        ///< likewise
  articulation::SketchedDeformers::Shared seen_deformers_;  ///< of which all doubts are told
};

}  // namespace penpose::app
