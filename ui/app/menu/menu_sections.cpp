#include "ui/app/menu/menu_sections.h"

#include <algorithm>
#include <array>
#include <span>

#include "ui/app/camera/camera_actions.h"
#include "ui/app/playback/time_actions.h"

namespace penpose::app {
namespace {

constexpr std::string_view k_edit = "Edit", k_view = "View", k_animation = "Animation";

bool holds(const MenuSection& section, Action action) {
  return std::any_of(section.groups.begin(), section.groups.end(),
                     [&](const auto& group) { return std::find(group.begin(), group.end(), action) != group.end(); });
}

using A = Action;

// clang-format off
std::vector<MenuSection> placed() {
  return {
      {"File", "M6 3L14 3L19 8L19 21L6 21Z M14 3L14 8L19 8",
       {{A::open, A::recent, {"sessions"}}, {A::save, A::save_as, A::export_as}, {A::film, {"playblast"}},
        {A::up_axis, A::left_handed}, {A::quit}}},
      {k_edit, "M4 20L5 15L16 4L20 8L9 19Z M13 7L17 11",
       {{A::undo, A::redo, A::history, A::cancel},
        {A::tool_draw, A::tool_pose, A::tool_oversketch, A::tool_constraint, A::tool_pin, A::tool_erase,
         A::tool_select, {"tool_arc"}, {"tool_ghost"}, {"tool_feature"}},
        {A::delete_curve, A::keep_curve, A::clear_curves, A::suggest_rest, {"second_reading"}, {"third_reading"}},
        {A::mirror_strokes, A::stabiliser, {"hand"}, {"pressure"}}, {A::search, {"preferences"}}}},
      {k_view, "M3 12L8 7L12 6L16 7L21 12L16 17L12 18L8 17ZC12 12 2.5",
       {{A::view_front, A::view_three_quarter, A::view_side, A::flat_view, A::set_front},
        {A::frame_face, A::frame_all, A::zoom_in, {"zoom_out"}, {"orbit_left"}, {"orbit_right"}, {"orbit_up"},
         {"orbit_down"}},
        {{"cameras"}, {"look_through"}},
        {{"textured"}, A::clay, {"matcap"}, A::wireframe, {"soft_shadows"}, A::backdrop, A::backdrop_off},
        {A::panels, {"side_panel"}, A::fullscreen, A::theme, A::larger, A::smaller, A::density}}},
      {"Character", "C12 8 4M4 21L5 16L9 14L15 14L19 16L20 21",
       {{A::tool_articulate}, {A::reset_pose, A::flip_pose, A::copy_to_right, A::copy_to_left, A::neutral},
        {{"only_these"}, {"not_these"}, {"only_brows"}, {"only_eyes"}, {"only_mouth"}, {"all_controls"}},
        {{"new_to_rest"}, {"new_stays"}}, {A::library, {"mouths"}, A::moved_only, {"model_notes"}},
        {{"add_character"}, {"next_character"}, {"previous_character"}, {"characters"}, {"frame_characters"},
         {"other_characters"}, {"tool_place"}, {"stand_beside"}, {"remove_character"}, {"bring_back_character"}}}},
      {k_animation, "M3 5L21 5L21 19L3 19Z M10 8L16 12L10 16F",
       {{A::play, A::previous_frame, A::next_frame, A::previous_key, A::next_key, A::loop_from, A::loop_to, A::loop_off},
        {A::key_pose, A::delete_key, A::auto_key, A::copy_key, A::paste_key, {"paste_mirrored"}, {"mirror_keys"}},
        {A::perform, {"perform_again"}, {"review_take"}, {"keep_take"}},
        {{"key_camera"}, {"delete_camera_key"}, {"camera_cut"}},
        {{"bookmark"}, {"previous_bookmark"}, {"next_bookmark"}, {"play_speed"}},
        {{"breakdown"}, {"favour_before"}, {"favour_after"}, {"overshoot"}},
        {{"kind_smooth"}, {"kind_linear"}, {"kind_stepped"}, {"kind_ease_in"}, {"kind_ease_out"}, {"kind_ease"},
         {"kind_free"}, {"kind_overshoot"}},
        {A::dope_sheet, A::curve_editor, {"overlap"}, {"clips"}},
        {A::onion_skin, {"ghost_faces"}, {"ghost_frames"}, {"more_ghosts"}, {"fewer_ghosts"}, {"ghosts_in_films"}},
        {{"sound"}, {"first_pass"}}}},
      {"Tablet", "M3 6L21 6L21 18L3 18Z M8 14L16 9",
       {{{"tablet"}, {"tablet_keys"}, {"pen_menu"}, {"screen_keyboard"}}}},
      {"Help", "C12 12 9A12 10 3 180 400M13.5 13L12 14.5M12 17.5L12 18",
       {{A::help, A::shortcuts}, {A::tour_pose, A::tour_rig, A::tour_animate}}},
  };
}
// clang-format on

MenuSection& section_named(std::vector<MenuSection>& all, std::string_view name) {
  return *std::find_if(all.begin(), all.end(), [&](const MenuSection& one) { return one.name == name; });
}

std::vector<MenuSection> all_sections() {
  std::vector<MenuSection> all = placed();
  const auto of_time = time_actions();
  for (const ActionInfo& one : all_actions()) {
    const Action action = one.action;
    if (is_camera_key(action)) continue;
    if (std::any_of(all.begin(), all.end(), [&](const MenuSection& section) { return holds(section, action); }))
      continue;
    const bool is_of_time =
        std::any_of(of_time.begin(), of_time.end(), [&](const ActionInfo& other) { return other.action == action; });
    section_named(all, one.tool != nullptr ? k_edit
                       : is_of_time        ? k_animation
                                           : k_view)
        .groups.back()
        .push_back(action);
  }
  return all;
}

}  // namespace

const std::vector<MenuSection>& menu_sections() {
  static const std::vector<MenuSection> all = all_sections();
  return all;
}

}  // namespace penpose::app
