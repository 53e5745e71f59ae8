#include "ui/app/playback/time_actions.h"

#include <algorithm>
#include <array>

#include "ui/app/owners.h"
#include "ui/app/playback/frames.h"
#include "ui/app/playback/marks/bookmark_steps.h"

namespace penpose::app {
namespace {

void flip_on(bool& on) { on = !on; }

/// Onion, which says why nothing is seen of it.
void show_ghosts(CanvasLook& look, EditingSession& editing, Notices& notices) {
  flip_on(look.onion_skin);
  if (look.onion_skin && editing.document().timeline->keys.size() < 2)
    notices.tell("Onion is on: key a pose at two moments, and from one of them the other is seen");
}

void flip_ghost_style(CanvasLook& look) {
  using render::GhostStyle;
  look.ghosts.style = look.ghosts.style == GhostStyle::faces ? GhostStyle::contours : GhostStyle::faces;
  look.onion_skin = true;
}

void flip_ghost_steps(CanvasLook& look) {
  using render::GhostSteps;
  look.ghosts.steps = look.ghosts.steps == GhostSteps::keys ? GhostSteps::frames : GhostSteps::keys;
  look.onion_skin = true;
}

template <int by>
void add_ghosts(CanvasLook& look) {
  for (int* count : {&look.ghosts.before, &look.ghosts.after})
    *count = std::clamp(*count + by, 0, render::k_most_ghosts);
  look.onion_skin = true;
}

void step(Playback& playback, int frames) { playback.go_to(step_frame(playback.time_s(), frames, playback.rate())); }

void next_speed(Playback& playback) {
  const auto* now = std::find(k_speeds.begin(), k_speeds.end(), playback.speed());
  playback.set_speed(now == k_speeds.end() || now + 1 == k_speeds.end() ? k_speeds.front() : *(now + 1));
}

void name_film(Dialogs& dialogs) {
  dialogs.state<FileChoice>().name.clear();
  dialogs.state<SearchEntry>() = {};
  dialogs.show(Dialog::film);
}

/// Shows a part of the timeline, or the moments of keys alone where it is shown: what is selected in it is not seen
/// then, and nothing is done to it unseen.
void show_part(PanelState& panels, Keys& keys, TimelinePart part) {
  TimelinePart& shown = panels.own.of<TimelineShown>().part;
  shown = shown == part ? TimelinePart::poses : part;
  if (shown == TimelinePart::poses) keys.selected().clear();
  panels.shown = true;
}

constexpr KeyStroke plain_stroke(std::uint32_t key) { return plain_key(key); }
constexpr KeyStroke ctrl_stroke(std::uint32_t key) { return {key, true, false}; }
constexpr KeyStroke shift_stroke(std::uint32_t key) { return {key, false, true}; }

constexpr std::array k_key_kinds{
    KeyKindInfo{document::KeyKind::smooth, "Smooth", "Rounded, and never beyond the keys"},
    KeyKindInfo{document::KeyKind::linear, "Linear", "At one pace"},
    KeyKindInfo{document::KeyKind::stepped, "Stepped", "Holds, and jumps at the next key"},
    KeyKindInfo{document::KeyKind::ease_in, "Ease in", "Starts slowly"},
    KeyKindInfo{document::KeyKind::ease_out, "Ease out", "Ends slowly"},
    KeyKindInfo{document::KeyKind::ease, "Ease", "Starts and ends slowly"},
    KeyKindInfo{document::KeyKind::free, "Free", "By its handles in Curves, within the ranges of controls"},
    KeyKindInfo{document::KeyKind::overshoot, "Overshoot",
                "By its handles in Curves, beyond the ranges of controls, too"},
};

template <document::KeyKind kind>
constexpr ActionInfo action_of_kind(std::string_view name, std::string_view label, std::string_view tip,
                                    std::string_view icon) {
  return {{name}, label, {}, {}, tip, icon, does([](Keys& keys) { keys.set_kind(kind); })};
}

// clang-format off
constinit const std::array k_time_actions{
    ActionInfo{{"key_pose"}, "Key", plain_stroke('i'), plain_stroke('k'), "Key the pose at this frame",
     "M12 4L20 12L12 20L4 12F", does([](Keys& keys, Controls& controls) {
       // What is seen is keyed.
       controls.take_trial();
       keys.set();
     })},
    ActionInfo{{"delete_key"}, "Delete key", shift_stroke('i'), {}, "Delete the selected keys, else the keys at this frame",
     "M10 4L18 12L10 20L2 12Z M17 4L22 9M22 4L17 9",
     does([](Keys& keys) { keys.remove(); }), does([](Keys& keys) { return keys.any_meant(); })},
    ActionInfo{{"previous_key"}, "Key before", plain_stroke(','), {}, "Go to the key before",
     "M5 5L5 19M18 5L9 12L18 19Z", does([](Playback& playback) { playback.step_key(-1); })},
    ActionInfo{{"next_key"}, "Key after", plain_stroke('.'), {}, "Go to the key after",
     "M19 5L19 19M6 5L15 12L6 19Z", does([](Playback& playback) { playback.step_key(1); })},
    ActionInfo{{"play"}, "Play", plain_stroke(' '), {}, "Play from key to key",
     "M7 4L20 12L7 20F", does([](Playback& playback) { playback.play_or_stop(); })},
    ActionInfo{{"onion_skin"}, "Onion", shift_stroke('o'), {},
     "Show the face before this moment (violet) and after it (cyan)", "C9 12 6C15 12 6", does<show_ghosts>},
    ActionInfo{{"ghost_faces"}, "Onion as faces", {}, {},
     "Show the face before and after as translucent faces, or as contours again", "C9 12 6F C15 12 6",
     does<flip_ghost_style>},
    ActionInfo{{"ghost_frames"}, "Onion at frames", {}, {},
     "Show the face every few frames before and after, or at keys again", "C9 12 6C15 12 6M4 21L20 21",
     does<flip_ghost_steps>},
    ActionInfo{{"more_ghosts"}, "More ghosts", {}, {}, "Show one more face before and one more after",
     "C9 12 6C15 12 6M20 3L20 7M18 5L22 5", does<add_ghosts<1>>},
    ActionInfo{{"fewer_ghosts"}, "Fewer ghosts", {}, {}, "Show one face less before and one less after",
     "C9 12 6C15 12 6M18 5L22 5", does<add_ghosts<-1>>},
    ActionInfo{{"ghosts_in_films"}, "Onion in films", {}, {}, "Films and playblasts show the face before and after, too",
     "M3 5L21 5L21 19L3 19ZC10 12 4C14 12 4", does([](CanvasLook& look) { flip_on(look.ghosts_in_films); })},
    ActionInfo{{"previous_frame"}, "Frame back", shift_stroke(','), ctrl_stroke(k_key_left), "Go one frame back",
     "M15 5L7 12L15 19Z", does([](Playback& playback) { step(playback, -1); })},
    ActionInfo{{"next_frame"}, "Frame on", shift_stroke('.'), ctrl_stroke(k_key_right), "Go one frame on",
     "M9 5L17 12L9 19Z", does([](Playback& playback) { step(playback, 1); })},
    ActionInfo{{"copy_key"}, "Copy", ctrl_stroke('c'), {}, "Copy the pose at this frame",
     "M8 8L20 8L20 20L8 20Z M16 8L16 4L4 4L4 16L8 16", does([](Keys& keys) { keys.copy(); })},
    ActionInfo{{"paste_key"}, "Paste", ctrl_stroke('v'), {}, "Key the copied pose at this frame",
     "M7 5L4 5L4 21L16 21L16 18M8 3L20 3L20 17L8 17Z M11 10L17 10M14 7L14 13",
     does([](Keys& keys) { keys.paste(); }), does([](Keys& keys) { return keys.copied(); })},
    ActionInfo{{"paste_mirrored"}, "Paste mirrored", KeyStroke{'v', true, true}, {},
     "Key the pose that was copied to the other side: left and right exchanged",
     "M12 3L12 21M9 7L3 17L9 17Z M15 10L21 10M18 7L18 13",
     does([](Keys& keys) { keys.paste_mirrored(); }), does([](Keys& keys) { return keys.copied(); })},
    ActionInfo{{"mirror_keys"}, "Mirror keys", {}, {},
     "Exchange left and right of the selected keys, else of those at this moment",
     "M12 3L12 21M6 8L9 12L6 16L3 12ZM18 8L21 12L18 16L15 12Z",
     does([](Keys& keys) { keys.mirror(); }), does([](Keys& keys) { return keys.any_meant(); })},
    ActionInfo{{"loop_from"}, "In point", plain_stroke('['), {}, "What is played over and over begins here",
     "M8 4L4 4L4 20L8 20M20 12L10 12M14 8L10 12L14 16",
     does([](Playback& playback) { playback.loop().begin_at(playback.time_s()); })},
    ActionInfo{{"loop_to"}, "Out point", plain_stroke(']'), {}, "What is played over and over ends here",
     "M16 4L20 4L20 20L16 20M4 12L14 12M10 8L14 12L10 16",
     does([](Playback& playback) { playback.loop().end_at(playback.time_s()); })},
    ActionInfo{{"loop_off"}, "Clear in and out", plain_stroke('\\'), {}, "Play everything, from the first frame to the last key",
     "A12 12 7 -150 150M6 4L6 9L11 9M16 16L22 22M22 16L16 22", does([](Playback& playback) { playback.loop() = {}; })},
    ActionInfo{{"play_speed"}, "Speed", {}, {}, "Play at the whole, half or a quarter of the speed; the sound slows along",
     "A12 14 9 -180 0M12 14L17 8D12 14 1.5", does<next_speed>},
    ActionInfo{{"bookmark"}, "Bookmark", ctrl_stroke('b'), {}, "Set a bookmark here; on one, give it a name and a colour",
     "M6 21L6 4L18 4L14 8.5L18 13L6 13", does<set_bookmark>},
    ActionInfo{{"previous_bookmark"}, "Bookmark before", ctrl_stroke(k_key_page_up), {}, "Go to the bookmark before",
     "M13 21L13 4L22 4L19 8L22 12L13 12M8 8L3 12L8 16",
     does([](const EditingSession& editing, Playback& playback, Notices& notices) { step_bookmark(editing, playback, notices, -1); })},
    ActionInfo{{"next_bookmark"}, "Bookmark after", ctrl_stroke(k_key_page_down), {}, "Go to the bookmark after",
     "M3 21L3 4L12 4L9 8L12 12L3 12M16 8L21 12L16 16",
     does([](const EditingSession& editing, Playback& playback, Notices& notices) { step_bookmark(editing, playback, notices, 1); })},
    ActionInfo{{"auto_key"}, "Auto-key", shift_stroke('k'), {}, "Key every change of the pose at the current frame",
     "M9 5L16 12L9 19L2 12F D20 5 3", does([](Playback& playback) { flip_on(playback.while_drawing().auto_key); })},
    ActionInfo{{"film"}, "Film", {}, {}, "Export a film with sound, a GIF, pictures, or a sheet of frames",
     "M3 5L21 5L21 19L3 19Z M7 5L7 19M17 5L17 19M3 12L7 12M17 12L21 12",
     does<name_film>},
    ActionInfo{{"playblast"}, "Playblast", {}, {},
     "Write the canvas to a film next to the project, at once",
     "M3 5L21 5L21 19L3 19Z M10 8L16 12L10 16F",
     does([](FilmWriter& film) { film.playblast(); }), does([](FilmWriter& film) { return !film.writes(); })},
    ActionInfo{{"perform"}, "Perform", shift_stroke(' '), {},
     "Press on the face and pull: time runs while the pen is down, and what the face does is keyed",
     "C12 12 9D12 12 5", does([](ToolInHand& tool) { tool.perform_or_end(); })},
    ActionInfo{{"perform_again"}, "Again", shift_stroke(k_key_backspace), {},
     "Take the last take of Perform back and go to its start, to perform it anew",
     "A12 12 8 -160 130M4 4L4 9L9 9D12 12 3", does([](Performer& performer) { performer.again(); }),
     does([](const Performer& performer) { return performer.take() != nullptr; })},
    ActionInfo{{"review_take"}, "Watch", {}, {}, "Play the last take of Perform from its start",
     "M7 4L20 12L7 20Z", does([](Performer& performer) { performer.review(); }),
     does([](const Performer& performer) { return performer.take() != nullptr; })},
    ActionInfo{{"keep_take"}, "Keep the take", {}, {},
     "The last take of Perform stays; the playhead goes back to its start, to play it or to pull something else over it",
     "M4 13L9 18L20 6", does([](Performer& performer) { performer.keep(); }),
     does([](const Performer& performer) { return performer.take() != nullptr; })},
    ActionInfo{{"breakdown"}, "Breakdown", shift_stroke('b'), {},
     "Key a pose half way from the key before to the key after, of the selected controls or of all",
     "M4 12L10 6L10 18ZM20 12L14 6L14 18Z", does([](Keys& keys) { keys.tween(0.5); })},
    ActionInfo{{"favour_before"}, "Favour the key before", shift_stroke('['), {},
     "Key a pose a third of the way from the key before to the key after",
     "M4 12L12 5L12 19ZM20 12L16 9L16 15Z", does([](Keys& keys) { keys.tween(1.0 / 3); })},
    ActionInfo{{"favour_after"}, "Favour the key after", shift_stroke(']'), {},
     "Key a pose two thirds of the way from the key before to the key after",
     "M20 12L12 5L12 19ZM4 12L8 9L8 15Z", does([](Keys& keys) { keys.tween(2.0 / 3); })},
    ActionInfo{{"overshoot"}, "Overshoot", {}, {},
     "Key a pose a fifth of the way beyond the key after, within the ranges",
     "M3 18L9 18L15 7L20 10M16 11L20 10L19 6", does([](Keys& keys) { keys.tween(1.2); })},
    ActionInfo{{"dope_sheet"}, "Sheet", plain_stroke('t'), {},
     "A row for each control: its keys selected, moved, copied, scaled in time",
     "M3 6L21 6M3 12L21 12M3 18L21 18M8 4L10 6L8 8L6 6ZM16 10L18 12L16 14L14 12ZM8 16L10 18L8 20L6 18Z",
     does([](PanelState& panels, Keys& keys) { show_part(panels, keys, TimelinePart::sheet); })},
    ActionInfo{{"clips"}, "Clips", ctrl_stroke('t'), {},
     "Clips of this file: animations that came with it and those that were made",
     "M3 5L21 5L21 9L3 9Z M3 12L15 12L15 16L3 16Z M3 19L19 19",
     does([](Dialogs& dialogs) { dialogs.show(Dialog{"clips"}); })},
    ActionInfo{{"overlap"}, "Overlap", {}, {},
     "The controls whose keys are selected trail: later by frames, and as if on a spring",
     "M2 15L7 6L12 15M10 20L16 9L22 20",
     does([](OverlapOffer& overlap) { return overlap.open() ? overlap.dismiss() : overlap.begin(); })},
    ActionInfo{{"curve_editor"}, "Curves", shift_stroke('t'), {}, "The curves of controls, with handles",
     "M3 20L6 18L9 10L12 6L15 8L18 16L21 18M9 10L15 2",
     does([](PanelState& panels, Keys& keys) { show_part(panels, keys, TimelinePart::curves); })},
    action_of_kind<document::KeyKind::smooth>("kind_smooth", "Smooth keys", "Rounded, and never beyond the keys, from this key to the next",
     "M3 19L7 18L11 14L13 10L17 6L21 5"),
    action_of_kind<document::KeyKind::linear>("kind_linear", "Linear keys", "At one pace, from this key to the next",
     "M3 19L21 5"),
    action_of_kind<document::KeyKind::stepped>("kind_stepped", "Stepped keys", "Holds, and jumps at the next key, from this key to the next",
     "M3 19L15 19L15 5L21 5"),
    action_of_kind<document::KeyKind::ease_in>("kind_ease_in", "Ease in", "Starts slowly, from this key to the next",
     "M3 19L10 18L16 13L21 5"),
    action_of_kind<document::KeyKind::ease_out>("kind_ease_out", "Ease out", "Ends slowly, from this key to the next",
     "M3 19L8 11L14 6L21 5"),
    action_of_kind<document::KeyKind::ease>("kind_ease", "Ease in and out", "Starts and ends slowly, from this key to the next",
     "M3 19L8 18L12 12L16 6L21 5"),
    action_of_kind<document::KeyKind::free>("kind_free", "Free keys", "By its handles in Curves, within the ranges of controls, from this key to the next",
     "M3 19L9 9L15 15L21 5M5 5L13 13"),
    action_of_kind<document::KeyKind::overshoot>("kind_overshoot", "Overshooting keys", "By its handles in Curves, beyond the ranges of controls, too, from this key to the next",
     "M3 19L9 4L15 3L21 8M3 8L21 8"),
};
// clang-format on

}  // namespace

std::span<const KeyKindInfo> key_kinds() { return k_key_kinds; }

std::span<const ActionInfo> time_actions() { return k_time_actions; }

}  // namespace penpose::app
