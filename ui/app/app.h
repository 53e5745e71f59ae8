// One file above the usual size: the class that panels, pens and files meet in. What it does is in a file a subject
// (app_*.cpp).
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "replay/session/session_player.h"
#include "ui/app/action.h"
#include "ui/app/canvas/canvas.h"
#include "ui/app/controls/controls.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/dialogs/entries.h"
#include "ui/app/files/player.h"
#include "ui/app/input/hand_desk.h"
#include "ui/app/input/touch_gestures.h"
#include "ui/app/notices.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/playback/film_writer.h"
#include "ui/app/playback/keys.h"
#include "ui/app/playback/performer.h"
#include "ui/app/playback/playback.h"
#include "ui/app/preferences.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/session/session_files.h"
#include "ui/app/session/suggestion_offer.h"
#include "ui/app/tour/tour_guide.h"
#include "ui/app/view/shown_curves.h"

namespace penpose::app {

struct AppOptions {
  Folders folders;                         ///< empty members: nothing is kept
  std::string session;                     ///< the first session is written there instead
  EditingSession::Clock clock;             ///< microseconds, never goes back
  std::function<std::string()> date = {};  ///< names sessions: "2026-05-31_14-02-11"; empty: "session"
  std::string program = "penpose";
  const decode::TabletTable* own_tablets = nullptr;
};

/// Where the pointer is for the panels, in the order in which it went there.
struct PanelPointer {
  PxPoint at;
  bool down = false;
};

enum class MouseButton : std::uint8_t { left, middle, right };

/// The app without its window: events in, a document and things to show out. SDL, ImGui and OpenGL are elsewhere.
class App : private TracePlayer::Listener {
 public:
  explicit App(AppOptions options);
  ~App() override;
  App(const App&) = delete;
  App& operator=(const App&) = delete;

  /// A model, a project, or a session, whose end is gone on from; "tour:NAME" begins a tour.
  base::Status open(const std::string& path);
  /// The same with the notice of a refusal.
  void try_open(const std::string& path);
  /// Plays a trace into the document in place of a tablet.
  base::Status play_trace(const std::string& path);
  base::Status save(const std::string& path);
  /// Writes a copy for other programs; the work stays where it is saved.
  base::Status export_to(const std::string& path);
  /// Saves, and goes on with what waited for it.
  void save_from_dialog(const std::string& path);
  // Answers to the question about unsaved work.
  void save_first();
  void go_on_without_saving();
  /// Goes on from a session that a crash has ended, or lets it be.
  void recover(bool yes);
  void do_action(Action action);
  /// The curve under the pen.
  void delete_highlighted();
  void keep_highlighted();

  // Events, in px of the window.
  void resized(geometry::Viewport window, double dpi);
  void mouse_moved(PxPoint at);
  void mouse_button(MouseButton button, bool down, PxPoint at, bool shift = false, bool ctrl = false);
  void wheel(double steps);
  void finger(FingerKind kind, std::int64_t finger, PxPoint at);
  /// A key that no text field wants.
  void key(const KeyStroke& key);
  void tablet_arrived(int device, const decode::DeviceIdentity& identity);
  /// The lights that are on beside the dials of a tablet that has arrived.
  void lights_seen(int device, const decode::Lights& lights);
  /// The lights that a device is to show, nothing where it has none.
  [[nodiscard]] std::optional<decode::Lights> lights_of(int device) const;
  void tablet_left(int device, const std::string& name);
  void tablet_report(int device, std::int64_t received_us, base::Bytes bytes);
  void pointer_left();

  /// Brings the document and what follows the pen up to now.
  void advance();
  /// The same, and what is shown, before a frame is made. Panels come after it.
  void begin_frame();
  /// Milliseconds until the next frame is due without any event; -1: only an event makes one.
  [[nodiscard]] int next_frame_ms() const;
  [[nodiscard]] bool wants_quit() const { return quit_; }
  /// Asks about unsaved work first.
  void ask_to_quit();
  void quit() { quit_ = true; }
  /// Quits without asking, because nobody can answer: unsaved work is offered at the next start.
  void quit_at_once();

  // Who has what.
  [[nodiscard]] EditingSession& editing() { return editing_; }
  [[nodiscard]] const EditingSession& editing() const { return editing_; }
  [[nodiscard]] Notices& notices() { return notices_; }
  [[nodiscard]] Preferences& preferences() { return preferences_; }
  [[nodiscard]] Canvas& canvas() { return canvas_; }
  [[nodiscard]] const Canvas& canvas() const { return canvas_; }
  [[nodiscard]] Controls& controls() { return controls_; }
  [[nodiscard]] Playback& playback() { return playback_; }
  [[nodiscard]] Keys& keys() { return keys_; }
  [[nodiscard]] Performer& performer() { return performer_; }
  [[nodiscard]] FilmWriter& film() { return film_; }
  [[nodiscard]] Player& player() { return player_; }
  [[nodiscard]] const Player& player() const { return player_; }
  [[nodiscard]] Dialogs& dialogs() { return dialogs_; }
  [[nodiscard]] PanelState& panels() { return panels_; }
  [[nodiscard]] SuggestionOffer& offer() { return offer_; }
  [[nodiscard]] TourGuide& tour() { return tour_; }
  /// The tablet's own part of the settings, which every tablet takes over at once.
  void tablet_setting_changed();
  [[nodiscard]] HandDesk& desk() { return desk_; }
  /// What a key, a dial or a button of a pen does.
  [[nodiscard]] Binding bound(const DeskTablet& tablet, const PadControl& control) const;
  /// Binds it to something else; nothing: to what it does where nobody has chosen.
  void bind(const DeskTablet& tablet, const PadControl& control, std::optional<Binding> binding);
  /// What a tablet's dial does now.
  [[nodiscard]] std::int8_t dial_mode(const DeskTablet& tablet, std::uint8_t side) const;
  /// Panels are laid out: from now on it is known what is hit.
  void lay_out() { laid_out_ = true; }
  [[nodiscard]] std::deque<PanelPointer>& panel_pointer() { return panel_pointer_; }
  [[nodiscard]] double take_wheel() { return std::exchange(panel_wheel_, 0.0); }
  [[nodiscard]] const std::vector<render::CurveDrawing>& curves() const { return curves_; }
  [[nodiscard]] const std::vector<std::string>& abandoned() const { return abandoned_; }
  [[nodiscard]] const AppOptions& options() const { return options_; }
  [[nodiscard]] const std::string& project() const { return project_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::string session_path() const { return file_ ? file_->path() : std::string(); }
  /// What is done is being written down.
  [[nodiscard]] bool recording() const { return file_ && !file_->writer().broken(); }
  /// The step of the drawing and what to do next, in one line.
  [[nodiscard]] std::string hint() const;

  /// Opens a file, after asking about unsaved work.
  void ask_to_open(const std::string& path);

 private:
  void begin_session(document::Document document, const std::string& path);
  void end_session();
  base::Result<replay::Playback> played_session(const std::string& path);
  /// Goes on with a session that a crash has ended, in its own file.
  base::Status bring_back(const std::string& path);
  void resume(replay::Playback played, std::unique_ptr<SessionFile> file);
  void set_project(const std::string& path);
  void show_anew();
  void take_moments(int device, std::span<const replay::PenMoment> moments);
  void take_pen_button(int device, const replay::PenMoment& moment);
  void turn_pen_dials(int device, const replay::PenMoment& moment);
  void take_hand(std::span<const replay::HandMoment> moments);
  void take_pad_event(DeskTablet& tablet, int device, const decode::PadEvent& event);
  void press(DeskTablet& tablet, int device, const PadControl& control);
  void let_go(int device, const PadControl& control);
  void hold_tools();
  void place_pen();
  [[nodiscard]] const ViewHold* held_view() const;
  void turn_dial(DialUse use, int device, const PadControl& control, std::int32_t steps);
  void turn_control(double notches);
  void end_dial();
  void take_fingers(int device);
  void do_gesture(const TouchAct& act);
  [[nodiscard]] bool fingers_move_view() const;
  [[nodiscard]] PxPoint place_of_finger(int device, const decode::TouchContact& contact) const;
  void tell_battery(DeskTablet& tablet, int device);
  /// A wireless receiver hears another tablet, or none any more.
  void change_tablets(std::span<const replay::HandMoment> moments);
  /// That the session's file cannot be written, and that it can again.
  void tell_of_recording();
  /// What was held on a device that goes, for the message: "; Key 2 (Undo) was held and is let go".
  [[nodiscard]] std::string held_until_now(int device, std::span<const replay::HandMoment> let_go) const;
  [[nodiscard]] replay::TabletSetting setting_of(int device) const;
  [[nodiscard]] std::uint32_t drawing_buttons(int device) const;
  void forget_tablet(int device, const std::string& name, std::span<const replay::HandMoment> let_go);
  // What a trace that is played in place of tablets does.
  void on_device(int device, const decode::DeviceIdentity& identity) override;
  void on_moments(int device, std::span<const replay::PenMoment> pen,
                  std::span<const replay::HandMoment> hand) override;
  void on_gone(int device) override;
  void pen_pressed(PxPoint at);
  void pen_moved(PxPoint at);
  void pen_released(PxPoint at);
  void hover(PxPoint at);
  void hover_panels(PxPoint at, bool down);
  void try_pen(PxPoint at, double pressure, bool begins);
  void begin_drag(PxPoint at);
  void drag_to(PxPoint at, bool pan, bool zoom);
  void end_barrel(PxPoint at);
  void select_at(PxPoint at);
  [[nodiscard]] bool take_control_target(PxPoint at);
  [[nodiscard]] std::optional<document::PullBetween> control_pull(PxPoint at) const;
  void hold_line(const std::vector<geometry::ModelPoint>& line, PxPoint at);
  void follow_habits();
  [[nodiscard]] bool tablet_is_near() const;

  AppOptions options_;
  Notices notices_;
  Preferences preferences_;
  std::unique_ptr<SessionFile> file_;
  bool keep_file_ = false;  ///< a session that was asked for by name is kept, whatever is in it
  EditingSession editing_;
  Player player_;
  PanelState panels_;
  Dialogs dialogs_;
  Canvas canvas_;
  Controls controls_;
  Playback playback_;
  Keys keys_;
  Performer performer_;
  FilmWriter film_;
  SuggestionOffer offer_;
  TourGuide tour_;
  std::deque<PanelPointer> panel_pointer_;
  double panel_wheel_ = 0;
  std::vector<render::CurveDrawing> curves_;
  std::vector<std::string> abandoned_;
  TouchGestures touch_;
  std::string project_;                                       ///< where Save writes; empty: it asks
  std::string path_;                                          ///< what was opened
  std::map<int, decode::DeviceIdentity> tablets_;             ///< that were ever there
  std::map<int, std::vector<std::uint8_t>> receiver_status_;  ///< what receivers said last
  std::map<int, decode::Lights> lights_;                      ///< that are on beside the dials of tablets
  std::set<int> plugged_;                                     ///< those of them that are
  HandDesk desk_;
  std::map<int, TouchGestures> raw_touch_;    ///< by interface
  std::int64_t raw_gesture_us_ = -1;          ///< when fingers on a tablet last moved the view
  std::optional<drawing::Tool> tool_before_;  ///< a key holds another one
  std::optional<drawing::ToolKind> tool_held_;
  std::optional<ViewHold> pen_view_;    ///< a button of the pen moves the view
  std::optional<ViewHold> touch_view_;  ///< the pen's tip does, while a key is held
  std::optional<DialUse> dial_;         ///< a dial is being turned
  bool dial_touched_ = false;           ///< by a finger that will let go
  std::int64_t dial_us_ = 0;            ///< when it last was
  std::string dial_control_;            ///< the control that it changes
  double dial_value_ = 0;

  PxPoint at_;                   ///< the pointer's last place
  bool mouse_draws_ = false;     ///< the left button is held on the canvas
  bool mouse_on_panel_ = false;  ///< or on a panel
  std::optional<PxPoint> drag_;  ///< the view is being moved, last place
  bool drag_pans_ = false;
  bool drag_zooms_ = false;
  bool drag_moved_ = false;
  bool barrel_ = false;  ///< dragged by the pen's or the right button: a click opens the radial menu
  std::optional<document::CurveId> highlighted_;
  std::optional<std::pair<document::CurveId, PxPoint>> target_drag_;
  std::optional<PullHold> pull_;  ///< the target in hand is held at a place; nothing: all of it
  /// A target of the chosen control in hand: its value, and where it was taken.
  std::optional<std::pair<double, PxPoint>> control_drag_;
  bool whole_ = false;                              ///< a modifier is held: lines are moved as a whole
  std::optional<document::CurveId> touched_curve_;  ///< by the tool select
  std::int64_t tablet_seen_us_ = -1;
  bool tablet_near_ = false;
  std::int64_t last_frame_us_ = 0;
  bool laid_out_ = false;
  bool quit_ = false;
  bool leaves_work_ = false;  ///< the session stays as after a crash
  std::pair<std::uint64_t, drawing::ToolKind> refused_at_;
  bool broken_told_ = false;  ///< that the session cannot be written any more
};

}  // namespace penpose::app
