#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace penpose::app {

/// What can be chosen from a menu, the radial menu, the toolbar or by a key.
enum class Action : std::uint8_t {
  tool_select,
  tool_pose,
  tool_oversketch,
  tool_constraint,
  tool_pin,
  tool_erase,
  tool_articulate,
  undo,
  redo,
  clear_curves,
  delete_curve,
  keep_curve,
  reset_pose,
  suggest_rest,
  cancel,
  view_front,
  view_side,
  view_three_quarter,
  frame_all,
  orbit_left,
  orbit_right,
  orbit_up,
  orbit_down,
  zoom_in,
  zoom_out,
  wireframe,
  key_pose,
  delete_key,
  previous_key,
  next_key,
  play,
  onion_skin,
  open,
  recent,
  save,
  save_as,
  export_as,
  panels,
  fullscreen,
  theme,
  larger,
  smaller,
  help,
  quit,
  shortcuts,
  search,
  history,
  previous_frame,
  next_frame,
  copy_key,
  paste_key,
  loop_from,
  loop_to,
  loop_off,
  auto_key,
  mirror_strokes,
  flip_pose,
  copy_to_right,
  copy_to_left,
  stabiliser,
  moved_only,
  density,
  film,
  library,
  perform,
  tour_pose,
  tour_rig,
  tour_animate,
  flat_view,
  set_front,
  backdrop,
  backdrop_off,
};

/// Keys that are no character.
inline constexpr std::uint32_t k_key_escape = 27;
inline constexpr std::uint32_t k_key_tab = 9;
inline constexpr std::uint32_t k_key_delete = 127;
inline constexpr std::uint32_t k_key_home = 0x110000;
inline constexpr std::uint32_t k_key_left = 0x110001;
inline constexpr std::uint32_t k_key_right = 0x110002;
inline constexpr std::uint32_t k_key_up = 0x110003;
inline constexpr std::uint32_t k_key_down = 0x110004;
inline constexpr std::uint32_t k_key_f1 = 0x110005;
inline constexpr std::uint32_t k_key_f11 = 0x110006;

struct KeyStroke {
  std::uint32_t key = 0;  ///< the character without shift, in lower case, or one of the constants; 0: none
  bool ctrl = false;
  bool shift = false;
  friend bool operator==(const KeyStroke&, const KeyStroke&) = default;
};

struct ActionInfo {
  Action action;
  std::string_view label;
  std::string_view tip;
  KeyStroke key;
  KeyStroke other = {};  ///< a second key for the same
};

[[nodiscard]] std::span<const ActionInfo> all_actions();
[[nodiscard]] const ActionInfo& info(Action action);
/// The action of a key; null when it has none.
[[nodiscard]] const ActionInfo* action_of(const KeyStroke& key);
/// "Ctrl+Shift+Z"; empty where there is none.
[[nodiscard]] std::string shortcut_text(const KeyStroke& key);
/// The tip with the shortcut, for a tooltip.
[[nodiscard]] std::string tooltip_of(Action action);

}  // namespace penpose::app
