#pragma once

#include <optional>

#include "ui/app/panels/panels.h"

namespace penpose::app {

class EditingSession;
class ReadingOffer;

/// How wide and how high the row of other readings of a line of the face is, px, where there is room for `wide`.
struct FaceReadingsSize {
  float picture = 0;  ///< the width of each
  float width = 0, height = 0;
};
[[nodiscard]] FaceReadingsSize face_readings_size(const PanelContext& context, const ReadingOffer& offer, float wide);

/// Shows the faces that the readings make, each with the feature that the line then is, in the panel that was begun.
/// The model shows the one under the pen; a press takes it. True where one was taken. Precondition: there are some.
bool show_face_readings(PanelContext& context, EditingSession& editing, ReadingOffer& offer, float picture);

}  // namespace penpose::app
