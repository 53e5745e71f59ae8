#include "ui/app/widgets/pad_picture.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include "ui/app/dialogs/dialogs.h"
#include "ui/app/dialogs/entries.h"
#include "ui/app/hands/bindings.h"
#include "ui/app/hands/hand_desk.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

constexpr float k_dial_pi = 3.14159265F;
constexpr float k_key_units = 4.4F;
constexpr float k_dial_units = 2.7F;
/// Keys of a column; more stand in two, as on both sides of a large tablet.
constexpr std::size_t k_column_keys = 10;

struct Dial {
  PadControl::Kind kind;
  std::uint8_t side;
};

/// Keys above a dial, the dial, and keys below it, as tablets have them along their edge.
class Picture {
 public:
  Picture(PanelContext& context, const PadOwners& with, const DeskTablet& tablet)
      : context_(context),
        with_(with),
        tablet_(tablet),
        now_(tablet.pad >= 0 && with.editing.session().hands().pad(tablet.pad) != nullptr
                 ? with.editing.session().hands().pad(tablet.pad)->sample()
                 : decode::PadSample{}) {}

  void show();

 private:
  void show_column(std::span<const decode::PadKey> keys, std::span<const Dial> dials, bool lights_beside);
  void show_key(decode::PadKey key);
  void show_dial(const Dial& dial, bool lights_beside);
  void draw_strip(std::uint8_t side, ImVec2 from, ImVec2 to) const;
  void draw_ring(const Dial& dial, ImVec2 middle) const;
  void show_mode_key(std::uint8_t side, ImVec2 middle);
  void show_pen();
  void control_button(const PadControl& control, const std::string& label, float width, bool lit);
  [[nodiscard]] std::string label(const PadControl& control) const {
    return label_of(with_.bindings.bound(tablet_, control));
  }
  [[nodiscard]] std::vector<decode::PadKey> mode_keys(std::uint8_t side) const;

  PanelContext& context_;
  PadOwners with_;
  const DeskTablet& tablet_;
  const decode::PadSample now_;
};

void Picture::control_button(const PadControl& control, const std::string& text, float width, bool lit) {
  const bool chosen = with_.dialogs.state<PadChoice>().control == control;
  const std::string id = text + "###" + name_of(control);
  const std::string title = title_of(control, tablet_.features);
  ButtonLook look{width, chosen, title.c_str()};
  look.lit = lit;
  if (icon_button(context_, id.c_str(), look)) {
    with_.dialogs.state<PadChoice>().control = control;
  }
  // Found by its own name, whatever is written on it.
  note(context_, name_of(control).c_str());
  if (!chosen) return;
  ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                      ImGui::GetColorU32(ImGuiCol_Text), 4, 0, 2);
}

void Picture::show_key(decode::PadKey key) {
  const PadControl control = key_control(key);
  std::string text = label(control);
  if (const auto light = mode_key(key, tablet_.features)) {
    const bool bare = with_.bindings.bound(tablet_, control).kind == Binding::Kind::none;
    const std::string which = light->light < 0 ? "Next light" : "Light " + std::to_string(light->light + 1);
    text = bare ? which : which + ", " + text;
  }
  control_button(control, text, k_key_units * context_.unit, now_.keys.has(key));
}

/// Those that turn on the lights of a dial. A single one lies in the middle of its ring.
std::vector<decode::PadKey> Picture::mode_keys(std::uint8_t side) const {
  for (const decode::PadKey key : keys_of(tablet_.features)) {
    const auto light = mode_key(key, tablet_.features);
    if (light && light->side == side && light->light < 0) return {key};
  }
  return {};
}

void Picture::draw_strip(std::uint8_t side, ImVec2 from, ImVec2 to) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float half = 0.5F * (to.x - from.x);
  list.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg), half);
  list.AddRect(from, to, ImGui::GetColorU32(ImGuiCol_TextDisabled), half, 0, scaled(2));
  if (now_.strip[side] <= 0 && !now_.strip_at_zero[side]) return;
  const auto places = static_cast<float>(std::bit_width(static_cast<unsigned>(tablet_.features.strip_maximum)));
  const auto at = static_cast<float>(std::bit_width(static_cast<unsigned>(now_.strip[side])));
  const float y = from.y + half + (to.y - from.y - 2 * half) * std::min(1.0F, at / std::max(places, 1.0F));
  list.AddCircleFilled({from.x + half, y}, 0.8F * half, color_of(palette().lit));
}

void Picture::draw_ring(const Dial& dial, ImVec2 middle) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float unit = context_.unit;
  const float radius = 1.08F * unit;
  const ImU32 ink = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  list.AddCircle(middle, radius, ink, 48, 0.46F * unit);
  list.AddCircle(middle, radius, ImGui::GetColorU32(ImGuiCol_FrameBg), 48, 0.4F * unit);
  if (dial.kind == PadControl::Kind::wheel) {
    list.AddCircleFilled(middle, 0.3F * unit, ink);
    return;
  }
  if (!now_.ring_touched[dial.side] || tablet_.features.ring_maximum <= 0) return;
  // Wacom's rings count from the left with the clock.
  const float share =
      static_cast<float>(now_.ring[dial.side]) / (static_cast<float>(tablet_.features.ring_maximum) + 1);
  const float angle = k_dial_pi + 2 * k_dial_pi * share;
  list.AddCircleFilled({middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle)}, 0.22F * unit,
                       color_of(palette().lit));
}

/// The key in the middle of a ring.
void Picture::show_mode_key(std::uint8_t side, ImVec2 middle) {
  const auto keys = mode_keys(side);
  if (keys.empty()) return;
  const PadControl control = key_control(keys.front());
  const float radius = 0.62F * context_.unit;
  const ImVec2 after = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({middle.x - radius, middle.y - radius});
  if (ImGui::InvisibleButton(name_of(control).c_str(), {2 * radius, 2 * radius}))
    with_.dialogs.state<PadChoice>().control = control;
  note(context_, name_of(control).c_str());
  tooltip(context_, title_of(control, tablet_.features).c_str());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool down = now_.keys.has(keys.front());
  const auto color = ImGui::IsItemHovered() ? ImGuiCol_ButtonHovered : ImGuiCol_Button;
  list.AddCircleFilled(middle, radius, down ? color_of(palette().lit) : ImGui::GetColorU32(color), 32);
  if (with_.dialogs.state<PadChoice>().control == control)
    list.AddCircle(middle, radius, ImGui::GetColorU32(ImGuiCol_Text), 32, 2);
  // Its light stands in one of four corners, as on the tablet.
  const std::int8_t mode = with_.bindings.dial_mode(tablet_, side);
  const auto count = static_cast<float>(std::max<int>(modes_of(tablet_.features), 1));
  for (std::int8_t light = 0; light < modes_of(tablet_.features); ++light) {
    const float angle = -0.75F * k_dial_pi + 2 * k_dial_pi * static_cast<float>(light) / count;
    const ImVec2 at{middle.x + 0.38F * context_.unit * std::cos(angle),
                    middle.y + 0.38F * context_.unit * std::sin(angle)};
    const ImU32 lamp = down ? color_of(palette().on_accent) : color_of(palette().lit);
    list.AddCircleFilled(at, 0.09F * context_.unit, light == mode ? lamp : ImGui::GetColorU32(ImGuiCol_FrameBg));
  }
  ImGui::SetCursorScreenPos(after);
}

/// The dial as it is felt, with the finger on it, and what each of its lights makes it do.
void Picture::show_dial(const Dial& dial, bool lights_beside) {
  const float unit = context_.unit;
  const std::int8_t modes = modes_of(tablet_.features);
  const float rows = static_cast<float>(modes) * unit + static_cast<float>(modes - 1) * ImGui::GetStyle().ItemSpacing.y;
  const float height = lights_beside ? std::max(rows, k_dial_units * unit) : k_dial_units * unit;
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 middle{from.x + 0.5F * k_key_units * unit, from.y + 0.5F * height};
  if (dial.kind == PadControl::Kind::strip) {
    const float half = 0.32F * unit;
    draw_strip(dial.side, {middle.x - half, from.y + 0.1F * unit}, {middle.x + half, from.y + height - 0.1F * unit});
  } else {
    draw_ring(dial, middle);
    show_mode_key(dial.side, middle);
  }
  ImGui::Dummy({k_key_units * unit, height});
  if (lights_beside) ImGui::SameLine();
  ImGui::BeginGroup();
  const std::int8_t mode = with_.bindings.dial_mode(tablet_, dial.side);
  for (std::int8_t light = 0; light < modes; ++light) {
    const PadControl control{dial.kind, dial.side, light};
    control_button(control, std::to_string(light + 1) + "   " + label(control), k_key_units * unit, light == mode);
  }
  ImGui::EndGroup();
}

void Picture::show_column(std::span<const decode::PadKey> keys, std::span<const Dial> dials, bool lights_beside) {
  ImGui::BeginGroup();
  // Half of those that are numbered, so that dials beside each other are level.
  const auto numbered = static_cast<std::size_t>(std::count_if(keys.begin(), keys.end(), is_numbered));
  const std::size_t above = dials.empty() ? keys.size() : ((numbered > 0 ? numbered : keys.size()) + 1) / 2;
  for (const decode::PadKey key : keys.first(above)) show_key(key);
  for (const Dial& dial : dials) show_dial(dial, lights_beside);
  for (const decode::PadKey key : keys.subspan(above)) show_key(key);
  ImGui::EndGroup();
}

void Picture::show_pen() {
  if (!tablet_.has_pen) return;
  ImGui::Dummy({1, context_.gap});
  ImGui::TextDisabled("The pen: its buttons from the tip up");
  constexpr std::uint8_t k_buttons = 3;
  for (std::uint8_t i = 0; i < k_buttons; ++i) {
    if (i > 0) ImGui::SameLine();
    const PadControl control = pen_button_control(i);
    const auto held = std::any_of(tablet_.devices.begin(), tablet_.devices.end(),
                                  [&](int device) { return with_.desk.is_held(device, control); });
    control_button(control, label(control), 3.2F * context_.unit, held);
  }
  const PadControl wheel{PadControl::Kind::pen_wheel, 0, 0};
  const PadControl rotation{PadControl::Kind::pen_rotation, 0, 0};
  if (tablet_.pen_wheel) control_button(wheel, "Wheel: " + label(wheel), 0, false);
  if (tablet_.pen_wheel && tablet_.pen_rotation) ImGui::SameLine();
  if (tablet_.pen_rotation) control_button(rotation, "Turning it: " + label(rotation), 0, false);
}

void Picture::show() {
  const decode::PadFeatures& has = tablet_.features;
  std::vector<Dial> dials;
  for (std::uint8_t i = 0; i < has.rings; ++i) dials.push_back({PadControl::Kind::ring, i});
  for (std::uint8_t i = 0; i < has.strips; ++i) dials.push_back({PadControl::Kind::strip, i});
  for (std::uint8_t i = 0; i < has.wheels; ++i) dials.push_back({PadControl::Kind::wheel, i});
  std::vector<decode::PadKey> keys = keys_of(has);
  // Those that lie in the middle of a ring are shown there.
  for (const Dial& dial : dials) {
    if (dial.kind == PadControl::Kind::strip) continue;
    for (const decode::PadKey key : mode_keys(dial.side)) std::erase(keys, key);
  }
  const std::span<const Dial> all(dials);
  const std::span<const decode::PadKey> each(keys);
  if (keys.size() <= k_column_keys && dials.size() < 2) {
    show_column(each, all, true);
  } else {
    // Those with a meaning of their own, which come last, stand on the right.
    const auto numbered = std::count_if(keys.begin(), keys.end(), is_numbered);
    const std::size_t half = (static_cast<std::size_t>(numbered) + 1) / 2;
    const std::size_t dials_left = (dials.size() + 1) / 2;
    show_column(each.first(half), all.first(dials_left), false);
    ImGui::SameLine();
    show_column(each.subspan(half), all.subspan(dials_left), false);
  }
  show_pen();
}

}  // namespace

void show_pad_picture(PanelContext& context, const PadOwners& with, const DeskTablet& tablet) {
  Picture(context, with, tablet).show();
}

void show_guess(PanelContext& context, const DeskTablet& tablet) {
  if (tablet.guess.empty()) return;
  const std::string text = tablet.name + ": " + tablet.guess;
  ImGui::TextWrapped("%s", text.c_str());
  note(context, text.c_str());
}

}  // namespace penpose::app
