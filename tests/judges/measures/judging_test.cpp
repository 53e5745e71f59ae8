#include <gtest/gtest.h>

#include "tests/judges/measures/body_judge.h"
#include "tests/judges/measures/bounded.h"
#include "tests/judges/measures/gesture_judge.h"
#include "tests/judges/measures/judged_sets.h"
#include "tests/judges/measures/least_sum.h"

namespace penpose::judges {
namespace {

Rig rig_named(std::string_view name) {
  for (const RigMaker& maker : own_rigs()) {
    if (name == maker.name) return maker.make();
  }
  return {};
}

TEST(JudgesWholeFace, TheTrueWeightsAreWithoutError) {
  const Rig rig = rig_named("split");
  const auto cases = known_faces(rig, Extent::brief);
  const WholeFace face(rig.model, file_of(cases));
  for (const KnownFace& one : cases) {
    Outcome outcome;
    const auto truth = face.moved(one.truth);
    face.judge(truth, truth, outcome);
    EXPECT_EQ(outcome.error.value_or(0), 0) << one.asked.name;
    EXPECT_EQ(outcome.still.value_or(0), 0) << one.asked.name;
    // What should move by at most 0.02 of the most is the stray of the truth itself.
    EXPECT_LT(outcome.stray.value_or(0), 0.3) << one.asked.name;
    EXPECT_LT(face.left(one.asked, truth), one.hand == "exact" ? 0.1 : 1.0) << one.asked.name;
  }
}

TEST(JudgesWholeFace, AFaceThatStaysIsWrongByAllOfItAndAnotherOneByMore) {
  const Rig rig = rig_named("split");
  const auto cases = known_faces(rig, Extent::brief);
  const WholeFace face(rig.model, file_of(cases));
  const auto truth = face.moved(pose_of(*rig.model.rig, {{"mouthSmile_L", 0.7}}));
  Outcome stays;
  face.judge(truth, face.moved(rig::rest_pose(*rig.model.rig)), stays);
  EXPECT_NEAR(*stays.error, 100, 1e-9);
  EXPECT_EQ(*stays.stray, 0);
  Outcome other;
  face.judge(truth, face.moved(pose_of(*rig.model.rig, {{"browDown_R", 0.8}})), other);
  EXPECT_GT(*other.error, 100);
  EXPECT_GT(*other.stray, 1);
}

TEST(JudgesWholeFace, MovementWhereALineIsRedrawnIsNotStill) {
  const Rig rig = rig_named("split");
  const auto cases = known_faces(rig, Extent::brief);
  const WholeFace face(rig.model, file_of(cases));
  const auto rest = face.moved(rig::rest_pose(*rig.model.rig));
  Outcome outcome;
  face.judge(rest, face.moved(pose_of(*rig.model.rig, {{"jawOpen", 0.3}})), outcome);
  EXPECT_FALSE(outcome.error);
  EXPECT_GT(*outcome.still, 0.5);
}

struct SmileOn {
  Rig rig;
  std::vector<Gesture> cases;
  Gesture smile;
  WholeFace face;
  GestureJudge judge;

  explicit SmileOn(std::string_view name)
      : rig(rig_named(name)), cases(gestures(rig, Extent::brief)), face(rig.model, file_of(cases)), judge(face) {
    for (const Gesture& one : cases) {
      if (one.asked.name.starts_with("smile_15")) smile = one;
    }
  }
  Outcome with(const std::vector<std::pair<std::string, double>>& values) {
    Outcome outcome;
    judge.judge(smile, pose_of(*rig.model.rig, values), outcome);
    return outcome;
  }
};

TEST(JudgesGesture, WhatIsMeantIsRightWhateverItsStrength) {
  SmileOn split("split");
  for (const double weight : {0.3, 0.6, 0.9})
    EXPECT_EQ(split.with({{"mouthSmile_L", weight}, {"mouthSmile_R", weight}}).right, 1) << weight;
  EXPECT_EQ(split.with({{"mouthSmile_L", 0.6}, {"mouthSmile_R", 0.6}, {"mouthStretch_L", 0.2}}).right, 1);
}

TEST(JudgesGesture, OtherControlsOneSideAndNothingAreNotRight) {
  SmileOn split("split");
  EXPECT_EQ(split.with({{"mouthFrown_L", 0.6}, {"mouthFrown_R", 0.6}}).right, 0);
  EXPECT_EQ(split.with({{"mouthSmile_L", 0.6}}).right, 0);
  const Outcome also = split.with({{"mouthSmile_L", 0.6}, {"mouthSmile_R", 0.6}, {"jawOpen", 0.9}});
  EXPECT_EQ(also.right, 0);
  EXPECT_GT(*also.stray, 1);
  const Outcome still = split.with({});
  EXPECT_EQ(still.right, 0);
  EXPECT_EQ(still.nothing, 1);
}

TEST(JudgesGesture, ADoubleIsAsGoodAsTheOriginal) {
  SmileOn doubles("doubles");
  for (std::vector<std::string>& group : doubles.smile.needed)
    std::erase_if(group, [](const std::string& name) { return name.starts_with("old_"); });
  EXPECT_EQ(doubles.with({{"old_smile_l", 0.6}, {"old_smile_r", 0.6}}).right, 1);
}

TEST(JudgesGesture, WhereNoControlDoesItNothingIsRight) {
  SmileOn none("no_brows");
  for (const Gesture& one : none.cases) {
    if (!one.asked.name.starts_with("brows_up_16")) continue;
    none.smile = one;
    EXPECT_EQ(none.with({}).right, 1);
    EXPECT_EQ(none.with({{"eyeBlink_L", 0.8}}).right, 0);
    return;
  }
  FAIL() << "nobody is asked to raise brows that nothing moves";
}

TEST(JudgesBody, TheTruthIsWithoutErrorAndAnotherLimbIsNot) {
  const Rig rig = rig_named("walker");
  const auto cases = limbs(rig, Extent::brief);
  const WholeFace figure(rig.model, file_of(cases));
  Outcome truth;
  judge_body(figure, cases.front().truth, cases.front().truth, truth);
  EXPECT_EQ(*truth.error, 0);
  EXPECT_LT(*truth.stray, 0.5);
  Outcome stays;
  judge_body(figure, cases.front().truth, rig::rest_pose(*rig.model.rig), stays);
  EXPECT_GT(*stays.error, 1);
}

TEST(JudgesBody, JointsTurnAboutAxesOfTheWorld) {
  const Rig rig = rig_named("walker");
  const WholeFace figure(rig.model, file_of(limbs(rig, Extent::brief)));
  // The left arm, along +x, turned by 90 degrees about z points up.
  const std::vector<Move::Turn> turns{{6, {0, 0, 90}}};
  const auto moved = figure.moved(turned_pose(rig.model, turns));
  double highest = -1;
  double lowest = 1;
  for (const ModelVector& d : moved) {
    highest = std::max(highest, d.y);
    lowest = std::min(lowest, d.y);
  }
  EXPECT_GT(highest, 0.6);
  EXPECT_GT(lowest, -0.1);
}

TEST(JudgesBounded, FindsTheLeastSquaresWithinTheRange) {
  // Free: x = (0.5, 2); within 0..1 the second stays at 1 and the first is that of a single unknown.
  const std::vector<std::vector<double>> columns{{1, 0, 1}, {0, 1, 1}};
  const std::vector<double> b{0.5, 2, 2.5};
  const auto x = bounded_least_squares(columns, b, 1e-6);
  EXPECT_NEAR(x[1], 1, 1e-6);
  EXPECT_NEAR(x[0], 1, 1e-6);
  const auto y = bounded_least_squares({{1, 0, 1}, {0, 2, 1}}, {0.25, 1, 0.75}, 1e-6);
  EXPECT_NEAR(y[0], 0.25, 1e-6);
  EXPECT_NEAR(y[1], 0.5, 1e-6);
}

TEST(JudgesLeastSum, IsThatOfTheMedianWithinTheRange) {
  const std::vector<std::vector<ModelVector>> columns{{{1, 0, 0}, {1, 0, 0}, {1, 0, 0}}};
  EXPECT_NEAR(least_sum_of_distances(columns, {{0.1, 0, 0}, {0.2, 0, 0}, {0.9, 0, 0}}), 0.8, 1e-5);
  // Beyond the range the nearest end is best.
  EXPECT_NEAR(least_sum_of_distances(columns, {{1.5, 0, 0}, {2, 0, 0}, {3, 0, 0}}), 3.5, 1e-9);
}

}  // namespace
}  // namespace penpose::judges
