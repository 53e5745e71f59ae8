#include "ui/app/interface.h"
#include "ui/app/panels/panels.h"
#include "ui/app/widgets/internal/theme.h"

// What a screen without keyboard and mouse needs: keys to type with, and a pointer.

namespace penpose::app {

bool Interface::type_on_screen(const PanelPointer& pointer) {
  if (keyboard_held_) {
    keyboard_held_ = pointer.down;
    return true;
  }
  if (!keyboard_.shown() || !pointer.down || ImGui::GetIO().MouseDown[0] || !keyboard_.area().holds(pointer.at)) {
    return false;
  }
  keyboard_held_ = true;
  const auto key = keyboard_.press(pointer.at);
  if (!key) return true;
  ImGuiIO& io = ImGui::GetIO();
  if (key->kind == ScreenKeyboard::Kind::text) io.AddInputCharactersUTF8(key->text.c_str());
  if (key->kind == ScreenKeyboard::Kind::erase) key_to_release_ = io.KeyMap[ImGuiKey_Backspace];
  if (key->kind == ScreenKeyboard::Kind::done) key_to_release_ = io.KeyMap[ImGuiKey_Enter];
  if (key_to_release_ >= 0) io.KeysDown[key_to_release_] = true;
  return true;
}

void Interface::show_keyboard(PanelContext& context) {
  if (!context.typed_into || panels_.has_keyboard) {
    keyboard_.hide();
    return;
  }
  const auto window = canvas_.window();
  keyboard_.show({0, 0, static_cast<double>(window.width), static_cast<double>(window.height)}, *context.typed_into,
                 static_cast<double>(context.unit), static_cast<double>(context.gap));
  hits_.panels.push_back(keyboard_.area());
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  const auto corner = [](double x, double y) { return ImVec2{static_cast<float>(x), static_cast<float>(y)}; };
  const Area& all = keyboard_.area();
  list.AddRectFilled(corner(all.left, all.top), corner(all.right, all.bottom), ImGui::GetColorU32(ImGuiCol_PopupBg));
  for (const auto& key : keyboard_.keys()) {
    const bool lit = key.kind == ScreenKeyboard::Kind::shift && keyboard_.shifted();
    list.AddRectFilled(corner(key.area.left, key.area.top), corner(key.area.right, key.area.bottom),
                       ImGui::GetColorU32(lit ? ImGuiCol_ButtonActive : ImGuiCol_Button), 4);
    const ImVec2 size = ImGui::CalcTextSize(key.label.c_str());
    const PxPoint middle = key.area.middle();
    list.AddText(corner(middle.x - 0.5 * static_cast<double>(size.x), middle.y - 0.5 * static_cast<double>(size.y)),
                 ImGui::GetColorU32(ImGuiCol_Text), key.label.c_str());
    targets_["key " + key.label] = key.area;
  }
}

void Interface::draw_pointer() const {
  if (!pointer_) return;
  const auto size = static_cast<float>(18 * canvas_.scale());
  const ImVec2 tip{static_cast<float>(pointer_->x), static_cast<float>(pointer_->y)};
  const ImVec2 left{tip.x, tip.y + size};
  const ImVec2 right{tip.x + 0.7F * size, tip.y + 0.7F * size};
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  list.AddTriangleFilled(tip, right, left, color_of(k_canvas_colors.ink));
  list.AddTriangle(tip, right, left, color_of(k_canvas_colors.shade), static_cast<float>(1.5 * canvas_.scale()));
}

}  // namespace penpose::app
