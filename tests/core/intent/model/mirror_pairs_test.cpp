#include "core/intent/model/mirror_pairs.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/geometry/rotation.h"
#include "tests/support/models/test_rigs.h"

namespace penpose::intent {
namespace {

using geometry::ModelPoint;
using geometry::ModelVector;

constexpr auto k_none = static_cast<std::size_t>(-1);

TEST(Moments, AreWeightedByTheWay) {
  const std::vector<ModelPoint> rest{{0, 0, 0}, {4, 0, 0}, {9, 9, 9}};
  const std::vector<ModelPoint> moved{{0, 1, 0}, {4, 3, 0}, {9, 9, 9}};
  const ControlMoments m = moments_of(rest, moved);
  EXPECT_DOUBLE_EQ(m.way, 4);
  EXPECT_EQ(m.centre, (ModelPoint{3, 0, 0}));
  EXPECT_EQ(m.direction, (ModelVector{0, 1, 0}));
  EXPECT_NEAR(m.radius, std::sqrt((1 * 9.0 + 3 * 1.0) / 4), 1e-12);
}

TEST(Moments, OfWhatDoesNotMoveOrIsNoNumberAreNothing) {
  const std::vector<ModelPoint> rest{{1, 2, 3}, {4, 5, 6}};
  EXPECT_EQ(moments_of(rest, rest).way, 0);
  const std::vector<ModelPoint> broken{{NAN, 2, 3}, {4, 7, 6}};
  const ControlMoments m = moments_of(rest, broken);
  EXPECT_EQ(m.way, 2);
  EXPECT_EQ(m.centre, rest[1]);
}

/// Six controls a side, each with its mirror image, not quite symmetric, and what a face has in its middle.
struct Arrangement {
  std::vector<ControlMoments> controls;
  std::vector<std::size_t> partner;

  void add(ControlMoments m, std::size_t mate = k_none) {
    controls.push_back(m);
    partner.push_back(mate);
  }
  explicit Arrangement(double uneven, std::uint64_t seed = 7) {
    tests::Random random(seed);
    const ModelPoint places[] = {{0.5, 0.6, 0.2},  {0.5, 0.3, 0.1},  {0.35, -0.4, 0.3},
                                 {0.9, 0.1, -0.3}, {0.2, -0.1, 0.5}, {0.35, -0.4, 0.3}};
    const ModelVector ways[] = {{0, 1, 0}, {0.1, -1, 0}, {0.3, 0.9, 0}, {1, 0, 0}, {0.2, 0.5, 0.8}, {-0.2, -0.9, 0}};
    for (std::size_t i = 0; i < 6; ++i) {
      const double way = 1.0 + static_cast<double>(i);
      const double radius = 0.08 + 0.01 * static_cast<double>(i);
      add({way, places[i], ways[i], radius}, controls.size() + 1);
      const auto near = [&](ModelVector v) { return ModelVector{-v.x, v.y, v.z} + random.vector(uneven); };
      add({way * random(1 - 2 * uneven, 1 + 2 * uneven), near(places[i]), near(ways[i]), radius}, controls.size() - 1);
    }
    add({20, {0.03, -0.6, 0.1}, {0, -1, 0}, 0.5});   // the jaw
    add({12, {-0.03, -0.6, 0.1}, {-1, 0, 0}, 0.5});  // to the left
    add({12, {0.03, -0.6, 0.1}, {1, 0, 0}, 0.5});    // to the right: opposed, not a pair
    add({});                                         // moves nothing
  }
  void turn(const glm::dmat3& by, const ModelVector& shift) {
    for (ControlMoments& m : controls) {
      m.centre = by * m.centre + shift;
      m.direction = by * m.direction;
    }
  }
};

TEST(MirrorPairs, AreFoundByWhereControlsMoveTheModel) {
  const Arrangement face(0);
  EXPECT_EQ(mirror_pairs(face.controls, {0, 0, 0}, 3), face.partner);
}

TEST(MirrorPairs, AreFoundOnAFaceThatIsUnevenTurnedAndMoved) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    Arrangement face(0.03, seed);
    const ModelVector shift{0.4, -2, 7};
    face.turn(geometry::rotation_about(geometry::normalized({0.3, 1, 0.2}), 0.1), shift);
    EXPECT_EQ(mirror_pairs(face.controls, shift, 3), face.partner) << seed;
  }
}

TEST(MirrorPairs, OfAModelThatLooksAlongAnotherAxis) {
  Arrangement face(0.02);
  face.turn(geometry::rotation_about({0, 1, 0}, 1.5707963), {0, 0, 0});
  EXPECT_EQ(mirror_pairs(face.controls, {0, 0, 0}, 3), face.partner);
}

TEST(MirrorPairs, ASizeOfZeroOrNoControlsMakeNone) {
  const Arrangement face(0);
  EXPECT_EQ(mirror_pairs(face.controls, {0, 0, 0}, 0), std::vector<std::size_t>(face.controls.size(), k_none));
  EXPECT_TRUE(mirror_pairs({}, {0, 0, 0}, 3).empty());
}

TEST(MirrorPairs, OfControlsThatDoTheSameTheFirstIsThePartner) {
  const Arrangement face(0.02);
  std::vector<ControlMoments> controls = face.controls;
  controls.push_back(controls[1]);
  controls.insert(controls.begin(), controls[5]);
  std::vector<std::size_t> partner{5, 2, 1, 4, 3, 0};  // 6 does what 0 does
  const auto got = mirror_pairs(controls, {0, 0, 0}, 3);
  EXPECT_EQ(std::vector<std::size_t>(got.begin(), got.begin() + 6), partner);
  EXPECT_EQ(got[6], k_none);
  EXPECT_EQ(got.back(), k_none) << "it does what 2 does";
}

TEST(MirrorPairs, APartnerIsMutualWhateverTheControls) {
  tests::Random random(9);
  for (int run = 0; run < 50; ++run) {
    std::vector<ControlMoments> controls(12);
    for (ControlMoments& m : controls) m = {random(0, 2), random.vector(1), random.vector(1), random(0, 0.4)};
    const auto partner = mirror_pairs(controls, random.vector(0.1), 2);
    for (std::size_t i = 0; i < partner.size(); ++i) {
      if (partner[i] == k_none) continue;
      EXPECT_NE(partner[i], i);
      EXPECT_EQ(partner[partner[i]], i);
    }
  }
}

}  // namespace
}  // namespace penpose::intent
