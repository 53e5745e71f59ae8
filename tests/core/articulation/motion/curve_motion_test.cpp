#include "core/articulation/motion/curve_motion.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <random>

namespace penpose::articulation {
namespace {

using Curve = std::vector<ModelPoint>;

Curve random_curve(std::mt19937_64& random, std::size_t count) {
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53 - 0.5; };
  Curve curve;
  for (std::size_t i = 0; i < count; ++i) {
    curve.push_back({static_cast<double>(i) * 0.3 + uniform(), uniform(), uniform()});
  }
  return curve;
}

double segment(const Curve& curve, std::size_t j) { return geometry::distance(curve[j], curve[j + 1]); }

TEST(CurveMotion, StartsAtTheReferenceAndEndsAtTheTarget) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 50; ++trial) {
    for (const Mode mode : {Mode::translate, Mode::rotate}) {
      const Curve r = random_curve(random, 32);
      const Curve t = random_curve(random, 32);
      const CurveMotion motion(r, t, mode);
      const Curve start = motion.points(0.0);
      const Curve end = motion.points(1.0);
      for (std::size_t i = 0; i < r.size(); ++i) {
        EXPECT_LT(geometry::distance(start[i], r[i]), 1e-13);
        EXPECT_LT(geometry::distance(end[i], t[i]), 1e-12);
      }
    }
  }
}

TEST(CurveMotion, RotationInterpolatesSegmentLengthsExactly) {
  std::mt19937_64 random(2);
  const Curve r = random_curve(random, 20);
  const Curve t = random_curve(random, 20);
  const CurveMotion motion(r, t, Mode::rotate);
  for (const double amount : {0.25, 0.5, 0.9, 1.0}) {
    const Curve now = motion.points(amount);
    EXPECT_LT(geometry::distance(now[0], r[0] + (t[0] - r[0]) * amount), 1e-14);
    for (std::size_t j = 0; j + 1 < r.size(); ++j) {
      const double scale = segment(t, j) / segment(r, j);
      EXPECT_NEAR(segment(now, j), segment(r, j) * (1 + amount * (scale - 1)), 1e-12);
    }
  }
}

TEST(CurveMotion, RotationTurnsEverySegmentByItsShareOfTheWay) {
  // A straight line that becomes an arc in a plane: at half the amount it is an arc of half the bend.
  Curve r;
  Curve t;
  for (int i = 0; i <= 20; ++i) {
    r.push_back({i * 0.1, 0, 0});
    const double bend = i * 0.08;
    t.push_back({std::sin(bend) * 0.1 / 0.08, 0, 0.1 / 0.08 * (std::cos(bend) - 1)});
  }
  const Curve half = CurveMotion(r, t, Mode::rotate).points(0.5);
  for (std::size_t j = 0; j + 1 < r.size(); ++j) {
    const ModelVector d = half[j + 1] - half[j];
    const ModelVector full = t[j + 1] - t[j];
    const double angle = std::atan2(-d.z, d.x);
    EXPECT_NEAR(angle, 0.5 * std::atan2(-full.z, full.x), 1e-12);
    EXPECT_NEAR(d.y, 0.0, 1e-15);
  }
}

TEST(CurveMotion, TranslationGoesStraight) {
  std::mt19937_64 random(4);
  const Curve r = random_curve(random, 9);
  const Curve t = random_curve(random, 9);
  const Curve now = CurveMotion(r, t, Mode::translate).points(0.3);
  for (std::size_t i = 0; i < r.size(); ++i) EXPECT_LT(geometry::distance(now[i], r[i] * 0.7 + t[i] * 0.3), 1e-15);
}

TEST(CurveMotion, MakesNoFaultOfSegmentsWithoutLengthOrOfReversals) {
  const Curve r = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}};
  const Curve t = {{0, 0, 0}, {-1, 0, 0}, {-1, 1, 0}, {-1, 1, 0}, {5, 1, 3}};
  const CurveMotion motion(r, t, Mode::rotate);
  for (const double amount : {0.0, 0.4, 1.0, -3.0, 10.0}) {
    const Curve now = motion.points(amount);
    for (std::size_t i = 0; i < r.size(); ++i) {
      EXPECT_TRUE(std::isfinite(now[i].x) && std::isfinite(now[i].y) && std::isfinite(now[i].z));
    }
    for (std::size_t i = 0; amount == 1.0 && i < t.size(); ++i) {
      EXPECT_LT(geometry::distance(now[i], t[i]), 1e-12);
    }
  }
}

}  // namespace
}  // namespace penpose::articulation
