#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "ui/app/key_stroke.h"

namespace penpose::app {

class App;
struct WindowTool;

/// What can be chosen from a menu, the radial menu, the toolbar or by a key, by its name in the list of actions
/// (action_list.cpp).
struct Action {
  std::string_view name;
  friend constexpr bool operator==(Action, Action) = default;

  // Those that are asked for by name elsewhere.
  static const Action tool_select, tool_pose, tool_oversketch, tool_constraint, tool_pin, tool_erase, tool_articulate,
      undo, redo, clear_curves, delete_curve, keep_curve, reset_pose, cancel, view_front, view_side, view_three_quarter,
      frame_all, zoom_in, wireframe, key_pose, delete_key, previous_key, next_key, play, onion_skin, suggest_rest, open,
      recent, save, save_as, export_as, panels, fullscreen, theme, larger, smaller, help, quit, shortcuts, search,
      history, previous_frame, next_frame, copy_key, paste_key, loop_from, loop_to, loop_off, auto_key, mirror_strokes,
      flip_pose, copy_to_right, copy_to_left, stabiliser, moved_only, density, film, perform, library, tour_pose,
      tour_rig, tour_animate, flat_view, set_front, backdrop, backdrop_off, clay, frame_face, up_axis, left_handed,
      tool_draw, neutral, dope_sheet, curve_editor;
};
inline constexpr Action Action::tool_select{"tool_select"}, Action::tool_pose{"tool_pose"},
    Action::tool_oversketch{"tool_oversketch"}, Action::tool_constraint{"tool_constraint"},
    Action::tool_pin{"tool_pin"}, Action::tool_erase{"tool_erase"}, Action::tool_articulate{"tool_articulate"},
    Action::undo{"undo"}, Action::redo{"redo"}, Action::clear_curves{"clear_curves"},
    Action::delete_curve{"delete_curve"}, Action::keep_curve{"keep_curve"}, Action::reset_pose{"reset_pose"},
    Action::cancel{"cancel"}, Action::view_front{"view_front"}, Action::view_side{"view_side"},
    Action::view_three_quarter{"view_three_quarter"}, Action::frame_all{"frame_all"}, Action::zoom_in{"zoom_in"},
    Action::wireframe{"wireframe"}, Action::key_pose{"key_pose"}, Action::delete_key{"delete_key"},
    Action::previous_key{"previous_key"}, Action::next_key{"next_key"}, Action::play{"play"},
    Action::onion_skin{"onion_skin"}, Action::suggest_rest{"suggest_rest"}, Action::open{"open"},
    Action::recent{"recent"}, Action::save{"save"}, Action::save_as{"save_as"}, Action::export_as{"export_as"},
    Action::panels{"panels"}, Action::fullscreen{"fullscreen"}, Action::theme{"theme"}, Action::larger{"larger"},
    Action::smaller{"smaller"}, Action::help{"help"}, Action::quit{"quit"}, Action::shortcuts{"shortcuts"},
    Action::search{"search"}, Action::history{"history"}, Action::previous_frame{"previous_frame"},
    Action::next_frame{"next_frame"}, Action::copy_key{"copy_key"}, Action::paste_key{"paste_key"},
    Action::loop_from{"loop_from"}, Action::loop_to{"loop_to"}, Action::loop_off{"loop_off"},
    Action::auto_key{"auto_key"}, Action::mirror_strokes{"mirror_strokes"}, Action::flip_pose{"flip_pose"},
    Action::copy_to_right{"copy_to_right"}, Action::copy_to_left{"copy_to_left"}, Action::stabiliser{"stabiliser"},
    Action::moved_only{"moved_only"}, Action::density{"density"}, Action::film{"film"}, Action::perform{"perform"},
    Action::library{"library"}, Action::tour_pose{"tour_pose"}, Action::tour_rig{"tour_rig"},
    Action::tour_animate{"tour_animate"}, Action::flat_view{"flat_view"}, Action::set_front{"set_front"},
    Action::backdrop{"backdrop"}, Action::backdrop_off{"backdrop_off"}, Action::clay{"clay"},
    Action::frame_face{"frame_face"}, Action::up_axis{"up_axis"}, Action::left_handed{"left_handed"},
    Action::tool_draw{"tool_draw"}, Action::neutral{"neutral"}, Action::dope_sheet{"dope_sheet"},
    Action::curve_editor{"curve_editor"};
inline constexpr std::array k_named_actions{Action::tool_select,
                                            Action::tool_pose,
                                            Action::tool_oversketch,
                                            Action::tool_constraint,
                                            Action::tool_pin,
                                            Action::tool_erase,
                                            Action::tool_articulate,
                                            Action::undo,
                                            Action::redo,
                                            Action::clear_curves,
                                            Action::delete_curve,
                                            Action::keep_curve,
                                            Action::reset_pose,
                                            Action::cancel,
                                            Action::view_front,
                                            Action::view_side,
                                            Action::view_three_quarter,
                                            Action::frame_all,
                                            Action::zoom_in,
                                            Action::wireframe,
                                            Action::key_pose,
                                            Action::delete_key,
                                            Action::previous_key,
                                            Action::next_key,
                                            Action::play,
                                            Action::onion_skin,
                                            Action::suggest_rest,
                                            Action::open,
                                            Action::recent,
                                            Action::save,
                                            Action::save_as,
                                            Action::export_as,
                                            Action::panels,
                                            Action::fullscreen,
                                            Action::theme,
                                            Action::larger,
                                            Action::smaller,
                                            Action::help,
                                            Action::quit,
                                            Action::shortcuts,
                                            Action::search,
                                            Action::history,
                                            Action::previous_frame,
                                            Action::next_frame,
                                            Action::copy_key,
                                            Action::paste_key,
                                            Action::loop_from,
                                            Action::loop_to,
                                            Action::loop_off,
                                            Action::auto_key,
                                            Action::mirror_strokes,
                                            Action::flip_pose,
                                            Action::copy_to_right,
                                            Action::copy_to_left,
                                            Action::stabiliser,
                                            Action::moved_only,
                                            Action::density,
                                            Action::film,
                                            Action::perform,
                                            Action::library,
                                            Action::tour_pose,
                                            Action::tour_rig,
                                            Action::tour_animate,
                                            Action::flat_view,
                                            Action::set_front,
                                            Action::backdrop,
                                            Action::backdrop_off,
                                            Action::clay,
                                            Action::frame_face,
                                            Action::up_axis,
                                            Action::left_handed,
                                            Action::tool_draw,
                                            Action::neutral,
                                            Action::dope_sheet,
                                            Action::curve_editor};

struct ActionInfo {
  Action action;
  std::string_view label;
  KeyStroke key;    ///< unless another one was chosen (key_map.h)
  KeyStroke other;  ///< a second key for the same
  std::string_view tip;
  std::string_view icon;               ///< icon.h
  void (*run)(App& app);               ///< owners.h: `does(...)` makes it of a function of owners
  bool (*usable)(App& app) = nullptr;  ///< whether its buttons can be pressed; null: always
  const WindowTool* tool = nullptr;    ///< that it takes in hand, in place of `run`
};

[[nodiscard]] std::span<const ActionInfo> all_actions();
[[nodiscard]] const ActionInfo& info(Action action);

}  // namespace penpose::app
