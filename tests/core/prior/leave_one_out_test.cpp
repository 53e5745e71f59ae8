#include "core/prior/leave_one_out.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/models/test_rigs.h"

namespace penpose::prior {
namespace {

constexpr std::size_t k_shapes = 16;

/// A grid with bumps, of which the first half is what an artist draws.
class LeaveOneOut : public testing::Test {
 protected:
  LeaveOneOut() : mesh_(tests::grid_mesh(16, 16)), shapes_(tests::random_shapes(*mesh_, k_shapes, 4)) {
    rig_ = rig::CharacterRig::make(mesh_, {shapes_}, nullptr).value();
    for (std::size_t i = 0; i < k_shapes / 2; ++i) first_half_.push_back(i);
  }
  /// Each key is a mix of three moods and a share of chance.
  [[nodiscard]] std::vector<rig::Pose> keys(std::size_t count, double chance, std::uint64_t seed) const {
    tests::Random random(seed);
    std::vector<rig::Pose> moods(3);
    for (auto& mood : moods) {
      for (std::size_t i = 0; i < k_shapes; ++i) mood.push_back(random(0, 0.4));
    }
    std::vector<rig::Pose> out(count, rig::Pose(k_shapes, 0.0));
    for (auto& key : out) {
      for (const auto& mood : moods) {
        const double much = random(0, 1) * (1 - chance);
        for (std::size_t i = 0; i < k_shapes; ++i) key[i] += much * mood[i];
      }
      for (double& value : key) value = std::clamp(value + chance * random(0, 0.6), 0.0, 1.0);
    }
    return out;
  }
  [[nodiscard]] HeldOf drawn() const {
    return [this](const rig::Pose&) { return first_half_; };
  }

  std::shared_ptr<const mesh::TriangleMesh> mesh_;
  std::shared_ptr<const rig::BlendShapes> shapes_;
  std::shared_ptr<const rig::CharacterRig> rig_;
  std::vector<std::size_t> first_half_;
};

double pooled(const std::vector<LeftOut>& rows, double LeftOut::*left) {
  double sum = 0;
  double all = 0;
  for (const LeftOut& row : rows) {
    sum += row.*left * row.*left;
    all += row.way * row.way;
  }
  return std::sqrt(sum / all);
}

TEST_F(LeaveOneOut, MoodsAreForetoldFarBetterThanByNotMovingAndByTheMean) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const auto rows = leave_one_out(*rig_, keys(12, 0.05, seed), drawn(), std::nullopt);
    ASSERT_TRUE(rows.ok());
    ASSERT_EQ(rows->size(), 12U);
    EXPECT_LT(pooled(*rows, &LeftOut::suggested), 0.25 * pooled(*rows, &LeftOut::still)) << seed;
    EXPECT_LT(pooled(*rows, &LeftOut::suggested), 0.5 * pooled(*rows, &LeftOut::mean)) << seed;
    EXPECT_GT(trust(*rig_, keys(12, 0.05, seed), drawn()), 0.9) << seed;
  }
}

TEST_F(LeaveOneOut, ErrorsAreDistancesOfTheWholeModel) {
  const auto poses = keys(5, 0.2, 8);
  const auto rows = leave_one_out(*rig_, poses, drawn(), 1).value();
  ASSERT_EQ(rows.size(), 5U);
  const auto way = [&](const rig::Pose& a, const rig::Pose& b) {
    const auto from = tests::all_positions(*rig_, a);
    const auto to = tests::all_positions(*rig_, b);
    double sum = 0;
    for (std::size_t v = 0; v < from.size(); ++v) sum += std::pow(geometry::distance(from[v], to[v]), 2);
    return std::sqrt(sum);
  };
  for (std::size_t k = 0; k < 5; ++k) {
    rig::Pose start = poses[k];
    std::fill(start.begin() + k_shapes / 2, start.end(), 0.0);
    std::vector<rig::Pose> others = poses;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    const auto suggested = suggest(*learn(rig_->parameters(), others), rig_->parameters(), start, first_half_).value();
    EXPECT_EQ(rows[k].key, k);
    EXPECT_EQ(rows[k].held, k_shapes / 2);
    EXPECT_NEAR(rows[k].way, way(poses[k], rig::Pose(k_shapes, 0.0)), 1e-12);
    EXPECT_NEAR(rows[k].still, way(poses[k], start), 1e-12);
    EXPECT_NEAR(rows[k].suggested, way(poses[k], suggested), 1e-12) << "the key itself was not learned from";
  }
}

// What no key foretells is best left where it is, and leaving one out says so.
TEST_F(LeaveOneOut, TrustIsLowWhereKeysHaveNothingToDoWithEachOther) {
  std::vector<rig::Pose> poses(8, rig::Pose(k_shapes, 0.0));
  for (std::size_t k = 0; k < poses.size(); ++k) poses[k][k] = poses[k][k_shapes / 2 + k] = 0.9;
  EXPECT_LT(trust(*rig_, poses, drawn()), 0.3);
  const auto asked = leave_one_out(*rig_, poses, drawn(), std::nullopt).value();
  const auto full = leave_one_out(*rig_, poses, drawn(), 1).value();
  EXPECT_LT(pooled(asked, &LeftOut::suggested), pooled(full, &LeftOut::suggested));
  EXPECT_LT(pooled(asked, &LeftOut::suggested), 1.05 * pooled(asked, &LeftOut::still));
}

TEST_F(LeaveOneOut, CopiesOfAKeyDoNotForetellIt) {
  auto poses = keys(6, 0.3, 12);
  const auto once = leave_one_out(*rig_, poses, drawn(), 1).value();
  poses.push_back(poses[2]);
  const auto twice = leave_one_out(*rig_, poses, drawn(), 1).value();
  ASSERT_EQ(twice.size(), 6U);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(twice[k].suggested, once[k].suggested);
}

TEST_F(LeaveOneOut, TooFewKeysAreRefusedAndManyAreNotAllLeftOut) {
  const auto two = leave_one_out(*rig_, keys(2, 0.2, 1), drawn(), 1);
  ASSERT_FALSE(two.ok());
  EXPECT_EQ(two.error().line(), "one of two poses cannot be left out: what is left is one; key three different poses");
  EXPECT_FALSE(leave_one_out(*rig_, keys(1, 0.2, 1), drawn(), 1).ok());
  EXPECT_EQ(trust(*rig_, keys(2, 0.2, 1), drawn()), 1) << "nothing speaks against it";
  std::size_t asked = 0;
  const auto counted = [&](const rig::Pose&) {
    ++asked;
    return first_half_;
  };
  EXPECT_GT(trust(*rig_, keys(500, 0.05, 1), counted), 0.9);
  EXPECT_EQ(asked, k_most_left_out);
}

}  // namespace
}  // namespace penpose::prior
