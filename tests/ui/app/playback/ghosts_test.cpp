#include "ui/app/playback/ghosts.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "tests/support/app_desk.h"

// The face at other moments is shown and drawn on: the moment that is drawn on is changed, and the change goes out on
// both sides.

namespace penpose::app {
namespace {

/// Four poses of the mouth, looked at between the first two.
class GhostDesk : public Desk {
 public:
  explicit GhostDesk(const std::string& name) : Desk(name) {
    begin();
    for (const double time : {0.0, 1.0, 2.0, 3.0}) {
      perform(document::SetParameters{{{"jaw", 0.1 + 0.1 * time}, {"brow_inner_L", 0.2 * time}}});
      perform(document::SetKey{time, {}});
    }
    app->of<Playback>().go_to(0.5);
    app->of<Actions>().run(Action{"tool_ghost"});
    frames();
  }
  void perform(const document::Command& command) { ASSERT_TRUE(app->of<EditingSession>().perform(command)); }
  const GhostHand& hand() const { return app->of<GhostHand>(); }
  /// The lower lip of the ghost of a moment, moved by px.
  std::vector<PxPoint> ghost(double time_s, PxPoint by) const {
    std::vector<PxPoint> longest;
    for (const render::Ghost& one : hand().faces().ghosts()) {
      for (const render::GhostLine& line : one.lines) {
        const bool lip = line.feature.find("lip_lower") == 0 && line.places.size() > longest.size();
        if (one.moment.time_s == time_s && lip) longest = line.places;
      }
    }
    for (PxPoint& at : longest) at = at + by;
    return longest;
  }
  rig::Pose pose(double time_s) const { return document::pose_at(document(), time_s); }
  bool says(const std::string& text) const {
    const auto& all = app->of<Notices>().all();
    return std::any_of(all.begin(), all.end(), [&](const Notice& one) { return one.text.find(text) == 0; });
  }
};

double mean_apart(const std::vector<PxPoint>& a, const std::vector<PxPoint>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += geometry::distance(a[i], b[i]);
  return sum / static_cast<double>(a.size());
}

TEST(Ghosts, TheMomentThatIsDrawnOnIsChangedAndNoOther) {
  GhostDesk desk("ghost-drawn");
  const auto before = *desk.document().timeline;
  const auto poses = std::array{desk.pose(0), desk.pose(1), desk.pose(2)};
  const auto target = desk.ghost(1, {0, 12});
  ASSERT_GT(target.size(), 2U);
  desk.stroke(target);
  EXPECT_TRUE(desk.says("Frame 24 was changed, from frame 0 to 48"));
  EXPECT_EQ(desk.pose(0), poses[0]);
  EXPECT_EQ(desk.pose(2), poses[2]);
  EXPECT_NE(desk.pose(1), poses[1]);
  EXPECT_LT(mean_apart(desk.ghost(1, {}), target), 6) << "the ghost lies where it was drawn";
  EXPECT_EQ(desk.document().timeline->keys.size(), before.keys.size());
  EXPECT_EQ(desk.document().time_s, 0.5) << "one stays where one is";
  EXPECT_EQ(desk.document().pose, desk.pose(0.5));
  desk.press('z', true);
  EXPECT_EQ(*desk.document().timeline, before) << "one step";
}

TEST(Ghosts, TheOneThatWouldTakeALineIsSaidWhileThePenHovers) {
  GhostDesk desk("ghost-lit");
  EXPECT_FALSE(desk.hand().lit_s());
  const auto lip = desk.ghost(1, {});
  ASSERT_GT(lip.size(), 2U);
  desk.app->of<Pointer>().moved(lip[lip.size() / 2]);
  desk.frames();
  EXPECT_EQ(desk.hand().lit_s(), 1);
  EXPECT_NE(desk.hand().hint().find("frame 24 (after)"), std::string::npos) << desk.hand().hint();
  const auto drawings = desk.hand().drawings();
  EXPECT_TRUE(std::any_of(drawings.begin(), drawings.end(), [](const auto& one) { return one.highlighted; }));
}

TEST(Ghosts, AFeatureThatNobodyDrewIsPosedAsTheToolDrawWouldThere) {
  GhostDesk desk("ghost-draw");
  const auto line = desk.ghost(1, {0, 12});
  const auto before = desk.pose(1);
  // Another tool leaves the canvas more room.
  const document::View view = desk.app->of<EditingSession>().editor().view();
  desk.stroke(line);
  const auto on_ghost = desk.pose(1);
  EXPECT_NE(on_ghost, before);
  desk.press('z', true);
  desk.app->of<Playback>().go_to(1);
  desk.perform(document::DrawFaceLine{{view, line}});
  for (std::size_t p = 0; p < on_ghost.size(); ++p)
    EXPECT_NEAR(desk.document().pose[p], on_ghost[p], 0.02) << desk.document().model->rig->parameters()[p].name;
}

TEST(Ghosts, OnionShowsThemAndNothingIsKeptWithoutIt) {
  GhostDesk desk("ghost-onion");
  desk.app->of<Actions>().run(Action::tool_draw);
  desk.frames();
  EXPECT_TRUE(desk.hand().faces().ghosts().empty());
  EXPECT_TRUE(desk.hand().drawings().empty());
  desk.click("Onion");
  EXPECT_EQ(desk.hand().faces().ghosts().size(), 2U) << "the key before and the key after";
  EXPECT_FALSE(desk.hand().drawings().empty());
  desk.app->of<Actions>().run(Action{"more_ghosts"});
  desk.frames();
  EXPECT_EQ(desk.hand().faces().ghosts().size(), 3U) << "there is one key before, and two of those after are shown";
  EXPECT_EQ(desk.hand().veil(), nullptr);
  desk.app->of<Actions>().run(Action{"ghost_faces"});
  desk.frames();
  EXPECT_NE(desk.hand().veil(), nullptr);
  desk.press(' ');
  EXPECT_TRUE(desk.hand().drawings().empty()) << "what is played is looked at as it will be seen";
  EXPECT_EQ(desk.hand().veil(), nullptr);
}

TEST(Ghosts, FramesThatShowTheSameMakeNothingAnew) {
  GhostDesk desk("ghost-idle");
  desk.app->of<Pointer>().moved({600, 60});
  desk.frames();
  const render::GhostFaces& faces = desk.hand().faces();
  const auto posed = faces.posed(), traced = faces.traced();
  const auto* drawn = desk.hand().drawings().data();
  desk.frames(10);
  EXPECT_EQ(faces.posed(), posed);
  EXPECT_EQ(faces.traced(), traced);
  EXPECT_EQ(desk.hand().drawings().data(), drawn);
  desk.app->of<Playback>().go_to(0.75);
  desk.frames();
  EXPECT_EQ(faces.posed(), posed) << "between the same keys the same faces are seen";
  EXPECT_EQ(faces.traced(), traced);
}

TEST(Ghosts, BetweenKeysAFrameIsChangedUpToTheKeysAroundIt) {
  GhostDesk desk("ghost-frames");
  desk.app->of<CanvasLook>().ghosts.steps = render::GhostSteps::frames;
  desk.app->of<CanvasLook>().ghosts.every = 6;
  desk.frames();
  const auto before = desk.pose(0);
  desk.stroke(desk.ghost(0.75, {0, 12}));
  ASSERT_NE(desk.hand().last(), nullptr);
  EXPECT_EQ(desk.hand().last()->time_s, 0.75);
  EXPECT_EQ(desk.hand().last()->from_s, 0);
  EXPECT_EQ(desk.hand().last()->to_s, 1);
  EXPECT_EQ(desk.pose(0), before);
}

TEST(Ghosts, TheBarSetsHowFarTheChangeGoes) {
  GhostDesk desk("ghost-reach");
  const auto before = *desk.document().timeline;
  const auto at_two = desk.pose(2);
  const auto at_three = desk.pose(3);
  desk.stroke(desk.ghost(1, {0, 12}));
  GhostHand& hand = desk.app->of<GhostHand>();
  ASSERT_NE(hand.last(), nullptr);
  ASSERT_NE(desk.interface->find("reach"), nullptr);
  const GhostEdit edit = *hand.last();
  EXPECT_EQ(edit.from_s, 0);
  EXPECT_EQ(edit.to_s, 2);
  hand.reach(0, 3);
  ASSERT_NE(hand.last(), nullptr);
  EXPECT_EQ(hand.last()->to_s, 3);
  for (std::size_t c = 0; c < edit.controls.size(); ++c) {
    const std::size_t p = edit.controls[c];
    const rig::Parameter& range = desk.document().model->rig->parameters()[p];
    EXPECT_NEAR(desk.pose(2)[p], std::clamp(at_two[p] + 0.5 * edit.by[c], range.minimum, range.maximum), 1e-9);
  }
  EXPECT_EQ(desk.pose(3), at_three);
  // Narrower than to the neighbouring keys: it ends where nothing was keyed.
  hand.reach(0.75, 1.5);
  const document::Timeline narrow = *desk.document().timeline;
  EXPECT_EQ(desk.pose(2), at_two);
  EXPECT_NEAR(desk.pose(1.5)[edit.controls.front()], *document::sample(before, edit.controls.front(), 1.5), 1e-9);
  desk.press('z', true);
  EXPECT_EQ(*desk.document().timeline, before) << "still one step";
}

TEST(Ghosts, AChangeFadesSmoothly) {
  EXPECT_EQ(share_left(1, 1, 0, 3), 1);
  EXPECT_EQ(share_left(0, 1, 0, 3), 0);
  EXPECT_EQ(share_left(3, 1, 0, 3), 0);
  EXPECT_DOUBLE_EQ(share_left(2, 1, 0, 3), 0.5);
  EXPECT_EQ(share_left(0.5, 1, 1, 3), 0) << "nothing goes beyond an end";
}

TEST(Ghosts, FarFromThemNothingChangesAndItIsSaid) {
  GhostDesk desk("ghost-far");
  const auto before = *desk.document().timeline;
  desk.stroke(desk.ghost(1, {-170, 110}));
  EXPECT_EQ(*desk.document().timeline, before);
  EXPECT_TRUE(desk.says("Nothing changed"));
}

}  // namespace
}  // namespace penpose::app
