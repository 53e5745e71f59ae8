#pragma once

#include "ui/app/camera/camera_desk.h"
#include "ui/app/panels/timeline/timeline_strip.h"

namespace penpose::app {

/// The height of the row, px; 0 where the camera has no key.
[[nodiscard]] double camera_strip_height(const PanelContext& context, const CameraDesk& cameras);
/// What the row is called, which looks through the camera.
void show_camera_name(PanelContext& context, CameraDesk& cameras, float width);
/// The keys of the camera: a touch goes to one, a pull takes it along. Cuts are squares.
void show_camera_strip(PanelContext& context, const TimelineOwners& with, CameraDesk& cameras);

}  // namespace penpose::app
