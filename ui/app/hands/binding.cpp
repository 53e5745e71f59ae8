#include "ui/app/hands/binding.h"

#include <algorithm>
#include <array>

#include "ui/app/tools/tool.h"

namespace penpose::app {
namespace {

using drawing::ToolKind;
using Kind = Binding::Kind;

template <typename T>
struct Word {
  T value;
  std::string_view word;   ///< in settings
  std::string_view label;  ///< on buttons
  std::string_view tip;
};

constexpr std::string_view k_view_tip = "Hold to move the view with the pen";

constexpr std::array k_views{Word<ViewHold>{ViewHold::turn, "turn", "Turn view", k_view_tip},
                             Word<ViewHold>{ViewHold::move, "move", "Move view", k_view_tip},
                             Word<ViewHold>{ViewHold::zoom, "zoom", "Zoom view", k_view_tip}};
constexpr auto k_dials =
    std::to_array<Word<DialUse>>({{DialUse::time, "time", "Time", "The timeline's cursor, a frame for each notch"},
                                  {DialUse::zoom, "zoom", "Zoom", "Nearer and farther, about the pen where it is near"},
                                  {DialUse::turn, "turn", "Turn", "The view, about the model"},
                                  {DialUse::control, "control", "Control",
                                   "The value of the control that is selected, or that the last stroke moved most"},
                                  {DialUse::undo, "undo", "Undo and redo", "Undo and redo, step by step"},
                                  {DialUse::keys, "keys", "Key to key", "From key to key of the timeline"}});

template <typename T, std::size_t n>
const Word<T>* by_value(const std::array<Word<T>, n>& words, T value) {
  const auto found = std::find_if(words.begin(), words.end(), [&](const auto& one) { return one.value == value; });
  return found == words.end() ? nullptr : &*found;
}

template <typename T, std::size_t n>
const Word<T>* by_word(const std::array<Word<T>, n>& words, std::string_view word) {
  const auto found = std::find_if(words.begin(), words.end(), [&](const auto& one) { return one.word == word; });
  return found == words.end() ? nullptr : &*found;
}

/// The tools that a key can hold.
std::vector<const WindowTool*> held_tools() {
  std::vector<const WindowTool*> tools;
  for (const WindowTool& one : window_tools()) {
    // A key holds a tool by its kind.
    if (!one.button.label.empty() && one.can_be_held && &one == &window_tool(one.kind)) tools.push_back(&one);
  }
  return tools;
}

const WindowTool* held_tool(ToolKind kind) {
  for (const WindowTool* one : held_tools()) {
    if (one->kind == kind) return one;
  }
  return nullptr;
}

/// What a hand on the keys wants first when it draws poses.
const std::vector<Binding>& wanted_keys() {
  static const std::vector<Binding> all{
      binding_of(Action::undo),         binding_of(Action::redo),
      binding_of(ViewHold::turn),       binding_of(ViewHold::move),
      binding_of(ToolKind::erase),      binding_of(Action::key_pose),
      binding_of(ToolKind::constraint), binding_of(Action::play),
      binding_of(ViewHold::zoom),       binding_of(Action::previous_key),
      binding_of(Action::next_key),     binding_of(Action::frame_all),
      binding_of(Action::view_front),   binding_of(Action::view_three_quarter),
      binding_of(Action::view_side),    binding_of(Action::suggest_rest),
      binding_of(Action::clear_curves), binding_of(Action::cancel),
      binding_of(ToolKind::none),       binding_of(ToolKind::pin),
      binding_of(Action::save),         binding_of(Action::panels),
  };
  return all;
}

/// How dials of every kind begin, and in which order they go on with their modes.
DialUse default_use(const PadControl& control) {
  constexpr std::array k_order{DialUse::time, DialUse::zoom, DialUse::control, DialUse::undo};
  // A second dial begins with what the first does not do.
  const auto mode = static_cast<std::size_t>(std::max<int>(control.mode, 0));
  return k_order[(mode + control.index) % k_order.size()];
}

}  // namespace

Binding binding_of(Action action) { return {.kind = Kind::action, .action = action}; }
Binding binding_of(ViewHold view) { return {.kind = Kind::view, .view = view}; }
Binding binding_of(ToolKind tool) { return {.kind = Kind::tool, .tool = tool}; }
Binding binding_of(DialUse dial) { return {.kind = Kind::dial, .dial = dial}; }

std::string to_text(const Binding& binding) {
  switch (binding.kind) {
    case Kind::none:
      break;
    case Kind::action:
      return "action " + std::string(info(binding.action).label);
    case Kind::view:
      return "hold " + std::string(by_value(k_views, binding.view)->word);
    case Kind::tool:
      if (const auto* tool = held_tool(binding.tool)) return "tool " + std::string(tool->button.label);
      break;
    case Kind::dial:
      return "dial " + std::string(by_value(k_dials, binding.dial)->word);
    case Kind::pen_menu:
      return "menu";
    case Kind::next_mode:
      return "mode";
  }
  return "none";
}

std::optional<Binding> parse_binding(std::string_view text) {
  Binding made;
  if (text == "none") return made;
  if (text == "menu" || text == "mode") {
    made.kind = text == "menu" ? Kind::pen_menu : Kind::next_mode;
    return made;
  }
  const std::size_t blank = std::min(text.find(' '), text.size());
  const std::string_view kind = text.substr(0, blank);
  const std::string_view word = text.substr(std::min(blank + 1, text.size()));
  if (kind == "action") {
    for (const ActionInfo& one : all_actions()) {
      if (one.label == word) return binding_of(one.action);
    }
  }
  if (kind == "hold") {
    if (const auto* view = by_word(k_views, word)) return binding_of(view->value);
  }
  if (kind == "tool") {
    for (const WindowTool* one : held_tools()) {
      if (one->button.label == word) return binding_of(one->kind);
    }
  }
  if (kind == "dial") {
    if (const auto* dial = by_word(k_dials, word)) return binding_of(dial->value);
  }
  return std::nullopt;
}

std::string label_of(const Binding& binding) {
  switch (binding.kind) {
    case Kind::none:
      break;
    case Kind::action:
      return std::string(info(binding.action).label);
    case Kind::view:
      return std::string(by_value(k_views, binding.view)->label);
    case Kind::tool:
      if (const auto* tool = held_tool(binding.tool)) return "Pen: " + std::string(tool->button.label);
      break;
    case Kind::dial:
      return std::string(by_value(k_dials, binding.dial)->label);
    case Kind::pen_menu:
      return "Turn, menu";
    case Kind::next_mode:
      return "Next for dials";
  }
  return "Nothing";
}

std::string tip_of(const Binding& binding) {
  switch (binding.kind) {
    case Kind::none:
      return {};
    case Kind::action:
      return std::string(info(binding.action).tip);
    case Kind::view:
      return std::string(by_value(k_views, binding.view)->tip);
    case Kind::tool:
      return "Hold for this tool; release for the previous one";
    case Kind::pen_menu:
      return "Hold to turn the view; click for the pen menu";
    case Kind::next_mode:
      return "Switch rings, strips and wheels to their next function";
    case Kind::dial:
      return std::string(by_value(k_dials, binding.dial)->tip);
  }
  return {};
}

std::span<const Binding> held_choices() {
  static const std::vector<Binding> all = [] {
    std::vector<Binding> made;
    for (const auto& view : k_views) made.push_back(binding_of(view.value));
    for (const WindowTool* tool : held_tools()) made.push_back(binding_of(tool->kind));
    return made;
  }();
  return all;
}

std::span<const Binding> dial_choices() {
  static const std::vector<Binding> all = [] {
    std::vector<Binding> made;
    made.reserve(k_dials.size());
    for (const auto& dial : k_dials) made.push_back(binding_of(dial.value));
    return made;
  }();
  return all;
}

PadControl dial_control(decode::PadDial dial, std::uint8_t side, std::int8_t mode) {
  constexpr std::array k_kinds{PadControl::Kind::ring, PadControl::Kind::strip, PadControl::Kind::wheel};
  return {k_kinds[static_cast<std::size_t>(dial)], side, mode};
}

bool is_dial(const PadControl& control) {
  return control.kind != PadControl::Kind::key && control.kind != PadControl::Kind::pen_button;
}

bool is_of_pen(const PadControl& control) {
  return control.kind == PadControl::Kind::pen_button || control.kind == PadControl::Kind::pen_wheel ||
         control.kind == PadControl::Kind::pen_rotation;
}

std::string name_of(const PadControl& control) {
  const std::string number = std::to_string(control.index + 1);
  const std::string light = " light " + std::to_string(control.mode + 1);
  switch (control.kind) {
    case PadControl::Kind::key:
      return decode::key_name(static_cast<decode::PadKey>(control.index));
    case PadControl::Kind::ring:
      return "ring " + number + light;
    case PadControl::Kind::strip:
      return "strip " + number + light;
    case PadControl::Kind::wheel:
      return "wheel " + number + light;
    case PadControl::Kind::pen_button:
      return "pen button " + number;
    case PadControl::Kind::pen_wheel:
      return "pen wheel";
    case PadControl::Kind::pen_rotation:
      return "pen rotation";
  }
  return {};
}

std::string title_of(const PadControl& control, const decode::PadFeatures& features) {
  const auto dial = [&](const char* word, unsigned count) {
    std::string title = count > 1 ? std::string(word) + " " + std::to_string(control.index + 1) : std::string(word);
    return title + ", light " + std::to_string(control.mode + 1);
  };
  switch (control.kind) {
    case PadControl::Kind::key: {
      const auto keys = keys_of(features);
      const auto found = std::find(keys.begin(), keys.end(), static_cast<decode::PadKey>(control.index));
      const auto is_mode = [&](decode::PadKey key) { return features.mode_keys.has(key); };
      if (found != keys.end() && is_mode(*found)) return "Key of the lights";
      return "Key " + std::to_string(found - keys.begin() + 1 - std::count_if(keys.begin(), found, is_mode));
    }
    case PadControl::Kind::ring:
      return dial("Ring", features.rings);
    case PadControl::Kind::strip:
      return dial("Strip", features.strips);
    case PadControl::Kind::wheel:
      return dial("Wheel", features.wheels);
    case PadControl::Kind::pen_button:
      return "Pen's button " + std::to_string(control.index + 1);
    case PadControl::Kind::pen_wheel:
      return "Pen's wheel";
    case PadControl::Kind::pen_rotation:
      return "Pen rotation";
  }
  return {};
}

bool is_numbered(decode::PadKey key) {
  for (unsigned i = 0; i < decode::k_numbered_keys; ++i) {
    if (decode::numbered_key(i) == key) return true;
  }
  // Pads that describe more than ten keys go on with the codes behind them.
  return key > decode::PadKey::button9 && key < decode::PadKey::left;
}

std::vector<decode::PadKey> keys_of(const decode::PadFeatures& features) {
  std::vector<decode::PadKey> keys;
  features.keys.for_each([&keys](decode::PadKey key) { keys.push_back(key); });
  std::stable_partition(keys.begin(), keys.end(), is_numbered);
  return keys;
}

std::optional<ModeKey> mode_key(decode::PadKey key, const decode::PadFeatures& features) {
  if (!features.mode_keys.has(key)) return std::nullopt;
  int place = 0;
  features.mode_keys.for_each([&](decode::PadKey other) { place += other < key ? 1 : 0; });
  const int each = std::max(1, static_cast<int>(features.mode_keys.count() / std::max(1U, features.modes)));
  const auto side = static_cast<std::uint8_t>(std::min(place / each, static_cast<int>(decode::k_pad_sides) - 1));
  return ModeKey{side, static_cast<std::int8_t>(each > 1 ? place % each : -1)};
}

std::int8_t modes_of(const decode::PadFeatures& features) {
  constexpr std::int8_t k_without_lights = 4;
  return features.modes > 0 ? static_cast<std::int8_t>(features.lights) : k_without_lights;
}

Binding default_binding(const PadControl& control, const decode::PadFeatures& features) {
  switch (control.kind) {
    case PadControl::Kind::key: {
      std::size_t place = 0;
      for (const decode::PadKey key : keys_of(features)) {
        if (features.mode_keys.has(key)) continue;
        if (static_cast<std::uint8_t>(key) == control.index)
          return place < wanted_keys().size() ? wanted_keys()[place] : Binding{};
        ++place;
      }
      return {};
    }
    case PadControl::Kind::pen_button: {
      Binding menu;
      menu.kind = Kind::pen_menu;
      if (control.index == 0) return binding_of(ViewHold::move);
      return control.index == 1 ? menu : Binding{};
    }
    case PadControl::Kind::pen_wheel:
      return binding_of(DialUse::control);
    case PadControl::Kind::pen_rotation:
      return {};
    default:
      return binding_of(default_use(control));
  }
}

}  // namespace penpose::app
