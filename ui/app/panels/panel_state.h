#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/document/commands/command_members.h"
#include "core/document/document.h"
#include "ui/app/panels/panel_entries.h"
#include "ui/app/states.h"
#include "ui/app/view/area.h"

namespace penpose::app {

/// What is asked about a feature of the face, beside where the pen was.
struct FeatureMenu {
  std::string feature;                     ///< what can be done with it; empty: which feature a line is
  std::optional<document::CurveId> curve;  ///< the line, where it was drawn before
  document::View view;                     ///< else the view
  std::vector<document::PxPoint> line;     ///< and the line in px of it
  document::PxPoint at;
};

/// Which panels are shown. Nothing of it is saved.
struct PanelState {
  bool shown = true;
  bool narrow = false;            ///< the window has no room for the tools and the side panel at once
  bool side_in_turn = false;      ///< where it is narrow: the side panel, else the tools
  bool side_closed = false;       ///< elsewhere: the side panel is a rail with its tabs alone (a preference)
  bool controls_tab = false;      ///< of the side panel: sketched controls, else all parameters
  bool poses_tab = false;         ///< the poses that are keyed, in place of both
  bool mouths_tab = false;        ///< the mouths that are kept, in place of all
  bool has_keyboard = false;      ///< a key was pressed on one
  std::optional<PxPoint> radial;  ///< middle of the radial menu while it is open
  std::optional<std::pair<document::CurveId, PxPoint>> curve_menu;  ///< what can be done with a curve, and where
  /// Names of lines of the face, and where they are: a touch opens what can be done with a line.
  std::vector<std::pair<document::CurveId, Area>> face_labels;
  std::optional<FeatureMenu> feature_menu;
  bool face_pictures = false;  ///< other readings of a line of the face are offered
  /// Names of features and where they are, while the tool Feature is in hand: a touch opens the menu.
  std::vector<std::pair<std::string, Area>> feature_labels;
  States own;  ///< what each panel keeps for itself

  /// All, none; where there is no room for all, the tools, the side panel, none.
  void show_next() {
    if (!narrow) {
      shown = !shown;
    } else if (!shown) {
      shown = true;
      side_in_turn = false;
    } else if (side_in_turn) {
      shown = false;
    } else {
      side_in_turn = true;
    }
  }
  /// The side panel is there as a whole, as far as panels are shown.
  [[nodiscard]] bool side_open() const { return narrow ? side_in_turn : !side_closed; }
  void open_side(bool open = true) {
    if (open) shown = true;
    side_in_turn = open;
    if (!narrow) side_closed = !open;
  }
  /// The keyed poses on the side panel, or what was there before them.
  void show_poses() {
    poses_tab = !(poses_tab && side_open());
    open_side();
    controls_tab = mouths_tab = false;
  }
  /// The kept mouths likewise.
  void show_mouths() {
    mouths_tab = !(mouths_tab && side_open());
    open_side();
    controls_tab = poses_tab = false;
  }
  /// The line of the face whose menu is open.
  [[nodiscard]] std::optional<document::CurveId> face_line_asked(const document::Document& document) const {
    if (!curve_menu || document::find_face_line(document, curve_menu->first) == nullptr) return std::nullopt;
    return curve_menu->first;
  }
  /// Something with pictures of poses is shown.
  [[nodiscard]] bool pictured() const { return poses_tab || mouths_tab || face_pictures; }
};

}  // namespace penpose::app
