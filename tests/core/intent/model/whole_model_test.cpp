#include "core/intent/model/whole_model.h"

#include <gtest/gtest.h>

#include "tests/core/intent/face.h"

namespace penpose::intent {
namespace {

using geometry::ModelVector;
using tests::Face;

/// A band of the face, one vertex high and eleven wide, that moves as a whole.
Face& band(Face& face, const char* name, double x, double y, ModelVector way, double minimum = 0, double maximum = 1) {
  return face.control(
      name,
      [=](double px, double py) { return std::abs(py - y) < 0.01 && std::abs(px - x) < 0.26 ? way : ModelVector{0}; },
      minimum, maximum);
}

TEST(WholeModel, MovementIsTheWayOfAllVerticesBesideTheMedianControls) {
  Face face;
  band(face, "one", 0, 0, {0, 0.1, 0});
  band(face, "other", 0, 0.5, {0.1, 0, 0});
  band(face, "triple", 0, -0.5, {0, 0, 0.3});
  band(face, "both ways", 0, -0.2, {0, 0.1, 0}, -1, 1);
  band(face, "nothing", 7, 7, {0, 1, 0});
  const WholeModel whole = measure_whole_model(*face.ready().rig);
  ASSERT_EQ(whole.movement.size(), 5U);
  EXPECT_NEAR(whole.movement[0] / whole.movement[1], 1, 1e-6);
  EXPECT_NEAR(whole.movement[2] / whole.movement[1], 3, 1e-6);
  EXPECT_NEAR(whole.movement[3] / whole.movement[1], 2, 1e-6) << "between the ends of its range";
  EXPECT_EQ(whole.movement[4], 0);
  EXPECT_NEAR(whole.movement[3], 1, 1e-6) << "the median of those that move, the upper of two";
  for (std::size_t p = 0; p < 5; ++p) {
    EXPECT_EQ(whole.joint[p], k_no_partner);
    EXPECT_EQ(whole.group[p], p);
  }
}

TEST(WholeModel, HasNoUnit) {
  const Face small = tests::usual_face(1);
  const Face large = tests::usual_face(160);
  const WholeModel a = measure_whole_model(*small.rig);
  const WholeModel b = measure_whole_model(*large.rig);
  for (std::size_t p = 0; p < a.movement.size(); ++p) EXPECT_NEAR(a.movement[p], b.movement[p], 1e-5);
  EXPECT_EQ(a.partner, b.partner);
  EXPECT_NEAR(b.size, 160 * a.size, 1e-9 * b.size);
}

TEST(WholeModel, LeftAndRightFindEachOtherAndTheMiddleNobody) {
  const Face face = tests::usual_face();
  const WholeModel whole = measure_whole_model(*face.rig);
  const auto partner = [&](const char* name) { return whole.partner[face.number(name)]; };
  EXPECT_EQ(partner("cornerLeft"), face.number("cornerRight"));
  EXPECT_EQ(partner("cornerRight"), face.number("cornerLeft"));
  EXPECT_EQ(partner("browLeft"), face.number("browRight"));
  for (const char* middle : {"lipUp", "jawOpen", "jawLeft", "jawRight", "swell"})
    EXPECT_EQ(partner(middle), k_no_partner) << middle;
}

TEST(WholeModel, AnglesOfAJointComeTogether) {
  Face face;
  face.bump("shape", 0, 0, {0, 0.1, 0});
  face.ready(tests::chain_skeleton(*face.mesh, 3, 0.5));
  const WholeModel whole = measure_whole_model(*face.rig);
  ASSERT_EQ(whole.group.size(), 10U);
  EXPECT_EQ(whole.group, (std::vector<std::size_t>{0, 1, 1, 1, 4, 4, 4, 7, 7, 7}));
  EXPECT_EQ(whole.joint[0], k_no_partner);
  EXPECT_EQ(whole.joint[1], 0U);
  EXPECT_EQ(whole.joint[6], 1U);
  EXPECT_EQ(whole.joint[9], 2U);
}

TEST(WholeModel, AJointNearTheTipMovesLessThanOneNearTheRoot) {
  Face face;
  face.ready(tests::chain_skeleton(*face.mesh, 3, 0.5));
  const WholeModel whole = measure_whole_model(*face.rig);
  // About z: the whole sheet, then what lies beyond each joint.
  EXPECT_GT(whole.movement[2], whole.movement[5]);
  EXPECT_GT(whole.movement[5], whole.movement[8]);
}

}  // namespace
}  // namespace penpose::intent
