#include <gtest/gtest.h>

#include "core/geometry/rotation.h"
#include "tests/judges/cases/known_faces.h"
#include "tests/judges/drawing/faces/shared_drawings.h"
#include "tests/judges/drawing/signs/head_turn.h"
#include "tests/judges/drawing/signs/verdict.h"

namespace penpose::judges::drawn {
namespace {

/// A face with the shapes of ARKit, whose known poses have the names of expressions.
class DrawingSigns : public testing::Test {
 protected:
  [[nodiscard]] rig::Pose pose(const std::string& name) const {
    for (const KnownPose& known : rig_.poses) {
      if (known.name == name) return pose_of(face_.rig(), known.values);
    }
    ADD_FAILURE() << "no pose " << name;
    return rig::rest_pose(face_.rig());
  }
  [[nodiscard]] static Rig arkit() {
    for (const RigMaker& maker : own_rigs()) {
      if (std::string(maker.name) == "arkit") return maker.make();
    }
    return {};
  }

  Rig rig_ = arkit();
  std::shared_ptr<const JudgedFace> kept_ = face_of(rig_);
  const JudgedFace& face_ = *kept_;
  FaceJudge judge_ = FaceJudge::make(face_).value();
};

TEST_F(DrawingSigns, APoseOfAnExpressionIsRecognised) {
  struct Case {
    const char* pose;
    Expression meant;
    std::optional<Side> side;
  };
  for (const Case& one : {Case{"smile", Expression::happy, {}},
                          {"sad", Expression::sad, {}},
                          {"surprise", Expression::surprised, {}},
                          {"anger", Expression::angry, {}},
                          {"wink_L", Expression::wink, Side::left},
                          {"blink", Expression::sleepy, {}},
                          {"pucker", Expression::kiss, {}},
                          {"smirk_L", Expression::smirk, Side::left},
                          {"jaw_open", Expression::open, {}},
                          {"laugh", Expression::laugh, {}}}) {
    const Seen seen = judge_.look(pose(one.pose), one.meant, one.side);
    EXPECT_STREQ(verdict_name(seen.verdict), "recognised")
        << one.pose << testing::PrintToString(seen.missing) << testing::PrintToString(seen.other);
    EXPECT_FALSE(seen.torn) << one.pose;
  }
}

TEST_F(DrawingSigns, AFaceAtRestShowsNoExpressionAndIsStill) {
  const rig::Pose rest = rig::rest_pose(face_.rig());
  EXPECT_EQ(judge_.look(rest, Expression::rest, {}).verdict, Verdict::still);
  for (std::size_t e = 1; e < k_expression_count; ++e) {
    const auto meant = static_cast<Expression>(e);
    EXPECT_NE(judge_.look(rest, meant, {}).verdict, Verdict::recognised) << expression_name(meant);
    std::size_t there = 0;
    for (const AnyOf& sign : signs_of(meant).need) there += holds(sign, judge_.look(rest, meant, {}).signs) ? 1U : 0U;
    EXPECT_LT(there, signs_of(meant).need.size()) << expression_name(meant);
  }
}

TEST_F(DrawingSigns, AnotherExpressionIsWrongAndAnyMovementIsNotStill) {
  EXPECT_EQ(judge_.look(pose("smile"), Expression::sad, {}).verdict, Verdict::wrong);
  EXPECT_EQ(judge_.look(pose("frown"), Expression::happy, {}).verdict, Verdict::wrong);
  EXPECT_EQ(judge_.look(pose("wink_L"), Expression::wink, Side::right).verdict, Verdict::wrong);
  EXPECT_EQ(judge_.look(pose("smile"), Expression::rest, {}).verdict, Verdict::moved);
}

TEST_F(DrawingSigns, LipsThatRunThroughOneAnotherAreTorn) {
  CurvePlaces places = places_of(face_.marks, face_.rest);
  const FaceSigns signs = FaceSigns::make(face_.marks, places, face_.front_yaw_degrees()).value();
  const double at_rest = signs.crossing(places);
  for (std::size_t c = 0; c < face_.marks.size(); ++c) {
    if (face_.marks[c].name != "lip_upper_inner") continue;
    for (auto& p : places[c]) p.y -= 0.1 * signs.height();
  }
  EXPECT_NEAR(signs.crossing(places) - at_rest, 0.1 * signs.height(), 0.005 * signs.height());
  EXPECT_LT(signs.of(places, {})[Sign::gap], -0.25);
}

TEST_F(DrawingSigns, ATurnOfTheHeadIsTakenOut) {
  const CurvePlaces rest = places_of(face_.marks, face_.rest);
  const FaceSigns signs = FaceSigns::make(face_.marks, rest, 0).value();
  CurvePlaces turned = rest;
  const auto turn = geometry::rotation_about({0.6, 0.8, 0}, 0.3);
  for (auto& line : turned) {
    for (auto& p : line) p = turn * p + geometry::ModelVector{1, 2, 3};
  }
  const HeldStill held = without_head_turn(rest, turned, signs.fixed());
  EXPECT_NEAR(held.degrees, 0.3 * 180 / 3.14159265358979, 1e-6);
  for (std::size_t c = 0; c < rest.size(); ++c) {
    for (std::size_t i = 0; i < rest[c].size(); ++i)
      EXPECT_LT(geometry::distance(held.places[c][i], rest[c][i]), 1e-9 * signs.height());
  }
}

TEST(DrawingNames, ANameSaysWhatIsMeant) {
  const auto wink = meaning_of("cartoon_wink_R.svg");
  ASSERT_TRUE(wink);
  EXPECT_EQ(wink->meant, Expression::wink);
  EXPECT_EQ(wink->side, Side::right);
  EXPECT_EQ(wink->folder, "cartoon");
  EXPECT_EQ(meaning_of("few_rest.svg")->meant, Expression::rest);
  EXPECT_EQ(meaning_of("pencil_o.svg")->meant, Expression::open);
  EXPECT_FALSE(meaning_of("not_house.svg")->face);
  EXPECT_FALSE(meaning_of("portrait.svg"));
}

}  // namespace
}  // namespace penpose::judges::drawn
