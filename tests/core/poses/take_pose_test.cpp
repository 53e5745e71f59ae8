#include "core/poses/take_pose.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/character/demo_head.h"
#include "core/document/features/feature_curves.h"
#include "core/io/model/read_model.h"
#include "core/poses/keep_pose.h"
#include "tests/support/shared_data.h"

namespace penpose::poses {
namespace {

using document::NamedValue;

/// A face with what poses are measured by.
struct Head {
  document::Document document;
  std::optional<FaceMeasure> face;

  explicit Head(document::Model model) : document(document::make_document(std::move(model))) {
    const auto whole = intent::measure_whole_model(*document.model->rig);
    const auto features = document::feature_curves_of(*document.model, whole, {});
    if (features) face = FaceMeasure::of(*document.model, features->curves);
  }
  [[nodiscard]] const rig::Rig& rig() const { return *document.model->rig; }
  [[nodiscard]] KeptPose keep(const std::string& name, const std::vector<NamedValue>& values) const {
    return keep_pose(document, with_values(rig(), rig::rest_pose(rig()), values), name, "model", &*face, {});
  }
  [[nodiscard]] base::Result<TakenPose> take(const KeptPose& pose, const TakeOptions& options = {}) const {
    return take_pose(pose, *document.model, &*face, options);
  }
};

Head demo() { return Head(*character::make_demo_head()); }

double value_of(const TakenPose& taken, const std::string& name) {
  for (const NamedValue& one : taken.values) {
    if (one.name == name) return one.value;
  }
  return NAN;
}

TEST(TakePose, ToItsOwnRigItIsItself) {
  const Head head = demo();
  ASSERT_TRUE(head.face);
  const KeptPose pose = head.keep("smile", {{"mouth_corner_L", 0.8}, {"mouth_corner_R", 0.7}, {"brow_inner_L", -0.5}});
  const auto taken = head.take(pose);
  ASSERT_TRUE(taken) << taken.error().line();
  EXPECT_EQ(taken->way, Way::names);
  EXPECT_EQ(value_of(*taken, "mouth_corner_L"), 0.8);
  EXPECT_EQ(value_of(*taken, "brow_inner_L"), -0.5);
  EXPECT_EQ(value_of(*taken, "jaw"), 0) << "what was at rest goes back there";
  EXPECT_NEAR(*taken->left, 0, 1e-5);
  EXPECT_TRUE(taken->missing.empty());
}

TEST(TakePose, OfAPartOnlyItsControlsAreTaken) {
  const Head head = demo();
  const KeptPose pose = head.keep("smile", {{"mouth_corner_L", 0.8}, {"eyelid_upper_L", 1}, {"brow_inner_L", -0.5}});
  const auto taken = head.take(pose, {FacePart::eyes});
  ASSERT_TRUE(taken) << taken.error().line();
  EXPECT_EQ(value_of(*taken, "eyelid_upper_L"), 1);
  EXPECT_TRUE(std::isnan(value_of(*taken, "mouth_corner_L")));
  EXPECT_TRUE(std::isnan(value_of(*taken, "brow_inner_L")));
}

TEST(TakePose, ByEffectsItFindsTheControlsThatMovedWithoutTheirNames) {
  const Head head = demo();
  const std::vector<NamedValue> values{{"jaw", 0.6}, {"eyelid_upper_L", 0.9}, {"brow_outer_R", 0.7}};
  KeptPose pose = head.keep("surprise", values);
  for (KeptValue& one : pose.values) one.control = "other_" + one.control;
  pose.controls.clear();
  const auto taken = head.take(pose);
  ASSERT_TRUE(taken) << taken.error().line();
  EXPECT_EQ(taken->way, Way::effects);
  EXPECT_LT(*taken->left, 0.05);
  for (const NamedValue& one : values) EXPECT_NEAR(value_of(*taken, one.name), one.value, 0.08) << one.name;
  EXPECT_NEAR(value_of(*taken, "eyelid_upper_R"), 0, 0.02) << "the other eye stays open";
}

TEST(TakePose, WhatIsOutOfRangeEndsThereAndIsSaid) {
  const Head head = demo();
  const KeptPose pose =
      *read_kept_pose(base::as_bytes(R"({"penpose_pose": 1, "name": "far", "values": {"jaw": 3, "antenna": 1}})"));
  const auto taken = head.take(pose);
  ASSERT_TRUE(taken) << taken.error().line();
  EXPECT_EQ(value_of(*taken, "jaw"), 1);
  EXPECT_EQ(taken->clamped, std::vector<std::string>{"jaw"});
  EXPECT_EQ(taken->missing, std::vector<std::string>{"antenna"});
  const std::string words = words_of(pose, *taken);
  EXPECT_NE(words.find("nothing here stands for antenna"), std::string::npos) << words;
  EXPECT_NE(words.find("at the end of its range: jaw"), std::string::npos) << words;
  const KeptPose none =
      *read_kept_pose(base::as_bytes(R"({"penpose_pose": 1, "name": "no", "values": {"antenna": 1}})"));
  const auto refused = head.take(none);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().line().find("\"no\""), std::string::npos);
}

TEST(TakePose, ALineThatItWasDrawnWithPosesAFaceWithoutItsControls) {
  const Head head = demo();
  KeptPose pose;
  pose.name = "drawn";
  for (const char* lip : {"lip_lower", "lip_lower_inner"}) {
    KeptLine line{lip, {0, 0, 1}, {}, {}};
    const auto opened = head.keep("open", {{"jaw", 0.6}});
    for (std::size_t i = 0; i < k_places; ++i) {
      line.at.push_back(static_cast<double>(i) / 8);
      for (const FeatureMoves& one : opened.moves) {
        if (one.feature == lip) line.moves.push_back(one.moves[i]);
      }
    }
    pose.lines.push_back(line);
  }
  const auto taken = head.take(pose);
  ASSERT_TRUE(taken) << taken.error().line();
  EXPECT_EQ(taken->way, Way::lines);
  EXPECT_NEAR(value_of(*taken, "jaw"), 0.6, 0.1);
}

/// The poses of the two rigs that say the same.
struct Said {
  const char* name;
  std::vector<NamedValue> demo, ict;
};
std::vector<Said> said() {
  return {{"smile", {{"mouth_corner_L", 0.8}, {"mouth_corner_R", 0.8}}, {{"mouthSmile_L", 0.8}, {"mouthSmile_R", 0.8}}},
          {"frown", {{"mouth_frown_L", 0.8}, {"mouth_frown_R", 0.8}}, {{"mouthFrown_L", 0.8}, {"mouthFrown_R", 0.8}}},
          {"blink", {{"eyelid_upper_L", 1}, {"eyelid_upper_R", 1}}, {{"eyeBlink_L", 1}, {"eyeBlink_R", 1}}},
          {"jaw open", {{"jaw", 0.7}}, {{"jawOpen", 0.7}}}};
}

std::optional<Head> shared_head(const char* name) {
  const auto path = tests::shared_dir() / "meshes" / name;
  auto model = io::read_model(tests::read_file(path), path.string());
  if (!model) return std::nullopt;
  return Head(std::move(*model));
}

TEST(SharedTakePose, ExpressionsComeAcrossFromRigToRig) {
  if (!tests::has_shared()) GTEST_SKIP() << "no shared data";
  const Head built_in = demo();
  const auto ict = shared_head("ict_face.glb");
  ASSERT_TRUE(ict && ict->face);
  for (const Said& one : said()) {
    for (const bool to_ict : {true, false}) {
      const Head& from = to_ict ? built_in : *ict;
      const Head& to = to_ict ? *ict : built_in;
      const auto taken = to.take(from.keep(one.name, to_ict ? one.demo : one.ict));
      ASSERT_TRUE(taken) << taken.error().line();
      EXPECT_LT(*taken->left, 0.5) << one.name;
    }
  }
}

}  // namespace
}  // namespace penpose::poses
