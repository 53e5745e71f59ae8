#include "ui/app/playback/marks/bookmark_steps.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "tests/support/app_desk.h"

namespace penpose::app {
namespace {

constexpr std::uint32_t k_page_down = k_key_page_down;
constexpr std::uint32_t k_page_up = k_key_page_up;

const document::Bookmarks& bookmarks(const Desk& desk) {
  static const document::Bookmarks k_none;
  return desk.document().bookmarks ? *desk.document().bookmarks : k_none;
}

double now_s(Desk& desk) { return desk.app->of<Playback>().time_s(); }

bool says(Desk& desk, const std::string& words) {
  const auto& all = desk.app->of<Notices>().all();
  return std::any_of(all.begin(), all.end(),
                     [&](const Notice& one) { return one.text.find(words) != std::string::npos; });
}

TEST(BookmarkSteps, AKeySetsOneAndAgainNamesItAndItIsSavedWithTheProject) {
  Desk desk("bookmark-name");
  desk.begin();
  desk.app->of<Playback>().place_cursor(1);
  desk.press('b', true);
  ASSERT_EQ(bookmarks(desk), (document::Bookmarks{{1, "", 0}}));
  EXPECT_TRUE(desk.app->of<EditingSession>().unsaved());
  desk.press('b', true);
  ASSERT_EQ(desk.app->of<Dialogs>().open(), Dialog{"bookmark"});
  desk.type("hit");
  desk.click("##bookmark color 2");
  desk.click("Keep##bookmark");
  EXPECT_EQ(bookmarks(desk), (document::Bookmarks{{1, "hit", 2}}));
  EXPECT_NE(desk.interface->find("bookmark hit"), nullptr) << "its flag is on the ruler";
  ASSERT_TRUE(desk.app->of<Files>().save(desk.path("marked.glb")).ok());
  ASSERT_TRUE(desk.app->of<Files>().open(desk.path("marked.glb")).ok());
  EXPECT_EQ(bookmarks(desk), (document::Bookmarks{{1, "hit", 2}}));
  desk.app->of<Playback>().place_cursor(1);
  desk.press('b', true);
  desk.click("Delete##bookmark");
  EXPECT_TRUE(bookmarks(desk).empty());
  desk.press('z', true);
  EXPECT_EQ(bookmarks(desk).size(), 1U);
}

TEST(BookmarkSteps, KeysGoFromOneToTheNextAndSayWhereThereIsNone) {
  Desk desk("bookmark-steps");
  desk.begin();
  auto& editing = desk.app->of<EditingSession>();
  ASSERT_TRUE(editing.perform(document::SetKey{0, {}}));
  for (const double time_s : {0.5, 2.0}) ASSERT_TRUE(editing.perform(document::SetBookmark{time_s, {}, 0}));
  desk.press(k_page_down, true);
  EXPECT_EQ(now_s(desk), 0.5);
  desk.press(k_page_down, true);
  EXPECT_EQ(now_s(desk), 2);
  EXPECT_EQ(desk.document().time_s, 2) << "the face goes along";
  desk.press(k_page_down, true);
  EXPECT_EQ(now_s(desk), 2);
  EXPECT_TRUE(says(desk, "no bookmark after"));
  desk.press(k_page_up, true);
  EXPECT_EQ(now_s(desk), 0.5);
}

TEST(BookmarkSteps, AFlagIsTouchedToGoThereAndDraggedElsewhere) {
  Desk desk("bookmark-flag");
  desk.begin();
  auto& editing = desk.app->of<EditingSession>();
  ASSERT_TRUE(editing.perform(document::SetBookmark{1, "hit", 0}));
  desk.frames();
  desk.click("bookmark hit");
  EXPECT_EQ(now_s(desk), 1);
  const Area flag = *desk.interface->find("bookmark hit");
  const Area ruler = *desk.interface->find("ruler");
  desk.stroke({flag.middle(), {flag.middle().x + 0.25 * ruler.width(), flag.middle().y}});
  ASSERT_EQ(bookmarks(desk).size(), 1U);
  EXPECT_NEAR(bookmarks(desk).front().time_s, 2, 0.2);
  EXPECT_EQ(now_s(desk), 1) << "the playhead stays";
  desk.app->of<Playback>().place_cursor(bookmarks(desk).front().time_s);
  desk.frames();
  desk.click("bookmark hit");
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog{"bookmark"}) << "touched again where one stands already";
}

TEST(BookmarkSteps, TheMenuOfMarksIsAButtonAndTheRightButtonOnTheRuler) {
  Desk desk("bookmark-menu");
  desk.begin();
  ASSERT_TRUE(desk.app->of<EditingSession>().perform(document::SetBookmark{1.5, "hit", 0}));
  desk.frames();
  const PxPoint at = desk.interface->find("ruler")->middle();
  desk.app->of<Pointer>().moved(at);
  desk.app->of<Pointer>().button(MouseButton::right, true, at);
  desk.app->of<Pointer>().button(MouseButton::right, false, at);
  desk.frames();
  ASSERT_NE(desk.interface->find("hit##bookmark 36"), nullptr);
  desk.click("hit##bookmark 36");
  EXPECT_EQ(now_s(desk), 1.5);
  EXPECT_EQ(desk.interface->find("hit##bookmark 36"), nullptr) << "the menu is closed";
}

}  // namespace
}  // namespace penpose::app
