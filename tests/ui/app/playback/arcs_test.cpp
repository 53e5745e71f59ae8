#include "ui/app/playback/arcs.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/app_desk.h"
#include "ui/app/playback/keys.h"

namespace penpose::app {
namespace {

/// The head keyed at rest and, a second later, with a brow raised along a line that was drawn.
class ArcDesk : public Desk {
 public:
  explicit ArcDesk(const std::string& name) : Desk(name) {
    begin();
    click("Key");
    press('b');
    stroke(named_curve("brow_L"));
    app->of<Playback>().go_to(1);
    frames();
    stroke(named_curve("brow_L", {0, -14}));
    click("Key");
    press('w');
  }
  std::vector<ShownArc> arcs() {
    const auto& editing = app->of<EditingSession>();
    return arcs_of(editing.document(), editing.features(), app->of<Canvas>().view(), app->of<Playback>().rate());
  }
};

double farthest(const ShownArc& a, const ShownArc& b) {
  double most = 0;
  for (std::size_t f = 0; f < a.places.size(); ++f) most = std::max(most, geometry::distance(a.places[f], b.places[f]));
  return most;
}

TEST(Arcs, ADrawnPathIsTakenAndUndoneInOneStep) {
  ArcDesk desk("arc-redraw");
  const auto before = desk.arcs();
  ASSERT_FALSE(before.empty());
  const ShownArc& arc = before.front();
  ASSERT_EQ(arc.places.size(), 25U) << "a tick at each frame";
  const PxPoint from = arc.places.front();
  const PxPoint to = arc.places.back();
  const PxPoint aside{12, 0};
  desk.stroke({from, (from + to) * 0.5 + aside, to});
  const auto after = desk.arcs();
  ASSERT_FALSE(after.empty());
  ASSERT_EQ(after.front().point, arc.point);
  EXPECT_GT(farthest(after.front(), arc), 4) << "px";
  EXPECT_LT(geometry::distance(after.front().places.front(), from), 0.5);
  EXPECT_LT(geometry::distance(after.front().places.back(), to), 0.5);
  desk.press('z', true);
  EXPECT_LT(farthest(desk.arcs().front(), arc), 1e-9);
}

TEST(Arcs, AFrameIsPulledAlongItsArc) {
  ArcDesk desk("arc-pull");
  const ShownArc arc = desk.arcs().front();
  desk.stroke({arc.places[6], arc.places[12], arc.places[18]});
  const ShownArc after = desk.arcs().front();
  ASSERT_EQ(after.point, arc.point);
  EXPECT_GT(geometry::distance(arc.places[6], arc.places[18]), 4);
  EXPECT_LT(geometry::distance(after.places[6], arc.places[18]), 1) << "frame 6 is where frame 18 was";
  EXPECT_LT(geometry::distance(after.places[0], arc.places[0]), 0.5);
  EXPECT_LT(geometry::distance(after.places[24], arc.places[24]), 0.5);
}

TEST(Arcs, AStrokeBesideEveryArcMeansNothing) {
  ArcDesk desk("arc-beside");
  const auto steps = desk.app->of<EditingSession>().steps().list().size();
  const Area free = desk.app->of<Canvas>().free_area();
  desk.stroke({{free.left + 30, free.top + 30}, {free.left + 90, free.top + 60}});
  EXPECT_EQ(desk.app->of<EditingSession>().steps().list().size(), steps);
}

}  // namespace
}  // namespace penpose::app
