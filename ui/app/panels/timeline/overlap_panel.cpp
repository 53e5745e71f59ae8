#include <algorithm>
#include <cstdio>
#include <string>

#include "ui/app/canvas/canvas.h"
#include "ui/app/panels/panels.h"
#include "ui/app/playback/sheet/overlap_offer.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/widgets/internal/widgets.h"

// How the selected controls trail: values beside the model, which shows what they make.

namespace penpose::app {
namespace {

constexpr double k_finest_frames = 0.1;

struct OverlapPanelOwners {
  EditingSession& editing;
  OverlapOffer& offer;
  [[nodiscard]] std::string name(std::size_t control) const { return editing.words()[control].text(); }
};

std::string title_of(const OverlapPanelOwners& with) {
  const auto& all = with.offer.trailing();
  std::string title = with.name(all.front().overlap.control);
  if (all.size() == 2) title += " and " + with.name(all.back().overlap.control);
  if (all.size() > 2) title += " and " + std::to_string(all.size() - 1) + " more";
  return title + (all.size() == 1 ? " trails" : " trail");
}

std::string keys_text(const OverlapPanelOwners& with) {
  std::size_t keys = 0;
  for (const auto& one : with.offer.trailing()) keys += one.keys.times_s.size();
  return std::to_string(keys) + " keys";
}

/// Whose motion they take.
void show_leader(PanelContext& context, const OverlapPanelOwners& with) {
  OverlapValues values = with.offer.values();
  const std::string label = (values.leader ? "After " + with.name(*values.leader) : "After their own motion");
  if (wide_button(context, (fitted_text(label, ImGui::GetContentRegionAvail().x - context.unit) + "##leader").c_str(),
                  -1, false, "Whose motion they follow: their own as it is keyed, or that of another control"))
    ImGui::OpenPopup("leaders");
  if (!begin_menu(context, "leaders")) return;
  begin_list(context, "leaders list", {7 * context.unit, 6 * context.unit});
  const auto choose = [&](const std::string& text, std::optional<std::size_t> leader) {
    if (!wide_button(context, (text + "##choose leader").c_str(), -1, values.leader == leader)) return;
    values.leader = leader;
    with.offer.set(values);
    ImGui::CloseCurrentPopup();
  };
  choose("Their own motion", std::nullopt);
  for (const std::size_t control : with.offer.leaders()) choose(with.name(control), control);
  ImGui::EndChild();
  ImGui::EndPopup();
}

struct Slider {
  const char* id;
  const char* name;
  double least, most;
  const char* tip;
};

bool show_slider(PanelContext& context, const Slider& slider, const std::string& shown, double& value) {
  bool released = false;
  const SliderLook look{ImGui::GetContentRegionAvail().x, slider.name, shown,
                        std::max(0.0, slider.least),      false,       false};
  const bool moved = control_slider(context, slider.id, value, slider.least, slider.most, look, released);
  tooltip(context, slider.tip);
  return moved || released;
}

void show_values(PanelContext& context, const OverlapPanelOwners& with) {
  const auto text = [](const char* format, double value) {
    char out[64];
    std::snprintf(out, sizeof out, format, value);
    return std::string(out);
  };
  const auto rounded = [](double value) { return std::round(value / k_finest_frames) * k_finest_frames; };
  OverlapValues values = with.offer.values();
  bool moved = false;
  if (show_slider(context, {"##delay", "delay", 0, k_most_delay_frames, "How many frames later they move"},
                  text("%.1f frames later", values.delay_frames), values.delay_frames)) {
    values.delay_frames = rounded(values.delay_frames);
    moved = true;
  }
  // Most springs are short: the slider has more room for those.
  double share = std::sqrt(values.period_frames / k_most_period_frames);
  if (show_slider(context, {"##softness", "softness", 0, 1, "How soft the spring is: the frames of one swing of it"},
                  values.period_frames > 0 ? text("soft: %.1f frames", values.period_frames) : "stiff", share)) {
    values.period_frames = rounded(share * share * k_most_period_frames);
    moved = true;
  }
  if (show_slider(context,
                  {"##swing", "swing", 0, document::k_most_swing, "How far they swing past where they are led"},
                  values.swing > 0 ? text("swings past by %.0f %%", 100 * values.swing) : "does not swing past",
                  values.swing)) {
    values.swing = std::round(100 * values.swing) / 100;
    moved = true;
  }
  if (values.leader &&
      show_slider(context, {"##amount", "amount", -1, 1, "How much of the leader's motion they follow"},
                  text("%.0f %% of it", 100 * values.amount), values.amount)) {
    values.amount = std::round(100 * values.amount) / 100;
    moved = true;
  }
  if (moved) with.offer.set(values);
}

}  // namespace

void show_overlap(PanelContext& context, const Area& /*area*/, EditingSession& editing, Canvas& canvas,
                  OverlapOffer& offer) {
  if (!offer.open()) return;
  const OverlapPanelOwners with{editing, offer};
  const Area free = canvas.free_area();
  const double width =
      std::min(8.5 * static_cast<double>(context.unit), free.width() - 2 * static_cast<double>(context.gap));
  const std::string title = title_of(with) + ": " + keys_text(with);
  const std::string said = !offer.said().empty() ? offer.said()
                           : offer.shows()
                               ? "Go to a frame and draw, or pull, where it should be there: that says how soft it is."
                               : "";
  const ImGuiStyle& style = ImGui::GetStyle();
  const auto inside = static_cast<float>(width) - 2 * style.WindowPadding.x;
  const auto high = [&](const std::string& text) {
    return text.empty() ? 0 : ImGui::CalcTextSize(text.c_str(), nullptr, false, inside).y + style.ItemSpacing.y;
  };
  const bool drawing_small = offer.shows() && free.height() < 14 * static_cast<double>(context.unit);
  const float rows = drawing_small ? 2 : offer.values().leader ? 7 : 6;
  const float height =
      high(title) + high(said) + rows * (context.unit + style.ItemSpacing.y) + 2 * style.WindowPadding.y;
  const double right = free.right - static_cast<double>(context.gap);
  const double top = free.top + static_cast<double>(context.gap);
  if (begin_panel(context, "overlap",
                  {right - width, top, right, std::min(top + static_cast<double>(height), free.bottom)}, true)) {
    ImGui::TextWrapped("%s", title.c_str());
    const float half = 0.5F * (ImGui::GetContentRegionAvail().x - style.ItemSpacing.x);
    if (primary_button(context, "Bake##overlap", half, "Turn it into keys; one Undo takes it back")) offer.bake();
    ImGui::SameLine();
    if (wide_button(context, "Cancel##overlap", half, false, "Discard and change nothing (Esc)")) offer.dismiss();
    if (wide_button(context, "Show by drawing##overlap", -1, offer.shows(),
                    "Draw once where the trailing part should be: the softness is found, and the drawing taken back"))
      offer.show_by_drawing(!offer.shows());
    if (!said.empty()) ImGui::TextWrapped("%s", said.c_str());
    // While one draws in a small window the face has the room of the values.
    if (offer.open() && !drawing_small) {
      show_leader(context, with);
      show_values(context, with);
    }
  }
  end_panel();
}

}  // namespace penpose::app
