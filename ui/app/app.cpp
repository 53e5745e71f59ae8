#include "ui/app/app.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <utility>

#include "ui/app/view/backdrop.h"
#include "ui/app/view/user_messages.h"
#include "ui/files/process/own_program.h"

namespace penpose::app {
namespace {

constexpr int k_playing_frame_ms = 16;
constexpr int k_slow_frame_ms = 250;
/// So far a pen that rests trembles, of an ordinary display, and so long it rests before the face follows it.
constexpr double k_tremble_px = 3;
constexpr std::int64_t k_rest_us = 400'000;
constexpr int k_dial_look_ms = 50;
constexpr int k_film_look_ms = 200;
constexpr std::int64_t k_longest_step_us = 200'000;

std::string sessions_in(const std::string& state) { return state.empty() ? state : state + "/sessions"; }

/// Where pictures of films are kept.
std::string films_in(const Folders& folders) {
  const std::string& folder = folders.cache.empty() ? folders.state : folders.cache;
  return (folder.empty() ? std::string("/tmp/penpose") : folder) + "/films";
}

}  // namespace

App::App(AppOptions options)
    : options_(std::move(options)),
      notices_(options_.clock, !options_.slow_screen),
      preferences_(options_.folders.config, notices_),
      editing_(
          options_.clock, [this](std::string text, bool is_error) { notices_.tell(std::move(text), is_error); },
          options_.own_tablets),
      recording_({options_.folders.state, options_.session, options_.program, options_.date}, editing_, notices_),
      actions_(*this),
      canvas_(editing_, preferences_, notices_, player_),
      cast_(editing_, recording_, canvas_),
      cast_note_(sessions_in(options_.folders.state), cast_),
      features_(options_.folders.config, editing_, notices_),
      controls_(editing_, notices_, canvas_, panels_),
      restriction_(editing_, notices_),
      playback_(options_.clock, editing_, notices_, preferences_),
      keys_(editing_, notices_, playback_),
      overlap_(editing_, playback_, keys_, notices_),
      cameras_(editing_, canvas_, playback_, player_, notices_),
      performer_(editing_, notices_, playback_, player_),
      ghosts_({editing_, playback_, notices_, canvas_, look_}),
      tool_({editing_, controls_, panels_, playback_, performer_, canvas_, arcs_, ghosts_, notices_}),
      curves_({editing_, canvas_, controls_, panels_, performer_, notices_, tool_, features_, restriction_, cast_}),
      tour_({editing_, canvas_, playback_, panels_, player_, files_, actions_}),
      undrawn_(notices_),
      files_({options_.folders.state, options_.own_tablets, options_.program, options_.clock, editing_, recording_,
              cast_, player_, performer_, notices_, preferences_, dialogs_, tour_, features_, [this] { show_anew(); },
              [this] { show_character(); }}),
      sound_(editing_, notices_, playback_, files_),
      references_({editing_, canvas_, look_, playback_, notices_, files_, films_in(options_.folders)}),
      film_({editing_, notices_, canvas_, look_, playback_, sound_, files_, preferences_, cast_}),
      mouths_(editing_, notices_, playback_),
      first_pass_(editing_, notices_, playback_, sound_),
      shelf_(options_.folders.poses, editing_, preferences_, notices_, files_),
      leaving_(editing_, files_, recording_, dialogs_, notices_),
      system_dialogs_({options_.clock, references_, files_, leaving_, sound_, dialogs_, notices_, preferences_}),
      drops_({editing_, notices_, dialogs_, leaving_, files_, sound_, references_, playback_, files::own_program()}),
      recovery_(sessions_in(options_.folders.state), files_, notices_, actions_),
      bindings_(editing_, preferences_, desk_, tablets_, options_.panel),
      place_(options_.clock),
      drag_(editing_, canvas_, dialogs_),
      dials_({options_.clock, editing_, canvas_, hits_, dialogs_, playback_, controls_, notices_, desk_, place_,
              actions_}),
      held_keys_({editing_, bindings_, desk_, hits_, dialogs_, notices_, place_, actions_, features_}),
      fingers_({options_.clock, editing_, preferences_, canvas_, desk_, drag_}),
      pens_({editing_, hits_, dialogs_, panels_, desk_, bindings_, place_, panel_input_, drag_, dials_, held_keys_,
             curves_}),
      pointer_({editing_, canvas_, hits_, dialogs_, player_, place_, panel_input_, drag_, fingers_, held_keys_, curves_,
                pens_}),
      tablet_events_({options_.own_tablets, editing_, canvas_, dialogs_, notices_, player_, desk_, tablets_, bindings_,
                      place_, dials_, held_keys_, fingers_, pens_}),
      owners_(editing_, notices_, preferences_, recording_, player_, hits_, look_, drawing_, panels_, dialogs_,
              actions_, canvas_, controls_, playback_, keys_, performer_, film_, offer_, readings_, tool_, curves_,
              tour_, files_, leaving_, recovery_, desk_, bindings_, panel_input_, pointer_, tablet_events_, undrawn_,
              sound_, overlap_, ghosts_, mouths_, first_pass_, system_dialogs_, shelf_, features_, restriction_,
              cameras_, references_, drops_, cast_) {
  dialogs_.send_elsewhere([this](Dialog dialog) { return system_dialogs_.takes(dialog); });
  canvas_.ask_scale(options_.scale);
  // Before the first frame nobody knows where panels are.
  hits_.all = true;
  if (!recovery_.abandoned().empty()) {
    dialogs_.show(Dialog::recover);
  } else if (!preferences_.settings().steps_seen) {
    dialogs_.show(Dialog::steps);
  }
  const char* home = std::getenv("HOME");
  dialogs_.state<FileChoice>().folder = home != nullptr ? home : "/";
}

App::~App() {
  // What no memory was left for is offered at the next start, as after a crash.
  if (std::uncaught_exceptions() > 0) recording_.leave_work(true);
  recording_.end();
  cast_note_.end(recording_.leaves_work());
}

void App::show_anew() {
  overlap_.forget();
  features_.forget();
  playback_.begin();
  controls_.open_document();
  restriction_.forget();
  curves_.forget();
  mouths_.forget();
  canvas_.begin();
  cameras_.begin();
  references_.cancel();
  undrawn_.begin(*editing_.document().model);
  tablet_events_.plug_in_anew();
}

void App::show_character() {
  overlap_.forget();
  features_.forget();
  controls_.open_document();
  curves_.forget();
  mouths_.forget();
  undrawn_.begin(*editing_.document().model);
  tablet_events_.plug_in_anew();
  playback_.take_over();
}

void App::play_trace(std::int64_t passed_us) {
  // A frame that took long must not swallow the trace: what is due is handed on report by report.
  TracePlayer& trace = *player_.trace;
  const bool agreed = !trace.divergence();
  trace.advance(editing_, passed_us, tablet_events_);
  if (agreed && trace.divergence()) notices_.tell(replay::error_of(*trace.divergence()).line(), true);
  if (!trace.is_session()) return;
  // What its pen did to panels and tools is in its lines, in px of the window that it was drawn in.
  canvas_.show_played();
  controls_.show_new();
  if (trace.finished()) editing_.set_tool(editing_.editor().tool());
}

void App::advance() {
  const std::int64_t now = options_.clock();
  // A frame that took long does not make a recording jump: what its pen pressed has to be seen first.
  const bool shown = laid_out_ && last_frame_us_ != 0;
  const std::int64_t passed = now - std::max(last_frame_us_, player_.began_us);
  last_frame_us_ = now;
  // Nobody reads what stands behind a dialog.
  if (!(dialogs_.open() == Dialog::none)) notices_.wait();
  notices_.expire();
  if (const auto asked = cast_.take_asked()) files_.work_on(*asked);
  canvas_.commit();
  // Before the first frame nothing is known of what is hit, and keys would do nothing.
  if (player_.trace && shown) play_trace(std::min(passed, k_longest_step_us));
  held_keys_.follow_tool();
  follow_habits();
  film_.follow();
  system_dialogs_.follow();
  dials_.follow();
  playback_.others_end(cast_.several() ? cast_.last_key_s() : 0);
  playback_.advance(now);
  sound_.follow(now);
  cameras_.follow();
  references_.follow();
  drops_.follow();
  first_pass_.follow();
  controls_.swing(now);
  features_.follow(playback_.time_s(), playback_.playing() || performer_.performing());
  // What was said of a stroke is over with the next one that does something, and with another tool.
  const auto now_is = std::pair(editing_.revision(), &tool_.now());
  if (std::exchange(last_revision_and_tool_, now_is) != now_is) {
    notices_.take_away([](const Notice& one) { return one.text.starts_with(k_nothing_changed); });
  }
  controls_.tell_new_doubts();
  editing_.moments().look_at(playback_.shown_moment());
  rest_wait_us_ = wait_for_rest(now);
  editing_.shown().hold_still(rest_wait_us_ > 0);
  editing_.shown().follow_pen();
  performer_.follow(now);
  controls_.tell_doubt_of_feature();
  offer_.follow(editing_);
  overlap_.follow();
  const bool quiet = offer_.open() || overlap_.open() || tour_.active() || player_.plays_session() ||
                     playback_.playing() || performer_.performing() || sketches(editing_.editor().tool());
  readings_.follow(editing_, quiet, panels_.face_line_asked(editing_.document()));
}

std::int64_t App::wait_for_rest(std::int64_t now_us) {
  if (!options_.slow_screen || !editing_.pen_is_drawing()) {
    rests_since_us_ = now_us;
    return 0;
  }
  const PxPoint at = place_.at();
  if (std::hypot(at.x - rests_at_.x, at.y - rests_at_.y) > k_tremble_px * canvas_.scale()) {
    rests_at_ = at;
    rests_since_us_ = now_us;
  }
  return std::max<std::int64_t>(0, rests_since_us_ + k_rest_us - now_us);
}

void App::follow_habits() {
  Habits habits;
  // What is played has its own commands.
  if (!player_.plays_session()) {
    habits.mirrors = playback_.while_drawing().mirrors;
    if (playback_.while_drawing().auto_key && !overlap_.open() && !playback_.playing() && !performer_.performing())
      habits.keys.emplace(playback_.time_s(), keys_.name_at(playback_.time_s()));
  }
  editing_.habits() = habits;
}

void App::begin_frame() {
  advance();
  canvas_.surface().update(editing_.shown().model(), editing_.shown().pose());
  if (cast_.several()) cast_.follow(playback_.time_s(), playback_.playing());
  cast_note_.follow();
  CurveLook look;
  look.scale = static_cast<float>(canvas_.scale());
  // Lines of the moment in which a performance began are those that it pulls at.
  look.time_s = performer_.performing() ? editing_.document().time_s : playback_.time_s();
  look.window = canvas_.window();
  look.stabiliser = preferences_.settings().stabiliser;
  look.tool = &tool_.now();
  follow_ghosts(look.time_s);
  look.ghosts = ghosts_.drawings();
  drawing_.veil = ghosts_.veil();
  look.handles = look.tool->selects;
  look.deformer = controls_.shown();
  // Else where the features are is found once the pen comes near the face.
  look.all_features = features_.shown() || look.tool->kind == drawing::ToolKind::feature;
  const bool looks_for = look.tool->kind == drawing::ToolKind::draw || look.tool->pulls;
  look.features = !playback_.playing() && !performer_.performing() && panels_.shown &&
                  (look.all_features || (looks_for && hits_.on_canvas(place_.at())));
  if (look.tool->shows_arcs)
    look.arcs = arcs_.of(editing_.document(), editing_.features(), canvas_.view(), playback_.rate());
  curves_.add_to(look, place_.at());
  tour_.follow();
  drawing_.curves = shown_curves(editing_, canvas_.surface(), look);
  files_.follow();
  recording_.follow();
}

void App::follow_ghosts(double time_s) {
  const bool draws = tool_.now().shows_ghosts;
  // What is played is looked at as it will be seen.
  const bool shown = (look_.onion_skin || draws) && editing_.moments().any();
  std::optional<PxPoint> pen;
  if (draws && hits_.on_canvas(place_.at())) pen = place_.at();
  ghosts_.follow(shown ? std::optional(time_s) : std::nullopt, pen);
}

int App::next_frame_ms() {
  if (leaving_.wants_quit()) return 0;
  if (playback_.playing() || performer_.performing() || controls_.swings() || !panel_input_.pointer().empty())
    return options_.slow_screen && panel_input_.pointer().empty() ? k_slow_frame_ms : k_playing_frame_ms;
  if (rest_wait_us_ > 0) return static_cast<int>(rest_wait_us_ / 1000) + 1;
  if (player_.trace && player_.trace->playing()) {
    return static_cast<int>(std::clamp<std::int64_t>(player_.trace->next_in_us() / 1000, 1, 1000));
  }
  if (readings_.searches()) return 0;
  if (dials_.waits()) return k_dial_look_ms;
  if (film_.writes()) return k_film_look_ms;
  if (first_pass_.listens()) return k_dial_look_ms;
  if ((look_.backdrop && look_.backdrop->loading()) || references_.reads() != nullptr) return k_playing_frame_ms;
  if (!drops_.reads().empty()) return k_film_look_ms;
  if (keys_.shines() && !options_.slow_screen) return k_playing_frame_ms;
  if (ghosts_.waits()) return k_dial_look_ms;
  int next_ms = -1;
  for (const int ms : {notices_.next_frame_ms(), sound_.next_frame_ms(), system_dialogs_.next_frame_ms()}) {
    if (ms >= 0) next_ms = next_ms < 0 ? ms : std::min(next_ms, ms);
  }
  return next_ms;
}

}  // namespace penpose::app
