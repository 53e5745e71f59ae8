#include "core/portrait/surface/face_frame.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/math.h"
#include "core/geometry/closest_point.h"

namespace penpose::portrait {
namespace {

/// Samples of what moves less than this share of what moves most are not the face.
constexpr double k_still = 0.04;
/// Shapes of a face are no larger than this many times their median.
constexpr double k_larger_than_usual = 3.0;
/// A plane between pairs is not turned farther from the front than the cosine of this: they are searched for near the
/// planes of the axes, and may be wrong where a model looks elsewhere.
constexpr double k_near_front = 0.97;
/// Vertices that are mirrored to find the plane of a surface, at most, and rounds of it.
constexpr std::size_t k_most_mirrored = 300;
constexpr int k_frame_rounds = 10;

FaceFrame frame_of(const ModelVector& left, const ModelPoint& origin) {
  FaceFrame frame;
  frame.left = left;
  frame.front = geometry::normalized(glm::cross(left, ModelVector{0, 1, 0}));
  frame.up = glm::cross(frame.front, left);
  frame.origin = origin;
  return frame;
}

bool is_shape(const intent::WholeModel& whole, std::size_t control) {
  return whole.joint[control] == intent::k_no_partner;
}

/// The diagonal of the box of what a shape moves, model units.
double extent_of(const intent::WholeModel& whole, std::size_t control) {
  geometry::Box box;
  for (const std::uint32_t sample : whole.fields->field(control).samples) box.add(whole.fields->places()[sample]);
  return box.empty() ? 0.0 : box.diagonal();
}

/// The largest extent of a shape that is one of the face: others change the build of the body.
double largest_of_face(const intent::WholeModel& whole) {
  std::vector<double> extents;
  for (std::size_t k = 0; k < whole.fields->control_count(); ++k) {
    if (is_shape(whole, k) && !whole.fields->field(k).samples.empty()) extents.push_back(extent_of(whole, k));
  }
  if (extents.empty()) return 0.0;
  std::stable_sort(extents.begin(), extents.end());
  return k_larger_than_usual * extents[(extents.size() - 1) / 2];
}

/// The plane between controls and those that do the same on the other side: its normal, and the origin put on it.
std::size_t between_pairs(const intent::WholeModel& whole, FaceFrame& frame) {
  const intent::ControlFields& fields = *whole.fields;
  const auto centre = [&](std::size_t control) {
    ModelPoint sum{0};
    double weight = 0;
    const intent::ControlField field = fields.field(control);
    for (std::size_t i = 0; i < field.samples.size(); ++i) {
      const double way = geometry::length(field.ways[i]);
      sum += fields.places()[field.samples[i]] * way;
      weight += way;
    }
    return weight > 0.0 ? sum / weight : sum;
  };
  ModelVector across{0};
  std::vector<ModelPoint> middles;
  for (std::size_t k = 0; k < fields.control_count(); ++k) {
    const std::size_t other = whole.partner[k];
    if (other == intent::k_no_partner || other <= k || !is_shape(whole, k)) continue;
    const ModelPoint a = centre(k);
    const ModelPoint b = centre(other);
    const ModelVector d = a - b;
    across += glm::dot(d, frame.left) < 0.0 ? -d : d;
    middles.push_back((a + b) * 0.5);
  }
  if (middles.empty()) return 0;
  across.y = 0;
  const ModelVector left = geometry::normalized(across, frame.left);
  if (glm::dot(left, frame.left) < k_near_front) return 0;
  double offset = 0;
  for (const ModelPoint& m : middles) offset += glm::dot(left, m);
  offset /= static_cast<double>(middles.size());
  frame = frame_of(left, frame.origin + left * (offset - glm::dot(left, frame.origin)));
  return middles.size();
}

/// The plane that mirrors a surface onto itself best: points go to the mirror image's nearest places, and the plane
/// between both is taken again; the far ones count little. The share of points that meet the surface.
double between_halves(const mesh::TriangleMesh& mesh, std::span<const ModelPoint> rest,
                      std::span<const ModelPoint> face, const geometry::Box& box, FaceFrame& frame) {
  std::vector<ModelPoint> points;
  const std::size_t step = face.size() / k_most_mirrored + 1;
  for (std::size_t v = 0; v < face.size(); v += step) points.push_back(face[v]);
  const geometry::ClosestPointTree tree(rest, mesh.triangles());
  const double size = box.diagonal();
  double met = 0;
  for (int round = 0; round < k_frame_rounds; ++round) {
    const double reach = round < 5 ? 0.05 : 0.01;
    ModelVector across{0};
    double offset = 0;
    double weights = 0;
    met = 0;
    for (const ModelPoint& p : points) {
      const double side = glm::dot(frame.left, p - frame.origin);
      const ModelPoint image = p - frame.left * (2.0 * side);
      const geometry::ClosestPoint near = tree.closest(image);
      const double far = near.distance / (reach * size);
      const double weight = 1.0 / (1.0 + far * far);
      if (near.distance < 0.005 * size) met += 1.0;
      const ModelVector d = p - near.point;
      across += (side < 0.0 ? -d : d) * weight;
      offset += glm::dot(frame.left, (p + near.point) * 0.5) * weight;
      weights += weight;
    }
    if (!(weights > 0.0)) return 0.0;
    const ModelVector left = geometry::normalized(across, frame.left);
    const ModelPoint middle = frame.origin + frame.left * (offset / weights - glm::dot(frame.left, frame.origin));
    frame = frame_of(left, middle);
    frame.up = glm::cross(frame.front, frame.left);
  }
  return met / static_cast<double>(points.size());
}

}  // namespace

ModelPoint FaceFrame::local(const ModelPoint& p) const { return turned(p - origin); }

ModelVector FaceFrame::turned(const ModelVector& v) const {
  return {glm::dot(left, v), glm::dot(up, v), glm::dot(front, v)};
}

std::vector<double> moved_by_shapes(const intent::WholeModel& whole) {
  const intent::ControlFields& fields = *whole.fields;
  std::vector<double> moved(fields.places().size(), 0.0);
  const double largest = largest_of_face(whole);
  for (std::size_t k = 0; k < fields.control_count(); ++k) {
    if (!is_shape(whole, k) || extent_of(whole, k) > largest) continue;
    const intent::ControlField field = fields.field(k);
    for (std::size_t i = 0; i < field.samples.size(); ++i) moved[field.samples[i]] += geometry::length(field.ways[i]);
  }
  return moved;
}

std::optional<FacePlace> place_face(const mesh::TriangleMesh& mesh, const intent::WholeModel& whole,
                                    double front_yaw_degrees) {
  const std::span<const ModelPoint> rest = *whole.rest;
  if (mesh.triangle_count() == 0 || !(whole.size > 0.0)) return std::nullopt;
  for (const ModelPoint& p : rest) {
    if (!std::isfinite(p.x + p.y + p.z)) return std::nullopt;
  }
  const double yaw = base::radians(std::isfinite(front_yaw_degrees) ? front_yaw_degrees : 0.0);
  FacePlace place;

  const std::vector<double> moved = moved_by_shapes(whole);
  const double most = moved.empty() ? 0.0 : *std::max_element(moved.begin(), moved.end());
  place.of_shapes = most > 1e-6 * whole.size;
  std::vector<ModelPoint> face;
  for (std::size_t i = 0; place.of_shapes && i < moved.size(); ++i) {
    if (moved[i] > k_still * most) face.push_back(whole.fields->places()[i]);
  }
  if (!place.of_shapes) face.assign(rest.begin(), rest.end());
  geometry::Box world;
  for (const ModelPoint& p : face) world.add(p);

  place.frame = frame_of({base::cos(yaw), 0, -base::sin(yaw)}, world.center());
  const std::size_t pairs = between_pairs(whole, place.frame);
  place.mirrored = static_cast<double>(std::min<std::size_t>(pairs, 6)) / 6.0;
  if (pairs < 3) place.mirrored = between_halves(mesh, rest, face, world, place.frame);

  for (const ModelPoint& p : face) place.box.add(place.frame.local(p));
  return place;
}

}  // namespace penpose::portrait
