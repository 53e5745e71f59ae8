#include "replay/trace/trace_source.h"

#include <gtest/gtest.h>

#include "firmware_io/decode/decoder_factory.h"
#include "tests/support/hands/pen_path.h"
#include "tests/support/hands/pen_reports.h"
#include "tests/support/hands/stroke_recorder.h"
#include "tests/support/hands/trace_text.h"

namespace penpose::replay {
namespace {

TEST(TraceSource, GivesReportsOfSeveralDevicesWithTheirIndex) {
  const std::string text = tests::TraceText("\r\n")
                               .device(0, {0xc0}, "3 056a 0013")
                               .device(1, tests::ink_descriptor(), "5 1b96 1000")
                               .line("D: 0")
                               .report(1000, {1})
                               .line("# a comment")
                               .line("E: damaged")
                               .line("D: 1")
                               .report(2000, {2, 3})
                               .text();
  TraceSource source(read_from(base::as_bytes(text)));
  ASSERT_TRUE(source.read_header());
  ASSERT_EQ(source.devices().size(), 2u);
  EXPECT_EQ(source.devices().at(1).vendor, 0x1b96);
  EXPECT_EQ(source.devices().at(1).bus, decode::k_bus_bluetooth);
  EXPECT_EQ(source.devices().at(1).interface_number, 1);
  EXPECT_EQ(source.devices().at(1).input_report_length, 12);
  EXPECT_EQ(source.devices().at(1).name, "Test pen 1");

  auto first = source.next();
  ASSERT_TRUE(first && first->has_value());
  EXPECT_EQ((*first)->index, 0u);
  EXPECT_EQ((*first)->device, 0);
  EXPECT_EQ((*first)->time_us, 1000);
  auto second = source.next();
  ASSERT_TRUE(second && second->has_value());
  EXPECT_EQ((*second)->index, 2u) << "a damaged report keeps its number";
  EXPECT_EQ((*second)->device, 1);
  EXPECT_EQ((*second)->bytes.size(), 2u);
  auto end = source.next();
  ASSERT_TRUE(end);
  EXPECT_FALSE(end->has_value());
  ASSERT_EQ(source.problems().size(), 1u);
  EXPECT_EQ(source.problems()[0].place, "line 14");
  EXPECT_FALSE((*source.next()).has_value()) << "the end stays the end";
}

TEST(TraceSource, ACutTraceGivesAllBeforeTheCutAndSaysSo) {
  std::string text = tests::TraceText().device(0, {0xc0}, "3 056a 0013").report(0, {1, 2}).report(8000, {3, 4}).text();
  text.resize(text.size() - 3);
  TraceSource source(read_from(base::as_bytes(text)));
  int reports = 0;
  for (auto report = source.next(); report && report->has_value(); report = source.next()) ++reports;
  EXPECT_EQ(reports, 1);
  ASSERT_EQ(source.problems().size(), 1u);
  EXPECT_NE(source.problems()[0].what.find("cut off"), std::string::npos);
}

TEST(TraceSource, TimesOfASecondRecordingGoOnFromTheFirst) {
  const auto times = [](const std::string& text) {
    TraceSource source(read_from(base::as_bytes(text)));
    std::vector<std::int64_t> out;
    for (auto report = source.next(); report && report->has_value(); report = source.next())
      out.push_back((*report)->time_us);
    return out;
  };
  const std::string one =
      tests::TraceText().device(0, {0xc0}, "3 056a 0013").report(1000, {1}).report(3000, {1}).text();
  EXPECT_EQ(times(one + one + one), (std::vector<std::int64_t>{1000, 3000, 3000, 5000, 5000, 7000}));
  // A session says its own times, and a report that comes late is no second recording.
  EXPECT_EQ(times("# penpose session edition=1\n" + one + one), (std::vector<std::int64_t>{1000, 3000, 1000, 3000}));
  EXPECT_EQ(times(one + "E: 0.000002 1 01\n").back(), 2);
  EXPECT_EQ(times("R: 1 c0\nE: 9000000000000.0 1 01\nR: 1 c0\nE: 0.0 1 01\nE: 9000000000000.0 1 01\n").size(), 3u);
}

TEST(TraceSource, ADescriptorBehindReportsBeginsADeviceAnew) {
  TraceSource source(read_from(base::as_bytes(
      std::string_view("R: 1 c0\nN: Old\nP: usb-1/input1\nI: 3 056a 0013\nE: 0.0 1 01\nR: 2 c0 c0\nE: 0.1 1 01\n"))));
  int begun = 0;
  source.listen({}, [&](int, const decode::DeviceIdentity&) { ++begun; });
  while (true) {
    const auto report = source.next();
    if (!report || !report->has_value()) break;
  }
  EXPECT_EQ(begun, 2);
  EXPECT_EQ(source.devices().at(0).name, "");
  EXPECT_EQ(source.devices().at(0).product, 0);
  EXPECT_EQ(source.devices().at(0).interface_number, std::nullopt);
}

TEST(TraceSource, RealTimeWaitsForEachReport) {
  const std::string text =
      tests::TraceText().report(5000000, {1}).report(5008000, {2}).report(5008000, {3}).report(5100000, {4}).text();
  std::vector<std::int64_t> waits;
  TraceSource source(read_from(base::as_bytes(text)), Pace::real_time,
                     [&waits](std::int64_t after_us) { waits.push_back(after_us); });
  for (auto report = source.next(); report && report->has_value(); report = source.next()) {
  }
  EXPECT_EQ(waits, (std::vector<std::int64_t>{8000, 8000, 100000}));
}

TEST(TraceSource, OnlyTheFirstProblemsAreKept) {
  tests::TraceText trace;
  for (int i = 0; i < 1000; ++i) trace.line("E: damaged");
  TraceSource source(read_from(base::as_bytes(trace.text())));
  EXPECT_FALSE((*source.next()).has_value());
  EXPECT_EQ(source.problems().size(), 11u);
}

TEST(TraceSource, AGeneratedPathComesBackAsTheSameStrokes) {
  tests::TraceText trace;
  trace.device(0, tests::ink_descriptor(), "3 1b96 1000");
  const auto path = tests::pen_path({24188, 15360, 4095, true, -1}, 4, 50);
  std::int64_t time_us = 0;
  for (const auto& sample : path) trace.report(time_us += 5000, tests::ink_pen(sample));

  TraceSource source(read_from(base::as_bytes(trace.text())));
  ASSERT_TRUE(source.read_header());
  auto made = decode::make_decoder(source.devices().at(0));
  ASSERT_TRUE(made);
  tests::StrokeRecorder recorded;
  tests::StrokeRecorder wanted;
  std::size_t next = 0;
  for (auto report = source.next(); report && report->has_value(); report = source.next()) {
    const auto& raw = **report;
    if (made->decoder->decode(raw.bytes) == decode::ReportKind::pen) recorded.add(made->decoder->sample(), raw.time_us);
    wanted.add(path[next], static_cast<std::int64_t>(next + 1) * 5000);
    ++next;
  }
  ASSERT_EQ(recorded.strokes().size(), wanted.strokes().size());
  for (std::size_t i = 0; i < wanted.strokes().size(); ++i) {
    const auto& got = recorded.strokes()[i].points;
    const auto& want = wanted.strokes()[i].points;
    ASSERT_EQ(got.size(), want.size());
    for (std::size_t k = 0; k < want.size(); ++k) {
      EXPECT_EQ(got[k].time_us, want[k].time_us);
      EXPECT_EQ(got[k].sample, want[k].sample);
    }
  }
}

}  // namespace
}  // namespace penpose::replay
