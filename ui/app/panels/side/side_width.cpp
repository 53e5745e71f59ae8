#include "ui/app/panels/side/side_width.h"

#include <algorithm>

namespace penpose::app {
namespace {

/// In targets of a pen: the usual width, and the greatest.
constexpr double k_usual_side = 9.5, k_widest_side = 12.5;
/// More than the usual width only up to this share of the window.
constexpr double k_side_share = 0.28;

}  // namespace

double side_width(const PanelContext& context, PanelState& panels, double window_width) {
  const auto unit = static_cast<double>(context.unit);
  const auto wanted = static_cast<double>(panels.own.of<SideWidth>().wanted);
  const double most = std::clamp(k_side_share * window_width, k_usual_side * unit, k_widest_side * unit);
  return std::clamp(wanted, k_usual_side * unit, most);
}

}  // namespace penpose::app
