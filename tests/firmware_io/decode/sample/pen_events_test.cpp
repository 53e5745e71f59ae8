#include "firmware_io/decode/sample/pen_events.h"

#include <gtest/gtest.h>
#include <string>

namespace penpose::decode {
namespace {

std::string letters(const std::vector<PenEvent>& events) {
  std::string all;
  for (const PenEvent& event : events) all += "NADUhB.E"[static_cast<int>(event.kind)];
  return all;
}

PenSample pen(bool tip, std::int32_t x = 0, std::int32_t pressure = 0) {
  PenSample sample;
  sample.in_range = true;
  sample.tool = Tool::pen;
  sample.tip = tip;
  sample.x = x;
  sample.pressure = pressure;
  return sample;
}

std::vector<PenEvent> events_of(const std::vector<PenSample>& samples, ContactRule rule = {}) {
  PenEvents events(rule);
  std::vector<PenEvent> all;
  std::int64_t time_us = 0;
  for (const PenSample& sample : samples) events.add(sample, time_us += 1000, all);
  events.finish(time_us + 1000, all);
  return all;
}

// N near, A away, D and U buttons, h hover, B begin, . point, E end.
TEST(PenEvents, EverySampleInRangeIsOnePosition) {
  EXPECT_EQ(letters(events_of({pen(false), pen(true), pen(true), pen(true), pen(false), {}})), "NhB..EhA");
}

TEST(PenEvents, LeavingRangeEndsAStroke) {
  const auto events = events_of({pen(true, 5), pen(true, 6), {}, {}});
  EXPECT_EQ(letters(events), "NB.EA");
  EXPECT_EQ(events[3].sample.x, 6) << "the end shows where the pen was last, not the zeros of leaving";
}

TEST(PenEvents, TheEndOfARecordingEndsAStroke) { EXPECT_EQ(letters(events_of({pen(true)})), "NBEA"); }

TEST(PenEvents, AnotherToolEndsAStroke) {
  PenSample eraser = pen(true);
  eraser.tool = Tool::eraser;
  const auto events = events_of({pen(true), eraser, {}});
  EXPECT_EQ(letters(events), "NBEANBEA");
  EXPECT_EQ(events[4].tool, Tool::eraser);
}

TEST(PenEvents, ASerialThatArrivesLateIsTheSamePen) {
  PenSample known = pen(true);
  known.serial = 7;
  PenSample other = known;
  other.serial = 8;
  EXPECT_EQ(letters(events_of({pen(true), known})), "NB.EA");
  EXPECT_EQ(letters(events_of({known, other})), "NBEANBEA");
}

TEST(PenEvents, ButtonsAreEventsOfTheirOwn) {
  PenSample pressed = pen(false);
  pressed.buttons = 0b101;
  PenSample one = pen(false);
  one.buttons = 0b100;
  const auto events = events_of({pressed, one, {}});
  EXPECT_EQ(letters(events), "NDDhUhUA");
  EXPECT_EQ(events[2].button, 2);
  EXPECT_EQ(events[4].button, 0);
  EXPECT_EQ(events[6].button, 2) << "leaving releases what is held";
}

TEST(PenEvents, HysteresisKeepsNoiseFromMakingStrokes) {
  const ContactRule rule{true, 100, 50};
  EXPECT_EQ(letters(events_of({pen(false, 0, 90), pen(false, 0, 100), pen(false, 0, 60), pen(false, 0, 99),
                               pen(false, 0, 49), pen(false, 0, 90)},
                              rule)),
            "NhB..EhhA");
}

TEST(PenEvents, AMouseNeverDraws) {
  PenSample mouse = pen(true);
  mouse.tool = Tool::mouse;
  EXPECT_EQ(letters(events_of({mouse})), "NhA");
}

}  // namespace
}  // namespace penpose::decode
