#include "ui/app/input/drag_scroll.h"

#include <algorithm>
#include <cmath>

namespace penpose::app {

std::vector<PanelPointer> DragScroll::add(const PanelPointer& next, double slack_px) {
  const bool pressed = next.down && !down_;
  down_ = next.down;
  if (pressed) {
    const auto over =
        std::find_if(areas_.rbegin(), areas_.rend(), [&](const ScrollArea& one) { return one.area.holds(next.at); });
    if (over == areas_.rend() || over->id == 0) return {next};
    from_ = next.at;
    id_ = over->id;
    scrolls_ = false;
    // What lies below is lit, but not pressed.
    return {{next.at, false}};
  }
  if (dropped_) {
    dropped_ = next.down;
    return {{next.at, false}};
  }
  if (!from_) return {next};
  const PxPoint from = *from_;
  const double across = std::abs(next.at.x - from.x);
  const double along = std::abs(next.at.y - from.y);
  if (!scrolls_ && next.down && std::max(across, along) > slack_px) {
    if (across >= along) {
      from_.reset();
      return {{from, true}, next};
    }
    scrolls_ = true;
    last_y_ = from.y;
  }
  if (scrolls_) {
    moved_px_ += next.at.y - last_y_;
    last_y_ = next.at.y;
    if (!next.down) from_.reset();
    return {};
  }
  if (next.down) return {};
  from_.reset();
  return {{from, true}, {from, false}};
}

void DragScroll::drop() {
  if (!held()) return;
  from_.reset();
  dropped_ = true;
}

std::optional<std::pair<std::uint32_t, double>> DragScroll::take() {
  if (moved_px_ == 0) return std::nullopt;
  return std::pair(id_, std::exchange(moved_px_, 0.0));
}

}  // namespace penpose::app
