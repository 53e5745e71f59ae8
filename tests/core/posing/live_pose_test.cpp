#include "core/posing/live_pose.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/curve/pairing.h"
#include "core/curve/polyline.h"
#include "core/posing/curve_system.h"
#include "core/posing/solve.h"
#include "tests/support/models/posing_problems.h"

namespace penpose::posing {
namespace {

using Line = std::vector<geometry::PxPoint>;

/// A sheet seen from the front; 1 unit of the sheet is about 830 px.
struct Drawing {
  tests::Sheet sheet;
  geometry::Camera camera;
  LiveSetup setup;

  explicit Drawing(std::size_t shapes = 15, std::size_t joints = 0, std::uint64_t seed = 3)
      : sheet(shapes, seed, joints),
        camera(geometry::frame_box(sheet.mesh->rest_box(), {1000, 1000}, 0)),
        setup{sheet.row(15), {}, {}, rig::rest_pose(*sheet.rig), camera, {}} {
    setup.free.resize(setup.start.size());
    std::iota(setup.free.begin(), setup.free.end(), std::size_t{0});
  }

  [[nodiscard]] Line seen(const rig::Pose& pose) const {
    Line line;
    for (const ModelPoint& p : sheet.at(setup.reference, pose)) line.push_back(camera.project(p).value());
    return line;
  }
  /// What a pen draws along a curve: a report every few px.
  [[nodiscard]] static Line drawn(const Line& curve, std::size_t reports = 120) {
    return curve::resample<geometry::PxPoint>(curve, reports).value();
  }
  [[nodiscard]] LivePoser start() const { return LivePoser::start(*sheet.rig, setup).value(); }

  /// The energy of the whole stroke at a pose: what the full solve minimises.
  [[nodiscard]] PoseProblem whole(const Line& target) const {
    PoseProblem problem;
    const auto paired = curve::pair_target(sheet.at(setup.reference, setup.start), target, camera).value();
    problem.pairs.push_back({setup.reference, paired.points, {}});
    problem.constraints = setup.constraints;
    problem.free = setup.free;
    problem.start = setup.start;
    return problem;
  }
  [[nodiscard]] double energy(const PoseProblem& problem, const rig::Pose& pose) const {
    CurveSystem system(*sheet.rig, problem);
    Residuals residuals(system.residual_count());
    system.residuals(pose, residuals);
    return system.energy(residuals);
  }
  /// The drawn length L against the first L of the reference, point by point (lengths in px).
  [[nodiscard]] PoseProblem part(std::span<const geometry::PxPoint> target) const {
    const auto along = curve::cumulative_length<geometry::PxPoint>(seen(setup.start));
    const auto lengths = curve::cumulative_length<geometry::PxPoint>(target);
    const double stretch = std::max(1.0, lengths.back() / along.back());
    const auto at = sheet.at(setup.reference, setup.start);
    PoseProblem problem = whole(seen(setup.start));
    CurvePair pair;
    for (std::size_t i = 0; i < at.size() && along[i] * stretch <= lengths.back(); ++i) {
      const auto px = curve::resample_at<geometry::PxPoint>(target, std::vector{along[i] * stretch / lengths.back()});
      pair.reference.push_back(setup.reference[i]);
      pair.target.push_back(curve::lift(px.value()[0], at[i], camera));
    }
    problem.pairs = {pair};
    return problem;
  }
  /// Gap of a pose to the full solve, as a share of what the full solve gains.
  [[nodiscard]] double gap(const Line& target, const rig::Pose& pose) const { return gap(whole(target), pose); }
  [[nodiscard]] double gap(const PoseProblem& problem, const rig::Pose& pose) const {
    SolveWorkspace work;
    const Solution solution = solve(*sheet.rig, problem, {}, work).value();
    return (energy(problem, pose) - solution.energy) / (solution.energy_start - solution.energy);
  }
};

rig::Pose some_pose(std::size_t count, std::uint64_t seed) {
  tests::Random random(seed);
  rig::Pose pose(count, 0.0);
  for (double& x : pose) x = random.index(3) == 0 ? random(0.2, 0.9) : 0.0;
  return pose;
}

TEST(LivePose, TheMatchedShareGrowsWithTheDrawnLength) {
  const Drawing d;
  const Line target = d.drawn(d.seen(some_pose(15, 1)));
  auto poser = d.start();
  std::size_t before = 0;
  const double whole = curve::arc_length<geometry::PxPoint>(d.seen(d.setup.start));
  for (std::size_t n = 2; n <= target.size(); ++n) {
    const Line part(target.begin(), target.begin() + static_cast<std::ptrdiff_t>(n));
    const LiveStep step = poser.follow(part);
    EXPECT_GE(step.matched, before);
    before = step.matched;
    // Reference points lie every thirtieth of its length; those within the drawn length have a target.
    const double share = std::min(1.0, curve::arc_length<geometry::PxPoint>(part) / whole);
    EXPECT_NEAR(static_cast<double>(step.matched), 1 + 30 * share, 1.01) << n;
  }
  EXPECT_GE(before, 30U);
}

TEST(LivePose, TheDrawnLengthIsMatchedWithAsMuchOfTheReference) {
  const Drawing d;
  const Line target = d.drawn(d.seen(some_pose(15, 2)));
  auto poser = d.start();
  double worst = 0;
  for (std::size_t n = 2; n <= target.size(); ++n) {
    const LiveStep step = poser.follow(std::span(target).first(n));
    const PoseProblem problem = d.part(std::span(target).first(n));
    ASSERT_EQ(step.matched, problem.pairs[0].reference.size()) << n;
    EXPECT_NEAR(step.energy, d.energy(problem, poser.pose()), 1e-9) << n;
    // The face follows the pen: every step comes near to what a full solve of the part would find.
    worst = std::max(worst, d.gap(problem, poser.pose()));
  }
  EXPECT_LT(worst, 0.1);
}

TEST(LivePose, WhenThePenLiftsThePoseIsNearTheFullSolve) {
  for (const std::uint64_t seed : {2U, 7U, 8U}) {
    const Drawing d;
    const Line target = d.drawn(d.seen(some_pose(15, seed)));
    auto poser = d.start();
    for (std::size_t n = 2; n <= target.size(); ++n) poser.follow(std::span(target).first(n));
    EXPECT_LT(d.gap(target, poser.pose()), 0.05) << seed;
  }
}

TEST(LivePose, AStepKeepsItsBudgetOfEvaluations) {
  for (const std::size_t joints : {0U, 3U}) {
    Drawing d(60, joints);
    const Line target = d.drawn(d.seen(some_pose(d.setup.start.size(), 3)), 12);
    for (const std::size_t budget : {0U, 20U, 150U, 300U}) {
      d.setup.options.max_evaluations = budget;
      auto poser = d.start();
      EXPECT_EQ(poser.variables() > 20, true);
      for (std::size_t n = 2; n <= target.size(); ++n) {
        const LiveStep step = poser.follow(std::span(target).first(n));
        // Each of the finishing's iterations looks along one line in 11 places.
        const std::size_t finishing = joints > 0 ? 0 : 1 + 11 * d.setup.options.max_finish_iterations;
        EXPECT_LE(step.evaluations, budget + finishing);
      }
    }
  }
}

TEST(LivePose, JointsFollowToo) {
  Drawing d(4, 3);
  rig::Pose answer = d.setup.start;
  answer[2] = 0.5;
  answer[9] = 0.3;    // joint1.rz
  answer[12] = -0.2;  // joint2.rz
  const Line target = d.drawn(d.seen(answer), 60);
  auto poser = d.start();
  for (std::size_t n = 2; n <= target.size(); ++n) poser.follow(std::span(target).first(n));
  // A rig that is not linear is searched by the simplex alone, a few stages a report: most of the way, not all.
  EXPECT_LT(d.gap(target, poser.pose()), 0.25);
}

TEST(LivePose, ALineDrawnTheOtherWayGivesTheSamePose) {
  const Drawing d;
  Line target = d.drawn(d.seen(some_pose(15, 4)));
  const auto posed = [&](const Line& line) {
    auto poser = d.start();
    for (std::size_t n = 2; n <= line.size(); ++n) poser.follow(std::span(line).first(n));
    return poser.pose();
  };
  const auto forwards = posed(target);
  Line other = target;
  std::reverse(other.begin(), other.end());
  const auto backwards = posed(other);
  EXPECT_LT(d.gap(target, forwards), 0.03);
  EXPECT_LT(d.gap(target, backwards), 0.03);
}

TEST(LivePose, ATargetLongerThanTheReferenceIsMatchedAsAWhole) {
  const Drawing d;
  // The reference's line, half as long again: every point has a target, and the last one at the pen.
  Line target = d.seen(d.setup.start);
  for (geometry::PxPoint& p : target) p = {target.front().x + (p.x - target.front().x) * 1.5, p.y + 40};
  auto poser = d.start();
  const LiveStep step = poser.follow(target);
  EXPECT_EQ(step.matched, 31U);
  const PoseProblem problem = d.whole(target);
  EXPECT_NEAR(step.energy, d.energy(problem, poser.pose()), 1e-9) << "the targets of the full method";
}

TEST(LivePose, ReportsLeftOutAreNotMissed) {
  const Drawing d;
  const Line target = d.drawn(d.seen(some_pose(15, 5)));
  auto poser = d.start();
  for (int i = 0; i < 6; ++i) poser.follow(target);
  EXPECT_LT(d.gap(target, poser.pose()), 0.03);
}

TEST(LivePose, WithoutADrawnLengthNothingMoves) {
  const Drawing d;
  auto poser = d.start();
  for (const Line& line : {Line{}, Line{{500, 500}}, Line{{500, 500}, {500, 500}}, Line{{500, 500}, {NAN, 3}},
                           Line{{500, 500}, {INFINITY, 3}}}) {
    EXPECT_EQ(poser.follow(line).matched, 0U);
    EXPECT_EQ(poser.pose(), d.setup.start);
  }
}

TEST(LivePose, AConstraintHoldsItsCurve) {
  Drawing d(40, 0, 9);
  const auto kept = d.sheet.row(9);
  const auto at_rest = d.sheet.at(kept, d.setup.start);
  Line target = d.seen(d.setup.start);
  for (geometry::PxPoint& p : target) p.y -= 60;
  const auto moved = [&] {
    auto poser = d.start();
    for (int i = 0; i < 5; ++i) poser.follow(target);
    const auto at = d.sheet.at(kept, poser.pose());
    double sum = 0;
    for (std::size_t i = 0; i < at.size(); ++i) sum += geometry::distance(at[i], at_rest[i]);
    return sum;
  };
  const double loose = moved();
  d.setup.constraints.push_back({kept, at_rest});
  EXPECT_LT(moved(), 0.5 * loose);
}

TEST(LivePose, TheSameReportsGiveTheSameBits) {
  const Drawing d(40);
  const Line target = d.drawn(d.seen(some_pose(40, 6)), 20);
  auto one = d.start();
  auto other = d.start();
  for (std::size_t n = 2; n <= target.size(); ++n) {
    one.follow(std::span(target).first(n));
    other.follow(std::span(target).first(n));
    EXPECT_EQ(one.pose(), other.pose());
  }
}

TEST(LivePose, AnythingDrawnLeavesAPoseInItsRanges) {
  const Drawing d(20, 2);
  tests::Random random(31);
  auto poser = d.start();
  for (int run = 0; run < 60; ++run) {
    Line line;
    const std::size_t size = random.index(8);
    for (std::size_t i = 0; i < size; ++i) {
      line.push_back({random(-500, 1500), random(-500, 1500)});
      if (random.index(20) == 0) line.back().x = random.index(2) == 0 ? NAN : 1e308;
      if (random.index(5) == 0) line.push_back(line.back());
    }
    const LiveStep step = poser.follow(line);
    EXPECT_TRUE(std::isfinite(step.energy));
    for (std::size_t p = 0; p < poser.pose().size(); ++p) {
      EXPECT_GE(poser.pose()[p], d.sheet.rig->parameters()[p].minimum);
      EXPECT_LE(poser.pose()[p], d.sheet.rig->parameters()[p].maximum);
    }
  }
}

TEST(LivePose, AWholeTargetThatIsChangedIsFollowedPointByPoint) {
  Drawing d;
  rig::Pose there = rig::rest_pose(*d.sheet.rig);
  there[2] = 0.6;
  there[5] = 0.4;
  const Line target = Drawing::drawn(d.seen(there));
  const auto whole = d.whole(target);
  LivePoser poser = d.start();
  LiveStep step;
  for (int i = 0; i < 10; ++i) step = poser.follow_points(whole.pairs[0].target);
  EXPECT_EQ(step.matched, d.setup.reference.size());
  EXPECT_LT(d.gap(target, poser.pose()), 0.05);
  // What does not fit the reference moves nothing.
  const rig::Pose before = poser.pose();
  EXPECT_EQ(poser.follow_points({}).evaluations, 0U);
  const std::vector<double> one{1};
  EXPECT_EQ(poser.follow_points(whole.pairs[0].target, one).evaluations, 0U);
  EXPECT_EQ(poser.pose(), before);
}

TEST(LivePose, SaysWhatIsWrong) {
  const auto what = [](auto spoil) {
    Drawing d;
    spoil(d.setup);
    const auto poser = LivePoser::start(*d.sheet.rig, d.setup);
    return poser ? std::string("started") : poser.error().what;
  };
  EXPECT_EQ(what([](LiveSetup&) {}), "started");
  EXPECT_NE(what([](LiveSetup& s) { s.reference.clear(); }), "started");
  EXPECT_EQ(what([](LiveSetup& s) { s.reference.resize(1); }), "the reference curve has no length in this view");
  EXPECT_EQ(what([](LiveSetup& s) { s.reference.assign(5, at_vertex(3)); }),
            "the reference curve has no length in this view");
  EXPECT_EQ(what([](LiveSetup& s) {
              s.camera = geometry::Camera::make({{0.5, 0.5, -1}, {0.5, 0.5, -2}, {0, 1, 0}, 30}, {100, 100}).value();
            }),
            "the reference curve lies behind the camera");
  EXPECT_NE(what([](LiveSetup& s) { s.free = {99}; }), "started");
  EXPECT_NE(what([](LiveSetup& s) { s.start[0] = 7; }), "started");
}

}  // namespace
}  // namespace penpose::posing
