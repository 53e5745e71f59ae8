#include "replay/session/hand_input.h"

#include <gtest/gtest.h>

#include "replay/session/session_player.h"
#include "replay/session/virtual_pen.h"
#include "tests/support/hands/hand_descriptors.h"
#include "tests/support/hands/wacom_hand.h"
#include "tests/support/hands/wacom_receiver.h"
#include "tests/support/models/sheet_model.h"
#include "tests/support/session_script.h"

namespace penpose::replay {
namespace {

using decode::PadEventKind;

/// A touch screen that describes itself.
decode::DeviceIdentity fingers() {
  decode::DeviceIdentity identity;
  identity.vendor = 0x1b96;
  identity.product = 1;
  identity.report_descriptor = tests::touch_descriptor(2);
  return identity;
}

class HandInputTest : public testing::Test {
 protected:
  HandInputTest() {
    hands.connect(1, tests::intuos_pro());
    hands.connect(2, fingers());
  }
  std::vector<HandMoment> send(int device, const tests::Report& report, std::int64_t by_us = 1000) {
    const auto moments = hands.report(device, time_us += by_us, report);
    return {moments.begin(), moments.end()};
  }
  std::size_t fingers_after(std::int64_t by_us = 1000) {
    send(2, tests::touch_report({{7, 1, 100, 200}, {7, 2, 300, 400}}, 2), by_us);
    return hands.fingers(2).size();
  }
  void lift() { send(2, tests::touch_report({{0, 1, 0, 0}, {0, 2, 0, 0}}, 2)); }

  HandInput hands;
  std::int64_t time_us = 0;
};

TEST_F(HandInputTest, EachInterfaceHasItsOwnKeysAndFingers) {
  const auto moments = send(1, tests::pad_report(2));
  ASSERT_EQ(moments.size(), 1U);
  EXPECT_EQ(moments[0].device, 1);
  EXPECT_EQ(moments[0].event.kind, PadEventKind::key_down);
  EXPECT_EQ(moments[0].event.key, decode::PadKey::button1);
  EXPECT_EQ(fingers_after(), 2U);
  EXPECT_TRUE(hands.fingers(1).empty());
  EXPECT_EQ(hands.pad(2), nullptr);
  EXPECT_TRUE(hands.report(9, 0, tests::pad_report(1)).empty()) << "a device that nobody declared";
}

TEST_F(HandInputTest, AKeyThatIsHeldWhenItsTabletGoesIsLetGo) {
  send(1, tests::pad_report(2, 10));
  const auto moments = hands.disconnect(1, 5000);
  ASSERT_EQ(moments.size(), 2U);
  EXPECT_EQ(moments[0].event.kind, PadEventKind::key_up);
  EXPECT_EQ(moments[1].event.kind, PadEventKind::let_go);
  EXPECT_TRUE(hands.pad(1)->sample().keys.empty());
  EXPECT_TRUE(hands.disconnect(1, 6000).empty()) << "only once";
}

TEST_F(HandInputTest, FingersAreHeldBackWhileAPenIsNearOnAnyTabletAndAMomentAfter) {
  hands.pen(5, true, time_us);
  EXPECT_EQ(fingers_after(), 0U);
  lift();
  hands.pen(5, false, time_us);
  EXPECT_EQ(fingers_after(decode::PalmGuard::k_default_hold_us / 2), 0U);
  lift();
  EXPECT_EQ(fingers_after(decode::PalmGuard::k_default_hold_us), 2U);
}

TEST_F(HandInputTest, APenThatIsUnpluggedWhileItIsNearHoldsNothingBackForLong) {
  hands.pen(1, true, time_us);
  static_cast<void>(hands.disconnect(1, time_us));
  EXPECT_EQ(fingers_after(2 * decode::PalmGuard::k_default_hold_us), 2U);
}

TEST_F(HandInputTest, AMouseHoldsNoFingersBack) {
  hands.connect(0, virtual_pen_identity());
  hands.pen(0, true, time_us);
  EXPECT_EQ(fingers_after(), 2U);
}

TEST_F(HandInputTest, TheChargeIsToldWhenItChanges) {
  const auto status = [](std::uint8_t charge) { return tests::Report{0xc0, 0, 0, 1, 0x10, 0, 0, 0, charge, 0x03}; };
  auto moments = send(1, status(0x92));
  ASSERT_EQ(moments.size(), 1U);
  EXPECT_EQ(moments[0].kind, HandMoment::Kind::battery);
  EXPECT_EQ(hands.pad(1)->battery(), (decode::Battery{18 * 100 / 31, true}));
  EXPECT_TRUE(send(1, status(0x92)).empty());
  send(1, status(0x3f));
  EXPECT_EQ(hands.pad(1)->battery(), (decode::Battery{100, false})) << "more than full is full";
  send(1, {0xc0, 0, 0, 1, 0x10, 0, 0, 0, 0x92, 0x01});
  EXPECT_EQ(hands.pad(1)->battery().percent, -1) << "without its module there is no battery";
}

TEST(HandsInSessions, ARecordedSessionKeepsTheReportsAndComesToTheSameStates) {
  tests::SessionScript script(document::make_document(tests::sheet_model()));
  script.live().connect(3, tests::intuos_pro());
  script.live().report(3, 1000, tests::pad_report(0b0100, 30));
  ASSERT_TRUE(script.perform(document::SetParameters{{{"lift", 0.5}}}).ok()) << "what the key is bound to";
  script.live().report(3, 2000, tests::pad_report(0b0110, 33));
  ASSERT_TRUE(script.act(Undone{}).ok());
  ASSERT_TRUE(script.perform(document::SetParameters{{{"lift", 0.25}}}).ok());
  const decode::PadSample here = script.live().session().hands().pad(3)->sample();
  EXPECT_EQ(here.keys, (decode::PadKeys{decode::PadKey::button1, decode::PadKey::button2}));
  PlayerOptions options;
  options.open = [](const std::string&) {
    return base::Result<document::Document>(document::make_document(tests::sheet_model()));
  };
  const auto playback = play_session(read_from(base::as_bytes(script.text())), options);
  ASSERT_TRUE(playback.ok());
  EXPECT_EQ(playback->differing, 0U);
  EXPECT_EQ(playback->reports, 2U);
  EXPECT_EQ(playback->session->editor().state(), script.editor().state());
  ASSERT_NE(playback->session->hands().pad(3), nullptr);
  EXPECT_EQ(playback->session->hands().pad(3)->sample(), here);
}

PlayerOptions on_the_sheet() {
  PlayerOptions options;
  options.open = [](const std::string&) {
    return base::Result<document::Document>(document::make_document(tests::sheet_model()));
  };
  return options;
}

/// A wireless receiver at a session, its interfaces as devices 1 to 3.
class ReceiverInSession : public testing::Test {
 protected:
  ReceiverInSession() {
    for (int i = 0; i < 3; ++i) script.live().connect(1 + i, tests::receiver(i));
  }
  std::vector<HandMoment> send(int device, const tests::Report& report) {
    script.live().report(device, time_us += 1000, report);
    const auto moments = session().hand_moments();
    return {moments.begin(), moments.end()};
  }
  [[nodiscard]] const Session& session() { return script.live().session(); }
  static std::size_t count(const std::vector<HandMoment>& moments, HandMoment::Kind kind) {
    std::size_t number = 0;
    for (const HandMoment& one : moments) number += one.kind == kind ? 1 : 0;
    return number;
  }

  tests::SessionScript script{document::make_document(tests::sheet_model())};
  std::int64_t time_us = 0;
};

constexpr unsigned k_intuos_pro_s = 0x0314;

TEST_F(ReceiverInSession, ItsTabletIsReadOnceItIsHeard) {
  EXPECT_TRUE(send(2, tests::pad_report(2)).empty());
  EXPECT_FALSE(session().pens().decodes(2));
  const auto heard = send(1, tests::receiver_status(k_intuos_pro_s, 15));
  EXPECT_EQ(count(heard, HandMoment::Kind::tablet), 3U);
  ASSERT_EQ(count(heard, HandMoment::Kind::battery), 1U);
  EXPECT_EQ(heard.back().kind, HandMoment::Kind::battery) << "that of the tablet, so after it";
  EXPECT_EQ(session().hands().pad(1)->battery().percent, 48);
  EXPECT_TRUE(session().pens().decodes(2));
  EXPECT_EQ(session().identity_of(1)->product, k_intuos_pro_s) << "the charge is that tablet's";
  const auto pressed = send(2, tests::pad_report(2));
  ASSERT_EQ(pressed.size(), 1U);
  EXPECT_EQ(pressed[0].event.key, decode::PadKey::button1);
}

TEST_F(ReceiverInSession, WhatIsHeldWhenItGoesOutOfReachIsLetGo) {
  send(1, tests::receiver_status(k_intuos_pro_s));
  send(2, tests::pad_report(2));
  const auto lost = send(1, tests::receiver_status(0));
  ASSERT_EQ(count(lost, HandMoment::Kind::pad), 1U);
  EXPECT_EQ(count(lost, HandMoment::Kind::tablet), 3U);
  EXPECT_EQ(session().identity_of(2)->product, decode::k_wacom_receiver);
  EXPECT_FALSE(session().pens().decodes(2));
  EXPECT_TRUE(send(2, tests::pad_report(4)).empty());
}

TEST_F(ReceiverInSession, AReplayHearsItToo) {
  send(1, tests::receiver_status(k_intuos_pro_s, 20));
  send(2, tests::pad_report(0b0110, 33));
  const decode::PadSample here = session().hands().pad(2)->sample();
  EXPECT_FALSE(here.keys.empty());
  ASSERT_TRUE(script.act(PenPlace{true}).ok()) << "with which the reports are handed over";
  const auto playback = play_session(read_from(base::as_bytes(script.text())), on_the_sheet());
  ASSERT_TRUE(playback.ok());
  ASSERT_NE(playback->session->hands().pad(2), nullptr);
  EXPECT_EQ(playback->session->hands().pad(2)->sample(), here);
  EXPECT_EQ(playback->session->hands().pad(1)->battery().percent, 20 * 100 / 31);
}

TEST(HandsInSessions, LightsThatWereOnAlreadyAreReplayed) {
  tests::SessionScript script(document::make_document(tests::sheet_model()));
  script.live().connect(3, tests::intuos_pro());
  ASSERT_TRUE(script.act(LightsSeen{3, {2, 0}}).ok());
  EXPECT_EQ(script.live().session().hands().pad(3)->sample().mode[0], 2);
  script.live().report(3, 1000, tests::pad_report(1));
  EXPECT_EQ(script.live().session().hands().pad(3)->sample().mode[0], 3);
  ASSERT_TRUE(script.act(PenPlace{true}).ok()) << "with which the reports are handed over";
  const auto playback = play_session(read_from(base::as_bytes(script.text())), on_the_sheet());
  ASSERT_TRUE(playback.ok());
  ASSERT_NE(playback->session->hands().pad(3), nullptr);
  EXPECT_EQ(playback->session->hands().pad(3)->sample().mode[0], 3);
  EXPECT_TRUE(script.act(LightsSeen{9, {1, 1}}).ok()) << "of a device that is not there: nothing";
}

}  // namespace
}  // namespace penpose::replay
