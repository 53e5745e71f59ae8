#include "core/rig/joint_followers.h"

#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>

#include "tests/support/models/joint_trees.h"
#include "tests/support/models/test_rigs.h"

namespace penpose::rig {
namespace {

/// A layer that one control drives, whoever has it: all vertices go up.
class DrivenLift final : public DisplacementLayer {
 public:
  explicit DrivenLift(std::size_t driver) : driver_(driver) {}
  [[nodiscard]] std::span<const Parameter> parameters() const override { return {}; }
  [[nodiscard]] bool driven() const override { return true; }
  void add(std::span<const double> pose, std::span<ModelVector> displacements) const override {
    for (ModelVector& d : displacements) d.y += pose[driver_];
  }
  [[nodiscard]] std::unique_ptr<BoundLayer> bind(std::span<const std::uint32_t>) const override {
    return std::make_unique<Bound>(*this);
  }

 private:
  class Bound final : public BoundLayer {
   public:
    explicit Bound(const DrivenLift& lift) : lift_(lift) {}
    void add(std::span<const double> pose, std::span<ModelVector> displacements) override {
      lift_.add(pose, displacements);
    }
    [[nodiscard]] bool moves(std::size_t parameter) const override { return parameter == lift_.driver_; }
    bool column(std::size_t, std::span<ModelVector>) const override { return false; }

   private:
    const DrivenLift& lift_;
  };
  std::size_t driver_;
};

struct Figure {
  std::shared_ptr<const mesh::TriangleMesh> mesh = tests::grid_mesh(20, 15, 3, 1);
  std::shared_ptr<const BlendShapes> shapes = tests::random_shapes(*mesh, 4, 5);
  std::shared_ptr<const CharacterRig> rig;

  explicit Figure(const std::shared_ptr<const Skeleton>& skeleton)
      : rig(CharacterRig::make(mesh, {shapes}, skeleton).value()) {}
};

bool same_bits(const ModelPoint& a, const ModelPoint& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// Every turn, in an order that jumps about the tree, against the whole model.
void expect_as_of_all(const Figure& character) {
  const CharacterRig& rig = *character.rig;
  const Skeleton& skeleton = *rig.skeleton();
  const std::size_t first = rig.first_parameter(1);
  const std::vector<ModelPoint> rest = tests::all_positions(rig, rest_pose(rig));
  JointFollowers followers(rig);
  const std::size_t count = skeleton.parameters().size() / 3;
  for (std::size_t i = 0; i < 2 * count; ++i) {
    const std::size_t angle = 3 * (i * 7 % count) + i % 3;
    const auto follow = followers.of(skeleton.joint_of(angle));
    ASSERT_TRUE(std::is_sorted(follow.begin(), follow.end()));
    ASSERT_TRUE(std::adjacent_find(follow.begin(), follow.end()) == follow.end());
    for (const double value : {0.25, -0.7}) {
      std::vector<ModelPoint> places(follow.size());
      followers.turn(angle, value, places);
      std::vector<ModelPoint> all = rest;
      for (std::size_t k = 0; k < follow.size(); ++k) all[follow[k]] = places[k];
      Pose pose = rest_pose(rig);
      pose[first + angle] = value;
      const std::vector<ModelPoint> whole = tests::all_positions(rig, pose);
      for (std::size_t v = 0; v < whole.size(); ++v)
        ASSERT_TRUE(same_bits(whole[v], all[v])) << skeleton.parameters()[angle].name << " vertex " << v;
    }
  }
}

TEST(JointFollowers, GoWhereTheWholeModelGoesBitForBit) {
  const auto grid = tests::grid_mesh(20, 15, 3, 1);
  expect_as_of_all(Figure(tests::chain_skeleton(*grid, 40, 0.07, 0.1)));
  expect_as_of_all(Figure(tests::bushy_skeleton(*grid, 60, 3)));
}

TEST(JointFollowers, AreThoseThatAJointOrOneBelowItCarriesAndNoOthers) {
  const Figure character(tests::bushy_skeleton(*tests::grid_mesh(20, 15, 3, 1), 60, 4));
  const Skeleton& skeleton = *character.rig->skeleton();
  JointFollowers followers(*character.rig);
  std::size_t none = 0;
  for (std::uint32_t j = 0; j < skeleton.joints().size(); ++j) {
    std::vector<std::uint32_t> expected;
    for (std::uint32_t v = 0; v < skeleton.vertex_count(); ++v) {
      const auto influences = skeleton.influences_of(v);
      if (std::any_of(influences.begin(), influences.end(), [&](const Influence& influence) {
            auto above = static_cast<std::int32_t>(influence.joint);
            while (above > static_cast<std::int32_t>(j))
              above = skeleton.joints()[static_cast<std::size_t>(above)].parent;
            return above == static_cast<std::int32_t>(j);
          }))
        expected.push_back(v);
    }
    const auto follow = followers.of(j);
    EXPECT_EQ(std::vector<std::uint32_t>(follow.begin(), follow.end()), expected) << j;
    none += expected.empty();
  }
  EXPECT_GT(none, 0U) << "some joints carry nothing";
}

TEST(JointFollowers, AreNotAllWhereAnAngleDrivesALayer) {
  const Figure plain(tests::chain_skeleton(*tests::grid_mesh(20, 15, 3, 1), 3, 1));
  const std::size_t driver = plain.rig->first_parameter(1) + 4;
  const auto lift = std::make_shared<DrivenLift>(driver);
  const auto skeleton = tests::chain_skeleton(*plain.mesh, 3, 1);
  const auto rig = CharacterRig::make(plain.mesh, {plain.shapes, lift}, skeleton).value();
  const JointFollowers followers(*rig);
  for (std::size_t angle = 0; angle < 9; ++angle) EXPECT_EQ(followers.are_all(angle), angle != 4) << angle;
}

}  // namespace
}  // namespace penpose::rig
