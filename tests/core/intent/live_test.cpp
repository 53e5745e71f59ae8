#include "core/intent/live.h"

#include <gtest/gtest.h>

#include "core/intent/solve.h"
#include "tests/core/intent/face.h"

namespace penpose::intent {
namespace {

using tests::Face;
using tests::Line;
using tests::Points;

struct Desk {
  Face face = tests::usual_face();
  rig::Pose rest = rig::rest_pose(*face.rig);
  Points points = Face::mouth();

  [[nodiscard]] LivePoser start() const {
    return LivePoser::start(*face.rig, measure_whole_model(*face.rig), face.problem({face.drawn(points, {})})).value();
  }
  /// Follows a line report by report, a sixtieth at a time.
  static void draw(LivePoser& poser, const Line& line) {
    for (std::size_t n = 2; n <= line.size(); ++n) poser.follow(std::span(line).first(n));
  }
  [[nodiscard]] rig::Pose followed(const Line& line) const {
    LivePoser poser = start();
    draw(poser, line);
    return poser.pose();
  }
};

TEST(IntentLive, WhenThePenLiftsThePoseIsNearTheSolves) {
  const Desk d;
  for (const char* name : {"cornerLeft", "cornerRight", "lipUp", "jawOpen", "jawLeft"}) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      const Line line = tests::shaken(d.face.seen(d.points, d.face.pose({{name, 0.7}})), 1.5, seed);
      const rig::Pose whole = d.face.solve(d.face.problem({d.face.drawn(d.points, line)})).pose;
      EXPECT_LT(d.face.error(d.followed(line), whole), 0.2) << name << " " << seed;
      EXPECT_LT(d.face.error(d.followed(tests::backwards(line)), whole), 0.2) << name << " " << seed;
    }
  }
}

TEST(IntentLive, AHalfDrawnLineMovesWhatItRunsOver) {
  // Both corners lifted; only the half that is drawn so far is known, from whichever end it was begun.
  const Desk d;
  const std::size_t left = d.face.number("cornerLeft");
  const std::size_t right = d.face.number("cornerRight");
  const Line line = d.face.seen(d.points, d.face.pose({{"cornerLeft", 0.7}, {"cornerRight", 0.7}}));
  const rig::Pose from_left = d.followed(tests::part(line, 0, 0.45));
  EXPECT_GT(from_left[left], 0.4);
  const rig::Pose from_right = d.followed(tests::part(tests::backwards(line), 0, 0.45));
  EXPECT_GT(from_right[right], 0.4);
}

TEST(IntentLive, ACurveRedrawnWhereItIsMovesNothingAtAnyReport) {
  const Desk d;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const Line line = tests::shaken(d.face.seen(d.points, d.rest), 1.2, seed);
    LivePoser poser = d.start();
    for (std::size_t n = 20; n <= line.size(); ++n) {
      poser.follow(std::span(line).first(n));
      EXPECT_EQ(poser.pose(), d.rest) << seed << " " << n;
    }
  }
}

TEST(IntentLive, ReportsLeftOutAreNotMissed) {
  const Desk d;
  const Line line = d.face.seen(d.points, d.face.pose({{"cornerLeft", 0.7}}));
  LivePoser poser = d.start();
  for (int i = 0; i < 4; ++i) poser.follow(line);
  EXPECT_LT(d.face.error(poser.pose(), d.face.pose({{"cornerLeft", 0.7}})), 0.1);
}

TEST(IntentLive, WithoutADrawnLengthNothingMoves) {
  const Desk d;
  LivePoser poser = d.start();
  for (const Line& line : {Line{}, Line{{500, 500}}, Line{{500, 500}, {500, 500}}, Line{{500, 500}, {NAN, 3}},
                           Line{{500, 500}, {HUGE_VAL, 3}}}) {
    EXPECT_FALSE(poser.follow(line).solved);
    EXPECT_FALSE(poser.follow_whole(line).solved);
    EXPECT_EQ(poser.pose(), d.rest);
  }
}

TEST(IntentLive, AnythingDrawnLeavesAPoseInItsRanges) {
  const Desk d;
  tests::Random random(31);
  LivePoser poser = d.start();
  for (int run = 0; run < 80; ++run) {
    Line line;
    const double far = run % 10 == 0 ? 1e6 : 1500;
    for (std::size_t i = random.index(8); i-- > 0;) {
      line.push_back({random(-far, far), random(-far, far)});
      if (random.index(5) == 0) line.push_back(line.back());
    }
    if (run % 2 == 0) {
      poser.follow(line);
    } else {
      poser.follow_whole(line);
    }
    for (std::size_t p = 0; p < d.rest.size(); ++p) {
      EXPECT_GE(poser.pose()[p], 0);
      EXPECT_LE(poser.pose()[p], 1);
    }
  }
}

TEST(IntentLive, AWholeTargetThatIsChangedIsFollowed) {
  const Desk d;
  LivePoser poser = d.start();
  for (const double value : {0.2, 0.4, 0.6, 0.8, 0.5}) {
    const rig::Pose answer = d.face.pose({{"cornerLeft", value}});
    const Line line = d.face.seen(d.points, answer);
    for (int i = 0; i < 3; ++i) poser.follow_whole(line);
    EXPECT_LT(d.face.error(poser.pose(), answer), 0.15) << value;
  }
  const Line still = d.face.seen(d.points, d.rest);
  for (int i = 0; i < 3; ++i) poser.follow_whole(still);
  EXPECT_EQ(poser.pose(), d.rest) << "back again";
}

TEST(IntentLive, AKeptCurveIsHeld) {
  const Desk d;
  const Points chin = Face::row(4, 12, 28);
  const Line line = d.face.seen(d.points, d.face.pose({{"jawOpen", 0.5}}));
  IntentProblem problem = d.face.problem({d.face.drawn(d.points, {})});
  problem.kept.push_back({chin, d.face.at(chin, d.rest), 0.002});
  LivePoser poser = LivePoser::start(*d.face.rig, measure_whole_model(*d.face.rig), problem).value();
  for (int i = 0; i < 4; ++i) poser.follow(line);
  EXPECT_LT(poser.pose()[d.face.number("jawOpen")], 0.05);
}

TEST(IntentLive, TheSameReportsGiveTheSameBits) {
  const Desk d;
  const Line line = tests::shaken(d.face.seen(d.points, d.face.pose({{"jawOpen", 0.7}, {"cornerLeft", 0.4}})), 3, 5);
  LivePoser one = d.start();
  LivePoser other = d.start();
  for (std::size_t n = 2; n <= line.size(); ++n) {
    const LiveStep a = one.follow(std::span(line).first(n));
    const LiveStep b = other.follow(std::span(line).first(n));
    EXPECT_EQ(one.pose(), other.pose());
    EXPECT_EQ(a.evaluations, b.evaluations);
  }
}

TEST(IntentLive, AChainOfJointsFollowsAndTheOthersStay) {
  Face face;
  face.ready(tests::chain_skeleton(*face.mesh, 4, 0.33));
  const Points row = Face::row(20, 30, 40);
  rig::Pose answer = rig::rest_pose(*face.rig);
  answer[3 * 2 + 2] = 0.4;  // joint2.rz
  const Line line = tests::part(face.seen(row, answer), 0, 1);
  LivePoser poser =
      LivePoser::start(*face.rig, measure_whole_model(*face.rig), face.problem({face.drawn(row, {})})).value();
  Desk::draw(poser, line);
  for (std::size_t p = 0; p < 6; ++p) EXPECT_EQ(poser.pose()[p], 0) << p;
  const auto wanted = face.at(row, answer);
  const auto got = face.at(row, poser.pose());
  const auto before = face.at(row, rig::rest_pose(*face.rig));
  EXPECT_LT(geometry::distance(got.back(), wanted.back()), 0.3 * geometry::distance(before.back(), wanted.back()));
}

TEST(IntentLive, SaysWhatIsWrong) {
  const auto what = [](auto spoil) {
    const Desk d;
    IntentProblem problem = d.face.problem({d.face.drawn(d.points, {})});
    spoil(problem);
    const auto poser = LivePoser::start(*d.face.rig, measure_whole_model(*d.face.rig), problem);
    return poser ? std::string("started") : poser.error().what;
  };
  EXPECT_EQ(what([](IntentProblem&) {}), "started");
  EXPECT_EQ(what([](IntentProblem& p) { p.drawn.clear(); }), "there is no reference curve to match");
  EXPECT_EQ(what([](IntentProblem& p) { p.drawn[0].reference.resize(1); }),
            "the reference curve has fewer than two points");
  EXPECT_EQ(what([](IntentProblem& p) { p.drawn[0].reference.assign(5, posing::at_vertex(3)); }),
            "the reference curve has no length in this view");
  EXPECT_EQ(what([](IntentProblem& p) {
              p.drawn[0].camera = geometry::Camera::make({{0, 0, -5}, {0, 0, -9}, {0, 1, 0}, 30}, {100, 100}).value();
            }),
            "the reference curve lies behind the camera");
  EXPECT_NE(what([](IntentProblem& p) { p.free = {99}; }), "started");
  EXPECT_NE(what([](IntentProblem& p) { p.start[0] = 7; }), "started");
}

}  // namespace
}  // namespace penpose::intent
