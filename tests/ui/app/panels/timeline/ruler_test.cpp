#include <gtest/gtest.h>

#include "tests/support/app_desk.h"

// What is played: its two ends on the ruler.

namespace penpose::app {
namespace {

LoopRange& loop(Desk& desk) { return desk.app->of<Playback>().loop(); }

TEST(Ruler, TheEndsOfWhatIsPlayedAreDraggedAndTheFramesWithinAreScrubbed) {
  Desk desk("ruler-ends");
  desk.begin();
  for (const double time_s : {0.0, 3.0})
    ASSERT_TRUE(desk.app->of<EditingSession>().perform(document::SetKey{time_s, {}}));
  desk.app->of<Playback>().go_to(1);
  desk.press('[');
  desk.app->of<Playback>().go_to(2);
  desk.press(']');
  desk.app->of<Playback>().go_to(0);
  desk.frames();
  const Area in = *desk.interface->find("in point");
  const Area out = *desk.interface->find("out point");
  EXPECT_GE(in.width(), 32) << "wide enough for a pen";
  const double second = out.left - in.right;
  desk.pull(in.middle(), {in.middle().x - 0.5 * second, in.middle().y});
  EXPECT_LT(*loop(desk).from_s, 0.6);
  EXPECT_EQ(*loop(desk).to_s, 2);
  EXPECT_EQ(desk.app->of<Playback>().time_s(), 0) << "the playhead stays";
  desk.pull(out.middle(), {out.middle().x + 0.5 * second, out.middle().y});
  EXPECT_GT(*loop(desk).to_s, 2.4);
  const double middle = 0.5 * (in.right + out.left);
  desk.pull({middle, in.middle().y}, {middle + 2, in.middle().y});
  EXPECT_NEAR(desk.app->of<Playback>().time_s(), 1.5, 0.05) << "between them one scrubs";
}

TEST(Ruler, WithShiftADragSetsBothEndsAndThePlayheadStays) {
  Desk desk("ruler-shift");
  desk.begin();
  constexpr int k_left_shift = 225;
  const Area ruler = *desk.interface->find("ruler");
  const double y = ruler.middle().y;
  desk.interface->key(k_left_shift, {0, false, true}, true);
  desk.pull({ruler.left + 0.5 * ruler.width(), y}, {ruler.left + 0.25 * ruler.width(), y});
  desk.interface->key(k_left_shift, {0, false, false}, false);
  desk.frames();
  ASSERT_TRUE(loop(desk).from_s && loop(desk).to_s);
  EXPECT_NEAR(*loop(desk).from_s, 1, 0.1) << "in the order of time";
  EXPECT_NEAR(*loop(desk).to_s, 2, 0.1);
  EXPECT_EQ(desk.app->of<Playback>().time_s(), 0);
  // Let go of, it is forgotten.
  desk.pull({ruler.left + 0.45 * ruler.width(), y}, {ruler.left + 0.4 * ruler.width(), y});
  EXPECT_GT(desk.app->of<Playback>().time_s(), 1.4);
}

}  // namespace
}  // namespace penpose::app
