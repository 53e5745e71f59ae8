#include <gtest/gtest.h>

#include "tests/support/app_desk.h"
#include "tests/support/hands/hand_descriptors.h"

// Strips, rings, wheels and what turns on a pen: from the report through what is bound to what is done.

namespace penpose::app {
namespace {

using drawing::ToolKind;
using tests::Report;

constexpr int k_tablet = 3;
constexpr double k_frame_s = 1.0 / 24;

decode::DeviceIdentity tablet(std::uint16_t product, Report descriptor = {}) {
  decode::DeviceIdentity identity;
  identity.vendor = 0x056a;
  identity.product = product;
  identity.name = "Tablet";
  identity.report_descriptor = std::move(descriptor);
  return identity;
}

Report of(std::size_t size, std::initializer_list<std::pair<std::size_t, int>> bytes) {
  Report report(size);
  for (const auto& [at, value] : bytes) report[at] = static_cast<std::uint8_t>(value);
  return report;
}

class DialDesk : public Desk {
 public:
  DialDesk(const std::string& name, const decode::DeviceIdentity& identity) : Desk("dial-" + name) {
    begin();
    app->of<TabletEvents>().arrived(k_tablet, identity);
    app->of<Actions>().run(Action::key_pose);
    app->of<Playback>().scrub(2);
    app->of<Playback>().end_scrub();
    frames();
  }
  void send(const std::vector<Report>& reports) {
    for (const Report& report : reports) {
      app->of<TabletEvents>().report(k_tablet, now_us += 5000, report);
      frames(1);
    }
  }
  void bind(const PadControl& control, const Binding& binding) {
    app->of<Bindings>().bind(*app->of<HandDesk>().find(k_tablet), control, binding);
  }
  /// Frames by which the reports move the time, when the control is bound to it; everything else is bound to nothing.
  double frames_by(const PadControl& control, const std::vector<Report>& reports) {
    for (const auto dial : {decode::PadDial::ring, decode::PadDial::strip, decode::PadDial::wheel}) {
      for (std::uint8_t side = 0; side < 2; ++side) bind(dial_control(dial, side, 0), {});
    }
    bind(control, binding_of(DialUse::time));
    const double before = app->of<Playback>().time_s();
    send(reports);
    return (app->of<Playback>().time_s() - before) / k_frame_s;
  }
};

TEST(Dials, EachStripOfAnIntuos3IsOneOfItsOwn) {
  // A bit for each place, the first at the top.
  const auto first = [](int bits) { return of(10, {{0, 0x0c}, {1, bits >> 8}, {2, bits}}); };
  const auto second = [](int bits) { return of(10, {{0, 0x0c}, {3, bits >> 8}, {4, bits}}); };
  DialDesk desk("strips", tablet(0x00b1));
  EXPECT_NEAR(desk.frames_by(dial_control(decode::PadDial::strip, 0, 0), {first(1), first(2), first(8), first(0)}), 3,
              1e-9);
  EXPECT_NEAR(desk.frames_by(dial_control(decode::PadDial::strip, 1, 0), {second(0x1000), second(0x400), second(0)}),
              -2, 1e-9);
  EXPECT_NEAR(desk.frames_by(dial_control(decode::PadDial::strip, 1, 0), {first(1), first(0x100), first(0)}), 0, 1e-9)
      << "the other strip does what it is bound to";
}

TEST(Dials, TheSecondRingOfACintiq24HD) {
  const auto second = [](int place) { return of(10, {{0, 0x0c}, {2, 0x80 | place}}); };
  DialDesk desk("rings", tablet(0x00f4));
  EXPECT_NEAR(desk.frames_by(dial_control(decode::PadDial::ring, 1, 0),
                             {second(10), second(20), second(30), of(10, {{0, 0x0c}})}),
              10, 1e-9)
      << "20 of 72 places are 10 of 36 notches";
  EXPECT_NEAR(desk.frames_by(dial_control(decode::PadDial::ring, 0, 0), {second(10), second(30), of(10, {{0, 0x0c}})}),
              0, 1e-9);
}

TEST(Dials, TheWheelOfAGraphire4) {
  const auto turn = [](int steps) { return of(8, {{0, 0x02}, {7, (steps & 7) << 3}}); };
  DialDesk desk("wheel", tablet(0x0015));
  const PadControl wheel = dial_control(decode::PadDial::wheel, 0, 0);
  EXPECT_NEAR(desk.frames_by(wheel, {turn(1), turn(1)}), -2, 1e-9) << "away from oneself is back";
  EXPECT_NEAR(desk.frames_by(wheel, {turn(-1), turn(-1), turn(-1)}), 3, 1e-9);
}

/// A pad of report 17 that has keys and two rings which tell how far they were turned.
Report turning_descriptor() {
  constexpr std::uint32_t k_page = 0xff0d0000;
  Report items{0x06, 0x0d, 0xff, 0x09, 0x01, 0xa1, 0x01, 0x85, 0x11, 0x06, 0x0d, 0xff, 0x09, 0x39, 0xa1, 0x00};
  tests::append(items, tests::input({k_page | 0x910, k_page | 0x911}, 1, 2));
  tests::append(items, tests::padding(6));
  for (int side = 0; side < 2; ++side) {
    Report turn = tests::input({k_page | 0x138}, 8, 1, 127, 0x06);
    turn[6] = 0x81;  // from -127 on
    tests::append(items, turn);
  }
  tests::append(items, {0xc0, 0xc0});
  return items;
}

TEST(Dials, RingsThatTellHowFarTheyWereTurned) {
  const auto turn = [](int first, int second) { return of(4, {{0, 0x11}, {2, first}, {3, second}}); };
  DialDesk desk("turns", tablet(0xfff0, turning_descriptor()));
  ASSERT_EQ(desk.app->of<HandDesk>().find(k_tablet)->features.wheels, 2U);
  EXPECT_NEAR(desk.frames_by(dial_control(decode::PadDial::wheel, 0, 0), {turn(3, 0), turn(-1, 0)}), 2, 1e-9);
  EXPECT_NEAR(desk.frames_by(dial_control(decode::PadDial::wheel, 1, 0), {turn(5, -2)}), -2, 1e-9);
}

// Tools of an Intuos4: an art pen, an airbrush, and the pen that comes with it.
constexpr std::uint32_t k_art_pen = 0x10804;
constexpr std::uint32_t k_airbrush = 0x10902;
constexpr std::uint32_t k_grip_pen = 0x10802;
constexpr std::uint16_t k_intuos4_m = 0x00b9;

/// A packet of a pen in the middle of the tablet.
Report packet(int function, int byte6, int byte7, int byte8 = 0x40) {
  return {0x02,
          static_cast<std::uint8_t>(0xe0 | function << 1),
          0x20,
          0x00,
          0x18,
          0x00,
          static_cast<std::uint8_t>(byte6),
          static_cast<std::uint8_t>(byte7),
          static_cast<std::uint8_t>(byte8),
          0x40};
}

TEST(Dials, AnArtPenTurnedAboutItself) {
  const auto turned = [](int raw) { return packet(5, raw >> 3, (raw & 7) << 5); };
  DialDesk desk("art-pen", tablet(k_intuos4_m));
  ASSERT_TRUE(desk.app->of<HandDesk>().find(k_tablet)->pen_rotation);
  const PadControl rotation{PadControl::Kind::pen_rotation, 0, 0};
  // Half units: 200 are 100 of 1800, which is 2 of 36 notches.
  const double by = desk.frames_by(rotation, {tests::intuos_enter(k_art_pen, 7), turned(0x10), turned(0xd8)});
  EXPECT_NEAR(std::abs(by), 2, 1e-9);
  EXPECT_NEAR(desk.frames_by(rotation, {turned(0x10)}), -by, 1e-9) << "and back";
  EXPECT_NEAR(desk.frames_by(rotation, {tests::intuos_leave(), tests::intuos_enter(k_art_pen, 7), turned(0xd8)}), 0,
              1e-9)
      << "put down turned otherwise it did not turn";
}

TEST(Dials, TheWheelOfAnAirbrush) {
  const auto wheel = [](int value) { return packet(0xa, value >> 2, (value & 3) << 6); };
  DialDesk desk("airbrush", tablet(k_intuos4_m));
  const PadControl control{PadControl::Kind::pen_wheel, 0, 0};
  EXPECT_NEAR(desk.frames_by(control, {tests::intuos_enter(k_airbrush, 8), wheel(100), wheel(228), wheel(356)}), 6,
              1e-9)
      << "256 of 1024 are 6 of 24 notches";
  EXPECT_NEAR(desk.frames_by(control, {wheel(228)}), -3, 1e-9);
}

TEST(Dials, TheSecondButtonOfAPenHoldsWhatItIsBoundTo) {
  DialDesk desk("barrel", tablet(k_intuos4_m));
  desk.bind(pen_button_control(1), binding_of(ToolKind::erase));
  desk.bind(pen_button_control(0), binding_of(ToolKind::pin));
  const auto tool = [&] { return desk.app->of<EditingSession>().editor().tool().kind; };
  const ToolKind before = tool();
  desk.send({tests::intuos_enter(k_grip_pen, 9), packet(0, 0, 0), packet(2, 0, 0)});
  EXPECT_EQ(tool(), ToolKind::erase);
  desk.send({packet(0, 0, 0)});
  EXPECT_EQ(tool(), before);
  desk.send({packet(1, 0, 0)});
  EXPECT_EQ(tool(), ToolKind::pin);
  desk.send({packet(0, 0, 0), packet(2, 0, 0), tests::intuos_leave()});
  EXPECT_EQ(tool(), before) << "a pen that leaves holds nothing";
}

}  // namespace
}  // namespace penpose::app
