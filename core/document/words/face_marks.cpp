#include "core/document/words/face_marks.h"

#include "core/base/math.h"

namespace penpose::document {

using geometry::ModelVector;

portrait::FaceFrame front_of(const Model& model) {
  portrait::FaceFrame frame;
  const double yaw = base::radians(model.front_yaw_degrees);
  frame.front = {base::sin(yaw), 0, base::cos(yaw)};
  frame.left = {base::cos(yaw), 0, -base::sin(yaw)};
  return frame;
}

ModelVector FaceMarks::way_of(const Weights& weights, const Places& moved) const {
  ModelVector sum(0);
  for (const auto& [number, share] : weights) sum += (moved[number] - rest_[number]) * share;
  return frame_.turned(sum) / unit_;
}

FaceMoves FaceMarks::moves(const rig::Pose& pose) {
  Places moved(rest_.size());
  bound_->evaluate(pose, moved);
  FaceMoves out;
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t mark = 0; mark < k_marks; ++mark) {
      out.half[side].way[mark] = way_of(points_[mark][side], moved);
    }
  }
  ModelVector farthest(0);
  const ModelVector chin = 0.5 * (out.half[0][Mark::chin] + out.half[1][Mark::chin]);
  for (const Weights& piece : inside_) {
    const ModelVector way = way_of(piece, moved);
    if (geometry::length(way - chin) > geometry::length(farthest - chin)) farthest = way;
  }
  for (HalfMoves& half : out.half) half.way[static_cast<std::size_t>(Mark::tongue)] = farthest;
  for (ModelVector& way : out.half[1].way) way.x = -way.x;
  return out;
}

}  // namespace penpose::document
