#include "firmware_io/decode/sample/pad_events.h"

#include <gtest/gtest.h>

namespace penpose::decode {
namespace {

PadFeatures intuos() {
  PadFeatures has;
  has.keys = numbered_keys(~0ULL, 7);
  has.rings = 1;
  has.ring_maximum = 71;
  has.strips = 2;
  has.strip_maximum = 4096;
  has.wheels = 1;
  return has;
}

class PadEventsTest : public testing::Test {
 protected:
  std::vector<PadEvent> add(const PadSample& sample) {
    std::vector<PadEvent> out;
    events.add(sample, time_us += 1000, out);
    return out;
  }
  /// 120ths of a notch that a way over the ring adds up to, with the finger lifted nowhere.
  int around(std::initializer_list<int> places) {
    int sum = 0;
    for (const int at : places) {
      PadSample sample;
      sample.ring_touched[0] = true;
      sample.ring[0] = at;
      for (const PadEvent& event : add(sample)) sum += event.kind == PadEventKind::turned ? event.steps : 0;
    }
    return sum;
  }

  PadEvents events{intuos()};
  std::int64_t time_us = 0;
};

TEST_F(PadEventsTest, EachKeyIsPressedAndReleasedByItself) {
  PadSample sample;
  sample.keys = {PadKey::button1, PadKey::button4};
  auto out = add(sample);
  ASSERT_EQ(out.size(), 2U);
  EXPECT_EQ(out[0].kind, PadEventKind::key_down);
  EXPECT_EQ(out[0].key, PadKey::button1);
  EXPECT_EQ(out[1].key, PadKey::button4);
  EXPECT_TRUE(add(sample).empty()) << "held is not pressed again";
  sample.keys = {PadKey::button4};
  out = add(sample);
  ASSERT_EQ(out.size(), 1U);
  EXPECT_EQ(out[0].kind, PadEventKind::key_up);
  EXPECT_EQ(out[0].key, PadKey::button1);
  EXPECT_EQ(out[0].time_us, 3000);
}

TEST_F(PadEventsTest, AWholeTurnOfARingIsThirtySixNotchesAcrossItsEndToo) {
  PadSample sample;
  sample.ring_touched[0] = true;
  sample.ring[0] = 70;
  ASSERT_EQ(add(sample).front().kind, PadEventKind::touched);
  EXPECT_EQ(around({71, 0, 1, 2}), 4 * 60);
  EXPECT_EQ(around({0, 71, 70}), -4 * 60);
  int whole = 0;
  for (int i = 1; i <= 72; ++i) whole += around({(70 + i) % 72});
  EXPECT_EQ(whole, k_ring_notches * k_notch);
  const auto out = add({});
  ASSERT_EQ(out.size(), 1U);
  EXPECT_EQ(out[0].kind, PadEventKind::let_go);
}

TEST_F(PadEventsTest, EachPlaceOfACoarseRingIsANotch) {
  PadFeatures has;
  has.rings = 1;
  has.ring_maximum = 11;
  events = PadEvents(has);
  EXPECT_EQ(around({0, 1, 2}), 2 * k_notch);
  EXPECT_EQ(around({0, 11}), -3 * k_notch);
}

TEST_F(PadEventsTest, WhereAFingerComesDownTurnsNothing) {
  EXPECT_EQ(around({40}), 0);
  add({});
  EXPECT_EQ(around({3}), 0) << "lifted and put down elsewhere";
  EXPECT_EQ(around({38}), 0) << "a second finger on the other side";
  EXPECT_EQ(around({40}), 120);
}

TEST_F(PadEventsTest, AStripHasABitForEachPlaceAndGoesDownwards) {
  const auto at = [&](std::size_t side, int value) {
    PadSample sample;
    sample.strip[side] = value;
    return add(sample);
  };
  EXPECT_EQ(at(1, 0x010).front().kind, PadEventKind::touched);
  auto out = at(1, 0x040);
  ASSERT_EQ(out.size(), 1U);
  EXPECT_EQ(out[0].dial, PadDial::strip);
  EXPECT_EQ(out[0].side, 1);
  EXPECT_EQ(out[0].steps, 2 * k_notch);
  EXPECT_EQ(at(1, 0x001).front().steps, -6 * k_notch);
  EXPECT_EQ(at(1, 0).front().kind, PadEventKind::let_go);
}

TEST_F(PadEventsTest, WheelsGiveTheStepsOfEachReport) {
  PadSample sample;
  sample.wheel[0] = 2;
  EXPECT_EQ(add(sample).front().steps, -2 * k_notch) << "away from oneself, as Linux counts";
  EXPECT_EQ(add(sample).front().steps, -2 * k_notch) << "and again in the next report";
  sample.fine_wheel[0] = -30;
  sample.wheel[0] = 0;
  EXPECT_EQ(add(sample).front().steps, 30) << "a quarter of a notch where the device counts so";
  auto has = intuos();
  has.wheels_clockwise = true;
  PadEvents clockwise(has);
  std::vector<PadEvent> out;
  sample.fine_wheel[0] = 0;
  sample.wheel[0] = 1;
  clockwise.add(sample, 0, out);
  EXPECT_EQ(out.front().steps, k_notch);
}

TEST_F(PadEventsTest, WhatIsHeldAtTheEndIsLetGo) {
  PadSample sample;
  sample.keys = {PadKey::button2};
  sample.ring_touched[0] = true;
  sample.strip[0] = 4;
  add(sample);
  EXPECT_EQ(events.held(), PadKeys{PadKey::button2});
  std::vector<PadEvent> out;
  events.finish(5, out);
  ASSERT_EQ(out.size(), 3U);
  EXPECT_EQ(out[0].kind, PadEventKind::key_up);
  EXPECT_EQ(out[1].kind, PadEventKind::let_go);
  EXPECT_EQ(out[2].kind, PadEventKind::let_go);
  EXPECT_TRUE(events.held().empty());
}

TEST_F(PadEventsTest, PlacesThatNoDeviceHasDoNoHarm) {
  PadSample sample;
  sample.ring_touched[0] = true;
  sample.ring[0] = 2147483647;
  sample.strip[0] = -2147483647 - 1;
  sample.wheel[0] = -2147483647 - 1;
  sample.fine_wheel[0] = 0;
  add(sample);
  sample.ring[0] = -2147483647 - 1;
  sample.strip[0] = 2147483647;
  for (const PadEvent& event : add(sample)) EXPECT_LE(std::abs(event.steps), 64 * k_notch);
}

}  // namespace
}  // namespace penpose::decode
