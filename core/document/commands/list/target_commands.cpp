#include "core/document/commands/list/target_commands.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/articulation/region/region.h"
#include "core/base/numbers.h"
#include "core/curve/bend.h"
#include "core/curve/pairing.h"
#include "core/curve/polyline.h"
#include "core/document/commands/apply_deformers.h"
#include "core/geometry/lasso.h"

// The other targets of deformers, targets that are bent, and what the first lasso takes.

namespace penpose::document {
namespace {

using articulation::Between;
using articulation::Sketch;

/// Values nearer to each other than that are one.
constexpr double k_same_value = 1e-3;

std::vector<Between>::iterator find_between(Sketch& sketch, double value) {
  return std::find_if(sketch.betweens.begin(), sketch.betweens.end(),
                      [&](const Between& one) { return std::abs(one.value - value) <= k_same_value; });
}

base::Error no_such_target(const std::string& deformer, double value) {
  return {"\"" + deformer + "\" has no target at that value", "value",
          "draw one there first; its own stands at 1, not at " + base::format_fixed(value, 2)};
}

base::Status check_pull(PxPoint at, PxPoint by, double reach) {
  for (const double number : {at.x, at.y, by.x, by.y}) {
    if (std::abs(number) <= geometry::k_largest_px) continue;
    return base::Error{"the target cannot go that far", "by", "pull it by at most a million px"};
  }
  if (!(reach >= 0.0 && reach <= 10.0)) {
    return base::Error{"the reach is no share of the line's length", "reach", "give 0 to 10; 0 takes the whole line"};
  }
  return base::Done{};
}

}  // namespace

Changed run(const Document& document, const TakeRegion& command, Parts& work) {
  if (!document.pending) return base::Error{"no control is being sketched", "", "begin one"};
  PendingSketch pending = *document.pending;
  Sketch& sketch = pending.sketch;
  if (command.reach) {
    sketch.reach = *command.reach;
    sketch.piece = 0;
  }
  if (command.piece) sketch.piece = *command.piece;
  if (sketch.general.empty()) {
    if (command.piece) return base::Error{"the first line is not drawn yet", "piece", "draw around all that may move"};
    return with_pending(document, std::move(pending));
  }
  const auto canvas = pending_canvas(document, work);
  if (!canvas) return canvas.error();
  const auto camera = geometry::Camera::make(sketch.camera, sketch.viewport);
  if (!camera) return camera.error();
  const auto surface = articulation::KeptSurface::make(sketch.surface, **canvas);
  if (!surface) return surface.error();
  const auto region = general_region(**canvas, *camera, sketch.general, *surface, articulation::Borders::measured,
                                     {sketch.reach, sketch.piece});
  if (!region) return region.error();
  // A core that lies on what was taken before is drawn again on what is taken now.
  if (!sketch.specific.empty() && !specific_region(*region, sketch.specific)) sketch.specific.clear();
  return with_pending(document, std::move(pending));
}

Changed run(const Document& document, const DrawBetween& command, Parts& work) {
  const auto number = deformer_number(document, command.deformer);
  if (!number) return number.error();
  Sketch sketch = deformers_of(document)->deformers()[*number]->sketch();
  if (const auto own = geometry::Camera::make(command.view.camera, command.view.viewport); !own) {
    return at("view", own.error());
  }
  Between one{command.value, rescaled(command.line, command.view.viewport, sketch.viewport), std::nullopt};
  if (!(command.view.camera == sketch.camera)) one.camera = command.view.camera;
  const auto known = find_between(sketch, command.value);
  if (known != sketch.betweens.end()) {
    one.value = known->value;
    *known = std::move(one);
  } else {
    const auto after = std::find_if(sketch.betweens.begin(), sketch.betweens.end(),
                                    [&](const Between& other) { return other.value > command.value; });
    sketch.betweens.insert(after, std::move(one));
  }
  return with_deformer_from(document, *number, sketch, work);
}

Changed run(const Document& document, const DeleteBetween& command, Parts& work) {
  const auto number = deformer_number(document, command.deformer);
  if (!number) return number.error();
  Sketch sketch = deformers_of(document)->deformers()[*number]->sketch();
  const auto known = find_between(sketch, command.value);
  if (known == sketch.betweens.end()) return no_such_target(command.deformer, command.value);
  sketch.betweens.erase(known);
  return with_deformer_from(document, *number, sketch, work);
}

Changed run(const Document& document, const PullBetween& command, Parts& work) {
  const auto number = deformer_number(document, command.deformer);
  if (!number) return number.error();
  if (const auto fits = check_pull(command.at, command.by, command.reach); !fits) return fits.error();
  const auto camera = geometry::Camera::make(command.view.camera, command.view.viewport);
  if (!camera) return at("view", camera.error());
  const articulation::Deformer& deformer = *deformers_of(document)->deformers()[*number];
  Sketch sketch = deformer.sketch();
  const bool main = std::abs(command.value - 1.0) <= k_same_value;
  const auto between = main ? sketch.betweens.end() : find_between(sketch, command.value);
  if (!main && between == sketch.betweens.end()) return no_such_target(command.deformer, command.value);
  std::vector<PxPoint>& line = main ? sketch.target : between->target;
  std::optional<geometry::CameraPose>& own = main ? sketch.target_camera : between->camera;
  // Seen from elsewhere the line is that of its points in space.
  std::vector<PxPoint> seen = rescaled(line, sketch.viewport, command.view.viewport);
  if (!(own.value_or(sketch.camera) == command.view.camera)) {
    const auto number_of_between = static_cast<std::size_t>(between - sketch.betweens.begin());
    seen.clear();
    for (const auto& point : main
                                 ? std::vector<geometry::ModelPoint>(deformer.target().begin(), deformer.target().end())
                                 : deformer.betweens()[number_of_between]) {
      const auto px = camera->project(point);
      if (!px) return base::Error{"the target lies behind the camera", "view", "look at it and pull again"};
      seen.push_back(*px);
    }
  }
  const bool closed = curve::is_closed(seen, curve::pairing_distance_px(command.view.viewport));
  auto pulled = curve::bent(seen, command.at, command.by, command.reach, closed);
  if (!pulled)
    return base::Error{"the target has no length in this view", "view", "turn the view so that it is visible"};
  line = rescaled(*pulled, command.view.viewport, sketch.viewport);
  own = command.view.camera == sketch.camera ? std::nullopt : std::optional(command.view.camera);
  return with_deformer_from(document, *number, sketch, work);
}

}  // namespace penpose::document
