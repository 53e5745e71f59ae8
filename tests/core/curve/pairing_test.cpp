#include "core/curve/pairing.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/curve/polyline.h"
#include "tests/support/models/test_rigs.h"

namespace penpose::curve {
namespace {

using Px = std::vector<PxPoint>;
using Model = std::vector<ModelPoint>;

/// Looks down z at the origin from 10: 1 unit at z = 0 is 50 px, the origin is at (500, 500).
geometry::Camera front() {
  return geometry::Camera::make({{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 90}, {1000, 1000}).value();
}

Px seen(const Model& points, const geometry::Camera& camera) {
  Px px;
  for (const ModelPoint& p : points) px.push_back(camera.project(p).value());
  return px;
}

double sum_of_distances(const Model& a, const Model& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += geometry::distance(a[i], b[i]);
  return sum;
}

/// `count` points around an ellipse, from `start` radians, with a gap of `gap` radians at the end.
Px ellipse(std::size_t count, double start, double direction, double gap = 0) {
  Px line;
  for (std::size_t i = 0; i < count; ++i) {
    const double a =
        start + direction * (2 * 3.14159265358979 - gap) * static_cast<double>(i) / static_cast<double>(count - 1);
    line.push_back({500 + 300 * std::cos(a), 500 + 120 * std::sin(a)});
  }
  return line;
}

Model on_plane(const Px& line) {
  Model points;
  for (const PxPoint& p : line) points.emplace_back((p.x - 500) / 50, (500 - p.y) / 50, 0);
  return points;
}

TEST(Pairing, TheSamePlaceGrowsWithTheViewport) {
  EXPECT_EQ(pairing_distance_px({1600, 1000}), 10);
  EXPECT_EQ(pairing_distance_px({100, 2000}), 20);
}

TEST(Pairing, ALineIsClosedWhenItsEndsMeetAndItWentSomewhere) {
  EXPECT_TRUE(is_closed(Px{{0, 0}, {50, 0}, {50, 50}, {3, 4}}, 10));
  EXPECT_FALSE(is_closed(Px{{0, 0}, {50, 0}, {50, 50}, {30, 4}}, 10));
  EXPECT_FALSE(is_closed(Px{{0, 0}, {6, 0}, {0, 3}}, 10)) << "a dot that trembled is no loop";
  EXPECT_FALSE(is_closed(Px{{0, 0}, {5, 0}}, 10));
  EXPECT_FALSE(is_closed(Px{}, 10));
}

TEST(Pairing, ALineRunsBackwardsWhenItsEndIsNearerToTheReferencesStart) {
  const Px reference{{0, 0}, {100, 0}};
  EXPECT_FALSE(runs_backwards(reference, Px{{10, 50}, {90, 50}}));
  EXPECT_TRUE(runs_backwards(reference, Px{{90, 50}, {10, 50}}));
  // The rule asks for the reference's start alone, whatever its end is nearer to.
  EXPECT_FALSE(runs_backwards(reference, Px{{40, 0}, {-50, 0}}));
}

TEST(Pairing, LiftsToTheDistanceOfTheReferenceFromTheEye) {
  const auto camera = front();
  const ModelPoint reference{2, 1, 4};
  const PxPoint px{321, 654};
  const ModelPoint lifted = lift(px, reference, camera);
  EXPECT_NEAR(geometry::distance(lifted, camera.eye()), geometry::distance(reference, camera.eye()), 1e-12);
  EXPECT_NEAR(geometry::distance(camera.project(lifted).value(), px), 0, 1e-9);
  const ModelPoint self = lift(camera.project(reference).value(), reference, camera);
  EXPECT_NEAR(geometry::distance(self, reference), 0, 1e-12) << "a line drawn over the reference is the reference";
}

TEST(PairTarget, GoesByLengthAlongTheLine) {
  const auto camera = front();
  const Model reference{{-4, 0, 0}, {-2, 0, 0}, {0, 0, 0}, {2, 0, 0}, {4, 0, 0}};
  const Px target{{300, 300}, {320, 300}, {700, 300}};  // 400 px, unevenly sampled
  const auto paired = pair_target(reference, target, camera).value();
  ASSERT_EQ(paired.points.size(), 5U);
  EXPECT_FALSE(paired.reversed);
  const Px at = seen(paired.points, camera);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(paired.shares[i], 0.25 * static_cast<double>(i), 1e-12);
    EXPECT_NEAR(at[i].x, 300 + 100.0 * static_cast<double>(i), 1e-9);
    EXPECT_NEAR(geometry::distance(paired.points[i], camera.eye()), geometry::distance(reference[i], camera.eye()),
                1e-12);
  }
}

TEST(PairTarget, AnUnevenReferenceKeepsItsShares) {
  const auto camera = front();
  const Model reference{{-4, 0, 0}, {-3, 0, 0}, {4, 0, 0}};
  const auto at = seen(pair_target(reference, Px{{100, 200}, {900, 200}}, camera)->points, camera);
  EXPECT_NEAR(at[1].x, 200, 1e-9);
}

TEST(PairTarget, TurnsALineRoundThatWasDrawnTheOtherWay) {
  const auto camera = front();
  const Model reference{{-4, 0, 0}, {-3, 0, 0}, {4, 0, 0}};
  const Px forwards{{100, 200}, {900, 210}};
  const Px backwards{{900, 210}, {100, 200}};
  const auto one = pair_target(reference, forwards, camera).value();
  const auto other = pair_target(reference, backwards, camera).value();
  EXPECT_FALSE(one.reversed);
  EXPECT_TRUE(other.reversed);
  EXPECT_NEAR(sum_of_distances(one.points, other.points), 0, 1e-9);
}

TEST(PairTarget, SharesAreThoseOfTheLineAsItWasDrawn) {
  // Pressure along the stroke is looked up by these shares, so they count from where the pen went down.
  const auto camera = front();
  const auto expect_shares = [&](const Model& reference, const Px& target) {
    const auto paired = pair_target(reference, target, camera).value();
    Px loop = target;
    if (is_closed(target, 10)) loop.push_back(loop.front());
    const auto at = resample_at<PxPoint>(loop, paired.shares).value();
    const Px shown = seen(paired.points, camera);
    for (std::size_t i = 0; i < at.size(); ++i) EXPECT_NEAR(geometry::distance(at[i], shown[i]), 0, 1e-6) << i;
    return paired.reversed;
  };
  const Model reference{{-4, 0, 0}, {-3, 0, 0}, {4, 0, 0}};
  EXPECT_FALSE(expect_shares(reference, Px{{100, 200}, {150, 300}, {900, 210}}));
  EXPECT_TRUE(expect_shares(reference, Px{{900, 210}, {150, 300}, {100, 200}}));
  const Model loop = on_plane(ellipse(25, 0, 1));
  EXPECT_FALSE(expect_shares(loop, ellipse(60, 1.3, 1, 0.01)));
  EXPECT_TRUE(expect_shares(loop, ellipse(60, 1.3, -1, 0.01)));
}

TEST(PairTarget, TwoClosedCurvesPairByTheLeastSumOfDistances) {
  const auto camera = front();
  const Model reference = on_plane(ellipse(25, 0, 1));
  for (const double start : {0.0, 1.0, 2.5, 4.0, 6.0}) {
    for (const double direction : {1.0, -1.0}) {
      // The same ellipse, but begun elsewhere and perhaps drawn the other way round: it fits almost exactly.
      const auto paired = pair_target(reference, ellipse(200, start, direction, 0.005), camera).value();
      EXPECT_EQ(paired.reversed, direction < 0);
      // Within half a step of the reference's 24 places.
      EXPECT_LT(sum_of_distances(paired.points, reference) / 25, 0.5 * arc_length<ModelPoint>(reference) / 24)
          << start << " " << direction;
    }
  }
}

TEST(PairTarget, NoOtherShiftOfAClosedCurveFitsBetter) {
  const auto camera = front();
  tests::Random random(23);
  for (int run = 0; run < 20; ++run) {
    const std::size_t n = 9 + random.index(12);
    const Model reference = on_plane(ellipse(n, random(0, 6), 1));
    Px target = ellipse(80, random(0, 6), random.index(2) == 0 ? 1 : -1);
    for (PxPoint& p : target) p = {p.x * 0.7 + 130, p.y * 1.1 - 20};
    const auto paired = pair_target(reference, target, camera).value();
    const double kept = sum_of_distances(paired.points, reference);
    const auto shares = shares_of<PxPoint>(seen(reference, camera)).value();
    Px loop = target;
    loop.push_back(loop.front());
    double least = 1e300;
    for (int direction = 0; direction < 2; ++direction) {
      for (std::size_t shift = 0; shift + 1 < n; ++shift) {
        std::vector<double> turned;
        for (const double share : shares) turned.push_back(std::fmod(share + shares[shift], 1.0));
        const auto at = resample_at<PxPoint>(loop, turned).value();
        Model lifted;
        for (std::size_t i = 0; i < n; ++i) lifted.push_back(lift(at[i], reference[i], camera));
        least = std::min(least, sum_of_distances(lifted, reference));
      }
      std::reverse(loop.begin(), loop.end());
    }
    EXPECT_NEAR(kept, least, 1e-6);
  }
}

TEST(PairTarget, AnOpenTargetOfAClosedReferenceKeepsItsOrder) {
  const auto camera = front();
  const Model loop = on_plane(ellipse(25, 0, 1));
  const auto paired = pair_target(loop, Px{{790, 500}, {200, 500}}, camera).value();
  EXPECT_EQ(paired.shift, 0U);
  EXPECT_NEAR(seen(paired.points, camera).front().x, 790, 1e-9);
}

TEST(PairTarget, SaysWhatIsWrong) {
  const auto camera = front();
  const Model reference{{-1, 0, 0}, {1, 0, 0}};
  const Px target{{1, 1}, {99, 99}};
  const auto what = [&](const Model& r, const Px& t) {
    const auto paired = pair_target(r, t, camera);
    return paired ? std::string("paired") : paired.error().what;
  };
  EXPECT_EQ(what(reference, {}), "the target has fewer than two points");
  EXPECT_EQ(what(reference, {{5, 5}}), "the target has fewer than two points");
  EXPECT_EQ(what(reference, {{5, 5}, {5, 5}}), "the curve has no length");
  EXPECT_EQ(what(reference, {{5, 5}, {NAN, 5}}), "the curve has a point that is not finite");
  EXPECT_EQ(what({{-1, 0, 0}, {1, 0, 11}}, target), "the reference curve lies behind the camera");
  EXPECT_EQ(what({{0, 0, 0}, {0, 0, 1}}, target), "the reference curve has no length in this view");
  EXPECT_EQ(what({}, target), "the reference curve has no length in this view");
}

TEST(PairTarget, AnythingDrawnIsAFiniteCurveOrAnError) {
  const auto camera = front();
  tests::Random random(29);
  int paired_runs = 0;
  for (int run = 0; run < 400; ++run) {
    Model reference;
    const std::size_t n = random.index(10);
    for (std::size_t i = 0; i < n; ++i) reference.push_back(random.vector(random.index(20) == 0 ? 30 : 4));
    if (random.index(4) == 0 && n > 0) reference.push_back(reference.front());
    Px target;
    const std::size_t size = random.index(10);
    for (std::size_t i = 0; i < size; ++i) {
      target.push_back({random(-100, 1100), random(-100, 1100)});
      if (random.index(40) == 0) target.back().x = random.index(2) == 0 ? NAN : INFINITY;
      if (random.index(40) == 0) target.back().y = 1e308;
    }
    if (random.index(4) == 0 && size > 0) target.push_back(target.front());
    const auto paired = pair_target(reference, target, camera);
    if (!paired) {
      EXPECT_FALSE(paired.error().what.empty());
      continue;
    }
    ++paired_runs;
    ASSERT_EQ(paired->points.size(), reference.size());
    for (const ModelPoint& p : paired->points)
      EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  }
  EXPECT_GT(paired_runs, 100);
}

}  // namespace
}  // namespace penpose::curve
