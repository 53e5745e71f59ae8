#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/math.h"
#include "ui/app/cast/cast.h"

// Where a character stands that is added to others, and one that is dragged.

namespace penpose::app {
namespace {

/// Of the size of the first one's face; what lies beyond is made as large.
constexpr double k_least_face = 0.4, k_largest_face = 2.5;
/// A face that is a greater share of its model is no part of a figure.
constexpr double k_face_of_figure = 0.5;
/// Between two, as a share of how wide the new one is.
constexpr double k_gap_share = 0.06;

std::array<geometry::ModelPoint, 8> corners_of(const geometry::Box& box) {
  std::array<geometry::ModelPoint, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] = {(i & 1) != 0 ? box.maximum.x : box.minimum.x, (i & 2) != 0 ? box.maximum.y : box.minimum.y,
                  (i & 4) != 0 ? box.maximum.z : box.minimum.z};
  }
  return corners;
}

/// From where to where a box reaches along a direction.
std::pair<double, double> reach_of(const geometry::Box& box, const geometry::Placement& placement,
                                   const geometry::ModelVector& along) {
  std::pair<double, double> reach{1e300, -1e300};
  for (const geometry::ModelPoint& corner : corners_of(box)) {
    const double at = glm::dot(along, placed(placement, corner));
    reach = {std::min(reach.first, at), std::max(reach.second, at)};
  }
  return reach;
}

/// A model's boxes at rest, in its own space.
struct Measured {
  geometry::Box whole;
  geometry::Box face;

  explicit Measured(const document::Model& model)
      : whole(document::rest_world_box(model)), face(document::rest_box_of_shapes(model)) {
    if (face.empty()) face = whole;
  }
  [[nodiscard]] bool is_figure() const { return face.diagonal() < k_face_of_figure * whole.diagonal(); }
};

}  // namespace

geometry::Box Cast::box(std::size_t character) const {
  geometry::Box box;
  for (const auto& corner : corners_of(document::rest_world_box(*document(character).model)))
    box.add(placed(at(character).placement, corner));
  return box;
}

void Cast::place_beside(std::size_t character) {
  const std::size_t first = character == 0 ? 1 : 0;
  Measured there(*document(first).model);
  Measured here(*document(character).model);
  // Of two heads not both may have shapes that say where the face is.
  if (!there.is_figure() && !here.is_figure()) {
    there.face = there.whole;
    here.face = here.whole;
  }
  const geometry::Placement& from = at(first).placement;
  const double front = from.turn_degrees + front_degrees(document(first));
  geometry::Placement to{{}, front - front_degrees(document(character)), from.scale};
  const double ratio = there.face.diagonal() / std::max(here.face.diagonal(), 1e-300);
  if (!(1 / ratio >= k_least_face && 1 / ratio <= k_largest_face)) to.scale *= ratio;
  const geometry::ModelVector up{0, 1, 0};
  const geometry::ModelVector right = geometry::turned({{}, front, 1}, {1, 0, 0});
  const geometry::ModelVector ahead = geometry::turned({{}, front, 1}, {0, 0, 1});
  // On one ground, or else face by face.
  const bool stand = there.is_figure() && here.is_figure();
  const double rise = stand ? reach_of(there.whole, from, up).first - reach_of(here.whole, to, up).first
                            : placed(from, there.face.center()).y - placed(to, here.face.center()).y;
  const double forth = glm::dot(ahead, placed(from, there.face.center()) - placed(to, here.face.center()));
  double edge = -1e300;
  for (std::size_t i = 0; i < size(); ++i) {
    if (i == character) continue;
    edge = std::max(edge, reach_of(document::rest_world_box(*document(i).model), at(i).placement, right).second);
  }
  const auto reach = reach_of(here.whole, to, right);
  const double aside = edge - reach.first + k_gap_share * (reach.second - reach.first);
  to.at = up * rise + ahead * forth + right * aside;
  place(character, to);
}

void Cast::take_in_hand(PxPoint at_px) {
  in_hand_ = touched(at_px).value_or(active_);
  hand_at_ = at_px;
  const document::View& view = canvas_.view();
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  const geometry::ModelPoint middle = placed(inverse(at(active_).placement), box(in_hand_).center());
  hand_units_ = camera ? camera->units_per_px(std::max(camera->depth(middle), 0.0)) * at(active_).placement.scale : 0;
}

void Cast::drag_to(PxPoint at_px) {
  const document::View& view = canvas_.view();
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  if (!camera || in_hand_ >= size()) return;
  const PxPoint by = (at_px - hand_at_) * hand_units_;
  hand_at_ = at_px;
  geometry::Placement to = at(in_hand_).placement;
  to.at += turned(at(active_).placement, camera->right() * by.x - camera->up() * by.y);
  place(in_hand_, to);
}

}  // namespace penpose::app
