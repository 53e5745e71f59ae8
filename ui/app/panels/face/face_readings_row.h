#pragma once

#include <optional>

#include "ui/app/panels/panels.h"

namespace penpose::app {

class Canvas;
class EditingSession;
class ReadingOffer;

/// How wide and how high the row of other readings is, px.
struct FaceReadingsSize {
  float picture = 0;  ///< the width of each
  float width = 0, height = 0;
};
/// Where there is room for `wide` px and `high`.
[[nodiscard]] FaceReadingsSize face_readings_size(const PanelContext& context, const ReadingOffer& offer, float wide,
                                                  float high);

/// Shows the faces that the readings make, each with what it is in a few words, in the panel that was begun. The model
/// shows the one under the pen; a press takes it. True where one was taken. Precondition: there are some.
bool show_face_readings(PanelContext& context, EditingSession& editing, const Canvas& canvas, ReadingOffer& offer,
                        float picture);

}  // namespace penpose::app
