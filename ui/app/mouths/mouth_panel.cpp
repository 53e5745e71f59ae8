#include <algorithm>
#include <array>
#include <cmath>

#include "ui/app/dialogs/dialogs.h"
#include "ui/app/mouths/kept_mouths.h"
#include "ui/app/mouths/mouth_slots.h"
#include "ui/app/panels/panel_parts.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/pose_picture.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

// The nine mouths that speech is drawn with: pictures of those that are kept, places for the others.

namespace penpose::app {
namespace {

/// What is shown and changed here.
struct MouthOwners {
  EditingSession& editing;
  KeptMouths& kept;
  Dialogs& dialogs;
  PanelState& panels;

  [[nodiscard]] const document::Mouth* mouth(const MouthSlot& slot) const {
    return document::find_mouth(editing.document().mouths, slot.name());
  }
  [[nodiscard]] bool redraws(const MouthSlot& slot) const {
    return kept.redrawn() != nullptr && *kept.redrawn() == slot.name();
  }
};

/// The kept mouth that was touched last.
struct ChosenMouth {
  const MouthSlot* slot = nullptr;
};

/// A mouth in lines, as shares of the width of its picture.
struct MouthLines {
  float wide = 0, high = 0;  ///< half of the opening; a line where it is not open
  bool teeth = false, tongue = false;
};
MouthLines lines_of(speech::NineMouth mouth) {
  using enum speech::NineMouth;
  switch (mouth) {
    case closed:
      return {0.26F, 0};
    case a:
      return {0.2F, 0.19F};
    case e:
      return {0.27F, 0.1F, true};
    case o:
      return {0.14F, 0.16F};
    case f:
      return {0.22F, 0.04F, true};
    case l:
      return {0.2F, 0.13F, false, true};
    case consonants:
      return {0.26F, 0.055F, true};
    case u:
      return {0.07F, 0.08F};
    case rest:
      return {0.22F, 0};
  }
  return {};
}

void trace_oval(ImDrawList& list, ImVec2 middle, float wide, float high) {
  constexpr int k_points = 28;
  for (int i = 0; i < k_points; ++i) {
    const float angle = 6.2831853F * static_cast<float>(i) / k_points;
    list.PathLineTo({middle.x + wide * std::cos(angle), middle.y + high * std::sin(angle)});
  }
}

/// What the mouth of an empty place looks like.
void draw_lines(ImDrawList& list, speech::NineMouth mouth, ImVec2 middle, float width, ImU32 ink) {
  const MouthLines lines = lines_of(mouth);
  const float wide = lines.wide * width;
  const float high = lines.high * width;
  const float lip = (mouth == speech::NineMouth::closed ? 0.045F : 0.08F) * width;
  const float pen = std::max(1.0F, 0.018F * width);
  trace_oval(list, middle, wide + lip, high + lip);
  list.PathStroke(ink, ImDrawFlags_Closed, pen);
  if (high > 0) {
    trace_oval(list, middle, wide, high);
    list.PathStroke(ink, ImDrawFlags_Closed, pen);
  } else {
    list.AddLine({middle.x - wide, middle.y}, {middle.x + wide, middle.y}, ink, pen);
  }
  if (lines.teeth)
    list.AddLine({middle.x - 0.86F * wide, middle.y - 0.1F * high}, {middle.x + 0.86F * wide, middle.y - 0.1F * high},
                 ink, pen);
  if (lines.tongue) {
    trace_oval(list, {middle.x, middle.y - 0.25F * high}, 0.35F * wide, 0.5F * high);
    list.PathStroke(ink, ImDrawFlags_Closed, pen);
  }
}

std::string said_of(const MouthSlot& slot) {
  std::string text = "\"";
  text.append(slot.name()).append("\" (").append(slot.sounds).append("): ").append(slot.looks);
  return text;
}

/// What to do next, in a sentence or two.
std::string guidance(const MouthOwners& with, const MouthSlot* chosen) {
  for (const MouthSlot& slot : k_mouth_slots) {
    if (with.redraws(slot)) return "Draw " + said_of(slot) + ". Then tap its picture: it is kept, and its keys follow.";
  }
  if (chosen != nullptr && with.mouth(*chosen) != nullptr) {
    const std::size_t keys = with.kept.keys_of(std::string(chosen->name()));
    return said_of(*chosen) + (keys > 0 ? "; " + std::to_string(keys) + " keys speak it." : ".");
  }
  const MouthSlot* next = next_slot(with.editing.document().mouths);
  if (next == nullptr) return "All nine are kept. Tap one to draw it again.";
  const bool enough = next - k_mouth_slots.data() >= static_cast<std::ptrdiff_t>(k_first_mouths);
  const bool first = next == k_mouth_slots.data();
  const std::string begin = first    ? "Speech is read with six mouths. The first is "
                            : enough ? "Six are enough to speak. Finer with "
                                     : "Next: ";
  return begin + said_of(*next) + ". Draw it on the face, then tap its place.";
}

std::string tip_of(const MouthOwners& with, const MouthSlot& slot) {
  if (with.mouth(slot) == nullptr) return said_of(slot) + ". Tap: the mouth as it is now becomes this one";
  if (with.redraws(slot)) return said_of(slot) + ". Tap: the mouth as it is now becomes this one, its keys follow";
  return said_of(slot) + ". Tap to draw it again or to delete it";
}

void press(const MouthOwners& with, const MouthSlot& slot) {
  const MouthSlot*& chosen = with.panels.own.of<ChosenMouth>().slot;
  if (with.mouth(slot) == nullptr || with.redraws(slot)) {
    with.kept.keep(std::string(slot.name()));
    chosen = nullptr;
  } else {
    chosen = chosen == &slot ? nullptr : &slot;
  }
}

void show_slot(PanelContext& context, const MouthOwners& with, const MouthSlot& slot, float width) {
  const document::Mouth* mouth = with.mouth(slot);
  const std::string name(slot.name());
  const std::string label = "mouth " + name;
  const ImVec2 size{width, width + ImGui::GetFontSize() + context.gap};
  ImGui::PushID(label.c_str());
  const bool pressed = ImGui::InvisibleButton("##mouth", size);
  ImGui::PopID();
  note(context, label.c_str());
  tooltip(context, tip_of(with, slot).c_str());
  const ImVec2 from = ImGui::GetItemRectMin();
  const ImVec2 to = ImGui::GetItemRectMax();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 faint = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  const bool lit = ImGui::IsItemHovered();
  if (mouth != nullptr || lit)
    list.AddRectFilled(from, to, ImGui::GetColorU32(lit ? ImGuiCol_ButtonHovered : ImGuiCol_Button),
                       ImGui::GetStyle().FrameRounding);
  if (mouth != nullptr) {
    if (const auto place = context.pictures.place_of(with.editing, with.kept.pose_of(*mouth), FacePart::mouth))
      list.AddImageRounded(ImGui::GetIO().Fonts->TexID, {from.x + 2, from.y + 2}, {to.x - 2, from.y + width - 2},
                           place->first, place->second, k_untinted, 4);
  } else {
    list.AddRect(from, to, faint, ImGui::GetStyle().FrameRounding);
    draw_lines(list, slot.mouth, {0.5F * (from.x + to.x), from.y + 0.5F * width}, width, faint);
  }
  const std::string shown = fitted_text(name, width - context.gap);
  const float wide = ImGui::CalcTextSize(shown.c_str()).x;
  list.AddText({0.5F * (from.x + to.x - wide), from.y + width + 0.25F * context.gap},
               mouth != nullptr ? ImGui::GetColorU32(ImGuiCol_Text) : faint, shown.c_str());
  const bool chosen = with.panels.own.of<ChosenMouth>().slot == &slot && mouth != nullptr;
  if (chosen || with.redraws(slot))
    list.AddRect(from, to, ImGui::GetColorU32(ImGuiCol_ButtonActive), ImGui::GetStyle().FrameRounding, 0, scaled(2.5F));
  if (pressed) press(with, slot);
}

/// The fewest pictures in a row with which all are seen at once; where none does, they scroll.
int slots_across(const PanelContext& context, float room, float height) {
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const float line = ImGui::GetFontSize() + context.gap + ImGui::GetStyle().ItemSpacing.y;
  for (const int across : {3, 4, 5}) {
    const float width = (room - static_cast<float>(across - 1) * spacing) / static_cast<float>(across);
    const auto rows = static_cast<float>((static_cast<int>(speech::k_nine) + across - 1) / across);
    if (rows * (width + line) <= height) return across;
  }
  return 4;
}

void show_slots(PanelContext& context, const MouthOwners& with, float height) {
  begin_list(context, "mouths", {0, height});
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const float room = ImGui::GetWindowWidth() - 2 * ImGui::GetCursorStartPos().x - ImGui::GetStyle().ScrollbarSize;
  const int across = slots_across(context, room, height);
  const float width = (room - static_cast<float>(across - 1) * spacing) / static_cast<float>(across);
  int column = 0;
  for (const MouthSlot& slot : k_mouth_slots) {
    if (column++ % across != 0) ImGui::SameLine();
    show_slot(context, with, slot, width);
  }
  ImGui::EndChild();
}

/// What is done with the chosen mouth; grey while there is none.
void show_choices(PanelContext& context, const MouthOwners& with) {
  const MouthSlot* slot = with.panels.own.of<ChosenMouth>().slot;
  const bool chosen = slot != nullptr && with.mouth(*slot) != nullptr;
  const std::string name(chosen ? slot->name() : std::string_view());
  const float third = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
  ImGui::BeginDisabled(!chosen);
  if (wide_button(context, "Redraw##mouth", third, chosen && with.redraws(*slot),
                  "Load this mouth, redraw it, then tap its picture"))
    with.kept.redraw(name);
  ImGui::SameLine();
  if (wide_button(context, "Replace##mouth", third, false, "Replace with the current mouth; its keys follow"))
    with.kept.keep(name);
  ImGui::SameLine();
  if (wide_button(context, "Delete##mouth", third, false, "Remove this mouth; its keys stay")) with.kept.remove(name);
  ImGui::EndDisabled();
}

}  // namespace

void show_mouths(PanelContext& context, EditingSession& editing, KeptMouths& kept, Dialogs& dialogs,
                 PanelState& panels) {
  const MouthOwners with{editing, kept, dialogs, panels};
  const float spacing = ImGui::GetStyle().ItemSpacing.y;
  ImGui::TextWrapped("%s", guidance(with, panels.own.of<ChosenMouth>().slot).c_str());
  const bool usual = kept.offers_usual();
  const float below = (usual ? 3.0F : 2.0F) * (context.unit + spacing);
  show_slots(context, with, std::max(2 * context.unit, ImGui::GetContentRegionAvail().y - below));
  show_choices(context, with);
  if (usual && wide_button(context, "From the model's own controls##mouth", -1, false,
                           "Fill the empty places from the model's own mouth shapes"))
    kept.keep_usual();
  if (wide_button(context, "First pass...##mouth", -1, false, "Lip sync: key mouths to the sound"))
    dialogs.show(Dialog{"first pass"});
}

}  // namespace penpose::app
