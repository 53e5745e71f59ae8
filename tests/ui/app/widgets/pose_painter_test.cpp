#include "ui/app/widgets/pose_painter.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "ui/files/load_model.h"

namespace penpose::app {
namespace {

constexpr int k_side = 48;
using Pixels = std::vector<std::uint8_t>;

document::Model demo() { return files::load_model("builtin:demo").value(); }

PictureFrame face_of(const document::Model& model) { return picture_frames(model)[0]; }

const std::uint8_t* at(const Pixels& pixels, int x, int y) {
  return pixels.data() + 4 * (static_cast<std::ptrdiff_t>(y) * k_side + x);
}

/// A pose with one control at its end.
rig::Pose with_end(const document::Model& model, const std::string& name) {
  rig::Pose pose = rig::rest_pose(*model.rig);
  const auto index = rig::find_parameter(model.rig->parameters(), name).value();
  pose[index] = model.rig->parameters()[index].maximum;
  return pose;
}

TEST(PosePainter, HasTheColoursOfTheModelAndNothingBehindIt) {
  document::Model model = demo();
  for (auto& material : model.materials) material.base_color = {0.7, 0.03, 0.03, 1};
  PictureFrame whole = face_of(model);
  whole.side *= 3;
  const Pixels red = pose_pixels(model, rig::rest_pose(*model.rig), whole, k_side);
  const std::uint8_t* middle = at(red, k_side / 2, k_side / 2);
  EXPECT_EQ(middle[3], 255);
  EXPECT_GT(middle[0], 2 * middle[2]) << "red, and no clay";
  EXPECT_EQ(at(red, 0, 0)[3], 0) << "clear where the model is not";
}

TEST(PosePainter, OneThatIsKeptDrawsTheSameAsOneForEachPicture) {
  const document::Model model = demo();
  const PictureFrame face = face_of(model);
  const rig::Pose open = with_end(model, "jaw");
  PosePainter painter;
  const Pixels rest = painter.paint(model, rig::rest_pose(*model.rig), face, k_side);
  EXPECT_NE(painter.paint(model, open, face, k_side), rest) << "poses differ";
  EXPECT_EQ(painter.paint(model, rig::rest_pose(*model.rig), face, k_side), rest);
  EXPECT_EQ(pose_pixels(model, rig::rest_pose(*model.rig), face, k_side), rest);
}

TEST(PosePainter, AModelThatLooksBackIsSeenFromItsOwnFront) {
  const document::Model model = demo();
  document::Model back = model;
  back.front_yaw_degrees = 180;
  PictureFrame face = face_of(model);
  const rig::Pose rest = rig::rest_pose(*model.rig);
  const Pixels front = pose_pixels(model, rest, face, k_side);
  EXPECT_NE(pose_pixels(back, rest, face, k_side), front);
  face.yaw_degrees = 180;
  const Pixels turned = pose_pixels(back, rest, face, k_side);
  std::size_t differ = 0;
  for (std::size_t i = 0; i < front.size(); ++i) differ += std::abs(front[i] - turned[i]) > 2 ? 1U : 0U;
  EXPECT_LT(differ, front.size() / 100) << "both turns cancel out";
}

TEST(PictureFrame, WhatDiffersIsShownNearAndOfAllPosesAlike) {
  const document::Model model = demo();
  const PictureFrames frames = picture_frames(model);
  const PictureFrame face = frames[0];
  const rig::Pose rest = rig::rest_pose(*model.rig);
  const std::array brows{with_end(model, "brow_inner_L"), with_end(model, "brow_inner_R")};
  const PictureFrame near = frame_of_differences(model, rest, brows, face);
  EXPECT_LT(near.side, 0.8 * face.side);
  const PictureFrame wanted = frames[static_cast<std::size_t>(FacePart::brows)];
  EXPECT_LT(std::abs(near.middle.y - wanted.middle.y), 0.25 * face.side);
  EXPECT_LT(std::abs(near.middle.x - face.middle.x), 0.1 * face.side) << "both sides are on it";
  const std::array none{rest};
  EXPECT_EQ(frame_of_differences(model, rest, none, face), face);
}

TEST(PictureFrame, IsSeenFromWhereOneLooksButNotFromBehind) {
  const document::Model model = demo();
  const PictureFrame face = face_of(model);
  geometry::CameraPose camera;
  camera.look_at = {0, 0, 0};
  camera.eye = {1, 0, 1};
  EXPECT_DOUBLE_EQ(seen_from(model, face, camera).yaw_degrees, 45);
  camera.eye = {-0.02, 0, 1};
  EXPECT_DOUBLE_EQ(seen_from(model, face, camera).yaw_degrees, 0) << "whole steps: a view that trembles is the same";
  camera.eye = {0.1, 0, -1};
  EXPECT_LE(std::abs(seen_from(model, face, camera).yaw_degrees), 75);
}

}  // namespace
}  // namespace penpose::app
