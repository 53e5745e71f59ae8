#pragma once

#include <optional>
#include <string>

#include "ui/app/session/editing_session.h"
#include "ui/app/session/live_follow.h"
#include "ui/app/view/posed_surface.h"

namespace penpose::app {

/// What lies under the pen and can be pulled.
struct PlaceUnder {
  PulledPlace place;
  std::string feature;  ///< of the face, by its name in files; empty: a drawn line or any point of the surface
};

/// Finds what is pulled at a place of a view, px: the nearest feature of the face or drawn line within `near_px`, as it
/// is seen and not through the head; else a short line of the surface through that point. Nothing: the model is not
/// there.
[[nodiscard]] std::optional<PlaceUnder> place_under(const EditingSession& editing, PosedSurface& surface,
                                                    const document::View& view, geometry::PxPoint at, double near_px);

}  // namespace penpose::app
