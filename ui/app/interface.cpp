#include "ui/app/interface.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <filesystem>
#include <utility>

#include "ui/app/panels.h"
#include "ui/app/widgets.h"

namespace penpose::app {
namespace {

constexpr float k_font_px = 15;
constexpr int k_settle_frames = 3;
/// Latin, and the signs that the panels use.
constexpr ImWchar k_letters[] = {0x20, 0x17f, 0x21ba, 0x21ba, 0x25b6, 0x25be, 0x2713, 0x2713, 0x270e, 0x270e, 0};
constexpr const char* k_font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

}  // namespace

Interface::Interface(App& app) : app_(app) {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
  map_edit_keys();
  apply_look();
  disturb();
}

Interface::~Interface() { ImGui::DestroyContext(); }

void Interface::disturb() { unsettled_ = k_settle_frames; }

void Interface::apply_look() {
  const double scale = app_.scale();
  const bool light = app_.settings().light;
  if (scale == look_scale_ && light == look_light_) return;
  ImGuiIO& io = ImGui::GetIO();
  if (scale != look_scale_) {
    io.Fonts->Clear();
    std::error_code code;
    const auto px = static_cast<float>(std::round(k_font_px * scale));
    if (!std::filesystem::exists(k_font, code) ||
        io.Fonts->AddFontFromFileTTF(k_font, px, nullptr, k_letters) == nullptr) {
      ImFontConfig config;
      config.SizePixels = px;
      io.Fonts->AddFontDefault(&config);
    }
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    ++font_revision_;
  }
  look_scale_ = scale;
  look_light_ = light;
  ImGuiStyle style;
  if (light) {
    ImGui::StyleColorsLight(&style);
  } else {
    ImGui::StyleColorsDark(&style);
    style.Colors[ImGuiCol_WindowBg] = {0.13F, 0.14F, 0.16F, 0.97F};
    style.Colors[ImGuiCol_Button] = {0.24F, 0.27F, 0.32F, 1};
    style.Colors[ImGuiCol_ButtonHovered] = {0.30F, 0.36F, 0.44F, 1};
    style.Colors[ImGuiCol_ButtonActive] = {0.16F, 0.46F, 0.72F, 1};
    style.Colors[ImGuiCol_FrameBg] = {0.19F, 0.21F, 0.24F, 1};
  }
  style.Colors[ImGuiCol_PopupBg].w = 1;
  style.WindowRounding = 0;
  style.FrameRounding = 4;
  style.WindowBorderSize = 0;
  style.ScrollbarSize = 18;
  style.ItemSpacing = {6, 6};
  style.WindowPadding = {6, 6};
  style.FramePadding = {8, 6};
  style.ScaleAllSizes(static_cast<float>(scale));
  ImGui::GetStyle() = style;
}

void Interface::frame(double passed_s) {
  ImGuiIO& io = ImGui::GetIO();
  apply_look();
  const auto window = app_.window();
  io.DisplaySize = {static_cast<float>(window.width), static_cast<float>(window.height)};
  io.DeltaTime = static_cast<float>(std::clamp(passed_s, 1e-4, 0.5));
  // A dialog that opens knows nothing of what was pressed before.
  const Dialog dialog = app_.panels().dialog;
  const bool opens = std::exchange(shown_, dialog) != dialog;
  if (opens) {
    dialog_area_.reset();
    types_ = has_field_ = false;
    opening_ = app_.panels().has_keyboard ? 2 : 0;
  }
  take_pointer();
  take_typed();
  ImGui::NewFrame();
  targets_.clear();
  app_.hits() = {};
  const auto unit = static_cast<float>(app_.target_px());
  PanelContext context{app_, targets_, unit, static_cast<float>(6 * app_.scale())};
  context.dialog_opens = opens;
  context.accepts = std::exchange(accepts_, false);
  context.cancels = std::exchange(cancels_, false);
  context.field_first = !wants_keys() && !io.MouseDown[0] && (types_ || opening_ > 0);
  if (opening_ > 0) --opening_;
  const double width = window.width;
  const double height = window.height;
  const double top = unit + 2 * context.gap;
  const double left = 2.6 * unit + 2 * context.gap;
  const double right = std::min(9.5 * unit, 0.4 * width);
  const double bottom = 2 * unit + 3 * context.gap;
  const double player = app_.player() ? unit + 2 * context.gap : 0;
  Area free{0, 0, width, height};
  if (app_.panels().shown) {
    free = {left, top, width - right, height - bottom - player};
    show_top_bar(context, {0, 0, width, top});
    show_toolbar(context, {0, top, left, height - bottom});
    show_side_panel(context, {width - right, top, width, height - bottom});
    show_timeline(context, {0, height - bottom, width, height});
  } else {
    // The way back, for whoever has no keyboard at hand.
    const double side = 3 * unit;
    if (begin_panel(context, "back", {0, 0, side, top})) action_button(context, Action::panels, -1);
    end_panel();
  }
  if (app_.player()) show_player(context, {free.left, free.bottom, free.right, free.bottom + player});
  app_.set_free_area(free);
  show_curve_menu(context);
  show_suggestion(context);
  show_notices(context);
  show_radial_menu(context);
  show_dialog(context);
  show_keyboard(context);
  menu_open_ = context.menu_open;
  has_field_ = context.has_field;
  dialog_area_ = context.dialog_area;
  ImGui::Render();
  if (unsettled_ > 0) --unsettled_;
  if (!app_.panel_pointer().empty() || !typed_.empty() || shown_ != app_.panels().dialog) disturb();
}

void Interface::take_pointer() {
  ImGuiIO& io = ImGui::GetIO();
  // One press or release a frame, so that none is lost.
  if (key_to_release_ >= 0) {
    io.KeysDown[key_to_release_] = false;
    key_to_release_ = -1;
  }
  auto& pointer = app_.panel_pointer();
  while (!pointer.empty()) {
    const PanelPointer next = pointer.front();
    pointer.pop_front();
    disturb();
    if (type_on_screen(next)) {
      if (key_to_release_ >= 0) break;
      continue;
    }
    io.MousePos = {static_cast<float>(next.at.x), static_cast<float>(next.at.y)};
    // What lies behind a dialog is neither lit nor pressed.
    const bool behind = shown_ != Dialog::none && !(dialog_area_ && dialog_area_->holds(next.at));
    const bool down = next.down && (!behind || io.MouseDown[0]);
    const bool turned = io.MouseDown[0] != down;
    io.MouseDown[0] = down;
    if (turned) break;
  }
  const PxPoint at{static_cast<double>(io.MousePos.x), static_cast<double>(io.MousePos.y)};
  if (shown_ != Dialog::none && !io.MouseDown[0] && !(dialog_area_ && dialog_area_->holds(at))) {
    io.MousePos = {-FLT_MAX, -FLT_MAX};
  }
  io.MouseWheel = static_cast<float>(app_.take_wheel());
}

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
  if (!context.typed_into || app_.panels().has_keyboard) {
    keyboard_.hide();
    return;
  }
  const auto window = app_.window();
  keyboard_.show({0, 0, static_cast<double>(window.width), static_cast<double>(window.height)}, *context.typed_into,
                 static_cast<double>(context.unit), static_cast<double>(context.gap));
  app_.hits().panels.push_back(keyboard_.area());
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

const Area* Interface::find(std::string_view label) const {
  const auto found = targets_.find(label);
  return found == targets_.end() ? nullptr : &found->second;
}

const std::map<std::string, Area, std::less<>>& Interface::targets() const { return targets_; }

}  // namespace penpose::app
