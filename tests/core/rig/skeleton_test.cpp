#include "core/rig/skeleton.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/base/math.h"
#include "tests/support/models/test_rigs.h"

namespace penpose::rig {
namespace {

constexpr double k_quarter = base::k_pi / 2;

/// Two joints: the root at (1, 0, 0), its child 2 further along x; vertex 0 hangs on the root, vertex 1 on the child,
/// vertex 2 on both in equal shares, vertex 3 on none. Bound at rest.
struct Chain {
  std::vector<Joint> joints = std::vector<Joint>(2);
  std::vector<std::uint32_t> first{0, 1, 2, 4, 4};
  std::vector<Influence> influences{{0, 1}, {1, 1}, {0, 0.5}, {1, 0.5}};

  Chain() {
    joints[0].name = "root";
    joints[0].translation = {1, 0, 0};
    joints[0].inverse_bind[3] = {-1, 0, 0, 1};
    joints[1].name = "tip";
    joints[1].parent = 0;
    joints[1].translation = {2, 0, 0};
    joints[1].inverse_bind[3] = {-3, 0, 0, 1};
  }
  [[nodiscard]] auto make() const { return Skeleton::make(joints, first, influences); }
};

ModelPoint posed(const Skeleton& skeleton, const std::vector<double>& values, std::uint32_t vertex,
                 const ModelPoint& rest) {
  std::vector<glm::dmat4> matrices(skeleton.joints().size());
  skeleton.joint_matrices(values, matrices);
  return ModelPoint(skeleton.vertex_matrix(vertex, matrices) * glm::dvec4(rest, 1));
}

void expect_at(const ModelPoint& got, const ModelPoint& want) {
  EXPECT_NEAR(geometry::distance(got, want), 0, 1e-12) << got.x << " " << got.y << " " << got.z;
}

TEST(Skeleton, HasThreeParametersAJoint) {
  const auto skeleton = Chain().make().value();
  std::vector<std::string> names;
  for (const Parameter& p : skeleton->parameters()) names.push_back(p.name);
  EXPECT_EQ(names, (std::vector<std::string>{"root.rx", "root.ry", "root.rz", "tip.rx", "tip.ry", "tip.rz"}));
  EXPECT_EQ(skeleton->parameters()[0].rest, 0);
  EXPECT_EQ(skeleton->parameters()[0].maximum, k_quarter);
  EXPECT_EQ(skeleton->joint_of(2), 0U);
  EXPECT_EQ(skeleton->joint_of(3), 1U);
  EXPECT_EQ(skeleton->vertex_count(), 4U);
}

TEST(Skeleton, JointsThatAreNotPosableHaveNone) {
  Chain chain;
  chain.joints[0].posable = false;
  chain.joints[1].minimum = {-0.1, -0.2, -0.3};
  const auto skeleton = chain.make().value();
  ASSERT_EQ(skeleton->parameters().size(), 3U);
  EXPECT_EQ(skeleton->parameters()[1].name, "tip.ry");
  EXPECT_EQ(skeleton->parameters()[1].minimum, -0.2);
  EXPECT_EQ(skeleton->joint_of(0), 1U);
  expect_at(posed(*skeleton, {0, 0, k_quarter}, 1, {4, 0, 0}), {3, 1, 0});
}

TEST(Skeleton, AtRestNothingMoves) {
  const auto skeleton = Chain().make().value();
  const std::vector<double> rest(6, 0.0);
  for (std::uint32_t v = 0; v < 4; ++v) expect_at(posed(*skeleton, rest, v, {4, 5, 6}), {4, 5, 6});
}

TEST(Skeleton, AJointCarriesWhatHangsBelowIt) {
  const auto skeleton = Chain().make().value();
  // The root turns a quarter about z: the vertex 3 beyond it along x ends up 3 above it.
  const std::vector<double> root{0, 0, k_quarter, 0, 0, 0};
  expect_at(posed(*skeleton, root, 0, {4, 0, 0}), {1, 3, 0});
  expect_at(posed(*skeleton, root, 1, {4, 0, 0}), {1, 3, 0});
  // The tip turns alone: its vertex swings about (3, 0, 0), the root's stays.
  const std::vector<double> tip{0, 0, 0, 0, 0, k_quarter};
  expect_at(posed(*skeleton, tip, 0, {4, 0, 0}), {4, 0, 0});
  expect_at(posed(*skeleton, tip, 1, {4, 0, 0}), {3, 1, 0});
  // Both: the tip's joint is at (1, 2, 0) and its turns add up to a half.
  const std::vector<double> both{0, 0, k_quarter, 0, 0, k_quarter};
  expect_at(posed(*skeleton, both, 1, {4, 0, 0}), {0, 2, 0});
}

TEST(Skeleton, BlendsLinearly) {
  const auto skeleton = Chain().make().value();
  const std::vector<double> tip{0, 0, 0, 0, 0, k_quarter};
  // Half of the root's (4, 0, 0) and half of the tip's (3, 1, 0).
  expect_at(posed(*skeleton, tip, 2, {4, 0, 0}), {3.5, 0.5, 0});
  expect_at(posed(*skeleton, tip, 3, {4, 0, 0}), {4, 0, 0});
}

TEST(Skeleton, TurnsAboutXThenTheTurnedYThenTheTurnedZ) {
  const auto skeleton = Chain().make().value();
  // As matrices Rx Ry Rz: the turn about z is applied to the vertex first. (1, 0, 0) goes to y by z, and on to z by x.
  expect_at(posed(*skeleton, {k_quarter, 0, k_quarter, 0, 0, 0}, 0, {2, 0, 0}), {1, 0, 1});
  // (0, 1, 0) goes to -x by z, then to z by y.
  expect_at(posed(*skeleton, {0, k_quarter, k_quarter, 0, 0, 0}, 0, {1, 1, 0}), {1, 0, 1});
  // (0, 0, 1) goes to x by y and stays there under x.
  expect_at(posed(*skeleton, {k_quarter, k_quarter, 0, 0, 0, 0}, 0, {1, 0, 1}), {2, 0, 0});
}

TEST(Skeleton, ParametersTurnInTheJointsOwnFrame) {
  Chain chain;
  // The root rests turned a quarter about z, so that its own x axis is the world's y.
  chain.joints[0].rest_rotation = glm::dquat(std::sqrt(0.5), 0, 0, std::sqrt(0.5));
  const auto skeleton = chain.make().value();
  const auto at = [&](const ModelPoint& rest) { return posed(*skeleton, {k_quarter, 0, 0, 0, 0, 0}, 0, rest); };
  // In the joint's frame (0, 1, 0) turns to (0, 0, 1); the rest rotation leaves z alone.
  expect_at(at({1, 1, 0}), {1, 0, 1});
  expect_at(at({2, 0, 0}), {1, 1, 0});
}

TEST(Skeleton, ScaleActsBeforeTheTurn) {
  Chain chain;
  chain.joints[1].scale = {1, 2, 1};
  const auto skeleton = chain.make().value();
  expect_at(posed(*skeleton, {0, 0, 0, 0, 0, k_quarter}, 1, {3, 1, 0}), {1, 0, 0});
}

TEST(Skeleton, ScalesWeightsToOne) {
  Chain chain;
  chain.influences = {{0, 2}, {1, 1}, {0, 3}, {1, 1}};
  const auto skeleton = chain.make().value();
  EXPECT_EQ(skeleton->influences_of(0)[0].weight, 1);
  EXPECT_EQ(skeleton->influences_of(2)[0].weight, 0.75);
  EXPECT_EQ(skeleton->influences_of(2)[1].weight, 0.25);
  EXPECT_TRUE(skeleton->influences_of(3).empty());
}

TEST(Skeleton, NamesWhatIsWrong) {
  const auto place = [](auto spoil) {
    Chain chain;
    spoil(chain);
    const auto made = chain.make();
    return made ? std::string("made") : made.error().place;
  };
  EXPECT_EQ(place([](Chain&) {}), "made");
  EXPECT_EQ(place([](Chain& c) { c.joints[1].parent = 1; }), "joint 1 (tip)");
  EXPECT_EQ(place([](Chain& c) { c.joints[0].parent = 1; }), "joint 0 (root)");
  EXPECT_EQ(place([](Chain& c) { c.joints[0].parent = -2; }), "joint 0 (root)");
  EXPECT_EQ(place([](Chain& c) { c.joints[1].translation.x = NAN; }), "joint 1 (tip)");
  EXPECT_EQ(place([](Chain& c) { c.joints[1].inverse_bind[2][3] = INFINITY; }), "joint 1 (tip)");
  EXPECT_EQ(place([](Chain& c) { c.joints[1].rest_rotation.w = NAN; }), "joint 1 (tip)");
  EXPECT_EQ(place([](Chain& c) { c.joints[1].minimum.y = 0.1; }), "joint 1 (tip)");
  EXPECT_EQ(place([](Chain& c) { c.joints[1].maximum.y = c.joints[1].minimum.y = 0; }), "joint 1 (tip)");
  EXPECT_EQ(place([](Chain& c) { c.influences[1].joint = 2; }), "vertex 1");
  EXPECT_EQ(place([](Chain& c) { c.influences[2].weight = -0.5; }), "vertex 2");
  EXPECT_EQ(place([](Chain& c) { c.influences[2].weight = NAN; }), "vertex 2");
  EXPECT_EQ(place([](Chain& c) { c.influences[2].weight = c.influences[3].weight = 0; }), "vertex 2");
  EXPECT_EQ(place([](Chain& c) { c.first = {0, 2, 1, 4, 4}; }), "vertex 1");
  EXPECT_NE(place([](Chain& c) { c.first.clear(); }), "made");
  EXPECT_NE(place([](Chain& c) { c.first.back() = 5; }), "made");
  EXPECT_NE(place([](Chain& c) { c.first = {0, 9, 2, 4, 4}; }), "made") << "a run beyond all influences";
}

}  // namespace
}  // namespace penpose::rig
