#include "core/model_io/write_arkit.h"

#include <gtest/gtest.h>

#include "core/document/animation_building.h"
#include "core/model_io/read_obj.h"
#include "core/model_io/read_track.h"
#include "core/model_io/shape_list.h"

namespace penpose::model_io {
namespace {

document::Model square(const char* text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n") {
  return read_obj(base::as_bytes(text)).value();
}

document::Model two_shapes() {
  const auto up = square("v 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4\n");
  const std::vector<ShownShape> shapes{{"eyeBlink_L", up}, {"odd,name", up}};
  return with_shapes(square(), shapes).value();
}

TEST(ShapeList, FilesBecomeBlendShapesOfTheirNames) {
  EXPECT_EQ(control_name_of("a/b/jawOpen.obj"), "jawOpen");
  EXPECT_EQ(control_name_of("smile.v2.obj"), "smile.v2");
  auto model = two_shapes();
  ASSERT_EQ(model.shapes->shapes().size(), 2U);
  EXPECT_EQ(model.shapes->shapes()[0].vertices, (std::vector<std::uint32_t>{2}));
  model.pose[0] = 0.5;
  EXPECT_EQ(document::posed_positions(model)[2].y, 1.5);
  const std::vector<ShownShape> wrong{{"flat", square("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n")}};
  EXPECT_EQ(with_shapes(square(), wrong).error().place, "flat");
  const std::vector<ShownShape> again{{"eyeBlink_L", square()}};
  EXPECT_EQ(with_shapes(two_shapes(), again)->shapes->shapes()[2].parameter.name, "eyeBlink_L.2");
}

TEST(WriteArkit, ReadsBackAsItWas) {
  auto model = two_shapes();
  const std::vector<double> times{0, 0.5, 1.0};
  const std::vector<rig::Pose> poses{{0, 1}, {0.5, 0.5}, {1, 0}};
  model.animations = {document::make_animation(model, "clip", times, poses)};
  const auto text = write_arkit(model, 4).value();
  EXPECT_EQ(text.substr(0, text.find('\n')), "Timecode,BlendShapeCount,EyeBlinkLeft,odd_name");
  const auto track = read_arkit_track(base::as_bytes(text)).value();
  ASSERT_EQ(track.frames.size(), 5U);
  EXPECT_DOUBLE_EQ(track.frames[1].values[0], 0.25);
  EXPECT_NEAR(track.frames[3].time_s, 0.75, 1e-9);
  EXPECT_FALSE(write_arkit(square()).ok());
}

}  // namespace
}  // namespace penpose::model_io
