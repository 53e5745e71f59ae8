#include "ui/app/action.h"

#include <array>

#include "core/base/text/letters.h"

namespace penpose::app {
namespace {

constexpr KeyStroke plain(std::uint32_t key) { return {key, false, false}; }
constexpr KeyStroke ctrl(std::uint32_t key) { return {key, true, false}; }
constexpr KeyStroke ctrl_shift(std::uint32_t key) { return {key, true, true}; }
constexpr KeyStroke shift(std::uint32_t key) { return {key, false, true}; }

// Where Blender and Krita agree with each other their keys are used; where they do not, Blender's for views and keys,
// Krita's for drawing.
constexpr std::array k_actions{
    ActionInfo{Action::tool_select, "Select", "Drag targets, pick the control under the pen", plain('s')},
    ActionInfo{Action::tool_pose, "Pose", "Draw where a feature is, then where it should go", plain('b'), plain('p')},
    ActionInfo{Action::tool_oversketch, "Redraw", "Draw over a part of the last target", plain('o')},
    ActionInfo{Action::tool_constraint, "Hold", "Draw along what should stay where it is", plain('c')},
    ActionInfo{Action::tool_pin, "Pin", "Touch one point that should stay where it is", plain('n')},
    ActionInfo{Action::tool_erase, "Erase", "Draw over curves to delete them; so does the pen's other end", plain('e')},
    ActionInfo{Action::tool_articulate, "Rig", "Sketch a new control in three or four strokes", plain('a')},
    ActionInfo{Action::undo, "Undo", "Take back the last step", ctrl('z')},
    ActionInfo{Action::redo, "Redo", "Bring back what was undone", ctrl_shift('z'), ctrl('y')},
    ActionInfo{Action::clear_curves, "Clear", "Remove all curves; the pose stays", shift('x')},
    ActionInfo{Action::delete_curve, "Delete", "Delete the curve under the pen", plain(k_key_delete), plain('x')},
    ActionInfo{Action::keep_curve, "Keep", "Hold the curve under the pen where it is now", plain('h')},
    ActionInfo{Action::reset_pose, "Rest pose", "Put all parameters at rest", ctrl('r')},
    ActionInfo{Action::cancel, "Cancel", "Give up what is being drawn", plain(k_key_escape)},
    ActionInfo{Action::view_front, "Front", "Look from the front", plain('1')},
    ActionInfo{Action::view_side, "Side", "Look from the side", plain('3')},
    ActionInfo{Action::view_three_quarter, "3/4", "Look from between front and side", plain('2'), plain('7')},
    ActionInfo{Action::frame_all, "Frame", "Show all of the model", plain(k_key_home), plain('f')},
    ActionInfo{Action::orbit_left, "Turn left", "Turn the view", plain(k_key_left), plain('4')},
    ActionInfo{Action::orbit_right, "Turn right", "Turn the view", plain(k_key_right), plain('6')},
    ActionInfo{Action::orbit_up, "Turn up", "Turn the view", plain(k_key_up), plain('8')},
    ActionInfo{Action::orbit_down, "Turn down", "Turn the view", plain(k_key_down)},
    ActionInfo{Action::zoom_in, "Nearer", "Zoom in", plain('+'), plain('=')},
    ActionInfo{Action::zoom_out, "Farther", "Zoom out", plain('-')},
    ActionInfo{Action::wireframe, "Wire", "Show the edges of the mesh", shift('z')},
    ActionInfo{Action::key_pose, "Key", "Keep the pose at this moment", plain('i'), plain('k')},
    ActionInfo{Action::delete_key, "Delete key", "Remove the key at this moment", shift('i')},
    ActionInfo{Action::previous_key, "Key before", "Go to the key before", plain(',')},
    ActionInfo{Action::next_key, "Key after", "Go to the key after", plain('.')},
    ActionInfo{Action::play, "Play", "Play from key to key", plain(' ')},
    ActionInfo{Action::onion_skin, "Onion", "Show the curves at the keys before and after", shift('o')},
    ActionInfo{Action::suggest_rest, "Suggest", "Suggest the rest of the face from the poses that are keyed",
               plain('g')},
    ActionInfo{Action::open, "Open", "Open a model, a project or a session", ctrl('o')},
    ActionInfo{Action::recent, "Recent", "Open what was opened or saved before", ctrl_shift('o')},
    ActionInfo{Action::save, "Save", "Save the project", ctrl('s')},
    ActionInfo{Action::save_as, "Save as", "Save under another name", ctrl_shift('s')},
    ActionInfo{Action::export_as, "Export", "Write a copy for other programs", {}},
    ActionInfo{Action::panels, "Panels", "Hide or show the panels", plain(k_key_tab)},
    ActionInfo{Action::fullscreen, "Full screen", "Use the whole screen", plain(k_key_f11)},
    ActionInfo{Action::theme, "Light", "Dark or light colours", {}},
    ActionInfo{Action::larger, "Larger", "Make everything larger", ctrl('+'), ctrl('=')},
    ActionInfo{Action::smaller, "Smaller", "Make everything smaller", ctrl('-')},
    ActionInfo{Action::help, "Help", "The first steps again, and tours that show them", {}},
    ActionInfo{Action::quit, "Quit", "Close the program", ctrl('q')},
    ActionInfo{Action::shortcuts, "Shortcuts", "All keys and what they do", plain(k_key_f1), shift('/')},
    ActionInfo{Action::search, "Search", "Find an action, a control, a pose or a file by its name", ctrl('k')},
    ActionInfo{Action::history, "History", "What was done, by name, to go back to", ctrl('h')},
    ActionInfo{Action::previous_frame, "Frame back", "Go one frame back", shift(','), ctrl(k_key_left)},
    ActionInfo{Action::next_frame, "Frame on", "Go one frame on", shift('.'), ctrl(k_key_right)},
    ActionInfo{Action::copy_key, "Copy", "Copy the pose of this moment, to be put at another one", ctrl('c')},
    ActionInfo{Action::paste_key, "Paste", "Key the pose that was copied at this moment", ctrl('v')},
    ActionInfo{Action::loop_from, "Loop from", "What is played begins here", plain('[')},
    ActionInfo{Action::loop_to, "Loop to", "What is played ends here", plain(']')},
    ActionInfo{Action::loop_off, "Loop all", "All is played, from the first frame to the last key", plain('\\')},
    ActionInfo{Action::auto_key, "Auto-key", "Every change of the pose is keyed at this moment", shift('k')},
    ActionInfo{Action::mirror_strokes, "X-mirror", "What is drawn on one side is done on both", plain('m')},
    ActionInfo{Action::flip_pose, "Flip", "Exchange left and right of the pose", shift('m')},
    ActionInfo{Action::copy_to_right, "Left to right", "The left side of the pose on the right, too", ctrl('m')},
    ActionInfo{Action::copy_to_left, "Right to left", "The right side of the pose on the left, too", ctrl_shift('m')},
    ActionInfo{
        Action::stabiliser, "Steady line", "How much drawn lines are smoothed to the eye: off, light or strong", {}},
    ActionInfo{Action::moved_only, "Moved only", "List only the controls that are not at rest", {}},
    ActionInfo{Action::density, "Density", "Compact, usual or for touch", {}},
    ActionInfo{Action::film, "Film", "Write a film (.mp4) or its pictures (.png) of what is played", {}},
    ActionInfo{Action::perform, "Perform", "Time runs while the pen holds a target, and what the face does is keyed",
               shift(' ')},
    ActionInfo{Action::library, "Poses", "The poses that are keyed, to be used again", plain('l')},
    ActionInfo{
        Action::tour_pose, "Tour: pose a face", "Six strokes on the built-in head, each shown before it is drawn", {}},
    ActionInfo{Action::tour_rig, "Tour: make a control", "A control for a brow, sketched line by line", {}},
    ActionInfo{Action::tour_animate, "Tour: animate", "Two keys and a smile between them", {}},
    ActionInfo{Action::flat_view, "Flat", "Look without perspective, as a drawing does; again: with it", plain('5')},
    ActionInfo{
        Action::set_front, "Front is here", "From here on this side is the model's front; the project keeps it", {}},
    ActionInfo{
        Action::backdrop, "Picture behind", "A picture, or the frames of a film, behind the model to draw after", {}},
    ActionInfo{Action::backdrop_off, "No picture", "Take the picture behind the model away", {}},
};

std::string key_name(std::uint32_t key) {
  switch (key) {
    case k_key_escape:
      return "Esc";
    case k_key_tab:
      return "Tab";
    case k_key_delete:
      return "Del";
    case k_key_home:
      return "Home";
    case k_key_left:
      return "Left";
    case k_key_right:
      return "Right";
    case k_key_up:
      return "Up";
    case k_key_down:
      return "Down";
    case k_key_f1:
      return "F1";
    case k_key_f11:
      return "F11";
    case ' ':
      return "Space";
    default:
      return {base::upper(static_cast<char>(key))};
  }
}

}  // namespace

std::span<const ActionInfo> all_actions() { return k_actions; }

const ActionInfo& info(Action action) {
  for (const ActionInfo& one : k_actions) {
    if (one.action == action) return one;
  }
  return k_actions.front();
}

const ActionInfo* action_of(const KeyStroke& key) {
  for (const ActionInfo& one : k_actions) {
    if (one.key.key != 0 && (one.key == key || (one.other.key != 0 && one.other == key))) return &one;
  }
  return nullptr;
}

std::string shortcut_text(const KeyStroke& key) {
  if (key.key == 0) return {};
  return std::string(key.ctrl ? "Ctrl+" : "") + (key.shift ? "Shift+" : "") + key_name(key.key);
}

std::string tooltip_of(Action action) {
  const ActionInfo& one = info(action);
  const std::string key = shortcut_text(one.key);
  return std::string(one.tip) + (key.empty() ? "" : " (" + key + ")");
}

}  // namespace penpose::app
