#include "ui/render/framing.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "core/base/math.h"

namespace penpose::render {
namespace {

using geometry::ModelPoint;
using geometry::ModelVector;

/// The smallest wedge along one axis: where the eye has to stand, sideways and back, so that all points fit between two
/// planes through it that open by `tangent` to either side.
struct Wedge {
  double lowest = 1e300;    ///< of side - tangent * near, which bounds the eye from one side
  double highest = -1e300;  ///< of side + tangent * near, from the other

  void add(double side, double near, double tangent) {
    lowest = std::min(lowest, side - tangent * near);
    highest = std::max(highest, side + tangent * near);
  }
  [[nodiscard]] double middle() const { return 0.5 * (lowest + highest); }
  [[nodiscard]] double away(double tangent) const { return 0.5 * (highest - lowest) / tangent; }
};

}  // namespace

std::optional<Viewpoint> find_viewpoint(std::string_view name) {
  if (name == "front") return Viewpoint{0, 0};
  if (name == "side") return Viewpoint{90, 0};
  if (name == "three-quarter") return Viewpoint{};
  if (name == "back") return Viewpoint{180, 0};
  if (name == "top") return Viewpoint{0, 85};
  return std::nullopt;
}

std::vector<std::uint32_t> face_vertices(const document::Model& model) {
  constexpr double k_whole = 0.5;
  constexpr double k_far = 0.25;
  constexpr double k_margin = 0.4;
  constexpr float k_some = 0.25F;
  constexpr float k_much = 0.5F;
  if (!model.shapes) return {};
  std::vector<ModelPoint> rest(model.mesh->vertex_count());
  model.rig->evaluate(rig::rest_pose(*model.rig), rest);
  geometry::Box whole;
  for (const ModelPoint& p : rest) whole.add(p);
  const double size = whole.diagonal();
  std::vector<geometry::Box> boxes;
  for (const rig::BlendShape& shape : model.shapes->shapes()) {
    float most = 0;
    for (const glm::vec3& d : shape.deltas) most = std::max(most, glm::dot(d, d));
    // What arithmetic leaves behind does not count, nor the throat, which a jaw takes with it.
    geometry::Box box;
    double lowest = 1e300;
    for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
      const float motion = glm::dot(shape.deltas[i], shape.deltas[i]);
      const ModelPoint& p = rest[shape.vertices[i]];
      if (motion > k_some * k_some * most) box.add(p);
      if (motion > k_much * k_much * most) lowest = std::min(lowest, p.y);
    }
    if (!box.empty()) box.minimum.y = lowest;
    if (!box.empty() && box.diagonal() < k_whole * size) boxes.push_back(box);
  }
  if (boxes.empty() || 2 * boxes.size() < model.shapes->shapes().size()) return {};
  ModelPoint middle{0};
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> centers;
    for (const geometry::Box& box : boxes) centers.push_back(box.center()[axis]);
    const auto half = centers.begin() + static_cast<std::ptrdiff_t>(centers.size() / 2);
    std::nth_element(centers.begin(), half, centers.end());
    middle[axis] = *half;
  }
  std::erase_if(boxes,
                [&](const geometry::Box& box) { return geometry::distance(box.center(), middle) > k_far * size; });
  if (boxes.empty()) return {};
  // The fifth of the shapes that reach farthest to a side, such as those of a throat, do not say where a face ends.
  const std::size_t fifth = boxes.size() / 5;
  geometry::Box face;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> low;
    std::vector<double> high;
    for (const geometry::Box& box : boxes) {
      low.push_back(box.minimum[axis]);
      high.push_back(-box.maximum[axis]);
    }
    for (std::vector<double>* ends : {&low, &high})
      std::nth_element(ends->begin(), ends->begin() + static_cast<std::ptrdiff_t>(fifth), ends->end());
    face.minimum[axis] = low[fifth];
    face.maximum[axis] = -high[fifth];
  }
  if (face.diagonal() > k_whole * size) return {};
  const ModelVector margin(k_margin * (face.maximum.y - face.minimum.y));
  const ModelPoint low = face.minimum - margin;
  const ModelPoint high = face.maximum + margin;
  std::vector<std::uint32_t> vertices;
  for (std::size_t v = 0; v < rest.size(); ++v) {
    const ModelPoint& p = rest[v];
    if (glm::all(glm::greaterThanEqual(p, low)) && glm::all(glm::lessThanEqual(p, high)))
      vertices.push_back(static_cast<std::uint32_t>(v));
  }
  return vertices;
}

geometry::Camera frame_points(std::span<const glm::vec3> points, geometry::Viewport viewport, const Viewpoint& from,
                              double vertical_fov_degrees) {
  viewport = {std::max(1, viewport.width), std::max(1, viewport.height)};
  geometry::Box box;
  for (const glm::vec3& p : points) box.add(ModelPoint(p));
  const double size = box.diagonal();
  if (points.empty() || !(size > 0)) {
    return geometry::frame_box(box, viewport, from.yaw_degrees, from.pitch_degrees, vertical_fov_degrees);
  }
  const double yaw = base::radians(from.yaw_degrees);
  const double pitch = base::radians(std::clamp(from.pitch_degrees, -89.0, 89.0));
  const ModelVector back{base::sin(yaw) * base::cos(pitch), base::sin(pitch), base::cos(yaw) * base::cos(pitch)};
  const ModelVector right = geometry::normalized(glm::cross(ModelVector{0, 1, 0}, back));
  const ModelVector up = glm::cross(back, right);
  constexpr double k_fill = 10.0 / 12.0;
  const double tan_y = base::tan(base::radians(std::clamp(vertical_fov_degrees, 1.0, 179.0)) * 0.5) * k_fill;
  const double tan_x = tan_y * viewport.width / viewport.height;
  Wedge across;
  Wedge upright;
  double nearest = -1e300;
  for (const glm::vec3& p : points) {
    const ModelVector d = (ModelPoint(p) - box.center()) / size;
    const double near = glm::dot(d, back);
    across.add(glm::dot(d, right), near, tan_x);
    upright.add(glm::dot(d, up), near, tan_y);
    nearest = std::max(nearest, near);
  }
  const double away = std::max({across.away(tan_x), upright.away(tan_y), nearest + 0.05});
  // On the loose side the wedge's middle is not the picture's: a few steps bring the outermost points to equal margins.
  double x = across.middle();
  double y = upright.middle();
  for (int step = 0; step < 6; ++step) {
    geometry::Box seen;
    for (const glm::vec3& p : points) {
      const ModelVector d = (ModelPoint(p) - box.center()) / size;
      const double depth = away - glm::dot(d, back);
      seen.add({(glm::dot(d, right) - x) / depth, (glm::dot(d, up) - y) / depth, 0});
    }
    x += seen.center().x * away;
    y += seen.center().y * away;
  }
  const ModelPoint target = box.center() + (right * x + up * y) * size;
  const geometry::CameraPose pose{target + back * (away * size), target, {0, 1, 0}, vertical_fov_degrees};
  auto camera = geometry::Camera::make(pose, viewport);
  if (camera) return *camera;
  return geometry::frame_box(box, viewport, from.yaw_degrees, from.pitch_degrees);
}

}  // namespace penpose::render
