#include <gtest/gtest.h>

#include "tests/support/hands/pad_desk.h"
#include "tests/support/hands/wacom_receiver.h"

// Which tablet is which: two of one model, one behind a wireless receiver, and the light that is on already.

namespace penpose::app {
namespace {

using drawing::ToolKind;

TEST(PadDevices, TwoTabletsOfOneModelShareBindingsAndNothingElse) {
  Desk desk("pad-twins");
  desk.begin();
  for (int i = 0; i < 2; ++i) {
    auto twin = tests::intuos_pro();
    twin.unit = "usb-" + std::to_string(i);
    desk.app->of<TabletEvents>().arrived(10 + i, twin);
  }
  const auto tablet = [&](int i) -> const DeskTablet& { return *desk.app->of<HandDesk>().find(10 + i); };
  ASSERT_NE(&tablet(0), &tablet(1));
  EXPECT_EQ(tablet(0).name, "Wacom Intuos Pro S");
  EXPECT_EQ(tablet(1).name, "Wacom Intuos Pro S (2)");
  const auto send = [&](int i, unsigned keys) {
    desk.app->of<TabletEvents>().report(10 + i, desk.now_us += 5000, tests::pad_report(keys));
    desk.frames(2);
  };
  desk.app->of<Bindings>().bind(tablet(0), key(2), binding_of(ToolKind::pin));
  EXPECT_EQ(desk.app->of<Bindings>().bound(tablet(1), key(2)), binding_of(ToolKind::pin)) << "chosen for the model";
  send(1, 1);
  send(1, 0);
  const auto light = [&](int i) { return desk.app->of<TabletEvents>().lights_of(10 + i)->front(); };
  EXPECT_EQ(light(0), 0);
  EXPECT_EQ(light(1), 1);
  tests::Report status{0xc0, 0, 0, 1, 0x10, 0, 0, 0, 0x0a, 0x03};
  desk.app->of<TabletEvents>().report(10, desk.now_us += 5000, status);
  EXPECT_EQ(tablet(0).battery.percent, 10 * 100 / 31);
  EXPECT_EQ(tablet(1).battery.percent, -1);
  // Held on both; one is pulled out, and the other holds on.
  send(0, 1U << 2);
  send(1, 1U << 2);
  desk.app->of<TabletEvents>().left(10, "Wacom Intuos Pro S");
  desk.frames(2);
  EXPECT_EQ(desk.app->of<EditingSession>().editor().tool().kind, ToolKind::pin);
  EXPECT_EQ(desk.app->of<HandDesk>().find(10), nullptr);
  send(1, 0);
  EXPECT_NE(desk.app->of<EditingSession>().editor().tool().kind, ToolKind::pin);
  desk.open_menu("Tablet");
  desk.click("Tablet keys");
  EXPECT_NE(desk.interface->find("BTN_3"), nullptr);
}

TEST(PadDevices, ATabletBehindAReceiverIsItselfWithTheBindingsItHasByCable) {
  PadDesk desk("pad-receiver");
  desk.bind(key(2), binding_of(ToolKind::pin));
  desk.app->of<TabletEvents>().left(k_pad, "Wacom Intuos Pro S");
  for (int i = 0; i < 3; ++i) desk.app->of<TabletEvents>().arrived(20 + i, tests::receiver(i));
  EXPECT_TRUE(desk.told("Wacom Wireless Receiver is ready"));
  const auto send = [&](int device, const tests::Report& report) {
    desk.app->of<TabletEvents>().report(device, desk.now_us += 5000, report);
    desk.frames(2);
  };
  send(21, tests::pad_report(1U << 2));
  EXPECT_EQ(desk.tool(), ToolKind::pose) << "nothing is heard yet";
  send(20, tests::receiver_status(0x0314, 4));
  EXPECT_TRUE(desk.told("Wacom Intuos Pro S (wireless) is ready"));
  EXPECT_TRUE(desk.told("Wacom Intuos Pro S (wireless): its battery is at 12 %"));
  ASSERT_EQ(desk.app->of<HandDesk>().find(20), desk.app->of<HandDesk>().find(21)) << "one tablet of three interfaces";
  EXPECT_EQ(desk.app->of<HandDesk>().find(21)->battery.percent, 12);
  send(21, tests::pad_report(0));
  send(21, tests::pad_report(1U << 2));
  EXPECT_EQ(desk.tool(), ToolKind::pin);
  // Another model in the window is another session, which hears the receiver all the same.
  ASSERT_TRUE(desk.app->of<Files>().open("builtin:demo").ok());
  desk.frames(2);
  EXPECT_EQ(desk.app->of<HandDesk>().find(21)->key, "056a:0314");
  send(21, tests::pad_report(0));
  send(21, tests::pad_report(1U << 2));
  EXPECT_EQ(desk.tool(), ToolKind::pin);
  send(20, tests::receiver_status(0));
  EXPECT_EQ(desk.tool(), ToolKind::pose);
  EXPECT_TRUE(desk.told("Wacom Intuos Pro S (wireless) is out of reach; Key 2 (Pen: Pin) was held and is let go"));
  EXPECT_FALSE(desk.app->of<HandDesk>().find(21)->has_anything());
}

TEST(PadDevices, TheLightThatWasOnAlreadyIsTheOneThatIsShown) {
  PadDesk desk("pad-light");
  desk.app->of<TabletEvents>().lights_seen(k_pad, {2, 0});
  EXPECT_EQ(desk.app->of<TabletEvents>().lights_of(k_pad)->front(), 2);
  desk.tap(0);
  EXPECT_EQ(desk.app->of<TabletEvents>().lights_of(k_pad)->front(), 3);
  EXPECT_TRUE(desk.told("Ring, light 4: Undo and redo"));
  ASSERT_TRUE(desk.app->of<Files>().open("builtin:demo").ok());
  desk.frames(2);
  EXPECT_EQ(desk.app->of<TabletEvents>().lights_of(k_pad)->front(), 3) << "the tablet did not change with the model";
  EXPECT_EQ(desk.app->of<TabletEvents>().lights_of(k_pen), std::nullopt);
}

TEST(PadDevices, ATabletThatMayBeAnotherModelSaysWhichItIsTakenFor) {
  const tests::Report draws{0x08, 0x81, 0x10, 0x27, 0x20, 0x4e, 0xe8, 0x03, 0, 0, 0, 0};
  const tests::Report hovers{0x08, 0x80, 0x10, 0x27, 0x20, 0x4e, 0, 0, 0, 0, 0, 0};
  Desk desk("pad-guess");
  desk.begin();
  decode::DeviceIdentity huion;
  huion.bus = decode::k_bus_usb;
  huion.vendor = 0x256c;
  huion.product = 0x006e;
  huion.name = "Huion tablet";
  huion.input_report_length = 12;
  const auto told = [&] {
    for (const Notice& one : desk.app->of<Notices>().all()) {
      if (one.text.starts_with("Huion tablet: a guess: one of ")) return one.text;
    }
    return std::string();
  };
  desk.app->of<TabletEvents>().arrived(30, huion);
  EXPECT_EQ(told(), "") << "nothing was read by the table yet";
  desk.app->of<TabletEvents>().report(30, desk.now_us += 5000, draws);
  const std::string guess = told();
  EXPECT_NE(guess.find(" tablets with the ids 256c:006e, read as "), std::string::npos) << guess;
  EXPECT_TRUE(guess.ends_with("; --tablet NAME says which it is")) << guess;
  // The mouse counts again once the pen is away.
  desk.app->of<TabletEvents>().report(30, desk.now_us += 5000, hovers);
  desk.now_us += 1'000'000;
  desk.frames();
  for (const char* dialog : {"Tablet keys", "Tablet"}) {
    desk.open_menu("Tablet");
    desk.click(dialog);
    EXPECT_NE(desk.interface->find(guess), nullptr) << dialog;
    desk.click("Done");
  }
  // The next model in the window is drawn on with the same tablet, of which it was said.
  desk.now_us += 60'000'000;
  desk.frames();
  ASSERT_TRUE(desk.app->of<Files>().open("builtin:demo").ok());
  desk.app->of<TabletEvents>().report(30, desk.now_us += 5000, draws);
  EXPECT_EQ(told(), "");
  EXPECT_EQ(desk.app->of<HandDesk>().find(30)->guess, guess.substr(guess.find("a guess")));
}

}  // namespace
}  // namespace penpose::app
