#pragma once

#include <string>

#include "ui/app/panels/panels.h"
#include "ui/app/poses/pose_shelf.h"

// What the panels of poses have in common.

namespace penpose::app {

/// The parts of a face in a row, of which one is chosen.
void show_part_buttons(PanelContext& context, FacePart& part, const char* tip);

/// The library: pictures to take by a touch, what is done to their files, and keeping.
void show_pose_shelf(PanelContext& context, PoseShelf& poses, EditingSession& editing, PanelState& panels,
                     FacePart& part);

/// A name that no pose of the library has: "pose 3".
[[nodiscard]] std::string usual_pose_name(const PoseShelf& shelf);

}  // namespace penpose::app
