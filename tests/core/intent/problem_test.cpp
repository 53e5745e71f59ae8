#include "core/intent/problem.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/core/intent/face.h"
#include "tests/support/error_of.h"

namespace penpose::intent {
namespace {

using tests::Face;
using tests::Line;

TEST(Doubt, GrowsWithTheScreen) {
  EXPECT_DOUBLE_EQ(doubt_px({1600, 1000}), k_doubt_px);
  EXPECT_DOUBLE_EQ(doubt_px({1600, 2000}), 2 * k_doubt_px);
}

TEST(StrokeDoubt, IsTheHandsOnASmoothStrokeAndLessOnASmallOne) {
  EXPECT_NEAR(stroke_doubt_px(Line{{0, 0}, {300, 40}}, 2.0), 2.0, 1e-9);
  EXPECT_NEAR(stroke_doubt_px(Line{{0, 0}, {60, 0}}, 2.0), 1.2, 1e-9) << "a fiftieth of the length";
  EXPECT_NEAR(stroke_doubt_px(Line{{0, 0}, {5, 0}}, 2.0), 0.6, 1e-9) << "three tenths of the hand's at least";
  EXPECT_NEAR(stroke_doubt_px(Line{{3, 3}, {3, 3}}, 2.0), 0.6, 1e-9) << "no length at all";
}

TEST(StrokeDoubt, GrowsWithTheRoughness) {
  const auto zigzag = [](double px) {
    Line line;
    for (int i = 0; i <= 60; ++i) line.push_back({5.0 * i, i % 2 == 0 ? px : -px});
    return stroke_doubt_px(line, 2.0);
  };
  EXPECT_NEAR(zigzag(0), 2.0, 1e-9);
  EXPECT_NEAR(zigzag(0.3), 2.0, 1e-9) << "within the hand's doubt";
  EXPECT_GT(zigzag(6), 5.0);
  EXPECT_GT(zigzag(12), zigzag(6) + 3);
}

TEST(StrokeDoubt, ACornerThatIsMeantIsNotRough) {
  EXPECT_LT(stroke_doubt_px(Line{{0, 0}, {250, 0}, {250, 250}}, 2.0), 2.5);
}

TEST(StrokeDoubt, ATabletOfCoarseStepsIsDoubtedMore) {
  // The same arc as devices report it whose steps are so many px wide.
  const auto arc = [](double step) {
    Line line;
    for (int i = 0; i <= 200; ++i) {
      const double x = 2.0 * i;
      const double y = 120.0 - 0.003 * (x - 200.0) * (x - 200.0);
      line.push_back({std::round(x / step) * step, std::round(y / step) * step});
    }
    return stroke_doubt_px(line, 2.0);
  };
  EXPECT_NEAR(arc(0.02), 2.0, 0.01) << "a pen tablet's";
  EXPECT_NEAR(arc(1), 2.0, 0.1) << "a px";
  EXPECT_GT(arc(6), 2.2) << "a matrix of coarse fingers";
  EXPECT_GT(arc(12), arc(6) + 0.8);
}

TEST(CheckIntentProblem, NamesWhatIsWrong) {
  const Face face = tests::usual_face();
  const rig::Pose rest = rig::rest_pose(*face.rig);
  IntentProblem good = face.problem({face.drawn(Face::mouth(), face.seen(Face::mouth(), rest)),
                                     face.drawn(Face::left_brow(), face.seen(Face::left_brow(), rest))});
  good.known.push_back({Face::right_brow(), face.at(Face::right_brow(), rest), 0.01});
  good.kept.push_back({Face::row(20, 5, 9), face.at(Face::row(20, 5, 9), rest), 0.01});
  const auto place = [&](auto spoil) {
    IntentProblem problem = good;
    spoil(problem);
    return tests::place_of_fault(check_problem(*face.rig, problem));
  };
  EXPECT_EQ(place([](IntentProblem&) {}), "fine");
  EXPECT_EQ(place([](IntentProblem& p) {
              p.drawn.clear();
              p.known.clear();
            }),
            "");
  EXPECT_EQ(place([](IntentProblem& p) { p.drawn.clear(); }), "fine");
  EXPECT_EQ(place([](IntentProblem& p) { p.drawn[1].reference.resize(1); }), "curve 1");
  EXPECT_EQ(place([](IntentProblem& p) { p.drawn[1].target.resize(1); }), "curve 1");
  EXPECT_EQ(place([](IntentProblem& p) { p.drawn[1].target.clear(); }), "curve 1");
  EXPECT_EQ(place([](IntentProblem& p) { p.drawn[1].target.assign(5, {3, 3}); }), "curve 1");
  EXPECT_EQ(place([](IntentProblem& p) { p.drawn[0].target[3].x = NAN; }), "curve 0");
  EXPECT_EQ(place([](IntentProblem& p) { p.drawn[0].target[3].y = INFINITY; }), "curve 0");
  EXPECT_EQ(place([](IntentProblem& p) { p.drawn[0].target[3].y = -1.1e6; }), "curve 0");
  EXPECT_EQ(place([](IntentProblem& p) { p.drawn[0].target[3].y = -0.9e6; }), "fine") << "off the screen is no fault";
  for (const double doubt : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    EXPECT_EQ(place([&](IntentProblem& p) { p.drawn[1].doubt_px = doubt; }), "curve 1");
    EXPECT_EQ(place([&](IntentProblem& p) { p.known[0].doubt = doubt; }), "curve 0");
    EXPECT_EQ(place([&](IntentProblem& p) { p.kept[0].doubt = doubt; }), "curve 0");
  }
  EXPECT_EQ(place([](IntentProblem& p) { p.drawn[0].weights = {1, 1}; }), "reference 0");
  EXPECT_EQ(place([](IntentProblem& p) { p.drawn[0].reference[2].vertex[0] = 41 * 41; }), "reference 0");
  EXPECT_EQ(place([](IntentProblem& p) { p.known[0].target.pop_back(); }), "reference 2");
  EXPECT_EQ(place([](IntentProblem& p) { p.kept[0].target[0].z = NAN; }), "constraint 0");
  EXPECT_EQ(place([](IntentProblem& p) { p.free = {0, 99}; }), "free 1");
  EXPECT_EQ(place([](IntentProblem& p) { p.free = {3, 2}; }), "free 1");
  EXPECT_EQ(place([](IntentProblem& p) { p.start[0] = 1.5; }), "parameter cornerLeft");
  EXPECT_EQ(place([](IntentProblem& p) { p.start.pop_back(); }), "start");
}

}  // namespace
}  // namespace penpose::intent
