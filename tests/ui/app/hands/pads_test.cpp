#include <gtest/gtest.h>

#include "tests/support/hands/hand_descriptors.h"
#include "tests/support/hands/pad_desk.h"
#include "tests/support/shared_data.h"

// The hand that holds no pen: what keys, rings and fingers of tablets do in the window.

namespace penpose::app {
namespace {

using drawing::ToolKind;

TEST(Pads, KeysUndoAndRedoAndKeyThePose) {
  PadDesk desk("pad-actions");
  desk.app->of<EditingSession>().perform(
      document::SetParameters{{{desk.document().model->rig->parameters()[0].name, 0.5}}});
  const auto posed = desk.document().pose;
  desk.tap(1);
  EXPECT_NE(desk.document().pose, posed);
  desk.tap(2);
  EXPECT_EQ(desk.document().pose, posed);
  EXPECT_TRUE(desk.document().timeline->keys.empty());
  desk.tap(6);
  EXPECT_EQ(desk.document().timeline->keys.size(), 1U);
  desk.hold(2);
  desk.hold(2 | 4);
  EXPECT_EQ(desk.document().timeline->keys.size(), 1U) << "redo while undo is held brings it back once";
}

TEST(Pads, WhileAKeyIsHeldThePenMovesTheViewAndDrawsNothing) {
  PadDesk desk("pad-view");
  const auto mouth = desk.named_curve(any_curve(desk));
  const auto before = desk.app->of<Canvas>().view().camera;
  desk.pen(mouth.front(), false);
  desk.hold(1U << 4);
  desk.draw({{500, 400}, {520, 400}, {560, 420}, {600, 430}});
  desk.frames();
  EXPECT_NE(desk.app->of<Canvas>().view().camera.eye, before.eye) << "moved";
  EXPECT_EQ(desk.app->of<Canvas>().view().camera.eye - before.eye,
            desk.app->of<Canvas>().view().camera.look_at - before.look_at)
      << "and not turned";
  EXPECT_TRUE(desk.document().curves.empty());
  desk.hold(0);
  desk.app->of<Actions>().run(Action::view_front);
  desk.frames();
  desk.draw(desk.named_curve(any_curve(desk)));
  EXPECT_EQ(desk.document().curves.size(), 1U) << "and when it is let go the pen draws again";
  desk.hold(1U << 3);
  const auto front = desk.app->of<Canvas>().view().camera;
  desk.draw({{500, 400}, {520, 400}, {560, 420}, {600, 430}});
  desk.frames();
  EXPECT_EQ(desk.app->of<Canvas>().view().camera.look_at, front.look_at);
  EXPECT_NE(desk.app->of<Canvas>().view().camera.eye, front.eye) << "the key above it turns";
}

TEST(Pads, AToolIsHeldAndAStrokeEndsAsWhatItBegan) {
  PadDesk desk("pad-tool");
  ASSERT_EQ(desk.tool(), ToolKind::pose);
  desk.hold(1U << 5);
  EXPECT_EQ(desk.tool(), ToolKind::erase);
  desk.hold(0);
  EXPECT_EQ(desk.tool(), ToolKind::pose);
  const auto line = desk.named_curve(any_curve(desk));
  desk.draw(line, false);
  desk.hold(1U << 5);
  EXPECT_EQ(desk.tool(), ToolKind::pose) << "in the middle of a stroke";
  desk.pen(line.back(), false);
  desk.frames(2);
  EXPECT_EQ(desk.document().curves.size(), 1U);
  EXPECT_EQ(desk.tool(), ToolKind::erase);
  desk.draw({line.front() + PxPoint{0, -20}, line[line.size() / 2], line.back() + PxPoint{0, 20}});
  desk.hold(0);
  EXPECT_TRUE(desk.document().curves.empty()) << "what was held erased it";
  EXPECT_EQ(desk.tool(), ToolKind::pose);
}

TEST(Pads, WhoChoosesAnotherToolWhileOneIsHeldKeepsIt) {
  PadDesk desk("pad-tool-kept");
  desk.hold(1U << 5);
  desk.app->of<Actions>().run(Action::tool_pin);
  desk.hold(0);
  EXPECT_EQ(desk.tool(), ToolKind::pin);
}

TEST(Pads, TheRingIsABrushOfTimeAndItsLightsOtherValues) {
  PadDesk desk("pad-ring");
  const std::string name = desk.document().model->rig->parameters()[0].name;
  desk.app->of<Actions>().run(Action::key_pose);
  desk.app->of<Playback>().scrub(2);
  desk.app->of<EditingSession>().perform(document::SetParameters{{{name, 1.0}}});
  desk.app->of<Actions>().run(Action::key_pose);
  desk.app->of<Playback>().scrub(0);
  desk.app->of<Playback>().end_scrub();
  desk.ring(10, 58, false);
  EXPECT_NEAR(desk.app->of<Playback>().time_s(), 1.0, 1e-9) << "48 places are 24 notches are 24 frames";
  EXPECT_TRUE(desk.app->of<EditingSession>().shown().previews());
  desk.hold(0);
  EXPECT_FALSE(desk.app->of<EditingSession>().shown().previews());
  EXPECT_NEAR(desk.document().time_s, 1.0, 1e-9) << "let go, the pose is there";
  // The middle key moves on to the next light, and it is said what that means.
  const auto before = desk.app->of<Canvas>().view().camera;
  desk.tap(0);
  EXPECT_TRUE(desk.told("Ring, light 2: Zoom"));
  desk.ring(10, 30);
  EXPECT_NE(desk.app->of<Canvas>().view().camera.eye, before.eye);
  EXPECT_NEAR(desk.document().time_s, 1.0, 1e-9);
  desk.tap(0);
  desk.ring(10, 30);
  EXPECT_TRUE(desk.told("no control is selected: draw a pose, or select a control in the panel"));
  desk.tap(0);
  // Moves in time are no steps: what was keyed at 2 s is taken back first, then the value that was set there.
  EXPECT_EQ(desk.document().timeline->keys.size(), 2U);
  desk.ring(30, 18);
  EXPECT_EQ(desk.document().timeline->keys.size(), 1U);
  EXPECT_EQ(desk.app->of<EditingSession>().editor().history().undo_count(), 1U) << "three notches each: two steps";
  desk.ring(18, 30);
  EXPECT_EQ(desk.document().timeline->keys.size(), 2U);
  EXPECT_EQ(desk.app->of<EditingSession>().steps().can_redo(), 0U);
}

TEST(Pads, ARingChangesTheControlInHandOnceItIsLetGo) {
  PadDesk desk("pad-control");
  desk.bind(dial_control(decode::PadDial::ring, 0, 0), binding_of(DialUse::control));
  pose_mouth(desk);
  ASSERT_FALSE(desk.app->of<EditingSession>().last_stroke().movements().empty());
  const std::string name = desk.app->of<EditingSession>().last_stroke().movements().front().name;
  const auto index = *rig::find_parameter(desk.document().model->rig->parameters(), name);
  const auto& range = desk.document().model->rig->parameters()[index];
  const double was = desk.document().pose[index];
  const int way = was < 0.5 * (range.minimum + range.maximum) ? 1 : -1;
  const std::size_t done = desk.app->of<EditingSession>().editor().history().undo_count();
  desk.ring(36, 36 + 18 * way, false);
  EXPECT_EQ(desk.document().pose[index], was) << "shown only, while the finger is on it";
  EXPECT_NEAR(desk.app->of<EditingSession>().shown().pose()[index], was + way * (range.maximum - range.minimum) / 6,
              1e-9);
  desk.hold(0);
  EXPECT_NEAR(desk.document().pose[index], was + way * (range.maximum - range.minimum) / 6, 1e-9);
  EXPECT_EQ(desk.app->of<EditingSession>().editor().history().undo_count(), done + 1) << "one step to take back";
}

TEST(Pads, AKeyHeldWhenItIsUnpluggedIsLetGoAndSaid) {
  PadDesk desk("pad-unplugged");
  desk.hold(1U << 5 | 1U << 1);
  ASSERT_EQ(desk.tool(), ToolKind::erase);
  desk.app->of<TabletEvents>().left(k_pad, "Wacom Intuos Pro S");
  EXPECT_EQ(desk.tool(), ToolKind::pose);
  EXPECT_TRUE(
      desk.told("Wacom Intuos Pro S was unplugged; Key 1 (Undo) was held and is let go; "
                "Key 5 (Pen: Erase) was held and is let go"));
  desk.app->of<TabletEvents>().arrived(k_pad, tests::intuos_pro());
  EXPECT_TRUE(desk.told("Wacom Intuos Pro S is back"));
  desk.draw(desk.named_curve(any_curve(desk)));
  EXPECT_EQ(desk.document().curves.size(), 1U);
}

TEST(Pads, BehindADialogKeysDoNothingButCancel) {
  PadDesk desk("pad-dialog-open");
  desk.app->of<Dialogs>().show(Dialog::save);
  desk.frames();
  desk.tap(6);
  EXPECT_TRUE(desk.document().timeline->keys.empty());
  desk.ring(0, 40);
  EXPECT_EQ(desk.app->of<Playback>().time_s(), 0);
  desk.bind(key(1), binding_of(Action::cancel));
  desk.tap(1);
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none);
}

TEST(Pads, WhatIsPressedIsChosenForAndThePenAloneBindsIt) {
  {
    PadDesk desk("pad-bind");
    desk.open_menu("Tablet");
    desk.click("Tablet keys");
    ASSERT_NE(desk.interface->find("BTN_3"), nullptr) << "the pad's keys are shown";
    ASSERT_NE(desk.interface->find("ring 1 light 4"), nullptr);
    desk.hold(1U << 1);
    EXPECT_EQ(desk.app->of<EditingSession>().editor().history().undo_count(), 0U);
    EXPECT_EQ(desk.app->of<Dialogs>().state<PadChoice>().control, key(1));
    desk.hold(0);
    EXPECT_NE(desk.interface->find("choose action Undo"), nullptr) << "what it does now is among what is offered";
    desk.click("choose action Front");
    EXPECT_EQ(desk.app->of<Bindings>().bound(*desk.app->of<HandDesk>().find(k_pad), key(1)),
              binding_of(Action::view_front));
    desk.click("BTN_4");
    desk.click("While held");
    desk.click("choose tool Pin");
    desk.click("ring 1 light 1");
    desk.click("choose dial keys");
    desk.click("Done");
    EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none);
    desk.hold(1U << 4);
    EXPECT_EQ(desk.tool(), ToolKind::pin);
    desk.hold(0);
  }
  PadDesk desk("pad-bind", false);
  if (desk.app->of<Dialogs>().open() == Dialog::recover) desk.click("Start fresh");
  desk.begin();
  const DeskTablet& tablet = *desk.app->of<HandDesk>().find(k_pad);
  EXPECT_EQ(desk.app->of<Bindings>().bound(tablet, key(1)), binding_of(Action::view_front)) << "and it is kept";
  EXPECT_EQ(desk.app->of<Bindings>().bound(tablet, key(4)), binding_of(ToolKind::pin));
  EXPECT_EQ(desk.app->of<Bindings>().bound(tablet, dial_control(decode::PadDial::ring, 0, 0)),
            binding_of(DialUse::keys));
  EXPECT_EQ(desk.app->of<Bindings>().bound(tablet, key(2)), binding_of(Action::redo)) << "the others do what they did";
  desk.open_menu("Tablet");
  desk.click("Tablet keys");
  desk.click("Reset##pad");
  EXPECT_EQ(desk.app->of<Bindings>().bound(*desk.app->of<HandDesk>().find(k_pad), key(1)), binding_of(Action::undo));
  EXPECT_TRUE(load_settings(desk.path("config")).pads.empty());
}

TEST(Pads, KeysThatATabletDescribesAreOfferedAndDoWhatTheyAreBoundTo) {
  PadDesk desk("pad-described");
  decode::DeviceIdentity described;
  described.bus = decode::k_bus_usb;
  described.vendor = 0xfff0;
  described.product = 1;
  described.name = "Described";
  described.report_descriptor = tests::uclogic_pad_descriptor();
  desk.app->of<TabletEvents>().arrived(7, described);
  const DeskTablet& tablet = *desk.app->of<HandDesk>().find(7);
  EXPECT_EQ(keys_of(tablet.features).size(), 13U);
  EXPECT_EQ(tablet.features.rings, 1U);
  EXPECT_EQ(tablet.features.wheels, 1U);
  desk.app->of<Bindings>().bind(tablet, key(12), binding_of(Action::redo));
  desk.app->of<EditingSession>().perform(
      document::SetParameters{{{desk.document().model->rig->parameters()[0].name, 0.5}}});
  const auto press = [&](std::uint8_t first, std::uint8_t second) {
    for (const bool down : {true, false}) {
      const auto bits = [down](std::uint8_t keys) { return static_cast<std::uint8_t>(down ? keys : 0); };
      desk.app->of<TabletEvents>().report(7, desk.now_us += 1000,
                                          tests::Report{0xf7, 0xe0, 1, 1, bits(first), bits(second), 0, 0, 0, 0, 0, 0});
    }
    return desk.app->of<EditingSession>().editor().history().undo_count();
  };
  EXPECT_EQ(press(0x01, 0), 0U) << "its first key is Undo";
  EXPECT_EQ(press(0, 0x10), 1U) << "and its last what was chosen";
}

TEST(Pads, EachTabletHasBindingsOfItsOwn) {
  PadDesk desk("pad-two");
  auto remote = tests::intuos_pro();
  remote.product = 0x0331;
  remote.name = "Wacom ExpressKey Remote";
  desk.app->of<TabletEvents>().arrived(7, remote);
  desk.bind(key(1), binding_of(Action::play));
  const DeskTablet& other = *desk.app->of<HandDesk>().find(7);
  EXPECT_EQ(other.name, "Wacom ExpressKey Remote");
  EXPECT_EQ(keys_of(other.features).size(), 18U);
  EXPECT_NE(desk.app->of<Bindings>().bound(other, key(1)), binding_of(Action::play));
  desk.app->of<EditingSession>().perform(
      document::SetParameters{{{desk.document().model->rig->parameters()[0].name, 0.5}}});
  tests::Report report(13);
  report[0] = 0x11;
  report[9] = 1;
  desk.app->of<TabletEvents>().report(7, desk.now_us += 1000, report);
  EXPECT_EQ(desk.app->of<EditingSession>().editor().history().undo_count(), 0U)
      << "its first key is Undo, for the same document";
}

TEST(Pads, WhileTheFeaturesAreShownHeldPoseDrawsAlongOne) {
  PadDesk desk("pad-feature");
  desk.app->of<Bindings>().bind(*desk.app->of<HandDesk>().find(k_pen), pen_button_control(0),
                                binding_of(ToolKind::pose));
  desk.app->of<Actions>().run(Action::tool_draw);
  ASSERT_TRUE(desk.app->of<KeptFeatures>().shown());
  const auto line = desk.named_curve("brow_L", {0, -8});
  const auto draw_with_button = [&] {
    desk.pen(line.front(), false, true);
    for (const PxPoint& at : line) desk.pen(at, true, true);
    desk.pen(line.back(), false, true);
    desk.pen(line.back(), false, false);
    desk.frames(2);
  };
  draw_with_button();
  ASSERT_EQ(desk.document().model->features.size(), 1U);
  EXPECT_EQ(desk.document().model->features.front().name, "brow_L");
  EXPECT_TRUE(desk.document().curves.empty());
  EXPECT_EQ(desk.tool(), ToolKind::draw);
  // Afterwards it is Pose again.
  desk.app->of<KeptFeatures>().hide();
  draw_with_button();
  EXPECT_EQ(desk.document().curves.size(), 1U);
}

TEST(Pads, AButtonOfThePenCanHoldATool) {
  PadDesk desk("pad-barrel");
  desk.draw(desk.named_curve(any_curve(desk)));
  ASSERT_EQ(desk.document().curves.size(), 1U);
  desk.app->of<Bindings>().bind(*desk.app->of<HandDesk>().find(k_pen), pen_button_control(0),
                                binding_of(ToolKind::erase));
  const auto line = desk.named_curve(any_curve(desk));
  desk.pen(line.front(), false, true);
  EXPECT_EQ(desk.tool(), ToolKind::erase);
  for (const PxPoint& at : line) desk.pen(at, true, true);
  desk.pen(line.back(), false, true);
  EXPECT_TRUE(desk.document().curves.empty());
  desk.pen(line.back(), false, false);
  desk.frames(2);
  EXPECT_EQ(desk.tool(), ToolKind::pose);
}

/// Two fingers of a tablet that go by so much, from frame to frame; the second moves `wider` away from the first.
void two_fingers(Desk& desk, int device, int by, int wider) {
  for (int i = 0; i <= 10; ++i) {
    desk.now_us += 8000;
    desk.app->of<TabletEvents>().report(
        device, desk.now_us,
        tests::touch_report({{7, 1, 3000 + by * i, 3000}, {7, 2, 5000 + (by + wider) * i, 3000}}, 2));
  }
  desk.app->of<TabletEvents>().report(device, desk.now_us += 8000,
                                      tests::touch_report({{0, 1, 0, 0}, {0, 2, 0, 0}}, 2));
  desk.frames();
}

TEST(Pads, TwoFingersOnATabletTurnAndZoomUnlessThePenIsNear) {
  PadDesk desk("pad-fingers");
  decode::DeviceIdentity touch;
  touch.vendor = 0x1b96;
  touch.product = 2;
  touch.report_descriptor = tests::touch_descriptor(2);
  desk.app->of<TabletEvents>().arrived(5, touch);
  const auto front = desk.app->of<Canvas>().view().camera;
  desk.pen({600, 300}, false);
  two_fingers(desk, 5, 100, 0);
  EXPECT_EQ(desk.app->of<Canvas>().view().camera.eye, front.eye) << "a palm";
  desk.pen({600, 300}, false, false, false);
  two_fingers(desk, 5, 100, 0);
  EXPECT_EQ(desk.app->of<Canvas>().view().camera.eye, front.eye) << "and for a moment after";
  desk.now_us += 1'000'000;
  two_fingers(desk, 5, 100, 0);
  const auto turned = desk.app->of<Canvas>().view().camera;
  EXPECT_NE(turned.eye, front.eye);
  const auto far = [](const geometry::CameraPose& camera) { return glm::distance(camera.eye, camera.look_at); };
  EXPECT_NEAR(far(turned), far(front), 1e-6);
  desk.app->of<Pointer>().wheel(1);
  EXPECT_NEAR(far(desk.app->of<Canvas>().view().camera), far(front), 1e-6)
      << "the desktop's wheel out of the same fingers";
  two_fingers(desk, 5, 0, 300);
  EXPECT_LT(far(desk.app->of<Canvas>().view().camera), 0.8 * far(front));
  EXPECT_TRUE(desk.document().curves.empty());
}

TEST(SharedPads, EveryKeyAndTheRingOfARecordedIntuosProDoWhatIsBound) {
  const auto trace = tests::shared_dir() / "hid" / "Wacom_Intuos_Pro_S_056a_0314.hid";
  if (!std::filesystem::exists(trace)) GTEST_SKIP() << "no recording";
  Desk desk("pad-trace");
  desk.begin();
  desk.app->of<Actions>().run(Action::key_pose);
  desk.app->of<Playback>().scrub(4);
  desk.app->of<EditingSession>().perform(
      document::SetParameters{{{desk.document().model->rig->parameters()[0].name, 1.0}}});
  desk.app->of<Actions>().run(Action::key_pose);
  desk.app->of<Playback>().scrub(1);
  desk.app->of<Playback>().end_scrub();
  ASSERT_TRUE(desk.app->of<Files>().play_trace(trace.string()).ok());
  // Bound before the first key is pressed: BTN_1 to BTN_6 in that order.
  auto& bindings = desk.app->of<Preferences>().settings().pads["056a:0314"];
  bindings["BTN_1"] = binding_of(Action::wireframe);
  bindings["BTN_2"] = binding_of(Action::onion_skin);
  bindings["BTN_3"] = binding_of(ViewHold::turn);
  bindings["BTN_4"] = binding_of(ToolKind::pin);
  bindings["BTN_5"] = binding_of(ToolKind::constraint);
  bindings["BTN_6"] = binding_of(Action::theme);
  std::map<std::string, int> times;
  std::map<std::string, bool> before;
  const auto count = [&](const char* what, bool now) {
    if (before[what] != now) ++times[what];
    before[what] = now;
  };
  double latest = 0;
  while (desk.app->of<Player>().trace && !desk.app->of<Player>().trace->finished()) {
    desk.frames(1);
    count("wire", desk.app->of<CanvasLook>().wireframe);
    count("onion", desk.app->of<CanvasLook>().onion_skin);
    count("turn", desk.app->of<HandDesk>().held(Binding::Kind::view) != nullptr);
    count("pin", desk.app->of<EditingSession>().editor().tool().kind == ToolKind::pin);
    count("hold", desk.app->of<EditingSession>().editor().tool().kind == ToolKind::constraint);
    count("light", desk.app->of<Preferences>().settings().light);
    latest = std::max(latest, desk.app->of<Playback>().time_s());
  }
  // As the kernel's driver saw it: BTN_1 twice, the others once; switches are one change, what is held two.
  EXPECT_EQ(times, (std::map<std::string, int>{
                       {"wire", 2}, {"onion", 1}, {"turn", 2}, {"pin", 2}, {"hold", 2}, {"light", 1}}));
  // The ring: from 19 up to 34 a turn later, which is 87 places and 43 whole frames, and back to 63: 44 places, 22
  // frames.
  EXPECT_NEAR(latest, 1 + 43 / 24.0, 1e-9);
  EXPECT_NEAR(desk.document().time_s, 1 + 22 / 24.0, 0.5 / 24) << "let go, the pose is that of the moment";
}

}  // namespace
}  // namespace penpose::app
