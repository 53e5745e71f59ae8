#include "core/intent/chain.h"

#include <gtest/gtest.h>

#include "tests/support/models/test_rigs.h"

namespace penpose::intent {
namespace {

/// A body of single vertices, one a joint: hips 0, chest 1, head 2, arm 3, forearm 4, hand 5, other arm 6, other hand
/// 7; vertex 8 is carried by none, vertex 9 by the forearm and a little by the hand.
std::shared_ptr<const rig::CharacterRig> body() {
  const std::int32_t parents[] = {-1, 0, 1, 1, 3, 4, 1, 6};
  std::vector<rig::Joint> joints(8);
  for (std::size_t j = 0; j < 8; ++j) {
    joints[j].name = "j" + std::to_string(j);
    joints[j].parent = parents[j];
  }
  mesh::MeshSource source;
  for (int v = 0; v < 10; ++v) source.positions.emplace_back(v, v % 3, 0);
  for (std::uint32_t v = 0; v + 2 < 10; ++v) source.triangles.push_back({v, v + 1, v + 2});
  std::vector<std::uint32_t> first{0};
  std::vector<rig::Influence> influences;
  for (std::uint32_t v = 0; v < 8; ++v) {
    influences.push_back({v, 1});
    first.push_back(v + 1);
  }
  first.push_back(8);
  influences.push_back({4, 0.7});
  influences.push_back({5, 0.3});
  first.push_back(10);
  return rig::CharacterRig::make(mesh::TriangleMesh::build(std::move(source)).value(), {},
                                 rig::Skeleton::make(joints, first, influences).value())
      .value();
}

std::vector<std::size_t> chain(std::initializer_list<std::uint32_t> vertices) {
  std::vector<posing::CurvePoint> points;
  for (const std::uint32_t v : vertices) points.push_back(posing::at_vertex(v));
  return chain_of(*body(), points);
}

using Joints = std::vector<std::size_t>;

TEST(Chain, IsWhatCarriesTheStrokeAndWhatLiesBetween) {
  EXPECT_EQ(chain({3, 4, 5}), (Joints{3, 4, 5}));
  EXPECT_EQ(chain({3, 5}), (Joints{3, 4, 5})) << "the forearm lies between";
  EXPECT_EQ(chain({5, 3}), (Joints{3, 4, 5})) << "whichever way it was drawn";
  EXPECT_EQ(chain({0, 2}), (Joints{0, 1, 2})) << "a line of action";
}

TEST(Chain, AStrokeOnOnePartMeansThatPart) {
  EXPECT_EQ(chain({5, 5, 5}), Joints{5});
  EXPECT_EQ(chain({0}), Joints{0});
}

TEST(Chain, APointBelongsToWhatCarriesItMost) { EXPECT_EQ(chain({3, 9}), (Joints{3, 4})); }

TEST(Chain, FromHandToHandTheTrunkThatCarriesBothIsNotMeant) {
  EXPECT_EQ(chain({5, 4, 3, 6, 7}), (Joints{3, 4, 5, 6, 7}));
  EXPECT_EQ(chain({5, 4, 3, 1, 6, 7}), (Joints{1, 3, 4, 5, 6, 7})) << "unless the stroke runs over it";
}

TEST(Chain, TheTrunkThatAStrokeOverlapsIsNotMeant) {
  const auto one = body();
  const joints::Body shape(*one->skeleton());
  std::vector<posing::CurvePoint> points{posing::at_vertex(1)};
  for (const std::uint32_t v : {3U, 3U, 3U, 4U, 4U, 4U, 5U, 5U}) points.push_back(posing::at_vertex(v));
  EXPECT_EQ(chain_of(*one, points, &shape), (Joints{3, 4, 5}));
  EXPECT_EQ(chain_of(*one, points), (Joints{1, 3, 4, 5})) << "as it was";
  points.push_back(posing::at_vertex(1));
  EXPECT_EQ(chain_of(*one, points, &shape), (Joints{1, 3, 4, 5})) << "a stroke over both means both";
}

TEST(Chain, IsEmptyWhereNothingCarries) {
  EXPECT_TRUE(chain({8}).empty());
  EXPECT_TRUE(chain({}).empty());
  const auto sheet = tests::grid_mesh(2, 2);
  const auto plain = rig::CharacterRig::make(sheet, {tests::random_shapes(*sheet, 1, 1)}, nullptr).value();
  EXPECT_TRUE(chain_of(*plain, std::vector{posing::at_vertex(0), posing::at_vertex(1)}).empty());
}

}  // namespace
}  // namespace penpose::intent
