#include "firmware_io/record/tablet_recorder.h"

#include <gtest/gtest.h>

#include "replay/trace/trace_source.h"
#include "tests/support/hands/pen_path.h"
#include "tests/support/hands/pen_reports.h"
#include "tests/support/hands/wacom_hand.h"
#include "tests/support/hands/wacom_receiver.h"

namespace penpose::record {
namespace {

decode::DeviceIdentity ink_pen() { return tests::ink_device(0x1000, "Ink pen"); }

decode::PenSample touching_pen() {
  decode::PenSample sample;
  sample.in_range = sample.tip = true;
  sample.tool = decode::Tool::pen;
  return sample;
}

device::Record report(std::int64_t time_us, std::vector<std::uint8_t> bytes) {
  return {device::RecordKind::report, time_us, 0, std::move(bytes)};
}

device::Record note(const std::string& text) { return {device::RecordKind::note, 0, 0, {text.begin(), text.end()}}; }

TEST(TabletRecorder, WhatIsRecordedIsReadBack) {
  TabletRecorder recorder;
  const int pen = recorder.add_tablet(ink_pen(), "usb-1/input0");
  std::string text;
  const auto path = tests::pen_path({24188, 15360, 4095, true, -1}, 4, 50);
  std::int64_t time_us = 77'000'000;
  for (const auto& sample : path) {
    recorder.add(pen, report(time_us += 5000, tests::ink_pen(sample)));
    text += recorder.take();
  }
  recorder.end(pen);
  EXPECT_EQ(recorder.counts().reports, path.size());
  EXPECT_EQ(recorder.counts().strokes, 4u);
  EXPECT_EQ(recorder.counts().span_us, static_cast<std::int64_t>(path.size() - 1) * 5000);

  replay::TraceSource source(replay::read_from(base::as_bytes(text)));
  ASSERT_TRUE(source.read_header());
  EXPECT_EQ(source.devices().at(0).report_descriptor, tests::ink_descriptor());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto read = source.next();
    ASSERT_TRUE(read && read->has_value());
    EXPECT_EQ((*read)->time_us, static_cast<std::int64_t>(i) * 5000) << "counted from the first report";
    const auto wanted = tests::ink_pen(path[i]);
    EXPECT_TRUE(std::equal(wanted.begin(), wanted.end(), (*read)->bytes.begin(), (*read)->bytes.end()));
  }
}

TEST(TabletRecorder, SaysWhenAPenWasLifted) {
  TabletRecorder recorder;
  const int pen = recorder.add_tablet(ink_pen(), "");
  decode::PenSample sample = touching_pen();
  recorder.add(pen, report(0, tests::ink_pen(sample)));
  EXPECT_FALSE(recorder.take_pen_up());
  sample.tip = false;
  recorder.add(pen, report(1, tests::ink_pen(sample)));
  EXPECT_TRUE(recorder.take_pen_up());
  EXPECT_FALSE(recorder.take_pen_up());
}

TEST(TabletRecorder, UnpluggingEndsTheStroke) {
  TabletRecorder recorder;
  const int pen = recorder.add_tablet(ink_pen(), "");
  recorder.add(pen, report(0, tests::ink_pen(touching_pen())));
  recorder.end(pen);
  EXPECT_TRUE(recorder.take_pen_up());
  EXPECT_EQ(recorder.counts().strokes, 1u);
}

TEST(TabletRecorder, NotesAndLossesAreComments) {
  TabletRecorder recorder;
  decode::DeviceIdentity identity = ink_pen();
  identity.strings[201] = "FIRMWARE";
  const int pen = recorder.add_tablet(identity, "");
  EXPECT_NE(recorder.take().find("# string 201: \"FIRMWARE\"\n"), std::string::npos);
  recorder.add(pen, note("wake feature 02 02: sent\nE: 0.000000 1 00"));
  recorder.add(pen, {device::RecordKind::lost, 0, 12, {}});
  EXPECT_EQ(recorder.take(), "# 0: wake feature 02 02: sent E: 0.000000 1 00\n# 0: 12 reports were lost here\n");
  EXPECT_EQ(recorder.counts().lost, 12u);
}

TEST(TabletRecorder, TwoTabletsShareOneClockThatNeverGoesBack) {
  TabletRecorder recorder;
  const int first = recorder.add_tablet(ink_pen(), "");
  const int second = recorder.add_tablet({}, "");
  EXPECT_FALSE(recorder.take().empty());
  recorder.add(first, report(1000, {1}));
  recorder.add(second, report(4000, {2}));
  recorder.add(first, report(3000, {3}));
  EXPECT_EQ(recorder.take(), "D: 0\nE: 0.000000 1 01\nD: 1\nE: 0.003000 1 02\nD: 0\nE: 0.003000 1 03\n");
}

TEST(TabletRecorder, CountsTheKeysOfATabletBehindAReceiver) {
  TabletRecorder recorder;
  for (int i = 0; i < 3; ++i) recorder.add_tablet(tests::receiver(i), "usb-1/input" + std::to_string(i));
  recorder.add(1, report(1000, tests::pad_report(2)));
  EXPECT_EQ(recorder.counts().keys, 0U) << "nobody knows yet whose it is";
  recorder.add(0, report(2000, tests::receiver_status(0x0314)));
  recorder.add(1, report(3000, tests::pad_report(2)));
  EXPECT_EQ(recorder.counts().keys, 1U);
  recorder.add(0, report(4000, tests::receiver_status(0)));
  EXPECT_NE(recorder.take().find("# 1: held at its end and let go: BTN_1"), std::string::npos);
  EXPECT_EQ(recorder.end(1), "");
}

}  // namespace
}  // namespace penpose::record
