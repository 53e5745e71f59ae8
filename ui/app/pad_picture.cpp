#include "ui/app/pad_picture.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "ui/app/widgets.h"

namespace penpose::app {
namespace {

constexpr float k_pi = 3.14159265F;
constexpr ImU32 k_lit = IM_COL32(255, 176, 0, 255);
constexpr float k_key_units = 4.4F;
/// Keys of a column; more stand in two, as on both sides of a large tablet.
constexpr std::size_t k_column_keys = 10;

class Picture {
 public:
  Picture(PanelContext& context, const DeskTablet& tablet)
      : context_(context),
        app_(context.app),
        tablet_(tablet),
        pad_(context.app.workspace().session().hands().pad(tablet.pad)) {}

  void show();

 private:
  void show_key(decode::PadKey key);
  void show_keys(std::size_t from, std::size_t to);
  void show_dials(PadControl::Kind kind, unsigned count);
  void show_dial(PadControl::Kind kind, std::uint8_t side);
  void show_pen();
  /// A button of a control with what it does; true where it is the one that is chosen for.
  void control_button(const PadControl& control, const std::string& prefix, float width, bool lit);
  [[nodiscard]] decode::PadSample sample() const { return pad_ != nullptr ? pad_->sample() : decode::PadSample{}; }

  PanelContext& context_;
  App& app_;
  const DeskTablet& tablet_;
  const decode::PadDecoder* pad_;
  std::vector<decode::PadKey> keys_;
};

void Picture::control_button(const PadControl& control, const std::string& prefix, float width, bool lit) {
  const bool chosen = app_.panels().pad_control == control;
  const std::string id = prefix + label_of(app_.bound(tablet_, control)) + "###" + name_of(control);
  if (lit) {
    for (const auto color : {ImGuiCol_Button, ImGuiCol_ButtonHovered, ImGuiCol_ButtonActive})
      ImGui::PushStyleColor(color, k_lit);
    ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32(20, 20, 20, 255));
  }
  if (wide_button(context_, id.c_str(), width, chosen && !lit, title_of(control, tablet_.features).c_str())) {
    app_.panels().pad_control = control;
  }
  if (lit) ImGui::PopStyleColor(4);
  // Found by its own name, whatever is written on it.
  note(context_, name_of(control).c_str());
  if (!chosen) return;
  const ImVec2 least = ImGui::GetItemRectMin();
  const ImVec2 most = ImGui::GetItemRectMax();
  ImGui::GetWindowDrawList()->AddRect(least, most, ImGui::GetColorU32(ImGuiCol_Text), 4, 0, 2);
}

void Picture::show_key(decode::PadKey key) {
  const bool light = (tablet_.features.mode_keys & decode::key_bit(key)) != 0;
  const bool down = (sample().keys & decode::key_bit(key)) != 0;
  const PadControl control = key_control(key);
  const bool bare = light && app_.bound(tablet_, control).kind == Binding::Kind::none;
  if (!bare) {
    control_button(control, light ? "Light, " : "", k_key_units * context_.unit, down);
    return;
  }
  control_button(control, "Next light: ", k_key_units * context_.unit, down);
}

void Picture::show_keys(std::size_t from, std::size_t to) {
  ImGui::BeginGroup();
  for (std::size_t i = from; i < to; ++i) show_key(keys_[i]);
  ImGui::EndGroup();
}

/// The dial as it is felt, with the finger on it, and below it what each of its lights makes it do.
void Picture::show_dial(PadControl::Kind kind, std::uint8_t side) {
  const float unit = context_.unit;
  const decode::PadSample now = sample();
  const ImVec2 from = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 ink = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  const float width = k_key_units * unit;
  const float height = 2.6F * unit;
  const ImVec2 middle{from.x + 0.5F * width, from.y + 0.5F * height};
  const float radius = 1.1F * unit;
  if (kind == PadControl::Kind::strip) {
    const float half = 0.3F * unit;
    const ImVec2 top{middle.x - half, from.y + 0.1F * unit};
    const ImVec2 bottom{middle.x + half, from.y + height - 0.1F * unit};
    list.AddRectFilled(top, bottom, ImGui::GetColorU32(ImGuiCol_FrameBg), half);
    list.AddRect(top, bottom, ink, half, 0, 2);
    if (now.strip[side] > 0) {
      const auto places = static_cast<float>(std::bit_width(static_cast<unsigned>(tablet_.features.strip_maximum)));
      const auto at = static_cast<float>(std::bit_width(static_cast<unsigned>(now.strip[side])));
      const float y = top.y + half + (bottom.y - top.y - 2 * half) * std::min(1.0F, at / std::max(places, 1.0F));
      list.AddCircleFilled({middle.x, y}, 0.8F * half, k_lit);
    }
  } else {
    const bool ring = kind == PadControl::Kind::ring;
    list.AddCircle(middle, radius, ink, 48, 0.5F * unit);
    list.AddCircle(middle, radius, ImGui::GetColorU32(ImGuiCol_FrameBg), 48, 0.42F * unit);
    if (ring && now.ring_touched[side] && tablet_.features.ring_maximum > 0) {
      // Wacom's rings count from the left with the clock.
      const float share = static_cast<float>(now.ring[side]) / static_cast<float>(tablet_.features.ring_maximum + 1);
      const float angle = k_pi + 2 * k_pi * share;
      list.AddCircleFilled({middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle)}, 0.2F * unit,
                           k_lit);
    }
    if (!ring) list.AddCircleFilled(middle, 0.3F * unit, ink);
  }
  ImGui::Dummy({width, height});
  const std::int8_t mode = app_.dial_mode(tablet_, side);
  for (std::int8_t light = 0; light < modes_of(tablet_.features); ++light) {
    const std::string prefix = std::to_string(light + 1) + "  ";
    control_button({kind, side, light}, prefix, width, light == mode);
  }
}

void Picture::show_dials(PadControl::Kind kind, unsigned count) {
  for (unsigned side = 0; side < count; ++side) {
    ImGui::SameLine();
    ImGui::BeginGroup();
    show_dial(kind, static_cast<std::uint8_t>(side));
    ImGui::EndGroup();
  }
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
                                  [&](int device) { return app_.desk().is_held(device, control); });
    control_button(control, "", 3.2F * context_.unit, held);
  }
  if (tablet_.pen_wheel) control_button({PadControl::Kind::pen_wheel, 0, 0}, "Wheel: ", 0, false);
  if (tablet_.pen_wheel && tablet_.pen_rotation) ImGui::SameLine();
  if (tablet_.pen_rotation) control_button({PadControl::Kind::pen_rotation, 0, 0}, "Turning it: ", 0, false);
}

void Picture::show() {
  keys_ = keys_of(tablet_.features);
  const std::size_t column = keys_.size() <= k_column_keys ? keys_.size() : (keys_.size() + 1) / 2;
  ImGui::BeginGroup();
  if (keys_.empty()) ImGui::Dummy({0, 0});
  show_keys(0, column);
  if (column < keys_.size()) {
    ImGui::SameLine();
    show_keys(column, keys_.size());
  }
  show_dials(PadControl::Kind::ring, tablet_.features.rings);
  show_dials(PadControl::Kind::strip, tablet_.features.strips);
  show_dials(PadControl::Kind::wheel, tablet_.features.wheels);
  ImGui::EndGroup();
  show_pen();
}

}  // namespace

void show_pad_picture(PanelContext& context, const DeskTablet& tablet) { Picture(context, tablet).show(); }

}  // namespace penpose::app
