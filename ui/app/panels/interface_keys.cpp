#include <algorithm>
#include <array>

#include "ui/app/interface.h"
#include "ui/app/widgets/internal/widgets.h"

// What a keyboard does to panels: text fields, dialogs and menus come before the app's own keys.

namespace penpose::app {
namespace {

// Keys that edit text, as ImGui asks for them and as SDL numbers them (USB usage codes).
struct EditKey {
  ImGuiKey_ key;
  int scancode;
};
constexpr int k_return = 40;
constexpr int k_escape = 41;
constexpr int k_backspace = 42;
constexpr int k_enter = 88;
constexpr std::array k_edit_keys{
    EditKey{ImGuiKey_Tab, 43},
    EditKey{ImGuiKey_LeftArrow, 80},
    EditKey{ImGuiKey_RightArrow, 79},
    EditKey{ImGuiKey_UpArrow, 82},
    EditKey{ImGuiKey_DownArrow, 81},
    EditKey{ImGuiKey_Home, 74},
    EditKey{ImGuiKey_End, 77},
    EditKey{ImGuiKey_Delete, 76},
    EditKey{ImGuiKey_Backspace, k_backspace},
    EditKey{ImGuiKey_Enter, k_return},
    EditKey{ImGuiKey_Escape, k_escape},
    EditKey{ImGuiKey_A, 4},
    EditKey{ImGuiKey_C, 6},
    EditKey{ImGuiKey_V, 25},
    EditKey{ImGuiKey_X, 27},
    EditKey{ImGuiKey_Y, 28},
    EditKey{ImGuiKey_Z, 29},
    EditKey{ImGuiKey_KeyPadEnter, k_enter},
};

}  // namespace

void map_edit_keys() {
  for (const EditKey& key : k_edit_keys) ImGui::GetIO().KeyMap[key.key] = key.scancode;
}

bool Interface::wants_keys() const { return ImGui::GetIO().WantTextInput; }

bool Interface::field_pressed() const {
  if (std::any_of(typed_.begin(), typed_.end(), [](const Typed& one) { return one.waits; })) return true;
  const auto& pointer = input_.pointer();
  return std::any_of(pointer.begin(), pointer.end(), [&](const PanelPointer& one) {
    return one.down &&
           std::any_of(fields_.begin(), fields_.end(), [&](const Area& field) { return field.holds(one.at); });
  });
}

bool Interface::asks_for_key(int scancode, const KeyStroke& stroke, bool down) {
  auto& asked = dialogs_.state<KeyAsked>();
  if (asked.held == scancode) {
    // Its repetitions are swallowed, too.
    if (!down) asked.held = -1;
    return true;
  }
  if (down) asked.held = -1;
  if (!asked.waits || !down || !dialogs_.any()) return false;
  // Ctrl and Shift alone are no key yet.
  if (stroke.key == 0) return true;
  asked = {false, as_actions_name(stroke), scancode};
  return true;
}

void Interface::text(const char* utf8) {
  disturb();
  if (dialogs_.state<KeyAsked>().held >= 0) return;
  if (!wants_keys() && field_pressed()) {
    typed_.push_back({utf8});
    typed_.back().waits = true;
    return;
  }
  if (wants_keys() || dialogs_.open() != Dialog::none) typed_.push_back({utf8});
}

void Interface::key(int scancode, const KeyStroke& stroke, bool down) {
  disturb();
  panels_.has_keyboard = true;
  if (asks_for_key(scancode, stroke, down)) return;
  Typed typed{{}, scancode, down, stroke.ctrl, stroke.shift};
  // Behind a dialog or a menu nothing is to happen.
  const bool owned = dialogs_.open() != Dialog::none || menu_open_ || wants_keys();
  if (!owned && field_pressed()) {
    typed.waits = true;
    typed.stroke = stroke;
    typed_.push_back(typed);
  } else if (!down || owned) {
    typed_.push_back(typed);
  } else {
    // Held, they say what a drag on a panel means.
    ImGui::GetIO().KeyCtrl = stroke.ctrl;
    ImGui::GetIO().KeyShift = stroke.shift;
    if (!hits_.all || stroke.key == k_key_escape) actions_.press(stroke);
  }
}

void Interface::take_typed() {
  ImGuiIO& io = ImGui::GetIO();
  while (!typed_.empty()) {
    const Typed next = typed_.front();
    if (next.waits) {
      if (!input_.pointer().empty() || pressed_frames_ > 0) return;
      if (!wants_keys()) {
        // The press was of something else: what was typed is the app's, as ever.
        typed_.pop_front();
        if (next.down && !hits_.all) actions_.press(next.stroke);
        continue;
      }
    }
    const bool dialog = shown_ != Dialog::none;
    const bool answers = dialog || menu_open_;
    if (next.down && answers && next.scancode == k_escape) {
      cancels_ = true;
    } else if (next.down && dialog && (next.scancode == k_return || next.scancode == k_enter)) {
      accepts_ = true;
    } else if (next.scancode < 0 || next.down) {
      // The dialog's field takes the keyboard first, so that not even the first letter is lost.
      types_ = types_ || next.scancode < 0 || next.scancode == k_backspace;
      if (dialog && has_field_ && types_ && !wants_keys()) return;
      if (next.scancode < 0) {
        io.AddInputCharactersUTF8(next.text.c_str());
      } else if (next.scancode < static_cast<int>(std::size(io.KeysDown))) {
        io.KeysDown[next.scancode] = true;
      }
    } else if (next.scancode < static_cast<int>(std::size(io.KeysDown))) {
      io.KeysDown[next.scancode] = false;
    }
    io.KeyCtrl = next.ctrl;
    io.KeyShift = next.shift;
    typed_.pop_front();
    // A press is seen for a frame before its release comes.
    if (next.down || accepts_ || cancels_) return;
  }
  types_ = false;
}

}  // namespace penpose::app
