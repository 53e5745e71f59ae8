#include "ui/app/sound/sound_strip.h"

#include <algorithm>
#include <string>

#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

/// Minimum and maximum of each px's samples.
void draw_wave(const SoundTrack& track, ImVec2 from, ImVec2 size, float inset, double from_s, double span_s) {
  const sound::Sound& sound = *track.sound();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = ImGui::GetColorU32(track.muted() ? ImGuiCol_TextDisabled : ImGuiCol_PlotLines);
  const float middle = from.y + 0.5F * size.y;
  const double px_s = span_s / static_cast<double>(size.x - 2 * inset);
  for (float x = 0; x < size.x; x += 1) {
    const double begin = from_s + static_cast<double>(x - inset) * px_s - track.offset_s();
    if (begin + px_s < 0 || begin > sound.duration_s()) continue;
    const sound::Peak peak = track.peaks().between(sound, begin, begin + px_s);
    const float half = 0.48F * size.y;
    list.AddLine({from.x + x, middle - half * peak.high}, {from.x + x, middle - half * peak.low + 1}, colour);
  }
}

/// Words, or the mouths that speak where none are known, each where it begins, as far as they do not cover each other.
void draw_said(PanelContext& context, const SoundTrack& track, const SpokenSound& said, ImVec2 from, ImVec2 size,
               float inset, double from_s, double span_s) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float y = from.y + 0.5F * (size.y - ImGui::GetTextLineHeight());
  float free = from.x;
  const auto draw = [&](double time_s, std::string_view text) {
    const float x = from.x + inset + static_cast<float>((time_s - from_s) / span_s) * (size.x - 2 * inset);
    if (x < free || x > from.x + size.x) return;
    const ImVec2 room = ImGui::CalcTextSize(text.data(), text.data() + text.size());
    list.AddRectFilled({x - 1, y}, {x + room.x + 1, y + room.y}, ImGui::GetColorU32(ImGuiCol_FrameBg, 0.7F), scaled(3));
    list.AddText({x, y}, ImGui::GetColorU32(ImGuiCol_Text), text.data(), text.data() + text.size());
    free = x + room.x + 4;
    std::string label = "said ";
    context.targets[label.append(text)] = {x, y, x + room.x, y + room.y};
  };
  if (said.words != nullptr) {
    for (const document::SpokenWord& one : *said.words) draw(one.from_s + track.offset_s(), one.word);
    return;
  }
  if (said.mouths == nullptr) return;
  const std::string* last = nullptr;
  for (const document::SpokenMouth& one : *said.mouths) {
    if (last == nullptr || *last != one.mouth) draw(one.time_s, one.mouth);
    last = &one.mouth;
  }
}

}  // namespace

double sound_strip_height(const PanelContext& context, const SoundTrack& track) {
  return track.sound() == nullptr ? 0 : static_cast<double>(context.unit + context.gap);
}

void show_sound_strip(PanelContext& context, SoundTrack& track, const SpokenSound& said, const Playback& playback,
                      double from_s, double span_s) {
  if (track.sound() == nullptr) return;
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 size{std::max(context.unit, ImGui::GetContentRegionAvail().x), context.unit};
  const float inset = 0.3F * context.unit;
  // The button comes first, so that it and not the strip below it is hit.
  const char* label = track.muted() ? "Muted" : "Mute";
  const float wide = ImGui::CalcTextSize(label).x + 2 * context.gap;
  ImGui::SetCursorScreenPos({from.x + size.x - wide, from.y});
  if (ImGui::InvisibleButton("Mute", {wide, size.y})) track.mute(!track.muted());
  note(context, "Mute");
  tooltip(context, "Silence the sound, or let it be heard");
  ImGui::SetCursorScreenPos(from);
  ImGui::InvisibleButton("sound", {size.x - wide, size.y});
  note(context, "sound");
  tooltip(context, "Drag the sound to let it begin at another moment");
  if (ImGui::IsItemActive()) {
    const double px_s = span_s / static_cast<double>(size.x - 2 * inset);
    const double begun = track.document_offset_s();
    track.drag(begun + static_cast<double>(ImGui::GetMouseDragDelta(0, 0).x) * px_s);
  }
  if (ImGui::IsItemDeactivated()) {
    const double to = track.offset_s();
    track.drag(std::nullopt);
    if (to != track.document_offset_s()) track.move(to);
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 to{from.x + size.x, from.y + size.y};
  list.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg), scaled(4));
  list.PushClipRect(from, to, true);
  draw_wave(track, from, size, inset, from_s, span_s);
  draw_said(context, track, said, from, size, inset, from_s, span_s);
  const float cursor =
      from.x + inset + static_cast<float>((playback.time_s() - from_s) / span_s) * (size.x - 2 * inset);
  list.AddLine({cursor, from.y}, {cursor, to.y}, ImGui::GetColorU32(ImGuiCol_ButtonActive), scaled(2));
  list.AddRectFilled({to.x - wide, from.y}, to, ImGui::GetColorU32(ImGuiCol_Button), scaled(4));
  list.AddText({to.x - wide + context.gap, from.y + 0.5F * (size.y - ImGui::GetTextLineHeight())},
               ImGui::GetColorU32(ImGuiCol_Text), label);
  list.PopClipRect();
}

}  // namespace penpose::app
