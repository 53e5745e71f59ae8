#include "core/character/live_target.h"

#include "core/drawing/live_target.h"

namespace penpose::character {

base::Result<LiveTarget> LiveTarget::begin(Character& character, CurveId curve, const View& view) {
  const document::Document& document = character.document();
  const document::PoseCurve* found = document::find_curve(document, curve);
  if (found == nullptr || found->role != document::PoseCurveRole::reference) {
    return base::Error{"there is no reference curve " + std::to_string(curve.value), "curve", "name a reference curve"};
  }
  if (const auto camera = geometry::Camera::make(view.camera, view.viewport); !camera) return camera.error();
  auto problem = drawing::live_problem(document, *found, view);
  if (!problem) return base::Error{"the view does not see the reference", "view", "turn it so that it does"};
  auto poser = intent::LivePoser::start(*document.model->rig, character.whole_model(), *std::move(problem));
  if (!poser) return poser.error();
  return LiveTarget(document.model, std::move(poser).value());
}

}  // namespace penpose::character
