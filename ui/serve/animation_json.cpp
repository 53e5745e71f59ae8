#include "ui/serve/animation_json.h"

#include "core/base/math.h"
#include "core/document/document_hash.h"
#include "core/geometry/rotation.h"

namespace penpose::serve {
namespace {

using json::Json;

Json head_json(const std::vector<animation::HeadTurn>& head) {
  Json pitch = Json::array();
  Json yaw = Json::array();
  Json roll = Json::array();
  Json scale = Json::array();
  Json shift = Json::array();
  for (const animation::HeadTurn& turn : head) {
    const glm::dvec3 angles = geometry::xyz_from_quaternion(glm::quat_cast(turn.rotation));
    pitch.push_back(base::degrees(angles.x));
    yaw.push_back(-base::degrees(angles.y));
    roll.push_back(base::degrees(angles.z));
    scale.push_back(turn.scale);
    shift.push_back({turn.shift.x, turn.shift.y});
  }
  return {{"pitch", pitch}, {"yaw", yaw}, {"roll", roll}, {"scale", scale}, {"shift_px", shift}};
}

}  // namespace

Json animation_json(const tracking::Animated& animated, std::optional<double> solve_us) {
  const auto all = animated.document.model->rig->parameters();
  Json parameters = Json::object();
  for (std::size_t i = 0; i < animated.poses.front().size(); ++i) {
    Json& values = parameters[all[i].name] = Json::array();
    for (const rig::Pose& pose : animated.poses) values.push_back(pose[i]);
  }
  Json out = {{"frames", animated.poses.size()}, {"held", animated.held}, {"fps", animated.fps}};
  if (solve_us) out["solve_us"] = *solve_us;
  out["unmatched"] = animated.unmatched;
  out["nearest"] = animated.nearest;
  out["blinks"] = animated.eyes.blinks;
  out["blink_dip"] = animated.eyes.full_dip;
  out["rest"] = animated.rest ? Json(animated.rest->frame) : Json();
  out["parameters"] = std::move(parameters);
  out["head"] = head_json(animated.head);
  out["state"] = document::DocumentHasher()(animated.document).whole.hex();
  return out;
}

}  // namespace penpose::serve
