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

#include "core/articulation/sketched_deformers.h"
#include "replay/session/session_player.h"
#include "ui/app/action.h"
#include "ui/app/dialogs/film_job.h"
#include "ui/app/input/hand_desk.h"
#include "ui/app/input/touch_gestures.h"
#include "ui/app/input/trace_player.h"
#include "ui/app/session/loop_range.h"
#include "ui/app/session/performance.h"
#include "ui/app/session/pose_clipboard.h"
#include "ui/app/session/pose_library.h"
#include "ui/app/session/session_files.h"
#include "ui/app/session/settings.h"
#include "ui/app/session/suggestion_offer.h"
#include "ui/app/session/workspace.h"
#include "ui/app/tour/tour_guide.h"
#include "ui/app/view/hit_map.h"
#include "ui/app/view/posed_surface.h"
#include "ui/app/view/shown_curves.h"
#include "ui/render/framing.h"

namespace penpose::app {

struct AppOptions {
  Folders folders;                         ///< empty members: nothing is kept
  std::string session;                     ///< the first session is written there instead
  Workspace::Clock clock;                  ///< microseconds, never goes back
  std::function<std::string()> date = {};  ///< names sessions: "2026-05-31_14-02-11"; empty: "session"
  std::string program = "penpose";
  const decode::TabletTable* own_tablets = nullptr;
};

/// Something that is said for a while.
struct Notice {
  std::string text;
  bool is_error = false;
  std::int64_t until_us = 0;
};

/// Where the pointer is for the panels, in the order in which it went there.
struct PanelPointer {
  PxPoint at;
  bool down = false;
};

enum class MouseButton : std::uint8_t { left, middle, right };
enum class Dialog : std::uint8_t {
  none,
  open,
  save,
  export_as,
  recent,
  recover,
  steps,
  tablet,
  pad,
  sessions,
  unsaved,
  number,
  key_name,
  radial,
  shortcuts,
  search,
  history,
  film,
  backdrop
};

/// A number being typed for a parameter.
struct NumberEntry {
  enum class Field : std::uint8_t { value, least, most };
  std::string parameter;
  std::string text;
  Field field = Field::value;
};

/// What panels show beside the document. Nothing of it is saved.
struct PanelState {
  bool shown = true;
  bool controls_tab = false;  ///< of the side panel: sketched controls, else all parameters
  Dialog dialog = Dialog::none;
  bool poses_tab = false;               ///< the poses that are keyed, in place of both
  PoseChoice chosen_pose;               ///< of them
  bool blending = false;                ///< it is being blended in
  std::string filter;                   ///< of the parameters
  std::string deformer;                 ///< the one that is selected
  std::string scrolled_to;              ///< the one that its list was last scrolled to
  std::set<std::string> folded_groups;  ///< of the parameters
  NumberEntry number;
  std::string key_name;                               ///< what is being typed
  bool cursor_placed = true;                          ///< in the field of a dialog that has just taken the keyboard
  std::size_t radial_place = 0;                       ///< that is being chosen for
  bool has_keyboard = false;                          ///< a key was pressed on one
  double time_s = 0;                                  ///< of the timeline's cursor
  double from_s = 0;                                  ///< the first moment that the timeline shows
  double seen_time_s = 0;                             ///< where the cursor was last brought into sight
  double span_s = 0;                                  ///< how much of it; 0: all
  std::optional<std::pair<double, double>> key_drag;  ///< a key in hand: from, to
  bool onion_skin = true;
  int rate = k_usual_rate;  ///< frames a second
  LoopRange loop;
  bool performs = false;    ///< time runs while the pen holds a target, and what the face does is keyed
  bool auto_key = false;    ///< every change of the pose is keyed
  bool mirrors = false;     ///< strokes work on both sides
  bool moved_only = false;  ///< only controls that are not at rest are listed
  std::optional<PoseClipboard> clipboard;
  geometry::Viewport film_size{1280, 720};
  std::string frame_text;         ///< what is being typed as a frame
  std::string search_text;        ///< in the search, and in the list of shortcuts
  std::size_t search_chosen = 0;  ///< of what was found
  bool wireframe = false;
  std::shared_ptr<class Backdrop> backdrop;                     ///< a picture behind the model
  bool swing = false;                                           ///< the control in hand plays to and fro
  articulation::Mode new_mode = articulation::Mode::automatic;  ///< of the next control
  articulation::Surface new_surface;
  std::optional<std::pair<document::CurveId, PxPoint>> curve_menu;  ///< what can be done with a curve, and where
  std::string rename;             ///< what is being typed as a name of the selected control
  std::optional<PxPoint> radial;  ///< middle of the radial menu while it is open
  std::string folder;             ///< of the file dialogs
  std::string file_name;
  std::vector<PxPoint> test_line;  ///< drawn in the test area of the tablet's settings
  std::vector<double> test_pressure;
  Area test_area{};
  std::pair<std::string, std::string> pad_tablet;  ///< whose keys are shown, by key and unit; empty: the first
  PadControl pad_control;                          ///< that something is chosen for
  float pad_height = 0;                            ///< px of the picture of its keys in the last frame
  bool pad_once = false;                           ///< actions are offered, else what holds while a key is held
  std::string after_unsaved;  ///< what to open once the question about unsaved work is answered; empty: quit
  bool saves_first = false;   ///< that question was answered with Save: it is done once something was saved
};

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
  /// Writes a film of what is keyed, seen from where one looks; it goes on beside.
  void write_film(const std::string& path);
  /// Saves, and goes on with what waited for it.
  void save_from_dialog(const std::string& path);
  // Answers to the question about unsaved work.
  void save_first();
  void go_on_without_saving();
  /// Goes on from a session that a crash has ended, or lets it be.
  void recover(bool yes);
  void do_action(Action action);
  void tell(std::string text, bool is_error = false);

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

  [[nodiscard]] Workspace& workspace() { return workspace_; }
  [[nodiscard]] const Workspace& workspace() const { return workspace_; }
  [[nodiscard]] PosedSurface& surface() { return surface_; }
  [[nodiscard]] SuggestionOffer& offer() { return offer_; }
  [[nodiscard]] TourGuide& tour() { return tour_; }
  [[nodiscard]] PanelState& panels() { return panels_; }
  [[nodiscard]] Settings& settings() { return settings_; }
  void settings_changed();
  /// The tablet's own part of them, which every tablet takes over at once.
  void tablet_setting_changed();
  [[nodiscard]] HandDesk& desk() { return desk_; }
  /// What a key, a dial or a button of a pen does.
  [[nodiscard]] Binding bound(const DeskTablet& tablet, const PadControl& control) const;
  /// Binds it to something else; nothing: to what it does where nobody has chosen.
  void bind(const DeskTablet& tablet, const PadControl& control, std::optional<Binding> binding);
  /// What a tablet's dial does now.
  [[nodiscard]] std::int8_t dial_mode(const DeskTablet& tablet, std::uint8_t side) const;
  [[nodiscard]] HitMap& hits() { return hits_; }
  /// Panels are laid out: from now on it is known what is hit.
  void lay_out() { laid_out_ = true; }
  [[nodiscard]] std::deque<PanelPointer>& panel_pointer() { return panel_pointer_; }
  [[nodiscard]] double take_wheel() { return std::exchange(panel_wheel_, 0.0); }
  [[nodiscard]] const std::vector<Notice>& notices() const { return notices_; }
  [[nodiscard]] const std::vector<render::CurveDrawing>& curves() const { return curves_; }
  [[nodiscard]] std::optional<TracePlayer>& player() { return player_; }
  [[nodiscard]] const std::vector<std::string>& abandoned() const { return abandoned_; }
  [[nodiscard]] const AppOptions& options() const { return options_; }
  [[nodiscard]] const std::string& project() const { return project_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::string session_path() const { return file_ ? file_->path() : std::string(); }
  /// What is done is being written down.
  [[nodiscard]] bool recording() const { return file_ && !file_->writer().broken(); }
  [[nodiscard]] bool playing() const { return playing_; }
  /// What the pen does is being keyed frame by frame.
  [[nodiscard]] bool performing() const { return performance_.has_value(); }
  [[nodiscard]] bool fullscreen() const { return fullscreen_; }
  [[nodiscard]] geometry::Viewport window() const { return window_; }
  /// Px of a target that a finger or a pen hits for certain: 9 mm.
  [[nodiscard]] double target_px() const;
  /// Px of the display for each px of an ordinary one.
  [[nodiscard]] double scale() const;
  /// The part of the window that no panel covers.
  [[nodiscard]] Area free_area() const;
  void set_free_area(const Area& area);
  /// The camera as it is shown now.
  [[nodiscard]] const document::View& view() const { return view_; }
  /// Looks from a direction by the model's own front; a view that was zoomed into stays as near as it is.
  void look_from(const render::Viewpoint& viewpoint);
  /// The direction in which one looks, by the model's own front.
  [[nodiscard]] render::Viewpoint looking_from() const;
  /// What is seen from here is the model's front from now on.
  void set_front();
  /// With perspective or without.
  [[nodiscard]] bool flat() const;
  void set_flat(bool on);
  /// Puts a picture behind the model; what cannot be read is told.
  void open_backdrop(const std::string& path);
  /// The step of the drawing and what to do next, in one line.
  [[nodiscard]] std::string hint() const;

  // What panels do.
  /// Names the key at the timeline's cursor, whose pose stays.
  void name_key(const std::string& name);
  /// Moves a key of the timeline; one that is in the way is told.
  void move_key(double from_s, double to_s);
  /// Opens a file, after asking about unsaved work.
  void ask_to_open(const std::string& path);
  void undo();
  void redo();
  /// Undoes or redoes until so many commands are done.
  void go_to_step(std::size_t commands);
  /// Goes to a moment at once, as scrubbing and letting go does.
  void go_to(double time_s);
  void set_rate(int rate);
  void scrub(double time_s);
  void end_scrub();
  void preview_parameter(std::size_t parameter, double value);
  void set_parameter(std::size_t parameter, double value);
  /// How the control that is being sketched, or the next one, moves and what it slides over. Strokes that are drawn
  /// already are drawn again.
  void choose_for_new_control(articulation::Mode mode, const articulation::Surface& surface);
  /// The next stroke draws a curve of a control again; regions in the view in which they were drawn.
  void redraw_control(const std::string& deformer, articulation::CurveRole role);
  void set_swing(bool on);
  /// The next stroke draws another goal of a control, at the value that it shows.
  void draw_between(const std::string& deformer, double value);
  /// Begins to correct the pose as it stands.
  void correct_pose();
  /// Makes the same control on the other side, and takes it in hand.
  void mirror_control(const std::string& deformer);
  void rename_control(const std::string& deformer, const std::string& to);

 private:
  void begin_session(document::Document document, const std::string& path);
  void end_session();
  base::Result<replay::Playback> played_session(const std::string& path);
  /// Goes on with a session that a crash has ended, in its own file.
  base::Status bring_back(const std::string& path);
  void resume(replay::Playback played, std::unique_ptr<SessionFile> file);
  void set_project(const std::string& path);
  void show_anew();
  void frame_from(const render::Viewpoint& from);
  void commit_view();
  void begin_control();
  /// Says so before the goal is drawn where the feature that was found may not be the one that is meant.
  void doubt_feature();
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
  void show_new_deformer();
  /// Says what is doubtful of a control that was changed and was not before.
  void tell_new_doubts();
  void pen_moved(PxPoint at);
  void pen_released(PxPoint at);
  void hover(PxPoint at);
  void hover_panels(PxPoint at, bool down);
  void try_pen(PxPoint at, double pressure, bool begins);
  void begin_drag(PxPoint at);
  void drag_to(PxPoint at, bool pan, bool zoom);
  void end_barrel(PxPoint at);
  void select_at(PxPoint at);
  [[nodiscard]] bool take_goal(PxPoint at);
  [[nodiscard]] std::optional<document::PullBetween> goal_pull(PxPoint at) const;
  void hold_line(const std::vector<geometry::ModelPoint>& line, PxPoint at);
  void suggest_rest();
  void step_key(int direction);
  [[nodiscard]] const document::PoseKey* key_at(double time_s) const;
  [[nodiscard]] std::string name_of_key(double time_s) const;
  void play_on();
  void follow_habits();
  void follow_performance();
  /// Keys what was performed; false where that was nothing.
  bool end_performance();
  void follow_film();
  void follow_time(double was_s);
  void swing();
  [[nodiscard]] bool pen_is_drawing() const;
  [[nodiscard]] bool tablet_is_near() const;

  AppOptions options_;
  Settings settings_;
  std::unique_ptr<SessionFile> file_;
  bool keep_file_ = false;  ///< a session that was asked for by name is kept, whatever is in it
  Workspace workspace_;
  SuggestionOffer offer_;
  TourGuide tour_;
  PosedSurface surface_;
  PanelState panels_;
  HitMap hits_;
  std::deque<PanelPointer> panel_pointer_;
  double panel_wheel_ = 0;
  std::vector<Notice> notices_;
  std::vector<render::CurveDrawing> curves_;
  std::optional<TracePlayer> player_;
  std::unique_ptr<FilmJob> film_;
  std::vector<std::string> abandoned_;
  TouchGestures touch_;
  geometry::Viewport window_{1280, 800};
  double dpi_ = 96;
  Area free_{0, 0, 1280, 800};
  document::View view_;
  render::Viewpoint viewpoint_;
  bool framed_ = false;                            ///< the view still frames the model: it follows the window's size
  std::string project_;                            ///< where Save writes; empty: it asks
  std::string path_;                               ///< what was opened
  std::map<int, decode::DeviceIdentity> tablets_;  ///< that were ever there
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
  std::optional<PullHold> pull_;  ///< the target or the goal in hand is held at a place; nothing: all of it
  /// A goal of the chosen control in hand: its value, and where it was taken.
  std::optional<std::pair<double, PxPoint>> goal_drag_;
  bool whole_ = false;                              ///< a modifier is held: lines are moved as a whole
  std::optional<document::CurveId> touched_curve_;  ///< by the tool select
  std::int64_t tablet_seen_us_ = -1;
  bool tablet_near_ = false;
  std::int64_t last_frame_us_ = 0;
  bool laid_out_ = false;
  bool playing_ = false;
  double play_from_s_ = 0;
  std::optional<Performance> performance_;
  std::size_t performed_steps_ = 0;  ///< that were done when it began
  std::int64_t play_from_us_ = 0;
  std::shared_ptr<const document::PendingSketch> doubted_;  ///< whose feature that was said of
  std::size_t deformer_count_ = 0;                          ///< to tell a new one
  std::size_t correction_count_ = 0;                        ///< likewise
  bool fullscreen_ = false;
  bool quit_ = false;
  bool leaves_work_ = false;  ///< the session stays as after a crash
  std::pair<std::uint64_t, drawing::ToolKind> refused_at_;
  bool broken_told_ = false;                                ///< that the session cannot be written any more
  articulation::SketchedDeformers::Shared seen_deformers_;  ///< of which all doubts are told
};

}  // namespace penpose::app
