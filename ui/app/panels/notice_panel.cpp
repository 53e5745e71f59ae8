#include <algorithm>

#include "ui/app/canvas/canvas.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/notices.h"
#include "ui/app/panels/panel_entries.h"
#include "ui/app/panels/panels.h"
#include "ui/app/view/toast_place.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

// What is said for a while, where it covers least of what is drawn.

namespace penpose::app {
namespace {

/// So much of the picture what is said hides.
constexpr float k_notice_cover = 0.94F;

}  // namespace

void show_notices(PanelContext& context, const Area& /*area*/, Canvas& canvas, CanvasDrawing& drawing, Notices& notices,
                  Dialogs& dialogs) {
  const auto& all = notices.all();
  std::optional<Area>& said = context.own.of<ToastPlace>().area;
  said.reset();
  if (all.empty()) return;
  Area free = canvas.free_area();
  if (const auto& readings = context.own.of<ReadingsPlace>().area) free.bottom = readings->top;
  const CanvasBars& bars = context.own.of<CanvasBars>();
  if (bars.reference) free.bottom = std::min(free.bottom, bars.reference->top);
  if (const auto& film = context.own.of<FilmPlace>().area) free.top = film->bottom;
  // What a dialog has to tell is not to lie in its shade.
  const bool dialog = dialogs.open() != Dialog::none;
  ImDrawList& list = dialog ? *ImGui::GetForegroundDrawList() : *ImGui::GetBackgroundDrawList();
  const float pad = context.gap;
  const float width = std::min(static_cast<float>(free.width()) - 2 * context.gap, 20 * context.unit);
  const float corner_px = ImGui::GetStyle().FrameRounding;
  float wide = 0;
  float high = 0;
  for (const Notice& one : all) {
    const ImVec2 size = ImGui::CalcTextSize(one.text.c_str(), nullptr, false, width - 3 * pad);
    wide = std::max(wide, size.x + 3 * pad);
    high += size.y + 3 * pad;
  }
  const Area inner{free.left + static_cast<double>(pad), free.top + static_cast<double>(pad),
                   free.right - static_cast<double>(pad), free.bottom - static_cast<double>(pad)};
  // A dialog has the middle of the window: its own fields and buttons stay readable.
  const auto corner = static_cast<double>(pad);
  const Area place = dialog
                         ? Area{corner, corner, corner + static_cast<double>(wide), corner + static_cast<double>(high)}
                         : toast_place(inner, static_cast<double>(wide), static_cast<double>(high),
                                       drawn_px(canvas.view(), drawing.curves));
  said = place;
  auto y = static_cast<float>(place.top);
  const auto x = static_cast<float>(place.left);
  for (const Notice& one : all) {
    // It goes as it came, and not at a stroke.
    const auto alpha = static_cast<float>(notices.opacity(one));
    const ImU32 back = color_of(palette().popup, dialog ? alpha : alpha * k_notice_cover);
    const ImU32 ink = color_of(palette().ink, alpha);
    const ImU32 mark = color_of(one.is_error ? palette().error : palette().accent, alpha);
    const ImVec2 size = ImGui::CalcTextSize(one.text.c_str(), nullptr, false, width - 3 * pad);
    const ImVec2 to{x + size.x + 3 * pad, y + size.y + 2 * pad};
    list.AddRectFilled({x, y}, to, back, corner_px);
    list.AddRectFilled({x, y}, {x + 0.5F * pad, to.y}, mark, corner_px);
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {x + 1.5F * pad, y + pad}, ink, one.text.c_str(), nullptr,
                 width - 3 * pad);
    y = to.y + pad;
  }
}

}  // namespace penpose::app
