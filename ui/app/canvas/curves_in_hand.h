#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ui/app/cast/cast.h"
#include "ui/app/controls/controls.h"
#include "ui/app/controls/restriction.h"
#include "ui/app/face/kept_features.h"
#include "ui/app/playback/performer.h"
#include "ui/app/tools/tool_in_hand.h"
#include "ui/app/view/shown_curves.h"

namespace penpose::app {

/// The curves under the pen: lit, touched, and targets that are dragged or pulled.
class CurvesInHand {
 public:
  struct Parts {
    EditingSession& editing;
    Canvas& canvas;
    Controls& controls;
    PanelState& panels;
    Performer& performer;
    Notices& notices;
    ToolInHand& tool;
    const KeptFeatures& features;
    const Restriction& restriction;
    Cast& cast;
  };
  explicit CurvesInHand(const Parts& parts) : parts_(parts) {}

  // The pen on the canvas.
  void hover(PxPoint at, bool on_canvas);
  void press(PxPoint at);
  void move(PxPoint at);
  void release(PxPoint at);
  /// A modifier is held: lines are moved as a whole.
  void set_whole(bool on) { whole_ = on; }

  // The curve that is lit.
  void delete_lit();
  void keep_lit();

  /// Says how the curves in hand look, with the pointer at a place.
  void add_to(CurveLook& look, PxPoint at) const;
  /// Another document is opened.
  void forget();

 private:
  /// The line of the face whose name is there; nothing: none.
  [[nodiscard]] std::optional<document::CurveId> name_at(PxPoint at) const;
  /// The feature of the face that is shown there, by its name or its line; nothing: none.
  [[nodiscard]] std::optional<std::string> feature_at(PxPoint at) const;
  /// Opens the menu of a feature that was touched; also whether one is open.
  bool take_feature(PxPoint at);
  void select_at(PxPoint at);
  void select_control_at(PxPoint at);
  [[nodiscard]] bool take_control_target(PxPoint at);
  [[nodiscard]] std::optional<document::PullBetween> control_pull(PxPoint at) const;
  void hold_line(const std::vector<geometry::ModelPoint>& line, PxPoint at);
  [[nodiscard]] bool is_far(PxPoint by) const;
  /// What is under the pen is pulled from now on: a target that was drawn, else any place of the model.
  void take_place(PxPoint at);
  void end_performance();

  Parts parts_;
  std::optional<document::CurveId> lit_;
  std::optional<std::pair<document::CurveId, PxPoint>> target_;  ///< in hand, and where it was taken
  std::optional<PullHold> pull_;  ///< the target in hand is held at a place; nothing: all of it
  /// A target of the chosen control in hand: its value, and where it was taken.
  std::optional<std::pair<double, PxPoint>> control_target_;
  bool whole_ = false;
  std::optional<PxPoint> place_;  ///< where a place of the model was taken, to be pulled
  PxPoint pressed_;
  bool touches_ = true;                       ///< the pen has stayed where it was pressed
  std::optional<document::CurveId> named_;    ///< the name of this line of the face was pressed
  std::optional<document::CurveId> touched_;  ///< by the tool Select
  std::optional<std::size_t> character_;      ///< another one was pressed
};

}  // namespace penpose::app
