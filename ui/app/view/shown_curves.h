#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ui/app/playback/arcs.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/view/ink.h"
#include "ui/app/view/posed_surface.h"
#include "ui/render/scene.h"

namespace penpose::app {

struct WindowTool;

struct CurveLook {
  float scale = 1;  ///< px of the display for each px of an ordinary one
  std::optional<document::CurveId> highlighted;
  std::optional<document::CurveId> dragged;      ///< a target in hand
  geometry::PxPoint dragged_by;                  ///< how far, px
  std::optional<PullHold> pulled;                ///< it is held at a place; nothing: all of it
  std::optional<double> control_target;          ///< the target of `deformer` at that value is in hand
  bool features = false;                         ///< those of the face, faintly: what lines of it are read against
  bool all_features = false;                     ///< also those that are not sure, and what was corrected
  bool handles = false;                          ///< the middles by which whole targets are moved
  std::span<const render::CurveDrawing> ghosts;  ///< the face at other moments
  double time_s = 0;                             ///< of which moment
  std::span<const ShownArc> arcs;                ///< paths over time
  std::string deformer;                          ///< whose reference and target are shown; empty: of none
  Stabiliser stabiliser = Stabiliser::off;       ///< of lines as they are shown
  const WindowTool* tool = nullptr;              ///< in hand; null: the one of its kind
  geometry::Viewport window;                     ///< in whose px curves on the glass are given
};

/// All curves to draw over the surface: what was drawn for posing, with the distance left along each target in colour;
/// the curves of the deformer that is being drawn; those of ghosts; the stroke under the pen.
[[nodiscard]] std::vector<render::CurveDrawing> shown_curves(const EditingSession& editing, const PosedSurface& surface,
                                                             const CurveLook& look);

/// From blue, where a target is reached, to amber from a fiftieth of the model's size on.
[[nodiscard]] render::Color distance_color(double distance, double model_size);

/// The drawn curve nearest to a place, within a distance.
[[nodiscard]] std::optional<document::CurveId> curve_near(const EditingSession& editing, const PosedSurface& surface,
                                                          geometry::PxPoint at, double within_px);

}  // namespace penpose::app
