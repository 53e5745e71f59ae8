// Strokes along the limbs of a body whose joints stand in odd frames: the limb that was drawn follows, and nothing
// else.
#include <gtest/gtest.h>

#include "core/base/math.h"
#include "core/intent/live.h"
#include "core/intent/solve.h"
#include "core/joints/turn.h"
#include "tests/core/intent/face.h"
#include "tests/support/models/stick_figure.h"

namespace penpose::intent {
namespace {

using geometry::ModelVector;
using Joints = std::vector<std::size_t>;
struct Bend {
  std::size_t joint;
  ModelVector axis;
  double degrees;
};

struct Figure {
  tests::StickFigure figure;
  std::shared_ptr<const rig::CharacterRig> rig = figure.rig();
  WholeModel whole = measure_whole_model(*rig);
  double unit;

  explicit Figure(double u = 1) : figure(tests::stick_man(u)), unit(u) {}
  Figure(tests::StickFigure other, double u) : figure(std::move(other)), unit(u) {}

  [[nodiscard]] rig::Pose pose(const std::vector<Bend>& bends) const {
    rig::Pose pose = rig::rest_pose(*rig);
    for (const Bend& bend : bends) {
      const glm::dvec3 angles = figure.angles(bend.joint, bend.axis, base::radians(bend.degrees));
      for (int k = 0; k < 3; ++k) pose[3 * bend.joint + static_cast<std::size_t>(k)] = angles[k];
    }
    return pose;
  }
  [[nodiscard]] geometry::Camera camera(double yaw) const {
    const double a = base::radians(yaw);
    return geometry::Camera::make({ModelVector{4 * std::sin(a), 0.9, 4 * std::cos(a)} * unit,
                                   ModelVector{0, 0.9, 0} * unit,
                                   {0, 1, 0},
                                   35},
                                  {1000, 1000})
        .value();
  }
  /// The limb drawn as it stands in a pose, by a hand that shakes.
  [[nodiscard]] IntentProblem problem(const Joints& chain, const rig::Pose& answer, double yaw, std::uint64_t seed,
                                      double tremor = 1.0) const {
    DrawnCurve curve{{}, camera(yaw), {}, k_doubt_px, {}};
    const auto posed = tests::all_positions(*rig, answer);
    for (const std::size_t joint : chain) {
      for (const std::uint32_t v : figure.along(joint)) {
        curve.reference.push_back(posing::at_vertex(v));
        curve.target.push_back(curve.camera.project(posed[v]).value());
      }
    }
    if (tremor > 0) curve.target = tests::shaken(curve.target, tremor, seed);
    IntentProblem problem;
    problem.drawn.push_back(std::move(curve));
    problem.start = rig::rest_pose(*rig);
    problem.free.resize(problem.start.size());
    std::iota(problem.free.begin(), problem.free.end(), std::size_t{0});
    return problem;
  }
  [[nodiscard]] Solution solve(const IntentProblem& problem) const {
    SolveWorkspace work;
    return intent::solve(*rig, whole, problem, {}, work).value();
  }
  /// Root mean square over all vertices, per cent of the height.
  [[nodiscard]] double error(const rig::Pose& a, const rig::Pose& b) const {
    const auto one = tests::all_positions(*rig, a);
    const auto other = tests::all_positions(*rig, b);
    double sum = 0;
    for (std::size_t v = 0; v < one.size(); ++v) sum += glm::dot(one[v] - other[v], one[v] - other[v]);
    return 100 * std::sqrt(sum / static_cast<double>(one.size())) / (1.7 * unit);
  }
  /// How far a joint is turned from rest, degrees.
  [[nodiscard]] static double turned(const rig::Pose& pose, std::size_t joint) {
    const glm::dquat q = geometry::quaternion_from_xyz({pose[3 * joint], pose[3 * joint + 1], pose[3 * joint + 2]});
    return base::degrees(2 * base::acos(std::abs(q.w)));
  }
  /// How far it is twisted about its own bone.
  [[nodiscard]] double twisted(const rig::Pose& pose, std::size_t joint) const {
    const glm::dquat q = geometry::quaternion_from_xyz({pose[3 * joint], pose[3 * joint + 1], pose[3 * joint + 2]});
    const glm::dvec3 bone = glm::conjugate(figure.frame(joint)) * whole.body->bone(joint, {});
    return base::degrees(2 * base::atan2(std::abs(glm::dot(glm::dvec3{q.x, q.y, q.z}, bone)), std::abs(q.w)));
  }
  void expect_only(const Joints& chain, const rig::Pose& pose, const std::string& what) const {
    for (std::size_t joint = 0; joint < whole.body->size(); ++joint) {
      if (std::find(chain.begin(), chain.end(), joint) != chain.end()) continue;
      EXPECT_LE(turned(pose, joint), 1.0) << what << ": joint " << joint << " was not drawn";
    }
  }
};

struct Movement {
  const char* name;
  double yaw;
  Joints chain;
  std::vector<Bend> bends;
};

const ModelVector k_x{1, 0, 0};
const ModelVector k_y{0, 1, 0};
const ModelVector k_z{0, 0, 1};

const std::vector<Movement>& movements() {
  static const std::vector<Movement> all = {
      {"arm up", 0, {6, 7, 8}, {{6, k_z, 50}}},
      {"arm down", 0, {12, 13, 14}, {{12, k_z, 45}}},
      {"elbow", 0, {6, 7, 8}, {{7, k_z, 60}}},
      {"arm and elbow", 0, {12, 13, 14}, {{12, k_z, -25}, {13, k_z, -50}}},
      {"arm up, three-quarter", 35, {6, 7, 8}, {{6, k_z, 45}}},
      {"leg to the side", 0, {9, 10}, {{9, k_z, 35}}},
      {"knee", 90, {9, 10}, {{9, k_x, -45}, {10, k_x, 60}}},
      {"leg back", -90, {9, 10}, {{9, k_x, 30}}},
      {"side bend", 0, {0, 1, 2, 3, 4, 5}, {{1, k_z, 9}, {2, k_z, 9}, {3, k_z, 9}, {4, k_z, 9}}},
      {"bow", 90, {0, 1, 2, 3, 4, 5}, {{1, k_x, 11}, {2, k_x, 11}, {3, k_x, 11}, {4, k_x, 11}}},
      {"nod", 90, {4, 5}, {{5, k_x, 30}}},
  };
  return all;
}

TEST(IntentBody, WhatWasDrawnIsPosedAndNothingElseTurns) {
  for (const double unit : {1.0, 100.0}) {
    const Figure man(unit);
    for (const Movement& m : movements()) {
      const rig::Pose answer = man.pose(m.bends);
      for (std::uint64_t seed = 0; seed < 2; ++seed) {
        const rig::Pose pose = man.solve(man.problem(m.chain, answer, m.yaw, seed)).pose;
        EXPECT_LT(man.error(pose, answer), 2.0) << m.name << ", unit " << unit << ", seed " << seed;
        man.expect_only(m.chain, pose, m.name);
      }
    }
  }
}

TEST(IntentBody, NoTwistThatWasNotDrawn) {
  const Figure man;
  for (const Movement& m : movements()) {
    // A limb that leans out of the picture turns about the view's direction, which twists it as the picture does.
    if (m.yaw == 35) continue;
    const rig::Pose answer = man.pose(m.bends);
    const rig::Pose pose = man.solve(man.problem(m.chain, answer, m.yaw, 3)).pose;
    for (const std::size_t joint : m.chain)
      EXPECT_LT(man.twisted(pose, joint), man.twisted(answer, joint) + 6) << m.name << ", joint " << joint;
  }
}

TEST(IntentBody, ALineOfActionBendsTheSpineEvenly) {
  const Figure man;
  const Joints chain{0, 1, 2, 3, 4, 5};
  for (const double each : {-10.0, 6.0, 12.0}) {
    const rig::Pose answer = man.pose({{1, k_z, each}, {2, k_z, each}, {3, k_z, each}, {4, k_z, each}});
    const rig::Pose pose = man.solve(man.problem(chain, answer, 0, 7)).pose;
    EXPECT_LT(Figure::turned(pose, 0), 1.0) << "the legs stay";
    for (std::size_t joint = 1; joint <= 4; ++joint)
      EXPECT_NEAR(Figure::turned(pose, joint), std::abs(each), 0.35 * std::abs(each)) << each << ", joint " << joint;
  }
}

TEST(IntentBody, AnSBendsTheSpineToAndFro) {
  const Figure man;
  const rig::Pose answer = man.pose({{1, k_z, 14}, {2, k_z, 14}, {3, k_z, -16}, {4, k_z, -16}});
  const rig::Pose pose = man.solve(man.problem({0, 1, 2, 3, 4, 5}, answer, 0, 1)).pose;
  EXPECT_LT(man.error(pose, answer), 1.0);
  EXPECT_GT(man.error(rig::rest_pose(*man.rig), answer), 2.5);
}

TEST(IntentBody, ALimbRedrawnWhereItIsStays) {
  const Figure man;
  for (const Movement& m : movements()) {
    const rig::Pose rest = rig::rest_pose(*man.rig);
    EXPECT_EQ(man.solve(man.problem(m.chain, rest, m.yaw, 5)).pose, rest) << m.name;
  }
}

TEST(IntentBody, TwistJointsAreNotMeant) {
  tests::StickFigure figure = tests::stick_man();
  const std::size_t helper = figure.add_helper(6, 0.7);
  const Figure man(figure, 1);
  const rig::Pose answer = man.pose({{6, k_z, 50}});
  const rig::Pose pose = man.solve(man.problem({6, 7, 8}, answer, 0, 2)).pose;
  EXPECT_LT(man.error(pose, answer), 1.0);
  EXPECT_EQ(Figure::turned(pose, helper), 0.0);
}

TEST(IntentBody, ADownwardStrokeFromTheHandBackIsTheSame) {
  const Figure man;
  const rig::Pose answer = man.pose({{6, k_z, 50}});
  IntentProblem problem = man.problem({6, 7, 8}, answer, 0, 4);
  const rig::Pose forth = man.solve(problem).pose;
  std::reverse(problem.drawn[0].target.begin(), problem.drawn[0].target.end());
  EXPECT_LT(man.error(man.solve(problem).pose, forth), 0.2);
}

TEST(IntentBody, ATentacleCurlsInAllItsJoints) {
  tests::StickFigure rope(10);
  Joints chain;
  for (int k = 0; k < 12; ++k) chain.push_back(rope.add(k - 1, {0, 0.14 * k, 0}, {0, 0.14 * (k + 1), 0}, 0.03));
  const Figure figure(rope, 10);
  std::vector<Bend> bends;
  for (const std::size_t joint : chain) bends.push_back({joint, k_z, 7});
  const rig::Pose answer = figure.pose(bends);
  const rig::Pose pose = figure.solve(figure.problem(chain, answer, 0, 1)).pose;
  EXPECT_LT(figure.error(pose, answer), 4.0);
  for (std::size_t joint = 0; joint < 12; ++joint) EXPECT_NEAR(Figure::turned(pose, joint), 7, 1.5) << joint;
}

TEST(IntentBody, FrontAndSideTogetherShowWhereTheArmGoes) {
  const Figure man;
  const rig::Pose answer = man.pose({{6, geometry::normalized(ModelVector{0.2, 0.6, 1}), 50}});
  IntentProblem both = man.problem({6, 7, 8}, answer, 0, 1);
  both.drawn.push_back(man.problem({6, 7, 8}, answer, 70, 2).drawn[0]);
  const rig::Pose pose = man.solve(both).pose;
  EXPECT_LT(man.error(pose, answer), 1.5);
  man.expect_only({6, 7, 8}, pose, "two views");
}

TEST(IntentBody, RangesOfTheFileAreKept) {
  tests::StickFigure figure = tests::stick_man();
  figure.limit(6, {-0.3, -0.3, -0.3}, {0.3, 0.3, 0.3});
  const Figure man(figure, 1);
  const Solution solution = man.solve(man.problem({6, 7, 8}, man.pose({{6, k_z, 50}}), 0, 1));
  for (std::size_t k = 18; k < 21; ++k) EXPECT_LE(std::abs(solution.pose[k]), 0.3);
}

TEST(IntentBody, LockedJointsStay) {
  const Figure man;
  IntentProblem problem = man.problem({6, 7, 8}, man.pose({{6, k_z, 40}}), 0, 1);
  std::erase_if(problem.free, [](std::size_t p) { return p / 3 == 6; });
  const rig::Pose pose = man.solve(problem).pose;
  EXPECT_EQ(Figure::turned(pose, 6), 0.0);
}

TEST(IntentBody, WhileDrawnNothingElseTurnsAndTheEndIsTheSolves) {
  const Figure man;
  for (const Movement& m : movements()) {
    const IntentProblem problem = man.problem(m.chain, man.pose(m.bends), m.yaw, 6);
    const auto target = problem.drawn[0].target;
    const rig::Pose whole = man.solve(problem).pose;
    LivePoser poser = LivePoser::start(*man.rig, man.whole, problem).value();
    rig::Pose before = problem.start;
    double largest = 0;
    double way = 0;
    for (std::size_t n = 2; n <= target.size(); ++n) {
      // Three reports a segment, as a pen sends them.
      for (const double share : {0.33, 0.67, 1.0}) {
        auto line = std::vector(target.begin(), target.begin() + static_cast<std::ptrdiff_t>(n));
        line.back() = line[n - 2] * (1 - share) + line.back() * share;
        poser.follow(line);
        man.expect_only(m.chain, poser.pose(), m.name);
        way += man.error(poser.pose(), before);
        before = poser.pose();
        largest = std::max(largest, man.error(before, problem.start));
      }
    }
    EXPECT_LT(man.error(poser.pose(), whole), 1.0) << m.name;
    EXPECT_LT(way, 4 * largest) << m.name << " flickers";
  }
}

}  // namespace
}  // namespace penpose::intent
