#include <algorithm>
#include <cmath>
#include <filesystem>

#include "ui/app/canvas/canvas.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/panels/panel_entries.h"
#include "ui/app/panels/panels.h"
#include "ui/app/playback/playback.h"
#include "ui/app/reference/reference_desk.h"
#include "ui/app/view/backdrop.h"
#include "ui/app/widgets/button_row.h"
#include "ui/app/widgets/internal/widgets.h"

// The reference in hand: dragged on the canvas, sized by the wheel, with a row of what can be done; and what is wrong
// with it.

namespace penpose::app {
namespace {

/// What is shown and changed here.
struct BackdropPanelOwners {
  Canvas& canvas;
  CanvasLook& look;
  Playback& playback;
  ReferenceDesk& references;
  Dialogs& dialogs;
};

constexpr double k_step = 1.08;
constexpr double k_backdrop_bar_units = 22;

/// A bar at the foot of the canvas.
Area foot_of(const PanelContext& context, const Area& free, double units) {
  const auto unit = static_cast<double>(context.unit);
  const double wide = std::min(free.width(), units * unit);
  return {free.middle().x - 0.5 * wide, free.bottom - unit - 2 * static_cast<double>(context.gap),
          free.middle().x + 0.5 * wide, free.bottom};
}

/// Takes the canvas, so that what is dragged is the picture.
void take_canvas(PanelContext& context, const BackdropPanelOwners& with, Backdrop& backdrop, const Area& free) {
  ImGui::SetNextWindowBgAlpha(0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  if (begin_panel(context, "backdrop canvas", free)) {
    ImGui::InvisibleButton("backdrop drag", {static_cast<float>(free.width()), static_cast<float>(free.height())});
    const document::View& view = with.canvas.view();
    const ImGuiIO& io = ImGui::GetIO();
    const PxPoint at{static_cast<double>(io.MousePos.x), static_cast<double>(io.MousePos.y)};
    if (ImGui::IsItemActivated()) backdrop.held = at;
    // The last way before it was let go counts, too.
    if (ImGui::IsItemActive() || ImGui::IsItemDeactivated()) {
      backdrop.drag(view, free, at - backdrop.held);
      backdrop.held = at;
    }
    if (ImGui::IsItemDeactivated()) with.references.commit();
    if (ImGui::IsItemHovered() && io.MouseWheel != 0) {
      backdrop.enlarge(view, free, std::pow(k_step, static_cast<double>(io.MouseWheel)), at);
      with.references.commit();
    }
  }
  end_panel();
  ImGui::PopStyleVar();
}

/// A button that changes the picture in hand, which is a step then.
template <typename Does>
ButtonRow::Button changes(const BackdropPanelOwners& with, const char* label, const char* tip, bool chosen, Does does) {
  ButtonRow::Button button{label, {}, tip};
  button.chosen = chosen;
  button.does = [&with, does] {
    does();
    with.references.commit();
  };
  return button;
}

void show_opacity(PanelContext& context, const BackdropPanelOwners& with, Backdrop& backdrop, float width) {
  double opacity = backdrop.placed().opacity;
  bool released = false;
  if (tall_slider(context, "##behind", opacity, 0, 1, width, "Shows", released)) backdrop.set_opacity(opacity);
  if (released) with.references.commit();
}

/// What can be done with the picture in hand.
void show_backdrop_bar(PanelContext& context, const BackdropPanelOwners& with, Backdrop& backdrop, const Area& free) {
  const document::View& view = with.canvas.view();
  const bool beside = backdrop.placed().beside;
  ButtonRow row(context, "more of the reference");
  ButtonRow::Button done{"Done##behind", {}, "Done: draw over it"};
  done.weight = ButtonWeight::primary;
  done.does = [&backdrop] { backdrop.adjusting = false; };
  row.add(std::move(done));
  ButtonRow::Button opacity{"##shows behind"};
  opacity.shows = [&](PanelContext& panel, float width) { show_opacity(panel, with, backdrop, width); };
  opacity.width = 4 * context.unit;
  row.add(std::move(opacity));
  row.add(changes(with, "Behind##behind", "Behind the model, where it goes along with the view", !beside,
                  [&backdrop] { backdrop.set_beside(false); }));
  row.add(changes(with, "Card##behind", "A card on the window, which stays where it is", beside,
                  [&backdrop] { backdrop.set_beside(true); }));
  row.add(changes(with, "-##behind", "Smaller; so does the wheel", false,
                  [&, free] { backdrop.enlarge(view, free, 1 / k_step, free.middle()); }));
  row.add(changes(with, "+##behind", "Larger; so does the wheel", false,
                  [&, free] { backdrop.enlarge(view, free, k_step, free.middle()); }));
  if (backdrop.frame_count() > 1) {
    const double frame_s = 1.0 / with.playback.rate();
    row.add(changes(with, "Earlier##behind", "It begins a frame earlier", false,
                    [&backdrop, frame_s] { backdrop.delay(-frame_s); }));
    row.add(changes(with, "Later##behind", "It begins a frame later", false,
                    [&backdrop, frame_s] { backdrop.delay(frame_s); }));
    row.add(changes(with, "Here##behind", "It begins at this moment of the timeline", false,
                    [&] { backdrop.delay(with.playback.time_s() - backdrop.placed().offset_s); }));
  }
  ButtonRow::Button other{"Other##behind", {}, "Choose another picture or film"};
  other.does = [&with] { with.dialogs.show(Dialog::backdrop); };
  row.add(std::move(other));
  ButtonRow::Button remove{"Remove##behind", {}, "Remove the picture"};
  remove.does = [&with] { with.references.remove(); };
  row.add(std::move(remove));
  row.show(static_cast<float>(free.width()));
}

/// A film is being read.
void show_reading(PanelContext& context, const BackdropPanelOwners& with, const Area& free) {
  const FilmReader& reader = *with.references.reads();
  if (begin_panel(context, "reading film", foot_of(context, free, 14))) {
    if (wide_button(context, "Cancel##film in", 0, false, "Do not take the film")) with.references.cancel();
    ImGui::SameLine();
    const std::string name = std::filesystem::path(reader.path()).filename().string();
    text_beside(context, (name + ": " + std::to_string(reader.done()) + " pictures are read").c_str());
  }
  end_panel();
}

/// The file is gone, or another one.
void show_doubt(PanelContext& context, const BackdropPanelOwners& with, const Area& free) {
  if (begin_panel(context, "reference doubt", foot_of(context, free, 26))) {
    if (with.references.differs() && primary_button(context, "Use it##doubt", 0, "Go on with the file as it is now"))
      with.references.accept();
    if (with.references.differs()) ImGui::SameLine();
    if (wide_button(context, "Find it##doubt", 0, false, "Choose the file")) with.dialogs.show(Dialog::backdrop);
    ImGui::SameLine();
    if (wide_button(context, "Remove##doubt", 0, false, "Go on without it")) with.references.remove();
    ImGui::SameLine();
    const std::string doubt = with.references.doubt();
    text_beside(context, fitted_text(doubt, ImGui::GetContentRegionAvail().x).c_str());
  }
  end_panel();
}

}  // namespace

void show_backdrop(PanelContext& context, const Area& free, Canvas& canvas, CanvasLook& look, Playback& playback,
                   ReferenceDesk& references, Dialogs& dialogs) {
  const BackdropPanelOwners with{canvas, look, playback, references, dialogs};
  auto& bar = context.own.of<CanvasBars>().reference;
  bar.reset();
  if (dialogs.open() != Dialog::none) return;
  const bool asks = references.reads() != nullptr || !references.doubt().empty();
  if (asks || (look.backdrop && look.backdrop->adjusting)) bar = foot_of(context, free, k_backdrop_bar_units);
  if (references.reads() != nullptr) return show_reading(context, with, free);
  if (!references.doubt().empty()) return show_doubt(context, with, free);
  const auto backdrop = look.backdrop;
  if (!backdrop || !backdrop->adjusting) return;
  if (begin_panel(context, "backdrop bar", foot_of(context, free, k_backdrop_bar_units)))
    show_backdrop_bar(context, with, *backdrop, foot_of(context, free, k_backdrop_bar_units));
  end_panel();
  // Of windows that never come to the front the one that was first lies above.
  take_canvas(context, with, *backdrop, free);
}

}  // namespace penpose::app
