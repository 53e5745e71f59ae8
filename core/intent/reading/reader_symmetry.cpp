#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/intent/reading/reader.h"

// Whether lines on a face ask for the same on both sides, and which controls do that.

namespace penpose::intent {
namespace {

/// A point has a mirror image where another lies within this share of the curves' extent of it.
constexpr double k_image_within = 0.06;
/// Seen from farther aside than this (sine of the angle) the two sides of a line do not look alike.
constexpr double k_from_the_front = 0.35;

ModelVector mirrored(const ModelVector& v) { return {-v.x, v.y, v.z}; }

}  // namespace

double Reader::likeness_to_image(std::span<const ModelVector> ways) const {
  double own = 0;
  double with = 0;
  for (std::size_t i = 0; i < images_.size(); ++i) {
    if (images_[i] == k_no_partner) continue;
    own += square_of(ways[i]);
    with += glm::dot(ways[i], mirrored(ways[images_[i]]));
  }
  return own > 0.0 ? std::clamp(with / own, -1.0, 1.0) : 0.0;
}

void Reader::measure_symmetry() {
  std::vector<ModelPoint> points;
  for (const DrawnCurve& curve : problem_.drawn) {
    if (std::abs(curve.camera.forward().x) > k_from_the_front) return;
    for (const ModelPoint& at : at_rest(curve.reference)) points.push_back(at);
  }
  geometry::Box model;
  for (const ModelPoint& at : whole_.fields->places()) model.add(at);
  geometry::Box box;
  for (const ModelPoint& at : points) box.add(at);
  if (points.empty() || model.empty()) return;
  const double within = k_image_within * box.diagonal();
  images_.assign(points.size(), k_no_partner);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ModelPoint image(2.0 * model.center().x - points[i].x, points[i].y, points[i].z);
    double nearest = within * within;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double square = square_of(points[k] - image);
      if (square > nearest) continue;
      nearest = square;
      images_[i] = k;
    }
  }
  std::vector<ModelVector> asked;
  std::size_t alone = 0;
  for (std::size_t c = 0; c < problem_.drawn.size(); ++c) {
    Block& block = blocks_[c];
    const geometry::Camera& camera = block.drawn->camera;
    const std::vector<PxPoint> px = seen(block, start_);
    match(block, px, false);
    for (std::size_t i = 0; i < block.count; ++i) {
      const bool stays = !block.drawn->stays.empty() && block.drawn->stays[i];
      const PxPoint way = stays ? PxPoint{} : block.matching.target[i] - px[i];
      const double unit = camera.units_per_px(std::max(0.0, camera.depth(start_[block.first + i])));
      asked.push_back((camera.right() * way.x - camera.up() * way.y) * unit);
      if (images_[asked.size() - 1] == k_no_partner) ++alone;
    }
  }
  // What is drawn on one side alone says nothing of the other.
  if (2 * alone > images_.size()) return images_.clear();
  symmetry_ = std::max(0.0, likeness_to_image(asked));
}

double Reader::asymmetry_of(const Unit& unit) const {
  if (symmetry_ == 0.0 || images_.empty()) return 0.0;
  std::vector<ModelVector> ways(images_.size(), ModelVector{0});
  for (std::size_t m = 0; m < unit.count; ++m) {
    const ModelVector* column = columns_.data() + parameter_of(unit.members[m]) * start_.size();
    for (std::size_t i = 0; i < ways.size(); ++i) ways[i] += column[i];
  }
  return symmetry_ * symmetry_ * 0.5 * (1.0 - likeness_to_image(ways));
}

}  // namespace penpose::intent
