#include "ui/app/panels/face/menu_place.h"

#include <algorithm>

#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {

Area menu_area(const PanelContext& context, const Canvas& canvas, PxPoint at, double wide, double rows) {
  const double height =
      rows * (static_cast<double>(context.unit) + static_cast<double>(ImGui::GetStyle().ItemSpacing.y)) +
      static_cast<double>(context.gap);
  const Area free = canvas.free_area();
  const double left =
      std::clamp(at.x + static_cast<double>(context.unit), free.left, std::max(free.left, free.right - wide));
  const double top = std::clamp(at.y, free.top, std::max(free.top, free.bottom - height));
  return {left, top, left + wide, top + height};
}

}  // namespace penpose::app
