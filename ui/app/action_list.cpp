// This file is above the usual size because it is one table: every action of the window, a row each.

#include <algorithm>
#include <array>
#include <vector>

#include "ui/app/action.h"
#include "ui/app/camera/camera_actions.h"
#include "ui/app/cast/cast_actions.h"
#include "ui/app/controls/control_actions.h"
#include "ui/app/face/neutral_face.h"
#include "ui/app/hand_actions.h"
#include "ui/app/input/side_pairs.h"
#include "ui/app/owners.h"
#include "ui/app/playback/keys.h"
#include "ui/app/playback/time_actions.h"
#include "ui/app/tools/tool.h"
#include "ui/app/view/backdrop.h"
#include "ui/app/view/user_messages.h"
#include "ui/files/load_model.h"

// Every action in a row: its words, its keys, its icon (widgets/internal/icon.cpp tells the language), what it does and
// when it can be used. A new one is a row here. Those that take a tool in hand come from the tools' own files.

namespace penpose::app {
namespace {

constexpr double k_turn_degrees = 15;
constexpr double k_zoom = 0.85;

void flip(bool& on) { on = !on; }

/// Opens a dialog in which one searches, with nothing searched for.
void find(Dialogs& dialogs, Dialog dialog) {
  dialogs.state<SearchEntry>() = {};
  dialogs.show(dialog);
}

/// Opens a dialog in which a file is named, with no name.
void name_file(Dialogs& dialogs, Dialog dialog) {
  dialogs.state<FileChoice>().name.clear();
  dialogs.show(dialog);
}

void save(Files& files, Dialogs& dialogs, Notices& notices) {
  const std::string project = files.project();
  if (project.empty()) return name_file(dialogs, Dialog::save);
  if (const auto saved = files.save(project); !saved) notices.tell(saved.error().line(project), true);
}

void look(Canvas& canvas, const char* viewpoint) { canvas.look_from(*render::find_viewpoint(viewpoint)); }

void turn(const EditingSession& editing, Canvas& canvas, double yaw, double pitch) {
  if (!editing.pen_is_drawing()) canvas.turn(yaw, pitch);
}

void zoom(const EditingSession& editing, Canvas& canvas, double factor) {
  if (!editing.pen_is_drawing()) canvas.zoom(factor, canvas.free_area().middle());
}

void resize(Preferences& preferences, double by) {
  double& scale = preferences.settings().scale;
  scale = std::clamp(scale + by, 0.5, 3.0);
  preferences.changed();
}

void suggest_rest(EditingSession& editing, SuggestionOffer& offer, Playback& playback, Controls& controls,
                  Notices& notices) {
  if (offer.open()) return offer.dismiss(editing);
  if (editing.pen_is_drawing()) return;
  playback.stop();
  if (controls.swings()) controls.set_swing(false);
  if (const auto asked = offer.ask(editing); !asked) notices.tell(message_of(asked.error()), true);
}

void close_dialog(Dialogs& dialogs, Preferences& preferences) {
  Settings& settings = preferences.settings();
  const Dialog dialog = dialogs.open();
  if (dialog == Dialog::steps) {
    settings.steps_seen = true;
    preferences.changed();
  }
  // Work that was not saved is offered again at the next start.
  dialogs.show(dialog == Dialog::recover && !settings.steps_seen ? Dialog::steps : Dialog::none);
  dialogs.state<FileChoice>().name.clear();
  dialogs.state<UnsavedWork>().saves_first = false;
}

void cancel(EditingSession& editing, PanelState& panels, Dialogs& dialogs, Preferences& preferences,
            SuggestionOffer& offer, Playback& playback, Controls& controls, OverlapOffer& overlap, ToolInHand& tool,
            KeptFeatures& features, Keys& keys) {
  if (panels.radial) {
    panels.radial.reset();
  } else if (panels.feature_menu) {
    panels.feature_menu.reset();
  } else if (panels.curve_menu) {
    panels.curve_menu.reset();
  } else if (dialogs.any()) {
    close_dialog(dialogs, preferences);
  } else if (offer.open()) {
    offer.dismiss(editing);
  } else if (overlap.open()) {
    overlap.dismiss();
  } else if (playback.playing()) {
    playback.play_or_stop();
  } else if (controls.lent().lent()) {
    if (!editing.pen_is_drawing()) controls.lent().give_back();
  } else if (editing.document().pending) {
    editing.perform(document::CancelDeformer{});
  } else if (controls.trial() != nullptr) {
    controls.end_trial();
  } else if (playback.while_drawing().performs && !features.shown()) {
    tool.perform_or_end();
  } else if (!keys.selected().empty()) {
    keys.selected().clear();
  } else {
    features.hide();
  }
}

/// Sets the pose that is made of the one there is.
template <typename Make>
void change_pose(EditingSession& editing, Notices& notices, const char* unchanged, const Make& make) {
  const document::Document& document = editing.document();
  const auto parameters = document.model->rig->parameters();
  const auto command =
      values_between(parameters, document.pose, make(parameters, document::weight_count(*document.model)));
  if (command.values.empty()) return notices.tell(unchanged);
  editing.perform(command);
}

void copy_side(EditingSession& editing, Notices& notices, bool from_left) {
  change_pose(editing, notices, "both sides are already the same", [&](auto parameters, std::size_t count) {
    return copied_over(parameters, editing.two_sided_pairs(), editing.document().pose, count, from_left);
  });
}

void flip_pose(EditingSession& editing, Notices& notices) {
  change_pose(editing, notices, "both sides are the same: there is nothing to flip",
              [&](auto parameters, std::size_t count) {
                return flipped(parameters, side_pairs(parameters), editing.document().pose, count);
              });
}

template <typename Enum>
Enum next_of(Enum value, int count) {
  return static_cast<Enum>((static_cast<int>(value) + 1) % count);
}

void delete_what_is_meant(CurvesInHand& curves, Keys& keys) {
  if (keys.selected().empty()) return curves.delete_lit();
  keys.remove();
}

void clear_curves(EditingSession& editing) {
  if (!editing.document().curves.empty() || editing.document().face) editing.perform(document::ClearCurves{});
}

void next_stabiliser(Preferences& preferences, Notices& notices) {
  constexpr std::array k_messages{"lines are shown as they are drawn",
                                  "lines look a little smoother; the recording keeps them as drawn",
                                  "lines look much smoother; the recording keeps them as drawn"};
  Stabiliser& stabiliser = preferences.settings().stabiliser;
  stabiliser = next_of(stabiliser, 3);
  preferences.changed();
  notices.tell(k_messages[static_cast<std::size_t>(stabiliser)]);
}

void next_density(Preferences& preferences) {
  preferences.settings().density = next_of(preferences.settings().density, 3);
  preferences.changed();
}

void adjust_backdrop(CanvasLook& look, Dialogs& dialogs) {
  if (!look.backdrop) return find(dialogs, Dialog::backdrop);
  look.backdrop->adjusting = !look.backdrop->adjusting;
}

void change_theme(Preferences& preferences) {
  flip(preferences.settings().light);
  preferences.changed();
}

/// Reads the file again with its coordinates meant in another way.
void read_anew(const Files& files, Leaving& leaving, void (*change)(io::Orientation&)) {
  files::ModelName name = files::model_name(files.path());
  change(name.orientation);
  leaving.ask_to_open(name.text());
}

constexpr KeyStroke plain(std::uint32_t key) { return plain_key(key); }
constexpr KeyStroke pad(std::uint32_t digit) { return plain_key(pad_key(digit)); }
constexpr KeyStroke ctrl(std::uint32_t key) { return {key, true, false}; }
constexpr KeyStroke ctrl_shift(std::uint32_t key) { return {key, true, true}; }
constexpr KeyStroke shift(std::uint32_t key) { return {key, false, true}; }

// Where Blender and Krita agree with each other their keys are used; where they do not, Blender's for views and keys,
// Krita's for drawing.
// clang-format off
constexpr std::array k_actions{
    ActionInfo{{"undo"}, "Undo", ctrl('z'), {}, "Take back the last step",
     "M9 5L4 10L9 15M4 10L14 10A14 14.5 4.5 -90 90M14 19L10 19",
     does([](Playback& playback) { playback.undo(); }), does([](EditingSession& editing) { return editing.steps().can_undo() > 0; })},
    ActionInfo{{"redo"}, "Redo", ctrl_shift('z'), ctrl('y'), "Bring back what was undone",
     "M15 5L20 10L15 15M20 10L10 10A10 14.5 4.5 270 90M10 19L14 19",
     does([](Playback& playback) { playback.redo(); }), does([](EditingSession& editing) { return editing.steps().can_redo() > 0; })},
    ActionInfo{{"clear_curves"}, "Clear", shift('x'), {}, "Remove all lines; the pose stays",
     "M5 7L19 7M9 7L9 4L15 4L15 7M7 7L8 20L16 20L17 7", does<clear_curves>},
    ActionInfo{{"delete_curve"}, "Delete", plain(k_key_delete), plain('x'), "Delete the selected keys, else the curve under the pen",
     "M4 16L9 11L13 14L16 11M16 16L21 21M21 16L16 21", does<delete_what_is_meant>},
    ActionInfo{{"keep_curve"}, "Keep", plain('h'), {}, "Keep the line under the pen where it is now",
     "M4 13L9 18L20 6", does([](CurvesInHand& curves) { curves.keep_lit(); })},
    ActionInfo{{"reset_pose"}, "Rest pose", ctrl('r'), {}, "Put the whole character back to rest",
     "C12 12 8M8 10L8 10.5M16 10L16 10.5M8 15.5L16 15.5",
     does([](EditingSession& editing) { editing.perform(document::ResetParameters{}); })},
    ActionInfo{{"cancel"}, "Cancel", plain(k_key_escape), {}, "Cancel the line that is being drawn",
     "M6 6L18 18M18 6L6 18", does<cancel>},
    ActionInfo{{"view_front"}, "Front", shift('1'), pad(1), "Look from the front",
     "C12 11 7M12 8L12 12M9 15L15 15", does([](Canvas& canvas) { look(canvas, "front"); })},
    ActionInfo{{"view_side"}, "Side", shift('3'), pad(3), "Look from the side",
     "M8 4L14 4L17 9L19 13L16.5 13.5L16 18L12 19L12 21M8 4L6 9L8 15L8 21",
     does([](Canvas& canvas) { look(canvas, "side"); })},
    ActionInfo{{"view_three_quarter"}, "3/4", shift('2'), pad(7), "Look from between front and side",
     "C12 11 7M14 8L15 12M11 15L16 14", does([](Canvas& canvas) { look(canvas, "three-quarter"); })},
    ActionInfo{{"frame_all"}, "Whole figure", plain(k_key_home), plain('f'), "Show all of the model",
     "M4 9L4 4L9 4M15 4L20 4L20 9M20 15L20 20L15 20M9 20L4 20L4 15", does([](Canvas& canvas) { canvas.frame_all(); })},
    ActionInfo{{"frame_face"}, "Face", shift('f'), {}, "Show the face: where most controls work",
     "C12 12 8M9 10L9 10.5M15 10L15 10.5M9 15.5L15 15.5", does([](Canvas& canvas) { canvas.frame_face(); })},
    ActionInfo{{"orbit_left"}, "Turn left", plain(k_key_left), pad(4), "Turn the view",
     "A12 12 8 100 330M4 12L4 18L10 18",
     does([](const EditingSession& editing, Canvas& canvas) { turn(editing, canvas, -k_turn_degrees, 0); })},
    ActionInfo{{"orbit_right"}, "Turn right", plain(k_key_right), pad(6), "Turn the view",
     "A12 12 8 -150 80M20 12L20 18L14 18",
     does([](const EditingSession& editing, Canvas& canvas) { turn(editing, canvas, k_turn_degrees, 0); })},
    ActionInfo{{"orbit_up"}, "Turn up", plain(k_key_up), pad(8), "Turn the view",
     "M12 20L12 5M6 11L12 5L18 11",
     does([](const EditingSession& editing, Canvas& canvas) { turn(editing, canvas, 0, k_turn_degrees); })},
    ActionInfo{{"orbit_down"}, "Turn down", plain(k_key_down), pad(2), "Turn the view",
     "M12 4L12 19M6 13L12 19L18 13",
     does([](const EditingSession& editing, Canvas& canvas) { turn(editing, canvas, 0, -k_turn_degrees); })},
    ActionInfo{{"zoom_in"}, "Nearer", plain('+'), plain('='), "Zoom in",
     "C10 10 6M15 15L21 21M10 7L10 13M7 10L13 10",
     does([](const EditingSession& editing, Canvas& canvas) { zoom(editing, canvas, k_zoom); })},
    ActionInfo{{"zoom_out"}, "Farther", plain('-'), {}, "Zoom out",
     "C10 10 6M15 15L21 21M7 10L13 10",
     does([](const EditingSession& editing, Canvas& canvas) { zoom(editing, canvas, 1 / k_zoom); })},
    ActionInfo{{"wireframe"}, "Wire", shift('z'), {}, "Show the edges of the mesh",
     "M4 18L12 4L20 18Z M8 11L16 11L12 18Z", does([](CanvasLook& look) { flip(look.wireframe); })},
    ActionInfo{{"clay"}, "Clay", shift('c'), {}, "Show the shape alone, without textures and colours",
     "C12 12 8A12 12 4 180 270",
     does([](CanvasLook& look) {
       flip(look.clay);
       look.matcap = false;
     })},
    ActionInfo{{"matcap"}, "Matcap", {}, {},
     "Show the shape in the light of a ball: every bump is seen from every side",
     "C12 12 8C9.5 8.5 2.5A12 12 5.5 10 80",
     does([](CanvasLook& look) {
       flip(look.matcap);
       look.clay = false;
     })},
    ActionInfo{{"textured"}, "Textured", {}, {}, "Show textures and colours of the file again",
     "M4 4L20 4L20 20L4 20ZM4 12L20 12M12 4L12 20", does([](CanvasLook& look) { look.clay = look.matcap = false; }),
     does([](const CanvasLook& look) { return look.clay || look.matcap; })},
    ActionInfo{{"soft_shadows"}, "Soft shadows", {}, {},
     "Shade in cavities and on the ground; a slow computer does without",
     "A12 9 6 180 360M4 19L20 19M8 16L16 16M6 9L18 9",
     does([](Preferences& preferences) {
       flip(preferences.settings().soft_shadows);
       preferences.changed();
     })},
    ActionInfo{{"model_notes"}, "Model notes", {}, {},
     "What was noticed about the model when it was opened: textures that cannot be drawn, parts that were left out",
     "M6 3L18 3L18 21L6 21ZM9 8L15 8M9 12L15 12M9 16L13 16",
     does([](Dialogs& dialogs) { dialogs.show(Dialog{"model notes"}); })},
    ActionInfo{{"suggest_rest"}, "Suggest", plain('g'), {},
     "Suggest the rest of the face from your keyed poses",
     "M12 3L14 10L21 12L14 14L12 21L10 14L3 12L10 10Z", does<suggest_rest>},
    ActionInfo{{"second_reading"}, "Second reading", plain('y'), {},
     "Did you mean: take the second reading of the last line; again: take the first one back",
     "M4 18L12 6L20 18M12 6L12 18", does([](EditingSession& editing, ReadingOffer& offer) { offer.take(editing, 0); }),
     does([](const ReadingOffer& offer) { return offer.open(); })},
    ActionInfo{{"third_reading"}, "Third reading", shift('y'), {},
     "Did you mean: take the third reading of the last line; again: take the first one back",
     "M4 18L12 6L20 18M12 6L9 18M12 6L15 18",
     does([](EditingSession& editing, ReadingOffer& offer) { offer.take(editing, 1); }),
     does([](const ReadingOffer& offer) { return offer.readings().size() > 1; })},
    ActionInfo{{"open"}, "Open", ctrl('o'), {}, "Open a model, a project or a session",
     "M3 19L3 5L9 5L11 8L20 8L20 11M3 19L7 11L22 11L19 19Z",
     does([](Dialogs& dialogs) { dialogs.show(Dialog::open); })},
    ActionInfo{{"recent"}, "Recent", ctrl_shift('o'), {}, "Open a recent file",
     "C12 12 8M12 7L12 12L16 14", does([](Dialogs& dialogs) { dialogs.show(Dialog::recent); })},
    ActionInfo{{"up_axis"}, "Z up", {}, {}, "Read the file again with Z or Y up",
     "M12 21L12 4M7 9L12 4L17 9M5 21L19 21",
     does([](Files& files, Leaving& leaving) {
       read_anew(files, leaving, [](io::Orientation& now) { now.up = now.up == io::Up::z ? io::Up::y : io::Up::z; });
     }), does([](const Files& files) { return files::leaves_axes_open(files::model_name(files.path()).file); })},
    ActionInfo{{"left_handed"}, "Left-handed", {}, {}, "Read the file again, mirrored",
     "M12 3L12 21M9 8L4 12L9 16M15 8L20 12L15 16",
     does([](Files& files, Leaving& leaving) {
       read_anew(files, leaving, [](io::Orientation& now) { now.left_handed = !now.left_handed; });
     }), does([](const Files& files) { return files::leaves_axes_open(files::model_name(files.path()).file); })},
    ActionInfo{{"save"}, "Save", ctrl('s'), {}, "Save the project",
     "M4 4L17 4L20 7L20 20L4 20Z M8 4L8 9L15 9L15 4M7 20L7 14L17 14L17 20", does<save>},
    ActionInfo{{"save_as"}, "Save as", ctrl_shift('s'), {}, "Save to a new file",
     "M4 4L17 4L20 7L20 12M4 4L4 20L11 20M8 4L8 9L15 9L15 4M14 20L19 15L21 17L16 22L14 22Z",
     does([](Dialogs& dialogs) { name_file(dialogs, Dialog::save); })},
    ActionInfo{{"export_as"}, "Export", {}, {}, "Export for other programs",
     "M12 15L12 4M7 9L12 4L17 9M4 14L4 20L20 20L20 14",
     does([](Dialogs& dialogs) { name_file(dialogs, Dialog::export_as); })},
    ActionInfo{{"panels"}, "Panels", plain(k_key_tab), {}, "Show or hide the panels; a small screen shows tools and sliders in turn",
     "M3 5L21 5L21 19L3 19Z M15 5L15 19", does([](PanelState& panels) { panels.show_next(); })},
    ActionInfo{{"fullscreen"}, "Full screen", plain(k_key_f11), {}, "Fill the whole screen",
     "M4 9L4 4L9 4M15 4L20 4L20 9M20 15L20 20L15 20M9 20L4 20L4 15M4 4L9 9M20 20L15 15",
     does([](CanvasLook& look) { flip(look.fullscreen); })},
    ActionInfo{{"theme"}, "Light", {}, {}, "Dark or light colours",
     "C12 12 4M12 3L12 5M12 19L12 21M3 12L5 12M19 12L21 12M6 6L7 7M17 17L18 18M18 6L17 7M6 18L7 17",
     does<change_theme>},
    ActionInfo{{"larger"}, "Larger", ctrl('+'), ctrl('='), "Make everything larger",
     "M3 19L9 5L15 19M5 14L13 14M17 8L23 8M20 5L20 11",
     does([](Preferences& preferences) { resize(preferences, 0.25); })},
    ActionInfo{{"smaller"}, "Smaller", ctrl('-'), {}, "Make everything smaller",
     "M3 19L9 5L15 19M5 14L13 14M17 8L23 8", does([](Preferences& preferences) { resize(preferences, -0.25); })},
    ActionInfo{{"help"}, "Help", {}, {}, "First steps and guided tours",
     "C12 12 9A12 10 3 180 400M13.5 13L12 14.5M12 17.5L12 18",
     does([](Dialogs& dialogs) { dialogs.show(Dialog::steps); })},
    ActionInfo{{"quit"}, "Quit", ctrl('q'), {}, "Close the program",
     "M14 4L4 4L4 20L14 20M9 12L21 12M16 7L21 12L16 17", does([](Leaving& leaving) { leaving.ask_to_quit(); })},
    ActionInfo{{"shortcuts"}, "Shortcuts", plain(k_key_f1), shift('/'), "All keyboard shortcuts",
     "M3 6L21 6L21 18L3 18Z M7 10L7 10.5M11 10L11 10.5M15 10L15 10.5M8 14.5L16 14.5",
     does([](Dialogs& dialogs) { find(dialogs, Dialog::shortcuts); })},
    ActionInfo{{"sound"}, "Sound", ctrl_shift('k'), {}, "Add a sound to the timeline: WAV, FLAC, OGG, MP3 or AIFF",
     "M4 9L8 9L13 5L13 19L8 15L4 15ZM16 9L16 15M19 7L19 17", does([](Dialogs& dialogs) { dialogs.show(Dialog::sound); })},
    ActionInfo{{"search"}, "Search", ctrl('k'), {}, "Find an action, a control, a pose or a file by its name",
     "C10 10 6M15 15L21 21", does([](Dialogs& dialogs) { find(dialogs, Dialog::search); })},
    ActionInfo{{"history"}, "History", ctrl('h'), {}, "List every step and go back to any of them",
     "A12 12 8 -160 130M4 4L4 9L9 9M12 8L12 12L15 14", does([](Dialogs& dialogs) { find(dialogs, Dialog::history); })},
    ActionInfo{{"mirror_strokes"}, "X-mirror", plain('m'), {}, "Draw on one side and both sides move",
     "M12 3L12 21M9 7L3 17L9 17Z M15 7L21 17L15 17Z",
     does([](Playback& playback) { flip(playback.while_drawing().mirrors); })},
    ActionInfo{{"flip_pose"}, "Flip", shift('m'), {}, "Flip the pose: left becomes right",
     "M12 3L12 21M4 9L9 9M6 6L3.5 9L6 12M20 15L15 15M18 12L20.5 15L18 18", does<flip_pose>},
    ActionInfo{{"copy_to_right"}, "Left to right", ctrl('m'), {}, "Copy the left side of the pose to the right",
     "M12 3L12 21M3 12L9 12M15 7L21 12L15 17F",
     does([](EditingSession& editing, Notices& notices) { copy_side(editing, notices, true); })},
    ActionInfo{{"copy_to_left"}, "Right to left", ctrl_shift('m'), {}, "Copy the right side of the pose to the left",
     "M12 3L12 21M15 12L21 12M9 7L3 12L9 17F",
     does([](EditingSession& editing, Notices& notices) { copy_side(editing, notices, false); })},
    ActionInfo{{"neutral"}, "My neutral face", {}, {},
     "Use this drawing as your neutral face for all later drawings; without lines: forget it",
     "C12 12 9M8 9L9.5 9M14.5 9L16 9M8.5 15.5L15.5 15.5", does<keep_neutral>},
    ActionInfo{{"stabiliser"}, "Steady line", {}, {},
     "Smooth drawn lines on screen: off, light or strong",
     "M3 16A7.5 16 4.5 180 360M12 16A16.5 16 4.5 180 0", does<next_stabiliser>},
    ActionInfo{{"side_panel"}, "Side panel", shift('n'), {}, "Open the panel at the right, or close it to a rail",
     "M3 5L21 5L21 19L3 19Z M15 5L15 19M18 9L18 15",
     does([](PanelState& panels) { panels.open_side(!panels.side_open()); })},
    ActionInfo{{"moved_only"}, "Moved only", {}, {}, "List only the controls that are not at rest",
     "M4 7L20 7M4 12L14 12M4 17L9 17",
     does([](PanelState& panels) { flip(panels.own.of<ParameterList>().moved_only); })},
    ActionInfo{{"density"}, "Density", {}, {}, "Compact, usual or for touch",
     "M4 5L20 5M4 9.5L20 9.5M4 14L20 14M4 18.5L20 18.5", does<next_density>},
    ActionInfo{{"library"}, "Poses", plain('l'), {}, "Keyed poses and your pose library",
     "M4 4L11 4L11 11L4 11Z M13 4L20 4L20 11L13 11Z M4 13L11 13L11 20L4 20Z M13 13L20 13L20 20L13 20Z",
     does([](PanelState& panels) { panels.show_poses(); })},
    ActionInfo{{"mouths"}, "Mouths", ctrl_shift('l'), {}, "Mouths for speech, and lip sync from a sound",
     "M3 12L8 9L12 10L16 9L21 12L16 16L8 16ZM3 12L21 12",
     does([](PanelState& panels) { panels.show_mouths(); })},
    ActionInfo{{"first_pass"}, "First pass", {}, {}, "Key your mouths to the sound on the timeline",
     "M3 6L21 6L21 15L12 15L8 20L8 15L3 15ZM7 10.5L17 10.5",
     does([](Dialogs& dialogs) { dialogs.show(Dialog{"first pass"}); })},
    ActionInfo{{"tour_pose"}, "Tour: pose a face", {}, {},
     "Six strokes on the built-in head, each shown first",
     "M7 4L20 12L7 20Z", does([](Leaving& leaving) { leaving.ask_to_open("tour:pose"); })},
    ActionInfo{{"tour_rig"}, "Tour: make a control", {}, {}, "A control for a brow, sketched line by line",
     "M7 4L20 12L7 20Z", does([](Leaving& leaving) { leaving.ask_to_open("tour:rig"); })},
    ActionInfo{{"tour_animate"}, "Tour: animate", {}, {}, "Two keys and a smile between them",
     "M7 4L20 12L7 20Z", does([](Leaving& leaving) { leaving.ask_to_open("tour:animate"); })},
    ActionInfo{{"flat_view"}, "Flat", shift('5'), pad(5), "Turn perspective off or on",
     "M5 8L14 8L14 17L5 17Z M5 8L9 4L18 4L14 8M18 4L18 13L14 17",
     does([](Canvas& canvas) { canvas.set_flat(!canvas.flat()); })},
    ActionInfo{{"set_front"}, "Front is here", {}, {},
     "Make this side the front of the model; the project keeps it",
     "C12 9 5M4 20A12 20 8 180 360", does([](Canvas& canvas) { canvas.set_front(); })},
    ActionInfo{{"backdrop"}, "Reference", {}, {},
     "A picture or a film behind the model or beside it, to animate after; the project keeps where it is",
     "M3 5L21 5L21 19L3 19Z M4 17L9 11L13 15L16 12L20 16", does<adjust_backdrop>},
    ActionInfo{{"preferences"}, "Preferences", ctrl(','), {}, "Settings for view, pen, keys, time and folders",
     "C12 12 3M12 3L12 6M12 18L12 21M3 12L6 12M18 12L21 12M6 6L8 8M16 16L18 18M18 6L16 8M6 18L8 16",
     does([](Dialogs& dialogs) { dialogs.show(Dialog{"preferences"}); })},
    ActionInfo{{"backdrop_off"}, "No reference", {}, {}, "Take the picture or the film away",
     "M3 5L21 5L21 19L3 19Z M8 8L16 16M16 8L8 16", does([](ReferenceDesk& references) { references.remove(); })},
};
// clang-format on

/// An action that takes a tool in hand.
ActionInfo action_of_tool(const WindowTool& tool) {
  const ToolButton& button = tool.button;
  return {{button.action}, button.label, button.key, button.other, button.tip, button.icon, nullptr, nullptr, &tool};
}

std::vector<ActionInfo> made_actions() {
  std::vector<ActionInfo> all;
  for (const WindowTool& tool : window_tools()) {
    if (!tool.button.label.empty()) all.push_back(action_of_tool(tool));
  }
  all.insert(all.end(), k_actions.begin(), k_actions.end());
  const auto of_hand = hand_actions();
  all.insert(all.end(), of_hand.begin(), of_hand.end());
  const auto of_controls = control_actions();
  all.insert(all.end(), of_controls.begin(), of_controls.end());
  const auto of_time = time_actions();
  all.insert(all.end(), of_time.begin(), of_time.end());
  const auto of_cameras = camera_actions();
  all.insert(all.end(), of_cameras.begin(), of_cameras.end());
  const auto of_cast = cast_actions();
  all.insert(all.end(), of_cast.begin(), of_cast.end());
  return all;
}

}  // namespace

std::span<const ActionInfo> all_actions() {
  static const std::vector<ActionInfo> all = made_actions();
  return all;
}

}  // namespace penpose::app
