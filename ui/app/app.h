#pragma once

#include <functional>
#include <string>
#include <tuple>

#include "ui/app/actions.h"
#include "ui/app/camera/camera_desk.h"
#include "ui/app/canvas/canvas.h"
#include "ui/app/canvas/curves_in_hand.h"
#include "ui/app/canvas/undrawn_textures.h"
#include "ui/app/cast/cast.h"
#include "ui/app/cast/cast_note.h"
#include "ui/app/controls/controls.h"
#include "ui/app/controls/restriction.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/dialogs/entries.h"
#include "ui/app/face/kept_features.h"
#include "ui/app/files/drop_desk.h"
#include "ui/app/files/files.h"
#include "ui/app/files/leaving.h"
#include "ui/app/files/player.h"
#include "ui/app/files/recording.h"
#include "ui/app/files/recovery.h"
#include "ui/app/files/system_dialogs.h"
#include "ui/app/film/film_writer.h"
#include "ui/app/hands/tablet_events.h"
#include "ui/app/input/pointer.h"
#include "ui/app/mouths/first_pass.h"
#include "ui/app/mouths/kept_mouths.h"
#include "ui/app/notices.h"
#include "ui/app/panels/panel_entries.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/playback/ghosts.h"
#include "ui/app/playback/keys.h"
#include "ui/app/playback/performer.h"
#include "ui/app/playback/playback.h"
#include "ui/app/playback/sheet/overlap_offer.h"
#include "ui/app/poses/pose_shelf.h"
#include "ui/app/preferences.h"
#include "ui/app/reference/reference_desk.h"
#include "ui/app/session/reading_offer.h"
#include "ui/app/session/suggestion_offer.h"
#include "ui/app/sound/sound_track.h"
#include "ui/app/tools/tool_in_hand.h"
#include "ui/app/tour/tour_guide.h"

namespace penpose::app {

struct AppOptions {
  Folders folders;                         ///< empty members: nothing is kept
  std::string session;                     ///< where to write the first session; empty: in the state folder
  EditingSession::Clock clock;             ///< microseconds, never goes back
  std::function<std::string()> date = {};  ///< names sessions: "2026-05-31_14-02-11"; empty: "session"
  std::string program = "penpose";
  const decode::TabletTable* own_tablets = nullptr;
  bool slow_screen = false;  ///< nothing moves by itself, and while the pen draws the face waits until it rests
  double scale = 0;          ///< of the interface, before all else that says it; 0: settings and system do
  PanelTurn panel = {};      ///< how the panel is mounted that pens may be built into
};

/// The app without its window: it holds the owners, each with one subject, and updates them every frame. SDL, ImGui and
/// OpenGL are elsewhere.
class App {
 public:
  explicit App(AppOptions options);
  ~App();
  App(const App&) = delete;
  App& operator=(const App&) = delete;

  /// An owner, by its type. Tables of actions, panels and dialogs name what they take (owners.h); nobody else needs
  /// this but the window and tests.
  template <typename Owner>
  [[nodiscard]] Owner& of() {
    return std::get<Owner&>(owners_);
  }

  /// Brings the document and what follows the pen up to now.
  void advance();
  /// advance(), then what is to be shown. Call it before the panels.
  void begin_frame();
  /// Milliseconds until the next frame is due without any event; -1: only an event makes one.
  [[nodiscard]] int next_frame_ms();
  /// The panels have been laid out: hits can be told apart from now on.
  void lay_out() { laid_out_ = true; }

 private:
  /// Another document was opened.
  void show_anew();
  /// Another character of the scene is worked on.
  void show_character();
  void play_trace(std::int64_t passed_us);
  void follow_habits();
  void follow_ghosts(double time_s);
  /// On a slow screen, microseconds until a pen that draws has rested long enough for the face to follow; 0: it may.
  [[nodiscard]] std::int64_t wait_for_rest(std::int64_t now_us);

  AppOptions options_;
  Notices notices_;
  Preferences preferences_;
  EditingSession editing_;
  Recording recording_;
  Player player_;
  HitMap hits_;
  CanvasLook look_;
  CanvasDrawing drawing_;
  PanelState panels_;
  Dialogs dialogs_;
  Actions actions_;
  Canvas canvas_;
  Cast cast_;
  CastNote cast_note_;
  KeptFeatures features_;
  Controls controls_;
  Restriction restriction_;
  Playback playback_;
  Keys keys_;
  OverlapOffer overlap_;
  CameraDesk cameras_;
  Performer performer_;
  SuggestionOffer offer_;
  ReadingOffer readings_;
  ArcsInSight arcs_;
  GhostHand ghosts_;
  ToolInHand tool_;
  CurvesInHand curves_;
  TourGuide tour_;
  UndrawnTextures undrawn_;
  Files files_;
  SoundTrack sound_;
  ReferenceDesk references_;
  FilmWriter film_;
  KeptMouths mouths_;
  FirstPass first_pass_;
  PoseShelf shelf_;
  Leaving leaving_;
  SystemDialogs system_dialogs_;
  DropDesk drops_;
  Recovery recovery_;
  HandDesk desk_;
  KnownTablets tablets_;
  Bindings bindings_;
  PointerPlace place_;
  PanelInput panel_input_;
  ViewDrag drag_;
  Dials dials_;
  HeldKeys held_keys_;
  TabletFingers fingers_;
  Pens pens_;
  Pointer pointer_;
  TabletEvents tablet_events_;
  std::tuple<EditingSession&, Notices&, Preferences&, Recording&, Player&, HitMap&, CanvasLook&, CanvasDrawing&,
             PanelState&, Dialogs&, Actions&, Canvas&, Controls&, Playback&, Keys&, Performer&, FilmWriter&,
             SuggestionOffer&, ReadingOffer&, ToolInHand&, CurvesInHand&, TourGuide&, Files&, Leaving&, Recovery&,
             HandDesk&, Bindings&, PanelInput&, Pointer&, TabletEvents&, UndrawnTextures&, SoundTrack&, OverlapOffer&,
             GhostHand&, KeptMouths&, FirstPass&, SystemDialogs&, PoseShelf&, KeptFeatures&, Restriction&, CameraDesk&,
             ReferenceDesk&, DropDesk&, Cast&>
      owners_;
  std::int64_t last_frame_us_ = 0;
  bool laid_out_ = false;
  std::pair<std::uint64_t, const WindowTool*> last_revision_and_tool_;
  PxPoint rests_at_;  ///< where the pen has been
  std::int64_t rests_since_us_ = 0;
  std::int64_t rest_wait_us_ = 0;
};

}  // namespace penpose::app
