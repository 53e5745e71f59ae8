#include "ui/app/hands/tablets.h"

#include <chrono>
#include <future>
#include <gtest/gtest.h>

#include "tests/support/app_desk.h"

namespace penpose::app {
namespace {

TEST(Tablets, WhereNoneCanBeWatchedItIsToldAndTheMouseDraws) {
  Desk desk("no-watch");
  desk.begin();
  std::promise<void> woken;
  Tablets tablets(
      [&] { woken.set_value(); }, nullptr,
      [] {
        return base::Result<device::TabletWatch>(base::Error{"udev gives no events", "/run/udev", "start udev"});
      });
  ASSERT_EQ(woken.get_future().wait_for(std::chrono::seconds(20)), std::future_status::ready) << "the window is woken";
  tablets.take(desk.app->of<TabletEvents>(), desk.app->of<Notices>());
  ASSERT_FALSE(desk.app->of<Notices>().all().empty());
  EXPECT_TRUE(desk.app->of<Notices>().all().back().is_error);
  EXPECT_EQ(desk.app->of<Notices>().all().back().text,
            "No tablet found; draw with the mouse or by touch: udev gives no events; start udev");
  desk.stroke(desk.named_curve(any_curve(desk)));
  EXPECT_EQ(desk.document().curves.size(), 1U);
}

}  // namespace
}  // namespace penpose::app
