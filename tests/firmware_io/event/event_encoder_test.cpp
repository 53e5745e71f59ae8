#include "firmware_io/event/event_encoder.h"

#include <gtest/gtest.h>

#include "firmware_io/decode/decoder_factory.h"
#include "firmware_io/decode/hand_factory.h"
#include "firmware_io/hid/report_descriptor.h"
#include "tests/support/hands/input_events.h"
#include "tests/support/hands/pen_path.h"
#include "tests/support/hands/pen_reports.h"
#include "tests/support/hands/same_pen.h"

namespace penpose::event {
namespace {

using tests::InputDevice;

std::unique_ptr<decode::PenDecoder> pen_of(const EventAxes& axes) {
  auto found = decode::make_decoder(tests::identity_of(axes));
  EXPECT_TRUE(found) << "no pen was found";
  return found ? std::move(found->decoder) : nullptr;
}

/// What a decoder says of one frame, which has one report.
decode::PenSample sample_of(decode::PenDecoder& decoder, const EventEncoder::Reports& reports) {
  EXPECT_EQ(reports.size(), 1U);
  for (const auto& report : reports) decoder.decode(report);
  return decoder.sample();
}

std::unique_ptr<decode::PenDecoder> ink_decoder() {
  return std::move(decode::make_decoder(tests::device(0x1b96, 0x21, tests::ink_descriptor()))->decoder);
}

TEST(EventEncoder, APenGivesTheSamplesThatItGivesThroughHidraw) {
  const auto axes = tests::ink_event_device();
  InputDevice device(axes);
  const auto through_events = pen_of(axes);
  const auto through_hidraw = ink_decoder();
  std::size_t compared = 0;
  for (decode::PenSample sample : tests::pen_path({24188, 15360, 4095, true, -1}, 6, 200)) {
    sample.tilt_x *= 7;
    through_hidraw->decode(tests::ink_pen(sample));
    EXPECT_EQ(sample_of(*through_events, device.pen(sample)), through_hidraw->sample());
    ++compared;
  }
  EXPECT_EQ(compared, 6U * 201U);
}

TEST(EventEncoder, RangesAndUnitsAreTheDevicesOwn) {
  const auto through_events = pen_of(tests::ink_event_device());
  const auto through_hidraw = ink_decoder();
  const auto expect_same = [](const decode::Axis& got, const decode::Axis& wanted) {
    EXPECT_EQ(got.present, wanted.present);
    EXPECT_EQ(got.minimum, wanted.minimum);
    EXPECT_EQ(got.maximum, wanted.maximum);
    // Linux gives whole units a mm.
    EXPECT_NEAR(got.units_per_mm, wanted.units_per_mm, 0.005 * wanted.units_per_mm);
  };
  const auto& got = through_events->axes();
  const auto& wanted = through_hidraw->axes();
  expect_same(got.x, wanted.x);
  expect_same(got.y, wanted.y);
  expect_same(got.pressure, wanted.pressure);
  expect_same(got.tilt_x, wanted.tilt_x);
  expect_same(got.tilt_y, wanted.tilt_y);
  EXPECT_DOUBLE_EQ(got.x.units_per_mm, 100);
  EXPECT_DOUBLE_EQ(got.tilt_x.units_per_mm, 100);
  EXPECT_FALSE(got.distance.present || got.rotation.present || got.wheel.present);
}

TEST(EventEncoder, ItsIdsDoNotMakeItAnotherTablet) {
  // By these ids reports are those of an Intuos4, of a Huion that must be woken, of a receiver.
  for (const auto& [vendor, product] :
       {std::pair{0x056a, 0x00b8}, {0x256c, 0x006d}, {0x056a, 0x0084}, {0x056a, 0x0357}}) {
    auto axes = tests::ink_event_device();
    axes.vendor = static_cast<std::uint16_t>(vendor);
    axes.product = static_cast<std::uint16_t>(product);
    const auto found = decode::make_decoder(tests::identity_of(axes));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->method, "event device");
    EXPECT_FALSE(found->is_pad);
  }
}

/// A Wacom tablet as Linux's wacom driver shows it: airbrush and art pen, puck, serial and tool numbers.
EventAxes intuos() {
  EventAxes axes = tests::ink_event_device();
  axes.vendor = 0x056a;
  axes.product = 0x00b8;
  axes.abs[ABS_X] = {0, 31496, 200};
  axes.abs[ABS_Y] = {0, 19685, 200};
  axes.abs[ABS_DISTANCE] = {0, 63, 0};
  axes.abs[ABS_TILT_X] = axes.abs[ABS_TILT_Y] = {-64, 63, 57};
  axes.abs[ABS_Z] = {-900, 899, 287};
  axes.abs[ABS_WHEEL] = {0, 1023, 0};
  axes.abs[ABS_MISC] = {0, 0, 0};
  axes.mscs = {MSC_SERIAL};
  axes.keys.insert({BTN_STYLUS2, BTN_STYLUS3, BTN_TOOL_BRUSH, BTN_TOOL_PENCIL, BTN_TOOL_AIRBRUSH, BTN_TOOL_MOUSE,
                    BTN_TOOL_LENS, BTN_LEFT, BTN_RIGHT, BTN_MIDDLE, BTN_SIDE, BTN_EXTRA});
  return axes;
}

TEST(EventEncoder, AnAirbrushHasItsWheelItsNumbersAndItsThreeButtons) {
  const auto axes = intuos();
  InputDevice device(axes);
  const auto decoder = pen_of(axes);
  device.put(EV_KEY, BTN_TOOL_AIRBRUSH, 1);
  device.put(EV_ABS, ABS_X, 31496);
  device.put(EV_ABS, ABS_Y, 7);
  device.put(EV_ABS, ABS_DISTANCE, 20);
  device.put(EV_ABS, ABS_WHEEL, 513);
  device.put(EV_ABS, ABS_Z, -899);
  device.put(EV_ABS, ABS_TILT_X, -64);
  device.put(EV_ABS, ABS_TILT_Y, 63);
  device.put(EV_ABS, ABS_MISC, 0x912);
  device.put(EV_MSC, MSC_SERIAL, static_cast<std::int32_t>(0xfedcba98));
  device.put(EV_KEY, BTN_STYLUS2, 1);
  device.put(EV_KEY, BTN_STYLUS3, 1);
  decode::PenSample wanted;
  wanted.in_range = true;
  wanted.tool = decode::Tool::pen;
  wanted.x = 31496;
  wanted.y = 7;
  wanted.distance = 20;
  wanted.wheel = 513;
  wanted.rotation = -899;
  wanted.tilt_x = -64;
  wanted.tilt_y = 63;
  wanted.tool_id = 0x912;
  wanted.serial = 0xfedcba98;
  wanted.buttons = 6;
  EXPECT_EQ(sample_of(*decoder, device.end()), wanted);
  const auto& ranges = decoder->axes();
  EXPECT_DOUBLE_EQ(ranges.rotation.units_per_mm, 5) << "units per degree";
  EXPECT_DOUBLE_EQ(ranges.tilt_x.units_per_mm, 1);
  EXPECT_DOUBLE_EQ(ranges.x.units_per_mm, 200);
  EXPECT_EQ(ranges.wheel.maximum, 1023);
}

TEST(EventEncoder, APuckThatReplacesThePenWithinAFrameComesAfterThePenLeft) {
  const auto axes = intuos();
  InputDevice device(axes);
  const auto decoder = pen_of(axes);
  device.put(EV_KEY, BTN_TOOL_PEN, 1);
  device.put(EV_ABS, ABS_X, 100);
  EXPECT_EQ(sample_of(*decoder, device.end()).tool, decode::Tool::pen);
  device.put(EV_KEY, BTN_TOOL_PEN, 0);
  device.put(EV_KEY, BTN_TOOL_MOUSE, 1);
  device.put(EV_KEY, BTN_RIGHT, 1);
  device.put(EV_ABS, ABS_X, 200);
  const auto reports = device.end();
  ASSERT_EQ(reports.size(), 2U);
  decoder->decode(reports[0]);
  EXPECT_FALSE(decoder->sample().in_range);
  decoder->decode(reports[1]);
  EXPECT_EQ(decoder->sample().tool, decode::Tool::mouse);
  EXPECT_EQ(decoder->sample().buttons, 2U);
  EXPECT_EQ(decoder->sample().x, 200);
  device.put(EV_KEY, BTN_TOOL_MOUSE, 0);
  EXPECT_FALSE(sample_of(*decoder, device.end()).in_range);
}

TEST(EventEncoder, WithoutASwitchOfTheTipThePressureTells) {
  auto axes = tests::ink_event_device();
  axes.keys.erase(BTN_TOUCH);
  InputDevice device(axes);
  const auto decoder = pen_of(axes);
  device.put(EV_KEY, BTN_TOOL_PEN, 1);
  device.put(EV_ABS, ABS_PRESSURE, 100);
  EXPECT_FALSE(sample_of(*decoder, device.end()).tip);
  device.put(EV_ABS, ABS_PRESSURE, 2000);
  EXPECT_TRUE(sample_of(*decoder, device.end()).tip);
}

TEST(EventEncoder, AfterALossNothingIsBelievedUpToTheEndOfTheFrame) {
  const auto axes = tests::ink_event_device();
  InputDevice device(axes);
  const auto decoder = pen_of(axes);
  device.put(EV_KEY, BTN_TOOL_PEN, 1);
  device.put(EV_ABS, ABS_X, 500);
  EXPECT_EQ(sample_of(*decoder, device.end()).x, 500);
  device.send(EV_SYN, SYN_DROPPED, 0);
  device.put(EV_ABS, ABS_X, 900);
  EXPECT_TRUE(device.end().empty());
  device.put(EV_ABS, ABS_X, 901);
  EXPECT_EQ(sample_of(*decoder, device.end()).x, 901);
}

TEST(EventEncoder, WhatItBeganWithIsInTheFirstReport) {
  const auto axes = tests::ink_event_device();
  InputDevice device(axes);
  const auto decoder = pen_of(axes);
  device.encoder().begin_with({EV_KEY, BTN_TOOL_PEN, 1});
  device.encoder().begin_with({EV_ABS, ABS_Y, 321});
  device.put(EV_ABS, ABS_X, 10);
  const auto sample = sample_of(*decoder, device.end());
  EXPECT_TRUE(sample.in_range);
  EXPECT_EQ(sample.y, 321);
}

TEST(EventEncoder, FramesOfUnknownControlsGiveNoReport) {
  InputDevice device(tests::ink_event_device());
  device.send(EV_ABS, ABS_BRAKE, 5);
  device.send(EV_KEY, KEY_A, 1);
  device.send(EV_ABS, ABS_MT_SLOT, 400);
  device.send(EV_ABS, ABS_MT_POSITION_X, 5);
  EXPECT_TRUE(device.end().empty());
}

EventAxes touch_pad() {
  EventAxes axes;
  axes.name = "Finger";
  axes.abs[ABS_MT_SLOT] = {0, 15, 0};
  axes.abs[ABS_MT_TRACKING_ID] = {0, 65535, 0};
  axes.abs[ABS_MT_POSITION_X] = {0, 4095, 20};
  axes.abs[ABS_MT_POSITION_Y] = {0, 3000, 20};
  axes.keys = {BTN_TOUCH, BTN_TOOL_FINGER};
  return axes;
}

/// Fingers by x after each frame.
class Fingers {
 public:
  explicit Fingers(const EventAxes& axes)
      : device(axes), decoder_(decode::make_hand_decoders(tests::identity_of(axes)).touch) {}

  void finger(int slot, int tracking, int x, int y) {
    device.send(EV_ABS, ABS_MT_SLOT, slot);
    device.send(EV_ABS, ABS_MT_TRACKING_ID, tracking);
    if (tracking < 0) return;
    device.send(EV_ABS, ABS_MT_POSITION_X, x);
    device.send(EV_ABS, ABS_MT_POSITION_Y, y);
  }
  std::vector<int> after_frame() {
    for (const auto& report : device.end()) decoder_->decode(report);
    std::vector<int> places;
    ids.clear();
    for (const auto& contact : decoder_->contacts()) {
      places.push_back(contact.x);
      ids.push_back(contact.id);
    }
    return places;
  }
  [[nodiscard]] const decode::TouchAxes& axes() const { return decoder_->axes(); }

  InputDevice device;
  std::vector<std::uint32_t> ids;

 private:
  std::unique_ptr<decode::TouchDecoder> decoder_;
};

TEST(EventEncoder, FingersKeepTheirSlots) {
  Fingers hand(touch_pad());
  EXPECT_EQ(hand.axes().contacts, 16U);
  EXPECT_FALSE(hand.axes().on_screen);
  EXPECT_EQ(hand.axes().x.maximum, 4095);
  EXPECT_DOUBLE_EQ(hand.axes().y.units_per_mm, 20);
  hand.finger(0, 70, 100, 5);
  hand.finger(1, 71, 4095, 3000);
  EXPECT_EQ(hand.after_frame(), (std::vector{100, 4095}));
  const auto ids = hand.ids;
  hand.finger(0, -1, 0, 0);
  EXPECT_EQ(hand.after_frame(), std::vector{4095});
  EXPECT_EQ(hand.ids, std::vector{ids[1]});
  hand.finger(0, 72, 7, 7);
  hand.device.send(EV_ABS, ABS_MT_SLOT, 1);
  hand.device.send(EV_ABS, ABS_MT_POSITION_X, 4000);
  EXPECT_EQ(hand.after_frame(), (std::vector{7, 4000}));
  EXPECT_NE(hand.ids[0], ids[0]);
  EXPECT_EQ(hand.ids[1], ids[1]);
}

TEST(EventEncoder, AFingerThatTakesAnothersSlotWithinAFrameIsAnother) {
  Fingers hand(touch_pad());
  hand.finger(0, 70, 100, 5);
  hand.finger(1, 71, 200, 5);
  hand.after_frame();
  const auto ids = hand.ids;
  hand.finger(0, 72, 900, 5);
  EXPECT_EQ(hand.after_frame(), (std::vector{900, 200}));
  EXPECT_TRUE(hand.ids[0] != ids[0] && hand.ids[1] == ids[1]);
}

TEST(EventEncoder, APalmIsNoFinger) {
  Fingers hand(touch_pad());
  hand.finger(0, 70, 100, 5);
  EXPECT_EQ(hand.after_frame().size(), 1U);
  hand.device.send(EV_ABS, ABS_MT_TOOL_TYPE, 2);
  EXPECT_TRUE(hand.after_frame().empty());
}

TEST(EventEncoder, OnAScreenTheyTouchThePicture) {
  auto axes = touch_pad();
  axes.properties = {INPUT_PROP_DIRECT};
  EXPECT_TRUE(Fingers(axes).axes().on_screen);
}

/// Keys, ring and wheels as Linux's wacom driver shows those of a tablet, with what it adds for older programs.
EventAxes pad() {
  EventAxes axes;
  axes.name = "Pad";
  axes.vendor = 0x256c;
  axes.abs[ABS_X] = axes.abs[ABS_Y] = {0, 1, 0};
  axes.abs[ABS_WHEEL] = {0, 71, 0};
  axes.abs[ABS_RX] = {0, 4096, 0};
  axes.abs[ABS_MISC] = {0, 0, 0};
  axes.rels = {REL_WHEEL, REL_HWHEEL};
  axes.keys = {BTN_STYLUS, BTN_0, BTN_1, BTN_9, BTN_A, BTN_BASE, KEY_PROG1, KEY_BUTTONCONFIG};
  return axes;
}

TEST(EventEncoder, KeysOfAPadAreLinuxs) {
  const auto axes = pad();
  ASSERT_TRUE(has_pad(axes));
  ASSERT_FALSE(has_pen(axes));
  InputDevice device(axes);
  const auto decoder = decode::make_hand_decoders(tests::identity_of(axes)).pad;
  ASSERT_TRUE(decoder);
  const auto keys_after = [&](std::uint16_t key, int value) {
    device.put(EV_KEY, key, value);
    for (const auto& report : device.end()) EXPECT_TRUE(decoder->decode(report));
    return decode::key_names(decoder->sample().keys);
  };
  EXPECT_EQ(decode::key_names(decoder->features().keys), "KEY_PROG1+BTN_0+BTN_1+BTN_9+BTN_BASE+BTN_A+KEY_BUTTONCONFIG");
  EXPECT_EQ(keys_after(BTN_0, 1), "BTN_0");
  EXPECT_EQ(keys_after(KEY_PROG1, 1), "KEY_PROG1+BTN_0");
  EXPECT_EQ(keys_after(BTN_0, 0), "KEY_PROG1");
  EXPECT_EQ(keys_after(KEY_BUTTONCONFIG, 1), "KEY_PROG1+KEY_BUTTONCONFIG");
}

TEST(EventEncoder, ARingIsTouchedAtItsFirstPlaceAsWell) {
  const auto axes = pad();
  InputDevice device(axes);
  const auto decoder = decode::make_hand_decoders(tests::identity_of(axes)).pad;
  const auto put = [&](std::initializer_list<std::pair<std::uint16_t, int>> values) {
    for (const auto& [code, value] : values) device.put(EV_ABS, code, value);
    for (const auto& report : device.end()) decoder->decode(report);
    return std::pair(decoder->sample().ring_touched[0], decoder->sample().ring[0]);
  };
  EXPECT_EQ(decoder->features().ring_maximum, 71);
  EXPECT_EQ(put({{ABS_MISC, 15}}), std::pair(true, 0));
  EXPECT_EQ(put({{ABS_WHEEL, 71}}), std::pair(true, 71));
  EXPECT_EQ(put({{ABS_WHEEL, 0}, {ABS_MISC, 0}}), std::pair(false, 0));
  EXPECT_EQ(put({{ABS_RX, 64}, {ABS_MISC, 15}}).second, 0);
  EXPECT_EQ(decoder->sample().strip[0], 64);
}

TEST(EventEncoder, TurnsOfAFrameAreAddedAndNotRepeated) {
  const auto axes = pad();
  InputDevice device(axes);
  const auto decoder = decode::make_hand_decoders(tests::identity_of(axes)).pad;
  device.put(EV_REL, REL_WHEEL, 1);
  device.put(EV_REL, REL_WHEEL, 2);
  device.put(EV_REL, REL_HWHEEL, -1);
  for (const auto& report : device.end()) decoder->decode(report);
  EXPECT_EQ(decoder->sample().wheel, (std::array<std::int32_t, 2>{3, -1}));
  device.put(EV_KEY, BTN_0, 1);
  for (const auto& report : device.end()) decoder->decode(report);
  EXPECT_EQ(decoder->sample().wheel, (std::array<std::int32_t, 2>{0, 0}));
}

TEST(EventEncoder, APenWithKeysOnTheSameNodeHasBoth) {
  auto axes = tests::ink_event_device();
  axes.keys.insert({BTN_0, BTN_1});
  InputDevice device(axes);
  const auto pen = pen_of(axes);
  const auto keys = decode::make_hand_decoders(tests::identity_of(axes)).pad;
  ASSERT_TRUE(pen && keys);
  device.put(EV_KEY, BTN_1, 1);
  device.put(EV_KEY, BTN_TOOL_PEN, 1);
  for (const auto& report : device.end()) {
    pen->decode(report);
    keys->decode(report);
  }
  EXPECT_TRUE(pen->sample().in_range);
  EXPECT_EQ(decode::key_names(keys->sample().keys), "BTN_1");
}

TEST(EventDevice, DescriptorsAreWholeAndShortEnoughForLinux) {
  auto many = touch_pad();
  many.abs[ABS_MT_SLOT].maximum = 1000000;
  many.abs[ABS_MT_POSITION_X] = {-2000000000, 2000000000, 2000000000};
  auto extreme = intuos();
  for (auto& [code, range] : extreme.abs) range = {-2147483647 - 1, 2147483647, 2147483647};
  for (const auto& axes : {tests::ink_event_device(), intuos(), touch_pad(), many, extreme, pad(), EventAxes{}}) {
    const auto descriptor = report_descriptor(axes);
    EXPECT_LT(descriptor.size(), 4096U);
    EXPECT_TRUE(hid::parse_report_descriptor(descriptor)) << "refused";
  }
}

TEST(EventDevice, WhatIsNoTabletIsNone) {
  EventAxes mouse;
  mouse.keys = {BTN_LEFT, BTN_RIGHT, BTN_MIDDLE};
  mouse.rels = {REL_X, REL_Y, REL_WHEEL};
  EventAxes screen = touch_pad();
  screen.abs[ABS_X] = {0, 4095, 0};
  screen.abs[ABS_Y] = {0, 4095, 0};
  EventAxes keyboard;
  for (std::uint16_t key = 1; key < 240; ++key) keyboard.keys.insert(key);
  for (const EventAxes& axes : {mouse, screen, keyboard, EventAxes{}}) {
    EXPECT_FALSE(has_pen(axes));
    EXPECT_FALSE(has_pad(axes));
    EXPECT_FALSE(decode::make_decoder(tests::identity_of(axes)));
  }
  EXPECT_TRUE(has_fingers(screen));
}

}  // namespace
}  // namespace penpose::event
