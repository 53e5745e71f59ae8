#include <algorithm>
#include <array>

#include "ui/app/action.h"
#include "ui/app/app.h"
#include "ui/app/input/side_pairs.h"
#include "ui/app/session/frames.h"
#include "ui/app/view/backdrop.h"
#include "ui/app/view/user_messages.h"

// Every action in a row: its words, its keys, its icon (widgets/internal/icon.cpp tells the language), what it does and
// when it can be used. A new one is a row here.

namespace penpose::app {
namespace {

constexpr double k_turn_degrees = 15;
constexpr double k_zoom = 0.85;

void flip(bool& on) { on = !on; }

void find(App& app, Dialog dialog) {
  app.dialogs().state<SearchEntry>() = {};
  app.dialogs().show(dialog);
}

void name_file(App& app, Dialog dialog) {
  app.dialogs().state<FileChoice>().name.clear();
  app.dialogs().show(dialog);
}

void save(App& app) {
  if (app.project().empty()) return name_file(app, Dialog::save);
  if (const auto saved = app.save(app.project()); !saved) app.notices().tell(saved.error().line(app.project()), true);
}

void look(App& app, const char* viewpoint) { app.canvas().look_from(*render::find_viewpoint(viewpoint)); }

void turn(App& app, double yaw, double pitch) {
  if (!app.editing().pen_is_drawing()) app.canvas().turn(yaw, pitch);
}

void zoom(App& app, double factor) {
  if (!app.editing().pen_is_drawing()) app.canvas().zoom(factor, app.canvas().free_area().middle());
}

void resize(App& app, double by) {
  double& scale = app.preferences().settings().scale;
  scale = std::clamp(scale + by, 0.5, 3.0);
  app.preferences().changed();
}

void take_tool(App& app, drawing::ToolKind kind) {
  drawing::Tool tool;
  tool.kind = kind;
  app.playback().stop();
  app.editing().preview(std::nullopt);
  app.editing().set_tool(tool);
  app.panels().curve_menu.reset();
  const bool sketches = kind == drawing::ToolKind::articulate;
  if (sketches && !app.editing().document().pending) app.controls().begin();
  bool& tab = app.panels().controls_tab;
  tab = sketches || (kind == drawing::ToolKind::none && tab);
}

void suggest_rest(App& app) {
  if (app.offer().open()) return app.offer().dismiss(app.editing());
  if (app.editing().pen_is_drawing()) return;
  app.playback().stop();
  if (app.controls().swings()) app.controls().set_swing(false);
  if (const auto asked = app.offer().ask(app.editing()); !asked) app.notices().tell(message_of(asked.error()), true);
}

void close_dialog(App& app) {
  Settings& settings = app.preferences().settings();
  const Dialog dialog = app.dialogs().open();
  if (dialog == Dialog::steps) {
    settings.steps_seen = true;
    app.preferences().changed();
  }
  // Work that was not saved is offered again at the next start.
  app.dialogs().show(dialog == Dialog::recover && !settings.steps_seen ? Dialog::steps : Dialog::none);
  app.dialogs().state<FileChoice>().name.clear();
  app.dialogs().state<UnsavedWork>().saves_first = false;
}

void cancel(App& app) {
  if (app.panels().radial) {
    app.panels().radial.reset();
  } else if (app.dialogs().any()) {
    close_dialog(app);
  } else if (app.offer().open()) {
    app.offer().dismiss(app.editing());
  } else if (app.playback().playing()) {
    app.playback().play_or_stop();
  } else if (app.editing().document().pending) {
    app.editing().perform(document::CancelDeformer{});
  }
}

/// Sets the pose that is made of the one there is.
template <typename Make>
void change_pose(App& app, const char* unchanged, const Make& make) {
  EditingSession& editing = app.editing();
  const document::Document& document = editing.document();
  const auto parameters = document.model->rig->parameters();
  const auto command =
      values_between(parameters, document.pose, make(parameters, document::weight_count(*document.model)));
  if (command.values.empty()) return app.notices().tell(unchanged);
  editing.perform(command);
}

void copy_side(App& app, bool from_left) {
  change_pose(app, "both sides are the same already", [&](auto parameters, std::size_t count) {
    return copied_over(parameters, app.editing().two_sided_pairs(), app.editing().document().pose, count, from_left);
  });
}

void step(App& app, int frames) {
  app.playback().go_to(step_frame(app.playback().time_s(), frames, app.playback().rate()));
}

template <typename Enum>
Enum next_of(Enum value, int count) {
  return static_cast<Enum>((static_cast<int>(value) + 1) % count);
}

void do_clear_curves(App& app) {
  if (!app.editing().document().curves.empty()) app.editing().perform(document::ClearCurves{});
}

void do_flip_pose(App& app) {
  change_pose(app, "both sides are the same: nothing to exchange", [&](auto parameters, std::size_t count) {
    return flipped(parameters, side_pairs(parameters), app.editing().document().pose, count);
  });
}

void do_stabiliser(App& app) {
  constexpr std::array k_said{"lines are shown as they are drawn", "lines are smoothed a little to the eye",
                              "lines are smoothed much to the eye"};
  app.preferences().settings().stabiliser = next_of(app.preferences().settings().stabiliser, 3);
  app.preferences().changed();
  app.notices().tell(k_said[static_cast<std::size_t>(app.preferences().settings().stabiliser)]);
}

void do_density(App& app) {
  app.preferences().settings().density = next_of(app.preferences().settings().density, 3);
  app.preferences().changed();
}

void do_library(App& app) {
  app.panels().shown = true;
  app.panels().poses_tab = !app.panels().poses_tab;
  app.panels().controls_tab = false;
}

void do_backdrop(App& app) {
  const auto& backdrop = app.canvas().look().backdrop;
  if (!backdrop) return find(app, Dialog::backdrop);
  backdrop->adjusting = !backdrop->adjusting;
}

constexpr KeyStroke plain(std::uint32_t key) { return {key, false, false}; }
constexpr KeyStroke ctrl(std::uint32_t key) { return {key, true, false}; }
constexpr KeyStroke ctrl_shift(std::uint32_t key) { return {key, true, true}; }
constexpr KeyStroke shift(std::uint32_t key) { return {key, false, true}; }

// Where Blender and Krita agree with each other their keys are used; where they do not, Blender's for views and keys,
// Krita's for drawing.
// clang-format off
constexpr std::array k_actions{
    ActionInfo{{"tool_select"}, "Select", plain('s'), {}, "Drag targets, pick the control under the pen",
     "M6 3L6 18L10 14.5L13 21L15.5 20L12.5 13.5L18 13Z", [](App& app) { take_tool(app, drawing::ToolKind::none); }},
    ActionInfo{{"tool_pose"}, "Pose", plain('b'), plain('p'), "Draw where a feature is, then where it should go",
     "M3 16L8 11L12 15L21 7M16 6L21 7L20 12", [](App& app) { take_tool(app, drawing::ToolKind::pose); }},
    ActionInfo{{"tool_oversketch"}, "Redraw", plain('o'), {}, "Draw over a part of the last target",
     "M3 18L9 13L13 16M14 13L20 4L22 6L16 14L13 15Z", [](App& app) { take_tool(app, drawing::ToolKind::oversketch); }},
    ActionInfo{{"tool_constraint"}, "Hold", plain('c'), {}, "Draw along what should stay where it is",
     "M6 11L18 11L18 20L6 20Z A12 11 4 180 360", [](App& app) { take_tool(app, drawing::ToolKind::constraint); }},
    ActionInfo{{"tool_pin"}, "Pin", plain('n'), {}, "Touch one point that should stay where it is",
     "C12 8 4M12 12L12 21", [](App& app) { take_tool(app, drawing::ToolKind::pin); }},
    ActionInfo{{"tool_erase"}, "Erase", plain('e'), {}, "Draw over curves to delete them; so does the pen's other end",
     "M4 15L13 5L20 11L12 20L8 20Z M9 10L16 16M12 20L20 20",
     [](App& app) { take_tool(app, drawing::ToolKind::erase); }},
    ActionInfo{{"tool_articulate"}, "Rig", plain('a'), {}, "Sketch a new control in three or four strokes",
     "C6 18 2.5C18 6 2.5M8 16L16 8M4 6L10 6M7 3L7 9", [](App& app) { take_tool(app, drawing::ToolKind::articulate); }},
    ActionInfo{{"undo"}, "Undo", ctrl('z'), {}, "Take back the last step",
     "M9 5L4 10L9 15M4 10L14 10A14 14.5 4.5 -90 90M14 19L10 19",
     [](App& app) { app.playback().undo(); }, [](App& app) { return app.editing().can_undo() > 0; }},
    ActionInfo{{"redo"}, "Redo", ctrl_shift('z'), ctrl('y'), "Bring back what was undone",
     "M15 5L20 10L15 15M20 10L10 10A10 14.5 4.5 270 90M10 19L14 19",
     [](App& app) { app.playback().redo(); }, [](App& app) { return app.editing().can_redo() > 0; }},
    ActionInfo{{"clear_curves"}, "Clear", shift('x'), {}, "Remove all curves; the pose stays",
     "M5 7L19 7M9 7L9 4L15 4L15 7M7 7L8 20L16 20L17 7", do_clear_curves},
    ActionInfo{{"delete_curve"}, "Delete", plain(k_key_delete), plain('x'), "Delete the curve under the pen",
     "M4 16L9 11L13 14L16 11M16 16L21 21M21 16L16 21", [](App& app) { app.delete_highlighted(); }},
    ActionInfo{{"keep_curve"}, "Keep", plain('h'), {}, "Hold the curve under the pen where it is now",
     "M4 13L9 18L20 6", [](App& app) { app.keep_highlighted(); }},
    ActionInfo{{"reset_pose"}, "Rest pose", ctrl('r'), {}, "Put all parameters at rest",
     "C12 12 8M8 10L8 10.5M16 10L16 10.5M8 15.5L16 15.5",
     [](App& app) { app.editing().perform(document::ResetParameters{}); }},
    ActionInfo{{"cancel"}, "Cancel", plain(k_key_escape), {}, "Give up what is being drawn",
     "M6 6L18 18M18 6L6 18", cancel},
    ActionInfo{{"view_front"}, "Front", plain('1'), {}, "Look from the front",
     "C12 11 7M12 8L12 12M9 15L15 15", [](App& app) { look(app, "front"); }},
    ActionInfo{{"view_side"}, "Side", plain('3'), {}, "Look from the side",
     "M8 4L14 4L17 9L19 13L16.5 13.5L16 18L12 19L12 21M8 4L6 9L8 15L8 21", [](App& app) { look(app, "side"); }},
    ActionInfo{{"view_three_quarter"}, "3/4", plain('2'), plain('7'), "Look from between front and side",
     "C12 11 7M14 8L15 12M11 15L16 14", [](App& app) { look(app, "three-quarter"); }},
    ActionInfo{{"frame_all"}, "Frame", plain(k_key_home), plain('f'), "Show all of the model",
     "M4 9L4 4L9 4M15 4L20 4L20 9M20 15L20 20L15 20M9 20L4 20L4 15", [](App& app) { app.canvas().frame_all(); }},
    ActionInfo{{"orbit_left"}, "Turn left", plain(k_key_left), plain('4'), "Turn the view",
     "A12 12 8 100 330M4 12L4 18L10 18", [](App& app) { turn(app, -k_turn_degrees, 0); }},
    ActionInfo{{"orbit_right"}, "Turn right", plain(k_key_right), plain('6'), "Turn the view",
     "A12 12 8 -150 80M20 12L20 18L14 18", [](App& app) { turn(app, k_turn_degrees, 0); }},
    ActionInfo{{"orbit_up"}, "Turn up", plain(k_key_up), plain('8'), "Turn the view",
     "M12 20L12 5M6 11L12 5L18 11", [](App& app) { turn(app, 0, k_turn_degrees); }},
    ActionInfo{{"orbit_down"}, "Turn down", plain(k_key_down), {}, "Turn the view",
     "M12 4L12 19M6 13L12 19L18 13", [](App& app) { turn(app, 0, -k_turn_degrees); }},
    ActionInfo{{"zoom_in"}, "Nearer", plain('+'), plain('='), "Zoom in",
     "C10 10 6M15 15L21 21M10 7L10 13M7 10L13 10", [](App& app) { zoom(app, k_zoom); }},
    ActionInfo{{"zoom_out"}, "Farther", plain('-'), {}, "Zoom out",
     "C10 10 6M15 15L21 21M7 10L13 10", [](App& app) { zoom(app, 1 / k_zoom); }},
    ActionInfo{{"wireframe"}, "Wire", shift('z'), {}, "Show the edges of the mesh",
     "M4 18L12 4L20 18Z M8 11L16 11L12 18Z", [](App& app) { flip(app.canvas().look().wireframe); }},
    ActionInfo{{"key_pose"}, "Key", plain('i'), plain('k'), "Keep the pose at this moment",
     "M12 4L20 12L12 20L4 12F", [](App& app) { app.keys().set(); }},
    ActionInfo{{"delete_key"}, "Delete key", shift('i'), {}, "Remove the key at this moment",
     "M10 4L18 12L10 20L2 12Z M17 4L22 9M22 4L17 9",
     [](App& app) { app.keys().remove(); }, [](App& app) { return app.keys().at_cursor(); }},
    ActionInfo{{"previous_key"}, "Key before", plain(','), {}, "Go to the key before",
     "M5 5L5 19M18 5L9 12L18 19Z", [](App& app) { app.playback().step_key(-1); }},
    ActionInfo{{"next_key"}, "Key after", plain('.'), {}, "Go to the key after",
     "M19 5L19 19M6 5L15 12L6 19Z", [](App& app) { app.playback().step_key(1); }},
    ActionInfo{{"play"}, "Play", plain(' '), {}, "Play from key to key",
     "M7 4L20 12L7 20F", [](App& app) { app.playback().play_or_stop(); }},
    ActionInfo{{"onion_skin"}, "Onion", shift('o'), {}, "Show the curves at the keys before and after",
     "C9 12 6C15 12 6", [](App& app) { flip(app.canvas().look().onion_skin); }},
    ActionInfo{{"suggest_rest"}, "Suggest", plain('g'), {},
     "Suggest the rest of the face from the poses that are keyed",
     "M12 3L14 10L21 12L14 14L12 21L10 14L3 12L10 10Z", suggest_rest},
    ActionInfo{{"open"}, "Open", ctrl('o'), {}, "Open a model, a project or a session",
     "M3 19L3 5L9 5L11 8L20 8L20 11M3 19L7 11L22 11L19 19Z", [](App& app) { app.dialogs().show(Dialog::open); }},
    ActionInfo{{"recent"}, "Recent", ctrl_shift('o'), {}, "Open what was opened or saved before",
     "C12 12 8M12 7L12 12L16 14", [](App& app) { app.dialogs().show(Dialog::recent); }},
    ActionInfo{{"save"}, "Save", ctrl('s'), {}, "Save the project",
     "M4 4L17 4L20 7L20 20L4 20Z M8 4L8 9L15 9L15 4M7 20L7 14L17 14L17 20", save},
    ActionInfo{{"save_as"}, "Save as", ctrl_shift('s'), {}, "Save under another name",
     "M4 4L17 4L20 7L20 12M4 4L4 20L11 20M8 4L8 9L15 9L15 4M14 20L19 15L21 17L16 22L14 22Z",
     [](App& app) { name_file(app, Dialog::save); }},
    ActionInfo{{"export_as"}, "Export", {}, {}, "Write a copy for other programs",
     "M12 15L12 4M7 9L12 4L17 9M4 14L4 20L20 20L20 14", [](App& app) { name_file(app, Dialog::export_as); }},
    ActionInfo{{"panels"}, "Panels", plain(k_key_tab), {}, "Hide or show the panels",
     "M3 5L21 5L21 19L3 19Z M15 5L15 19", [](App& app) { flip(app.panels().shown); }},
    ActionInfo{{"fullscreen"}, "Full screen", plain(k_key_f11), {}, "Use the whole screen",
     "M4 9L4 4L9 4M15 4L20 4L20 9M20 15L20 20L15 20M9 20L4 20L4 15M4 4L9 9M20 20L15 15",
     [](App& app) { flip(app.canvas().look().fullscreen); }},
    ActionInfo{{"theme"}, "Light", {}, {}, "Dark or light colours",
     "C12 12 4M12 3L12 5M12 19L12 21M3 12L5 12M19 12L21 12M6 6L7 7M17 17L18 18M18 6L17 7M6 18L7 17",
     [](App& app) { flip(app.preferences().settings().light); app.preferences().changed(); }},
    ActionInfo{{"larger"}, "Larger", ctrl('+'), ctrl('='), "Make everything larger",
     "M3 19L9 5L15 19M5 14L13 14M17 8L23 8M20 5L20 11", [](App& app) { resize(app, 0.25); }},
    ActionInfo{{"smaller"}, "Smaller", ctrl('-'), {}, "Make everything smaller",
     "M3 19L9 5L15 19M5 14L13 14M17 8L23 8", [](App& app) { resize(app, -0.25); }},
    ActionInfo{{"help"}, "Help", {}, {}, "The first steps again, and tours that show them",
     "C12 12 9A12 10 3 180 400M13.5 13L12 14.5M12 17.5L12 18", [](App& app) { app.dialogs().show(Dialog::steps); }},
    ActionInfo{{"quit"}, "Quit", ctrl('q'), {}, "Close the program",
     "M14 4L4 4L4 20L14 20M9 12L21 12M16 7L21 12L16 17", [](App& app) { app.ask_to_quit(); }},
    ActionInfo{{"shortcuts"}, "Shortcuts", plain(k_key_f1), shift('/'), "All keys and what they do",
     "M3 6L21 6L21 18L3 18Z M7 10L7 10.5M11 10L11 10.5M15 10L15 10.5M8 14.5L16 14.5",
     [](App& app) { find(app, Dialog::shortcuts); }},
    ActionInfo{{"search"}, "Search", ctrl('k'), {}, "Find an action, a control, a pose or a file by its name",
     "C10 10 6M15 15L21 21", [](App& app) { find(app, Dialog::search); }},
    ActionInfo{{"history"}, "History", ctrl('h'), {}, "What was done, by name, to go back to",
     "A12 12 8 -160 130M4 4L4 9L9 9M12 8L12 12L15 14", [](App& app) { find(app, Dialog::history); }},
    ActionInfo{{"previous_frame"}, "Frame back", shift(','), ctrl(k_key_left), "Go one frame back",
     "M15 5L7 12L15 19Z", [](App& app) { step(app, -1); }},
    ActionInfo{{"next_frame"}, "Frame on", shift('.'), ctrl(k_key_right), "Go one frame on",
     "M9 5L17 12L9 19Z", [](App& app) { step(app, 1); }},
    ActionInfo{{"copy_key"}, "Copy", ctrl('c'), {}, "Copy the pose of this moment, to be put at another one",
     "M8 8L20 8L20 20L8 20Z M16 8L16 4L4 4L4 16L8 16", [](App& app) { app.keys().copy(); }},
    ActionInfo{{"paste_key"}, "Paste", ctrl('v'), {}, "Key the pose that was copied at this moment",
     "M7 5L4 5L4 21L16 21L16 18M8 3L20 3L20 17L8 17Z M11 10L17 10M14 7L14 13",
     [](App& app) { app.keys().paste(); }, [](App& app) { return app.keys().copied(); }},
    ActionInfo{{"loop_from"}, "Loop from", plain('['), {}, "What is played begins here",
     "M8 4L4 4L4 20L8 20M20 12L10 12M14 8L10 12L14 16",
     [](App& app) { app.playback().loop().begin_at(app.playback().time_s()); }},
    ActionInfo{{"loop_to"}, "Loop to", plain(']'), {}, "What is played ends here",
     "M16 4L20 4L20 20L16 20M4 12L14 12M10 8L14 12L10 16",
     [](App& app) { app.playback().loop().end_at(app.playback().time_s()); }},
    ActionInfo{{"loop_off"}, "Loop all", plain('\\'), {}, "All is played, from the first frame to the last key",
     "A12 12 7 -150 150M6 4L6 9L11 9M16 16L22 22M22 16L16 22", [](App& app) { app.playback().loop() = {}; }},
    ActionInfo{{"auto_key"}, "Auto-key", shift('k'), {}, "Every change of the pose is keyed at this moment",
     "M9 5L16 12L9 19L2 12F D20 5 3", [](App& app) { flip(app.playback().while_drawing().auto_key); }},
    ActionInfo{{"mirror_strokes"}, "X-mirror", plain('m'), {}, "What is drawn on one side is done on both",
     "M12 3L12 21M9 7L3 17L9 17Z M15 7L21 17L15 17Z", [](App& app) { flip(app.playback().while_drawing().mirrors); }},
    ActionInfo{{"flip_pose"}, "Flip", shift('m'), {}, "Exchange left and right of the pose",
     "M12 3L12 21M4 9L9 9M6 6L3.5 9L6 12M20 15L15 15M18 12L20.5 15L18 18", do_flip_pose},
    ActionInfo{{"copy_to_right"}, "Left to right", ctrl('m'), {}, "The left side of the pose on the right, too",
     "M12 3L12 21M3 12L9 12M15 7L21 12L15 17F", [](App& app) { copy_side(app, true); }},
    ActionInfo{{"copy_to_left"}, "Right to left", ctrl_shift('m'), {}, "The right side of the pose on the left, too",
     "M12 3L12 21M15 12L21 12M9 7L3 12L9 17F", [](App& app) { copy_side(app, false); }},
    ActionInfo{{"stabiliser"}, "Steady line", {}, {},
     "How much drawn lines are smoothed to the eye: off, light or strong",
     "M3 16A7.5 16 4.5 180 360M12 16A16.5 16 4.5 180 0", do_stabiliser},
    ActionInfo{{"moved_only"}, "Moved only", {}, {}, "List only the controls that are not at rest",
     "M4 7L20 7M4 12L14 12M4 17L9 17", [](App& app) { flip(app.panels().own.of<ParameterList>().moved_only); }},
    ActionInfo{{"density"}, "Density", {}, {}, "Compact, usual or for touch",
     "M4 5L20 5M4 9.5L20 9.5M4 14L20 14M4 18.5L20 18.5", do_density},
    ActionInfo{{"film"}, "Film", {}, {}, "Write a film (.mp4) or its pictures (.png) of what is played",
     "M3 5L21 5L21 19L3 19Z M7 5L7 19M17 5L17 19M3 12L7 12M17 12L21 12",
     [](App& app) { app.dialogs().state<FileChoice>().name.clear(); find(app, Dialog::film); }},
    ActionInfo{{"perform"}, "Perform", shift(' '), {},
     "Time runs while the pen holds a target, and what the face does is keyed",
     "C12 12 9D12 12 5", [](App& app) { flip(app.playback().while_drawing().performs); }},
    ActionInfo{{"library"}, "Poses", plain('l'), {}, "The poses that are keyed, to be used again",
     "M4 4L11 4L11 11L4 11Z M13 4L20 4L20 11L13 11Z M4 13L11 13L11 20L4 20Z M13 13L20 13L20 20L13 20Z", do_library},
    ActionInfo{{"tour_pose"}, "Tour: pose a face", {}, {},
     "Six strokes on the built-in head, each shown before it is drawn",
     "M7 4L20 12L7 20Z", [](App& app) { app.ask_to_open("tour:pose"); }},
    ActionInfo{{"tour_rig"}, "Tour: make a control", {}, {}, "A control for a brow, sketched line by line",
     "M7 4L20 12L7 20Z", [](App& app) { app.ask_to_open("tour:rig"); }},
    ActionInfo{{"tour_animate"}, "Tour: animate", {}, {}, "Two keys and a smile between them",
     "M7 4L20 12L7 20Z", [](App& app) { app.ask_to_open("tour:animate"); }},
    ActionInfo{{"flat_view"}, "Flat", plain('5'), {}, "Look without perspective, as a drawing does; again: with it",
     "M5 8L14 8L14 17L5 17Z M5 8L9 4L18 4L14 8M18 4L18 13L14 17",
     [](App& app) { app.canvas().set_flat(!app.canvas().flat()); }},
    ActionInfo{{"set_front"}, "Front is here", {}, {},
     "From here on this side is the model's front; the project keeps it",
     "C12 9 5M4 20A12 20 8 180 360", [](App& app) { app.canvas().set_front(); }},
    ActionInfo{{"backdrop"}, "Picture behind", {}, {},
     "A picture, or the frames of a film, behind the model to draw after",
     "M3 5L21 5L21 19L3 19Z M4 17L9 11L13 15L16 12L20 16", do_backdrop},
    ActionInfo{{"backdrop_off"}, "No picture", {}, {}, "Take the picture behind the model away",
     "M3 5L21 5L21 19L3 19Z M8 8L16 16M16 8L8 16", [](App& app) { app.canvas().look().backdrop.reset(); }},
};
// clang-format on

}  // namespace

std::span<const ActionInfo> all_actions() { return k_actions; }

}  // namespace penpose::app
