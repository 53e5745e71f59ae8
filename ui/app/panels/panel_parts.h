#pragma once

#include "ui/app/controls/controls.h"
#include "ui/app/controls/restriction.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/mouths/kept_mouths.h"
#include "ui/app/panels/panels.h"
#include "ui/app/playback/playback.h"
#include "ui/app/poses/pose_shelf.h"
#include "ui/app/session/suggestion_offer.h"

// Parts of panels that stand in other panels.

namespace penpose::app {

/// All parameters, as sliders.
void show_parameters(PanelContext& context, EditingSession& editing, Controls& controls, Dialogs& dialogs,
                     PanelState& panels, Restriction& restriction);
/// The sketched controls, and new ones.
void show_deformers(PanelContext& context, EditingSession& editing, Canvas& canvas, Controls& controls,
                    Notices& notices, Dialogs& dialogs, PanelState& panels);
/// The corrections that there are, and what can be done with each.
void show_corrections(PanelContext& context, EditingSession& editing, Controls& controls, PanelState& panels);
/// Poses that are keyed, and those of the library, to be taken again.
void show_poses(PanelContext& context, EditingSession& editing, Playback& playback, PanelState& panels,
                PoseShelf& shelf);
/// The mouths that speech is drawn with.
void show_mouths(PanelContext& context, EditingSession& editing, KeptMouths& kept, Dialogs& dialogs,
                 PanelState& panels);
/// Asks for the rest of the face; grey, and saying why, while there are too few keys.
void show_suggest_button(PanelContext& context, EditingSession& editing, SuggestionOffer& offer, float width = -1,
                         bool words = true);

/// How the toolbar stands in its place.
struct ToolbarLayout {
  bool words = true;  ///< beside the icons
  int across = 1;     ///< buttons side by side
  float width = 0;    ///< of the panel, px
};
/// One column with words where the tools have room in `height` px, else icons alone, two or three side by side.
[[nodiscard]] ToolbarLayout toolbar_layout(const PanelContext& context, float height);

}  // namespace penpose::app
