#include "core/articulation/motion/curve_motion.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/base/sine_cosine.h"
#include "core/geometry/rotation.h"

namespace penpose::articulation {
namespace {

/// A rotation as a unit quaternion: w + (x, y, z).
struct Spin {
  double w = 1;
  ModelVector v{0};
};

Spin operator*(const Spin& a, const Spin& b) {
  return {a.w * b.w - (a.v.x * b.v.x + a.v.y * b.v.y + a.v.z * b.v.z),
          {a.w * b.v.x + b.w * a.v.x + (a.v.y * b.v.z - a.v.z * b.v.y),
           a.w * b.v.y + b.w * a.v.y + (a.v.z * b.v.x - a.v.x * b.v.z),
           a.w * b.v.z + b.w * a.v.z + (a.v.x * b.v.y - a.v.y * b.v.x)}};
}

glm::dmat3 matrix_of(const Spin& q) {
  const double x2 = q.v.x + q.v.x;
  const double y2 = q.v.y + q.v.y;
  const double z2 = q.v.z + q.v.z;
  const double xx = q.v.x * x2;
  const double yy = q.v.y * y2;
  const double zz = q.v.z * z2;
  const double xy = q.v.x * y2;
  const double xz = q.v.x * z2;
  const double yz = q.v.y * z2;
  const double wx = q.w * x2;
  const double wy = q.w * y2;
  const double wz = q.w * z2;
  return {1 - (yy + zz), xy + wz, xz - wy, xy - wz, 1 - (xx + zz), yz + wx, xz + wy, yz - wx, 1 - (xx + yy)};
}

/// v turned by q.
ModelVector turned(const Spin& q, const ModelVector& v) {
  const double tx = 2.0 * (q.v.y * v.z - q.v.z * v.y);
  const double ty = 2.0 * (q.v.z * v.x - q.v.x * v.z);
  const double tz = 2.0 * (q.v.x * v.y - q.v.y * v.x);
  return {v.x + q.w * tx + (q.v.y * tz - q.v.z * ty), v.y + q.w * ty + (q.v.z * tx - q.v.x * tz),
          v.z + q.w * tz + (q.v.x * ty - q.v.y * tx)};
}

/// Segments shorter than this share of the curve have no direction to turn from.
constexpr double k_shortest = 1e-9;

}  // namespace

CurveMotion::CurveMotion(std::vector<ModelPoint> reference, std::vector<ModelPoint> target, Mode mode, Turning turning)
    : reference_(std::move(reference)), target_(std::move(target)), mode_(mode), segments_(reference_.size() - 1) {
  if (mode_ != Mode::rotate) return;
  if (turning == Turning::swung) {
    swing_ = std::make_shared<const Swing>(reference_, target_);
    return;
  }
  double length = 0;
  for (std::size_t j = 0; j < segments_.size(); ++j) length += geometry::distance(reference_[j], reference_[j + 1]);
  Spin before;
  for (std::size_t j = 0; j < segments_.size(); ++j) {
    Segment& segment = segments_[j];
    const ModelVector from = reference_[j + 1] - reference_[j];
    const ModelVector to = glm::transpose(matrix_of(before)) * (target_[j + 1] - target_[j]);
    const double from_length = geometry::length(from);
    if (!(from_length > k_shortest * length)) {
      segment.empty = true;
      segment.appears = to;
      continue;
    }
    const geometry::Turn turn = geometry::turn_between(from, to);
    segment.along = from;
    segment.axis = turn.axis;
    segment.across = glm::cross(turn.axis, from);
    segment.angle = turn.angle;
    segment.growth = geometry::length(to) / from_length - 1.0;
    const double half = 0.5 * turn.angle;
    double sine = 0;
    double cosine = 1;
    base::sine_cosine({&half, 1}, {&sine, 1}, {&cosine, 1});
    before = before * Spin{cosine, turn.axis * sine};
  }
}

void CurveMotion::frames(double amount, std::span<const std::uint8_t> wanted, MotionWorkspace& work) const {
  const std::size_t n = wanted.size();
  work.angles.resize(n);
  work.sines.resize(n);
  work.cosines.resize(n);
  work.frames.resize(n);
  for (std::size_t j = 0; j < n; ++j) work.angles[j] = 0.5 * amount * segments_[j].angle;
  base::sine_cosine(work.angles, work.sines, work.cosines);
  Spin before;
  ModelPoint start = reference_.front() + (target_.front() - reference_.front()) * amount;
  for (std::size_t j = 0; j < n; ++j) {
    const Segment& segment = segments_[j];
    const double s = work.sines[j];
    const double c = work.cosines[j];
    // The whole angle by the half: cos = 1 - 2 s^2, sin = 2 s c.
    const double grown = 1.0 + amount * segment.growth;
    const double level = (1.0 - 2.0 * s * s) * grown;
    const double ahead = 2.0 * s * c * grown;
    ModelVector step = segment.along * level + segment.across * ahead;
    if (segment.empty) step = segment.appears * amount;
    if (wanted[j] != 0) {
      SegmentFrame& frame = work.frames[j];
      frame.turn = matrix_of(before);
      frame.start = start;
      frame.step = step;
    }
    start = start + turned(before, step);
    before = before * Spin{c, segment.axis * s};
  }
}

std::vector<ModelPoint> CurveMotion::points(double amount) const {
  std::vector<ModelPoint> points;
  if (mode_ != Mode::rotate) {
    for (std::size_t i = 0; i < reference_.size(); ++i) {
      points.push_back(reference_[i] + (target_[i] - reference_[i]) * amount);
    }
    return points;
  }
  MotionWorkspace work;
  if (swing_) {
    points.resize(reference_.size());
    swing_->points(amount, work.swing, points);
    return points;
  }
  frames(amount, std::vector<std::uint8_t>(segments_.size(), 1), work);
  for (const SegmentFrame& frame : work.frames) points.push_back(frame.start);
  points.push_back(work.frames.back().start + work.frames.back().turn * work.frames.back().step);
  return points;
}

}  // namespace penpose::articulation
