#include "core/rig/rig.h"

#include <gtest/gtest.h>

#include "tests/support/models/test_rigs.h"

namespace penpose::rig {
namespace {

TEST(Rig, RestsWhereItsParametersDo) {
  const auto mesh = tests::grid_mesh(1, 1);
  std::vector<BlendShape> shapes(3);
  shapes[0].parameter = {"a", 0.25, 0, 1};
  shapes[1].parameter = {"b", 0, -1, 1};
  shapes[2].parameter = {"c", -2, -2, 5};
  const auto rig = CharacterRig::make(mesh, {BlendShapes::make(shapes, 4).value()}, nullptr).value();
  EXPECT_EQ(rest_pose(*rig), (Pose{0.25, 0, -2}));
}

TEST(Rig, FindsParametersByTheirWholeName) {
  const std::vector<Parameter> parameters{{"jawOpen", 0, 0, 1}, {"jaw", 0, 0, 1}};
  EXPECT_EQ(find_parameter(parameters, "jaw"), 1U);
  EXPECT_EQ(find_parameter(parameters, "jawOpen"), 0U);
  EXPECT_FALSE(find_parameter(parameters, "Jaw"));
  EXPECT_FALSE(find_parameter({}, "jaw"));
}

}  // namespace
}  // namespace penpose::rig
