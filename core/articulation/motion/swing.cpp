#include "core/articulation/motion/swing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/algebra/jacobi.h"
#include "core/base/math.h"
#include "core/base/sine_cosine.h"
#include "core/geometry/rotation.h"

namespace penpose::articulation {
namespace {

using Quaternion = glm::dquat;
using Matrix4 = std::array<std::array<double, 4>, 4>;

Quaternion unit_turn(const Quaternion& q) {
  const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return length > 0.0 ? q * (1.0 / length) : Quaternion{1, 0, 0, 0};
}

/// How much of the whole curve's turn must be seen in it before it is believed: a straight curve says nothing of a turn
/// about itself, and a nearly straight one little.
constexpr double k_doubt = 0.02;

Quaternion spin(const geometry::Turn& turn) {
  const double half = 0.5 * turn.angle;
  return {base::cos(half), turn.axis * base::sin(half)};
}

/// The eigenvector of the largest eigenvalue of a symmetric matrix.
std::array<double, 4> largest_eigenvector(Matrix4 m) {
  Matrix4 vectors;
  algebra::rotate_to_diagonal(m[0].data(), vectors[0].data(), 4, {.most_sweeps = 30, .settled = -1, .zeroes = true});
  std::size_t best = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    if (m[i][i] > m[best][best]) best = i;
  }
  return vectors[best];
}

/// The rotation that turns the steps of one curve best onto those of the other (Horn 1987), with a little to say for no
/// rotation at all.
Quaternion best_turn(std::span<const ModelVector> from, std::span<const ModelVector> to) {
  std::array<std::array<double, 3>, 3> s{};
  double size = 0;
  for (std::size_t k = 0; k < from.size(); ++k) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) s[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] += from[k][i] * to[k][j];
    }
    size += geometry::length(from[k]) * geometry::length(to[k]);
  }
  for (std::size_t i = 0; i < 3; ++i) s[i][i] += k_doubt * size;
  const Matrix4 m{{{s[0][0] + s[1][1] + s[2][2], s[1][2] - s[2][1], s[2][0] - s[0][2], s[0][1] - s[1][0]},
                   {s[1][2] - s[2][1], s[0][0] - s[1][1] - s[2][2], s[0][1] + s[1][0], s[2][0] + s[0][2]},
                   {s[2][0] - s[0][2], s[0][1] + s[1][0], s[1][1] - s[0][0] - s[2][2], s[1][2] + s[2][1]},
                   {s[0][1] - s[1][0], s[2][0] + s[0][2], s[1][2] + s[2][1], s[2][2] - s[0][0] - s[1][1]}}};
  const auto q = largest_eigenvector(m);
  const double sign = q[0] < 0.0 ? -1.0 : 1.0;
  return unit_turn(Quaternion{q[0] * sign, q[1] * sign, q[2] * sign, q[3] * sign});
}

/// Axis times angle of a rotation; of all that it may be, the one nearest to another.
ModelVector turn_near(const Quaternion& q, const ModelVector& other) {
  const ModelVector v{q.x, q.y, q.z};
  const double sine = geometry::length(v);
  if (!(sine > 1e-15)) {
    // No rotation, or whole turns about what the neighbour turns about.
    const double size = geometry::length(other);
    const double whole = 2.0 * base::k_pi * std::floor(size / (2.0 * base::k_pi) + 0.5);
    return size > 0.0 ? other * (whole / size) : ModelVector{0};
  }
  const ModelVector axis = v / sine;
  const double angle = 2.0 * base::atan2(sine, q.w);
  const double wanted = glm::dot(axis, other);
  const double whole = 2.0 * base::k_pi * std::floor((wanted - angle) / (2.0 * base::k_pi) + 0.5);
  return axis * (angle + whole);
}

}  // namespace

Swing::Swing(std::span<const ModelPoint> reference, std::span<const ModelPoint> target) {
  find_turns(reference, target);
  const std::size_t n = reference.size();
  double length = 0;
  for (std::size_t k = 0; k + 1 < n; ++k) length += geometry::distance(reference[k], reference[k + 1]);
  for (std::size_t k = 0; k + 1 < n; ++k) {
    Segment segment;
    const ModelVector from = reference[k + 1] - reference[k];
    const ModelVector to = target[k + 1] - target[k];
    const double size = geometry::length(from);
    if (!(size > 1e-9 * length)) {
      segment.appears = to;
    } else {
      segment.angle = geometry::length(turns_[k]);
      const ModelVector axis = geometry::normalized(turns_[k]);
      segment.fixed = axis * glm::dot(axis, from);
      segment.level = from - segment.fixed;
      segment.ahead = glm::cross(axis, from);
      segment.growth = geometry::length(to) / size - 1.0;
    }
    segments_.push_back(segment);
  }
  // A point that moves by a twentieth of the curve is held 1/4 as much as one that stays.
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double way = geometry::distance(reference[i], target[i]) / (0.05 * length);
    const double once = 1.0 / (1.0 + way * way);
    holds_.push_back(once * once);
    sum += once * once;
  }
  for (std::size_t i = 0; i < n; ++i) {
    holds_[i] /= sum;
    held_ += reference[i] * holds_[i];
    held_move_ += (target[i] - reference[i]) * holds_[i];
  }
}

void Swing::find_turns(std::span<const ModelPoint> reference, std::span<const ModelPoint> target) {
  std::vector<ModelVector> from;
  std::vector<ModelVector> to;
  for (std::size_t k = 0; k + 1 < reference.size(); ++k) {
    from.push_back(reference[k + 1] - reference[k]);
    to.push_back(target[k + 1] - target[k]);
  }
  const std::size_t count = from.size();
  turns_.assign(count, ModelVector{0});
  const Quaternion whole = best_turn(from, to);
  const ModelVector middle_turn = turn_near(whole, ModelVector{0});
  const auto follow = [&](std::size_t k, Quaternion& q, ModelVector& turn) {
    q = unit_turn(spin(geometry::turn_between(q * from[k], to[k])) * q);
    turn = turns_[k] = turn_near(q, turn);
  };
  const std::size_t middle = count / 2;
  Quaternion q = whole;
  ModelVector turn = middle_turn;
  follow(middle, q, turn);
  const Quaternion start = q;
  const ModelVector start_turn = turn;
  for (std::size_t k = middle + 1; k < count; ++k) follow(k, q, turn);
  q = start;
  turn = start_turn;
  for (std::size_t k = middle; k-- > 0;) follow(k, q, turn);
}

void Swing::points(double amount, SwingWorkspace& work, std::span<ModelPoint> out) const {
  const std::size_t count = segments_.size();
  work.angles.resize(count);
  work.sines.resize(count);
  work.cosines.resize(count);
  for (std::size_t k = 0; k < count; ++k) work.angles[k] = amount * segments_[k].angle;
  base::sine_cosine(work.angles, work.sines, work.cosines);
  out[0] = ModelPoint{0};
  ModelPoint mean{0};
  for (std::size_t k = 0; k < count; ++k) {
    const Segment& segment = segments_[k];
    out[k + 1] = out[k] + segment.appears * amount +
                 (segment.fixed + segment.level * work.cosines[k] + segment.ahead * work.sines[k]) *
                     (1.0 + amount * segment.growth);
    mean += out[k + 1] * holds_[k + 1];
  }
  const ModelVector shift = held_ + held_move_ * amount - mean;
  for (ModelPoint& p : out) p += shift;
}

}  // namespace penpose::articulation
