#include <array>
#include <type_traits>

#include "ui/app/owners.h"
#include "ui/app/panels/panels.h"

namespace penpose::app {

// Each stands in a file of its own. A new one is that file, a line here and a row below.
void show_top_bar(PanelContext&, const Area&, Canvas&, CanvasLook&, Playback&, Recording&, Preferences&);
void show_toolbar(PanelContext&, const Area&, EditingSession&, SuggestionOffer&, ToolInHand&);
void show_side_panel(PanelContext&, const Area&, EditingSession&, Canvas&, Controls&, Playback&, Notices&, KeptMouths&,
                     Dialogs&, PanelState&, PoseShelf&, Restriction&);
void show_status(PanelContext&, const Area&, EditingSession&, CanvasLook&, ToolInHand&);
void show_timeline(PanelContext&, const Area&, EditingSession&, CanvasLook&, Playback&, Keys&, Performer&, TourGuide&,
                   Notices&, Dialogs&, PanelState&, SoundTrack&, OverlapOffer&, GhostHand&, CameraDesk&);
void show_timeline_grip(PanelContext&, const Area&, Canvas&, Preferences&, PanelState&);
void show_player(PanelContext&, const Area&, Player&);
void show_tour(PanelContext&, const Area&, TourGuide&, Files&);
void show_backdrop(PanelContext&, const Area&, Canvas&, CanvasLook&, Playback&, ReferenceDesk&, Dialogs&);
void show_axes(PanelContext&, const Area&, Canvas&, Dialogs&, PanelState&);
void show_face_labels(PanelContext&, const Area&, EditingSession&, Canvas&, PanelState&);
void show_feature_names(PanelContext&, const Area&, EditingSession&, Canvas&, PanelState&);
void show_feature_menu(PanelContext&, const Area&, EditingSession&, Canvas&, PanelState&, Restriction&);
void show_curve_menu(PanelContext&, const Area&, EditingSession&, Canvas&, Controls&, ReadingOffer&, PanelState&,
                     Restriction&);
void show_suggestion(PanelContext&, const Area&, EditingSession&, Canvas&, SuggestionOffer&);
void show_overlap(PanelContext&, const Area&, EditingSession&, Canvas&, OverlapOffer&);
void show_readings(PanelContext&, const Area&, EditingSession&, Canvas&, ReadingOffer&, PanelState&);
void show_canvas_chips(PanelContext&, const Area&, EditingSession&, Playback&, Performer&, ToolInHand&, Controls&,
                       Restriction&);
void show_film(PanelContext&, const Area&, Canvas&, FilmWriter&);
void show_cast(PanelContext&, const Area&, Canvas&, Cast&, ToolInHand&, PanelState&);
void show_notices(PanelContext&, const Area&, Canvas&, CanvasDrawing&, Notices&, Dialogs&);
void show_radial_menu(PanelContext&, const Area&, Canvas&, Preferences&, PanelState&);
void show_tour_ghost(PanelContext&, const Area&, Canvas&, TourGuide&, Dialogs&);

namespace {

using Show = void (*)(PanelContext& context, const Area& area, App& app);

struct PanelRow {
  PanelPlace place;
  Show show;
};

template <typename... Owners>
void call_panel(PanelContext& context, const Area& area, App& app,
                void (*panel)(PanelContext&, const Area&, Owners&...)) {
  panel(context, area, app.of<std::remove_const_t<Owners>>()...);
}

/// A panel with the owners that it takes.
template <auto panel>
void show(PanelContext& context, const Area& area, App& app) {
  call_panel(context, area, app, panel);
}

/// Those of one place are shown in this order.
constexpr std::array k_panels{
    PanelRow{PanelPlace::top, show<show_top_bar>},
    PanelRow{PanelPlace::left, show<show_toolbar>},
    PanelRow{PanelPlace::right, show<show_side_panel>},
    PanelRow{PanelPlace::status, show<show_status>},
    PanelRow{PanelPlace::timeline, show<show_timeline>},
    PanelRow{PanelPlace::timeline, show<show_timeline_grip>},
    PanelRow{PanelPlace::player, show<show_player>},
    PanelRow{PanelPlace::tour, show<show_tour>},
    PanelRow{PanelPlace::canvas, show<show_backdrop>},
    PanelRow{PanelPlace::canvas, show<show_axes>},
    PanelRow{PanelPlace::canvas, show<show_face_labels>},
    PanelRow{PanelPlace::canvas, show<show_feature_names>},
    PanelRow{PanelPlace::canvas, show<show_canvas_chips>},
    PanelRow{PanelPlace::canvas, show<show_curve_menu>},
    PanelRow{PanelPlace::canvas, show<show_feature_menu>},
    PanelRow{PanelPlace::canvas, show<show_suggestion>},
    PanelRow{PanelPlace::canvas, show<show_overlap>},
    PanelRow{PanelPlace::canvas, show<show_readings>},
    PanelRow{PanelPlace::canvas, show<show_film>},
    PanelRow{PanelPlace::canvas, show<show_cast>},
    PanelRow{PanelPlace::canvas, show<show_notices>},
    PanelRow{PanelPlace::window, show<show_radial_menu>},
    PanelRow{PanelPlace::window, [](PanelContext& context, const Area&, App& app) { show_dialog(context, app); }},
    PanelRow{PanelPlace::window, show<show_tour_ghost>},
};

}  // namespace

void show_panels(PanelContext& context, App& app, PanelPlace place, const Area& area) {
  for (const PanelRow& row : k_panels) {
    if (row.place == place) row.show(context, area, app);
  }
}

}  // namespace penpose::app
