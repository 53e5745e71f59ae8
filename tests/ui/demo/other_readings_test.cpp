#include <algorithm>
#include <gtest/gtest.h>

#include "core/character/demo_head.h"
#include "core/document/drawing/moment.h"
#include "core/io/project/read_document.h"
#include "core/io/project/write_document.h"
#include "tests/support/document_hand.h"

// What else a line on a face may mean, and that an artist who takes another reading is followed from then on.

namespace penpose::demo {
namespace {

using document::CurveId;
using document::DrawReference;
using document::DrawTarget;
using document::PxPoint;
using document::TakeReading;

/// Lines on the built-in head, seen from the front.
struct FaceHand : tests::DocumentHand {
  FaceHand() : DocumentHand(document::make_document(*character::make_demo_head())) {
    view.camera = {{0, -0.0173, 0.7837}, {0, -0.0173, 0.003}, {0, 1, 0}, 30};
    view.viewport = {1000, 1000};
  }

  /// A named curve of the head at rest, moved down by px that grow from its middle to its ends.
  [[nodiscard]] std::vector<PxPoint> curve(const std::string& name, double middle = 0, double ends = 0) const {
    const auto camera = geometry::Camera::make(view.camera, view.viewport).value();
    const auto positions = document::posed_positions(*document().model);
    std::vector<PxPoint> line;
    for (const auto& one : document().model->curves) {
      if (one.name != name) continue;
      for (const auto& p : one.points)
        line.push_back(*camera.project(mesh::position_of(p, document().model->mesh->triangles(), positions)));
    }
    const double from = line.front().x;
    const double width = line.back().x - from;
    for (PxPoint& p : line) {
      const double x = 2 * (p.x - from) / width - 1;
      p.y += middle + (ends - middle) * x * x;
    }
    return line;
  }
  /// Draws where a curve is and where it goes.
  CurveId draws(const std::string& name, double middle, double ends) {
    const std::vector<PxPoint> from = curve(name);
    const std::vector<PxPoint> to = curve(name, middle, ends);
    does(DrawReference{view, from});
    const CurveId id{document().last_curve};
    does(DrawTarget{id, view, to, {}});
    return id;
  }
  /// The corners of the mouth go up.
  CurveId smiles() { return draws("lip_upper_inner", 5, -20); }
  [[nodiscard]] std::vector<rig::Pose> others() const {
    std::vector<rig::Pose> poses;
    for (const document::Moment::Other& one : document().moment->others) poses.push_back(one.pose);
    return poses;
  }
};

TEST(OtherReadings, AreKeptWithTheLineAndMoveOtherControlsEach) {
  FaceHand hand;
  hand.smiles();
  ASSERT_TRUE(hand.document().moment);
  ASSERT_FALSE(hand.others().empty());
  EXPECT_LE(hand.others().size(), 4U);
  double before = 1;
  for (const auto& one : hand.document().moment->others) {
    EXPECT_LE(one.probability, before) << "the likeliest first";
    before = one.probability;
  }
  const rig::Pose rest = rig::rest_pose(*hand.document().model->rig);
  const auto moved = [&](const rig::Pose& pose) {
    std::vector<bool> which;
    for (std::size_t i = 0; i < pose.size(); ++i) which.push_back(pose[i] != rest[i]);
    return which;
  };
  const auto first = moved(hand.document().pose);
  std::vector<std::vector<bool>> all{first};
  for (const rig::Pose& other : hand.others()) {
    EXPECT_EQ(std::find(all.begin(), all.end(), moved(other)), all.end());
    all.push_back(moved(other));
  }
}

TEST(OtherReadings, OneThatIsTakenIsThePoseAndUndoBringsTheFirstBack) {
  FaceHand hand;
  const CurveId line = hand.smiles();
  const auto before = hand.state();
  const rig::Pose first = hand.document().pose;
  const rig::Pose second = hand.others()[0];
  hand.does(TakeReading{line, 0});
  EXPECT_EQ(hand.document().pose, second);
  ASSERT_TRUE(hand.document().taken);
  EXPECT_EQ(hand.document().taken->size(), 1U);
  EXPECT_TRUE(hand.undo().ok());
  EXPECT_EQ(hand.state(), before);
  EXPECT_EQ(hand.document().pose, first);
  EXPECT_FALSE(hand.document().taken);
}

TEST(OtherReadings, TheFirstOneCanBeTakenBack) {
  FaceHand hand;
  const CurveId line = hand.smiles();
  const rig::Pose first = hand.document().pose;
  hand.does(TakeReading{line, 0});
  hand.does(TakeReading{line, 0});
  EXPECT_EQ(hand.document().pose, first);
  ASSERT_TRUE(hand.document().taken);
  EXPECT_EQ(hand.document().taken->size(), 1U) << "the last word counts";
}

TEST(OtherReadings, ThoseOfALineBeforeAreOver) {
  FaceHand hand;
  const CurveId first = hand.smiles();
  hand.draws("brow_L", -10, -10);
  EXPECT_EQ(hand.refuses(TakeReading{first, 0}).place, "curve");
  EXPECT_EQ(hand.refuses(TakeReading{CurveId{hand.document().last_curve}, 7}).place, "which");
  EXPECT_EQ(FaceHand().refuses(TakeReading{CurveId{1}, 0}).place, "curve");
}

TEST(OtherReadings, WhatWasSetSinceStays) {
  FaceHand hand;
  const CurveId line = hand.smiles();
  hand.does(document::SetParameters{{{"brow_inner_L", 0.4}}});
  hand.does(TakeReading{line, 0});
  EXPECT_EQ(hand.value("brow_inner_L"), 0.4);
}

TEST(OtherReadings, ALaterLineFollowsTheChoice) {
  FaceHand hand;
  const CurveId line = hand.smiles();
  const rig::Pose first = hand.document().pose;
  const rig::Pose second = hand.others()[0];
  hand.does(TakeReading{line, 0});
  // The face at rest again, and the same line drawn anew.
  hand.does(document::ClearCurves{});
  hand.does(document::ResetParameters{});
  hand.smiles();
  for (std::size_t i = 0; i < second.size(); ++i) EXPECT_NEAR(hand.document().pose[i], second[i], 0.02);
  // Without the choice it is what it was.
  FaceHand other;
  const CurveId same = other.smiles();
  other.does(TakeReading{same, 0});
  other.does(document::ClearCurves{});
  other.does(document::ResetParameters{});
  EXPECT_TRUE(other.undo().ok() && other.undo().ok() && other.undo().ok() && other.undo().ok() && other.undo().ok());
  other.smiles();
  EXPECT_EQ(other.document().pose, first) << "what was undone tells nothing";
}

TEST(OtherReadings, AProjectKeepsTheChoice) {
  FaceHand hand;
  const CurveId line = hand.smiles();
  hand.does(TakeReading{line, 0});
  const auto bytes = io::write_document(hand.document(), "face.glb");
  ASSERT_TRUE(bytes.ok());
  const auto again = io::read_document(*bytes, "face.glb");
  ASSERT_TRUE(again.ok()) << again.error().line();
  ASSERT_TRUE(again->taken);
  EXPECT_EQ(*again->taken, *hand.document().taken);
  EXPECT_EQ(document::DocumentHasher()(*again), hand.state());
}

TEST(OtherReadings, ALineThatMovesNothingSaysWhatWouldHaveMoved) {
  FaceHand hand;
  const CurveId line = hand.draws("lip_upper_inner", 0, 3);
  ASSERT_EQ(hand.document().pose, rig::rest_pose(*hand.document().model->rig)) << "the line asks for more now";
  ASSERT_FALSE(hand.others().empty());
  hand.does(TakeReading{line, 0});
  EXPECT_NE(hand.document().pose, rig::rest_pose(*hand.document().model->rig));
}

TEST(OtherReadings, NoneMovesALockedControl) {
  FaceHand hand;
  hand.does(document::LockParameters{{"jaw"}, true});
  hand.smiles();
  const auto jaw = *rig::find_parameter(hand.document().model->rig->parameters(), "jaw");
  for (const rig::Pose& one : hand.others()) EXPECT_EQ(one[jaw], 0);
}

}  // namespace
}  // namespace penpose::demo
