#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "ui/app/input/panel_input.h"
#include "ui/app/view/area.h"

namespace penpose::app {

/// A part of a panel whose content is moved by a finger, a pen or a mouse that drags it up and down.
struct ScrollArea {
  Area area;
  std::uint32_t id = 0;  ///< 0: what is dragged here is not the content
};

/// Tells drags that scroll from presses: what is pressed where something scrolls waits until it is let go or moves to
/// the side, and is nothing where it moves up or down.
class DragScroll {
 public:
  /// Those of the last frame; an area lies over those before it.
  void set_areas(std::vector<ScrollArea> areas) { areas_ = std::move(areas); }

  /// What the panels are told of a place of the pointer. `slack_px`: so far a press may tremble.
  [[nodiscard]] std::vector<PanelPointer> add(const PanelPointer& next, double slack_px);

  /// A press is held back or scrolls.
  [[nodiscard]] bool active() const { return from_.has_value(); }
  /// A press is held back: it has neither moved nor been let go.
  [[nodiscard]] bool held() const { return from_ && !scrolls_; }
  /// What is held back shall be nothing, and what follows until it is let go neither.
  void drop();
  /// What scrolls, and by how many px the pointer has moved down since this was last asked; nothing: no drag.
  [[nodiscard]] std::optional<std::pair<std::uint32_t, double>> take();

 private:
  std::vector<ScrollArea> areas_;
  bool down_ = false;            ///< the pointer, as far as it was told of
  std::optional<PxPoint> from_;  ///< where a press that is held back began
  bool scrolls_ = false;
  bool dropped_ = false;
  std::uint32_t id_ = 0;
  double last_y_ = 0;
  double moved_px_ = 0;
};

}  // namespace penpose::app
