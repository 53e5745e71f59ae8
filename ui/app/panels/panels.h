#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/geometry/camera.h"
#include "ui/app/actions.h"
#include "ui/app/input/drag_scroll.h"
#include "ui/app/states.h"
#include "ui/app/view/area.h"
#include "ui/app/view/hit_map.h"

// What panels and dialogs are made with. Called between ImGui's NewFrame and Render alone.

namespace penpose::app {

class FilePictures;
class PosePictures;

/// What every panel and every dialog works with. What it shows besides, it takes by name.
struct PanelContext {
  Actions& actions;
  HitMap& hits;              ///< where panels lie
  States& own;               ///< what widgets keep
  const Area& free;          ///< the part of the window that no panel covers
  const bool& panels_shown;  ///< as they are now
  geometry::Viewport window;
  std::map<std::string, Area, std::less<>>& targets;
  PosePictures& pictures;
  FilePictures& file_pictures;
  float unit = 34;  ///< px of a target that a pen hits for certain
  float gap = 6;
  std::optional<Area> typed_into = {};        ///< the text field that has the keyboard
  std::vector<Area> fields = {};              ///< all that can be typed into
  bool accepts = false;                       ///< Return was pressed: the dialog does what it is for
  bool cancels = false;                       ///< Escape was pressed: the dialog, or else the menu, closes
  bool field_first = false;                   ///< the dialog's field takes the keyboard
  bool has_field = false;                     ///< the dialog has one
  bool dialog_opens = false;                  ///< it is in its first frame
  bool menu_open = false;                     ///< a menu is
  std::optional<Area> dialog_area = {};       ///< where the dialog is
  std::vector<ScrollArea> scrolls = {};       ///< what a drag moves up and down; while a dialog is open, of that alone
  std::vector<ScrollArea> menu_scrolls = {};  ///< of an open menu, which nothing else is hit beside
  std::optional<std::pair<std::uint32_t, double>> scrolled = {};  ///< what a drag moved, and by how many px down
  bool hovers = false;            ///< the pointer came without being pressed, as a mouse does and a finger does not
  bool long_press = false;        ///< a press rests where it began, long enough to ask for a menu
  bool takes_long_press = false;  ///< somebody opened one: the press is nothing else
  bool tip_due = false;           ///< the pointer has rested long enough for a tooltip
  std::string tip = {};           ///< what the tooltip says that is shown; empty: none is
  bool tip_waits = false;         ///< it rests on something that has one
};

/// Where panels lie in the window.
enum class PanelPlace : std::uint8_t {
  top,       ///< a bar above everything
  left,      ///< beside the canvas
  right,     ///< likewise
  status,    ///< a line below the canvas
  timeline,  ///< below everything
  player,    ///< while something is played
  tour,      ///< at the foot of the canvas, while a tour is under way
  canvas,    ///< over the canvas, wherever they choose
  window,    ///< over everything, dialogs among them
};

/// Shows the panels of a place (panel_list.cpp).
void show_panels(PanelContext& context, App& app, PanelPlace place, const Area& area);
/// Shows the dialog that is open (dialog_list.cpp).
void show_dialog(PanelContext& context, App& app);

}  // namespace penpose::app
