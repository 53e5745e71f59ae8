#include "core/model_io/known_heads.h"

#include <cmath>

#include "core/rig/rig.h"

namespace penpose::model_io {
namespace {

/// Vertices of the face, the head and the neck, which come first in every cut of ICT FaceKit.
constexpr std::size_t k_ict_skin_vertices = 11248;

std::vector<VertexCurve> ict_curves() {
  return {{"brow_R", {268, 493, 1914, 2044, 1401}},
          {"brow_L", {3615, 4240, 4114, 2734, 2509}},
          {"eyelid_upper_R", {1507, 1542, 1537, 1528}},
          {"eyelid_lower_R", {1507, 1511, 1518, 1528}},
          {"eyelid_upper_L", {3742, 3751, 3756, 3721}},
          {"eyelid_lower_L", {3742, 3732, 3725, 3721}},
          {"lip_upper", {5708, 5695, 2081, 0, 4275, 6200, 6213}},
          {"lip_lower", {5708, 5841, 5957, 5518, 6461, 6346, 6213}},
          {"lip_upper_inner", {5702, 5711, 5533, 6216, 6207}},
          {"lip_lower_inner", {5702, 5966, 5517, 6470, 6207}}};
}

}  // namespace

std::vector<VertexCurve> known_head_curves(const document::Model& model) {
  const auto positions = model.mesh->positions();
  if (positions.size() < k_ict_skin_vertices || !model.shapes) return {};
  for (const char* name : {"jawOpen", "eyeBlink_L", "browInnerUp_L"}) {
    if (!rig::find_parameter(model.rig->parameters(), name)) return {};
  }
  auto curves = ict_curves();
  // The corners of the mouth are mirror images of each other below the eyes, which are below the brows.
  const auto at = [&](std::size_t curve, std::size_t i) { return positions[curves[curve].vertices[i]]; };
  const auto right = at(6, 0);
  const auto left = at(6, 6);
  const double width = left.x - right.x;
  const bool face = width > 0 && std::abs(left.x + right.x) < 0.02 * width &&
                    std::abs(left.y - right.y) < 0.02 * width && at(2, 0).y > left.y && at(0, 2).y > at(2, 1).y &&
                    at(2, 0).x < right.x && at(4, 3).x > left.x;
  if (!face) curves.clear();
  return curves;
}

}  // namespace penpose::model_io
