#include "core/io/tracks/arkit/write_arkit.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/document/time/animation_building.h"
#include "core/geometry/rotation.h"
#include "core/io/surface/read_obj.h"
#include "core/io/surface/shape_list.h"
#include "core/io/tracks/read_track.h"

namespace penpose::io {
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

/// A square whose corner rises with each control.
document::Model with_controls(const std::vector<std::string>& names) {
  std::vector<ShownShape> shapes;
  for (const std::string& name : names)
    shapes.push_back({name, square("v 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4\n")});
  return with_shapes(square(), shapes).value();
}

std::size_t column_of(const animation::WeightTrack& track, const std::string& name) {
  return static_cast<std::size_t>(std::find(track.names.begin(), track.names.end(), name) - track.names.begin());
}

TEST(WriteArkit, HasTheColumnsOfLiveLinkFace) {
  const auto take = write_arkit(with_controls({"eyeBlink_L", "odd,name"})).value();
  const std::string header = take.text.substr(0, take.text.find('\n'));
  EXPECT_TRUE(
      header.starts_with("Timecode,BlendShapeCount,EyeBlinkLeft,EyeLookDownLeft,EyeLookInLeft,EyeLookOutLeft,"));
  EXPECT_NE(header.find(",JawForward,JawRight,JawLeft,JawOpen,"), std::string::npos);
  EXPECT_TRUE(
      header.ends_with(",NoseSneerRight,TongueOut,HeadYaw,HeadPitch,HeadRoll,LeftEyeYaw,LeftEyePitch,"
                       "LeftEyeRoll,RightEyeYaw,RightEyePitch,RightEyeRoll"));
  EXPECT_EQ(std::count(header.begin(), header.end(), ','), 62);
  const std::string row = take.text.substr(header.size() + 1);
  EXPECT_TRUE(row.starts_with("00:00:00:00.000,61,0,"));
  EXPECT_EQ(std::count(row.begin(), row.end(), ','), 62);
  EXPECT_EQ(take.notes, (std::vector<std::string>{"ARKit has no shape for odd,name; left out"}));
}

TEST(WriteArkit, ReadsBackAsItWas) {
  auto model = with_controls({"jawOpen", "eyeBlink_L"});
  const std::vector<double> times{0, 0.5, 1.0};
  const std::vector<rig::Pose> poses{{0, 1}, {0.5, 0.5}, {1, 0}};
  model.animations = {document::make_animation(model, "clip", times, poses)};
  const auto track = read_arkit_track(base::as_bytes(write_arkit(model, 4)->text)).value();
  ASSERT_EQ(track.frames.size(), 5U);
  const std::size_t jaw = column_of(track, "JawOpen");
  const std::size_t blink = column_of(track, "EyeBlinkLeft");
  EXPECT_DOUBLE_EQ(track.frames[1].values[jaw], 0.25);
  EXPECT_DOUBLE_EQ(track.frames[1].values[blink], 0.75);
  EXPECT_NEAR(track.frames[3].time_s, 0.75, 1e-9);
  EXPECT_FALSE(write_arkit(square()).ok());
  EXPECT_NE(write_arkit(with_controls({"smirk"})).error().remedy.find("jawOpen"), std::string::npos);
}

TEST(WriteArkit, MergesSidesThatArkitHasAsOne) {
  auto model = with_controls({"browInnerUp_L", "browInnerUp_R", "browOuterUp_L"});
  model.pose = {0.25, 0.75, 0.125};
  const auto take = write_arkit(model).value();
  const auto track = read_arkit_track(base::as_bytes(take.text)).value();
  EXPECT_DOUBLE_EQ(track.frames[0].values[column_of(track, "BrowInnerUp")], 0.5);
  EXPECT_DOUBLE_EQ(track.frames[0].values[column_of(track, "BrowOuterUpLeft")], 0.125);
  EXPECT_EQ(track.names.size(), 61U);
  ASSERT_EQ(take.notes.size(), 1U);
  EXPECT_NE(take.notes[0].find("BrowInnerUp is the mean of browInnerUp_L, browInnerUp_R"), std::string::npos);
}

TEST(WriteArkit, KeepsTheTurnOfTheHead) {
  auto model = with_controls({"jawOpen"});
  const std::vector<double> times{0, 1};
  const std::vector<document::Placement> placements{{}, {geometry::quaternion_from_xyz({0.1, 0.3, -0.2}), {}, 1}};
  model.animations = {document::make_animation(model, "clip", times, std::vector<rig::Pose>{{0}, {1}})};
  model = document::with_placements(std::move(model), 0, geometry::ModelPoint(0), times, placements).value();
  const auto track = read_arkit_track(base::as_bytes(write_arkit(model, 30)->text)).value();
  const auto& values = track.frames.back().values;
  EXPECT_NEAR(values[column_of(track, "HeadPitch")], 0.1, 1e-6);
  EXPECT_NEAR(values[column_of(track, "HeadYaw")], 0.3, 1e-6);
  EXPECT_NEAR(values[column_of(track, "HeadRoll")], -0.2, 1e-6);
}

/// Frames at any rate come back at that rate, whatever their timecodes count.
TEST(WriteArkit, TimecodesCountTheFrames) {
  auto model = with_controls({"jawOpen"});
  const std::vector<double> times{0, 4};
  model.animations = {document::make_animation(model, "clip", times, std::vector<rig::Pose>{{0}, {1}})};
  for (const double fps : {5.0, 12.5, 23.976, 24.0, 25.0, 29.97, 30.0, 50.0, 59.94, 60.0, 120.0}) {
    const auto track = read_arkit_track(base::as_bytes(write_arkit(model, fps)->text)).value();
    ASSERT_EQ(track.frames.size(), static_cast<std::size_t>(std::round(4 * fps)) + 1) << fps;
    for (std::size_t f = 0; f < track.frames.size(); ++f) {
      EXPECT_NEAR(track.frames[f].time_s, static_cast<double>(f) / fps, 5e-5) << fps << " frame " << f;
    }
  }
  const auto at_24 = write_arkit(model, 24)->text;
  EXPECT_NE(at_24.find("\n00:00:00:23.000,"), std::string::npos);
  EXPECT_NE(at_24.find("\n00:00:01:00.000,"), std::string::npos);
  EXPECT_NE(write_arkit(model, 29.97)->text.find("\n00:00:01:00.030,"), std::string::npos);
}

}  // namespace
}  // namespace penpose::io
