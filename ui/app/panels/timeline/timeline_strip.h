#pragma once

#include <cstdint>
#include <imgui.h>
#include <string>

#include "ui/app/canvas/canvas.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/notices.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/panels/panels.h"
#include "ui/app/playback/ghosts.h"
#include "ui/app/playback/keys.h"
#include "ui/app/playback/performer.h"
#include "ui/app/playback/playback.h"
#include "ui/app/playback/sheet/overlap_offer.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/tour/tour_guide.h"

// What the parts of the timeline have in common: which moments are shown, and where on the panel. Private to it.

namespace penpose::app {

/// What is shown and changed here.
struct TimelineOwners {
  EditingSession& editing;
  CanvasLook& look;
  Playback& playback;
  Keys& keys;
  Performer& performer;
  TourGuide& tour;
  Notices& notices;
  Dialogs& dialogs;
  PanelState& panels;
  OverlapOffer& overlap;
  GhostHand& ghosts;
  [[nodiscard]] TimelineShown& shown() const { return panels.own.of<TimelineShown>(); }
};

/// The moments that a strip shows, seconds.
struct ShownMoments {
  double from = 0;
  double span = 0;
};
[[nodiscard]] ShownMoments shown_moments(const TimelineOwners& with);
/// Shows more or less of the timeline, about its cursor.
void zoom_track(const TimelineOwners& with, double factor);
/// Shows another part of the timeline, by a share of what is shown.
void pan_track(const TimelineOwners& with, double share);

/// Where moments lie on a strip of the panel.
struct Strip {
  ImVec2 from;
  ImVec2 size;
  float inset = 0;
  ShownMoments shown;
  [[nodiscard]] float width() const { return size.x - 2 * inset; }
  [[nodiscard]] ImVec2 to() const { return {from.x + size.x, from.y + size.y}; }
  [[nodiscard]] float x_of(double time_s) const {
    return from.x + inset + static_cast<float>((time_s - shown.from) / shown.span) * width();
  }
  [[nodiscard]] double time_of(float x) const {
    const double share = static_cast<double>((x - from.x - inset) / width());
    return std::max(0.0, shown.from + std::clamp(share, -0.02, 1.02) * shown.span);
  }
};
/// Px at the left of all strips where rows have their names; 0 where there are no rows.
[[nodiscard]] float names_width(const PanelContext& context, const TimelineOwners& with);
/// Where a strip as wide as the panel lies that is shown next; `height`: px, 0: of one target.
[[nodiscard]] Strip place_strip(const PanelContext& context, const TimelineOwners& with, float height);
/// A strip as wide as the panel, which is hit under a name; `height`: px, 0: of one target.
Strip begin_strip(PanelContext& context, const TimelineOwners& with, const char* name, const char* tip,
                  float height = 0);
/// Frames from one number to the next on a strip, so that each has so many px of room.
[[nodiscard]] int frames_apart(const Strip& strip, int rate, float room);
/// A number as an axis has it, with as many decimals as its step needs.
[[nodiscard]] std::string axis_number(double value, double step);
/// The playhead's line on a strip.
void show_cursor(const Strip& strip, const TimelineOwners& with);

/// A key as a diamond, `half` px wide to each side.
void draw_key(ImVec2 middle, float half, ImU32 color, bool strong);
/// Keys of one row, drawn from the left to the right. Those that would lie over each other are one bar: there may be
/// thousands, and a panel of ImGui has room for 65536 corners.
class KeyRow {
 public:
  KeyRow(const Strip& strip, float middle_y, float half);
  ~KeyRow();
  KeyRow(const KeyRow&) = delete;
  KeyRow& operator=(const KeyRow&) = delete;

  /// What lies outside of the strip is left out.
  void add(float x, float half, ImU32 color, bool strong);

 private:
  struct Run {
    float from = 0, to = 0, half = 0;
    ImU32 color = 0;
    bool strong = false;
    int keys = 0;
  };
  void flush();

  const Strip& strip_;
  float y_;
  float apart_;
  Run run_;
};
/// Marks are no nearer to each other than this, so that a strip holds no more than 150.
[[nodiscard]] float least_apart(const Strip& strip, float half);

/// The colour of the curve of a control.
[[nodiscard]] ImU32 curve_color(const TimelineOwners& with, std::size_t control);

/// How far the last change of a ghost goes, where there is one, over the row of keys that is shown next: its ends are
/// hit before the keys (ghost_reach.cpp). Call `draw_ghost_reach` when the row is drawn.
void hit_ghost_reach(PanelContext& context, const TimelineOwners& with);
void draw_ghost_reach(const TimelineOwners& with, const Strip& strip);

/// Frames by number, bookmarks and the part that is played (ruler.cpp). Dragged along it, the playhead goes along.
void show_ruler(PanelContext& context, const TimelineOwners& with);
/// The menu of bookmarks and of what is played, where it was opened by its name (marks_menu.cpp).
void show_marks_menu(PanelContext& context, const TimelineOwners& with, const char* name);
/// The buttons above it, in groups (time_buttons.cpp).
void show_time_buttons(PanelContext& context, const TimelineOwners& with);
/// How the face goes to the next key: a button with its picture, and a menu of all (ease_menu.cpp).
void show_ease(PanelContext& context, const TimelineOwners& with, float width);
/// A slider from the key before to the key after; a breakdown is keyed where it is let go (breakdown_slider.cpp).
void show_breakdown(PanelContext& context, const TimelineOwners& with, float width);

/// The colours of bookmarks, by their numbers.
[[nodiscard]] ImU32 bookmark_color(std::uint32_t number, float alpha = 1);

/// How many ghosts are shown, and a menu of how they are (onion_menu.cpp).
void show_onion_button(PanelContext& context, CanvasLook& look, float width);

/// The rows of controls below the whole poses (dope_sheet.cpp), `height` px high.
void show_dope_sheet(PanelContext& context, const TimelineOwners& with, float height);
/// Their curves (curve_editor.cpp), likewise.
void show_curve_editor(PanelContext& context, const TimelineOwners& with, float height);

}  // namespace penpose::app
