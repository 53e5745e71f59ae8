#include "replay/trace/trace_writer.h"

#include <gtest/gtest.h>

#include "replay/trace/trace_source.h"
#include "tests/support/hands/pen_reports.h"
#include "tests/support/shared_data.h"

namespace penpose::replay {
namespace {

TraceDevice ink_pen() { return {tests::ink_descriptor(), "Ink pen", "usb-0000:00:14.0-1/input2", 3, 0x1b96, 0x1000}; }

TEST(TraceWriter, WritesWhatHidRecorderWrites) {
  TraceWriter writer;
  writer.comment("made by\na test");
  writer.declare(0, {{0x05, 0x0d}, "Pen\nE: 0.000000 1 00", "usb-1/input0", 3, 0x056a, 0x13});
  writer.report(0, 12000345, std::vector<std::uint8_t>{2, 0xd0});
  writer.report(0, 12001345, std::vector<std::uint8_t>{2});
  EXPECT_EQ(writer.take(),
            "# made by a test\nD: 0\nR: 2 05 0d\nN: Pen\nP: usb-1/input0\nI: 3 056a 0013\nE: 12.000345 2 02 d0\n"
            "E: 12.001345 1 02\n");
  EXPECT_EQ(writer.pending(), 0u);
}

TEST(TraceWriter, NamesTheDeviceWhereItChangesAndNowhereElse) {
  TraceWriter writer;
  const std::vector<std::uint8_t> bytes{1};
  writer.declare(0, {});
  writer.declare(1, {});
  EXPECT_GT(writer.pending(), 0u);
  EXPECT_FALSE(writer.take().empty());
  writer.report(1, 0, bytes);
  writer.comment("between");
  writer.report(1, 1, bytes);
  EXPECT_EQ(writer.take(), "E: 0.000000 1 01\n# between\nE: 0.000001 1 01\n");
  writer.report(0, 2, bytes);
  writer.report(1, 3, bytes);
  EXPECT_EQ(writer.take(), "D: 0\nE: 0.000002 1 01\nD: 1\nE: 0.000003 1 01\n");
}

TEST(TraceWriter, StringsOfADeviceComeBackWithIt) {
  TraceWriter writer;
  TraceDevice tablet = ink_pen();
  tablet.strings = {{2, "a \"quoted\" name"}, {201, "HUION_T174_170519"}};
  writer.declare(0, tablet);
  writer.comment("string 7 is no string of a device");
  writer.report(0, 0, std::vector<std::uint8_t>{1});
  writer.declare(0, ink_pen());  // plugged in anew, nothing was read
  writer.report(0, 1, std::vector<std::uint8_t>{1});
  const std::string text = writer.take();
  EXPECT_NE(text.find("\n# string 201: \"HUION_T174_170519\"\n"), std::string::npos);
  TraceSource source(read_from(base::as_bytes(text)));
  std::vector<std::map<int, std::string>> told;
  source.listen({}, [&](int, const decode::DeviceIdentity& identity) { told.push_back(identity.strings); });
  while (source.next().value()) {
  }
  ASSERT_EQ(told.size(), 2u);
  EXPECT_EQ(told[0], tablet.strings);
  EXPECT_TRUE(told[1].empty());
}

TEST(TraceWriter, WhatIsSaidOfADeviceStandsBehindItsLines) {
  TraceWriter writer;
  writer.declare(0, {});
  writer.declare(1, {});
  static_cast<void>(writer.take());
  writer.string(0, 201, "x");
  writer.string(0, 2, "more");
  EXPECT_EQ(writer.take(), "D: 0\n# string 201: \"x\"\n# string 2: \"more\"\n");
}

TEST(TraceWriter, AReportThatIsKnownInPartIsToldByItsReader) {
  TraceWriter writer;
  writer.cut_report(0, 5, 10, std::vector<std::uint8_t>{1, 2});
  writer.report(0, 6, std::vector<std::uint8_t>{3});
  const std::string text = writer.take();
  EXPECT_EQ(text, "D: 0\nE: 0.000005 10 01 02\nE: 0.000006 1 03\n");
  TraceSource source(read_from(base::as_bytes(text)));
  const auto report = source.next();
  ASSERT_TRUE(report && report->has_value());
  EXPECT_EQ((*report)->bytes[0], 3);
  ASSERT_EQ(source.problems().size(), 1u);
  EXPECT_EQ(source.problems()[0].what, "the line has fewer bytes than its length says and was left out");
}

TEST(TraceWriter, TheReaderGetsBackDevicesTimesAndBytes) {
  TraceWriter writer;
  writer.declare(0, ink_pen());
  writer.declare(1, {{0xc0}, "Other", "", 5, 0x056a, 0x0357});
  const std::vector<std::vector<std::uint8_t>> reports{{1, 2, 3}, {}, {0xff}, std::vector<std::uint8_t>(4096, 0xa5)};
  std::string text;
  for (std::size_t i = 0; i < reports.size(); ++i) {
    writer.report(static_cast<int>(i % 2), static_cast<std::int64_t>(i) * 999999, reports[i]);
    text += writer.take();
  }
  TraceSource source(read_from(base::as_bytes(text)));
  ASSERT_TRUE(source.read_header());
  ASSERT_EQ(source.devices().size(), 2u);
  EXPECT_EQ(source.devices().at(0).report_descriptor, tests::ink_descriptor());
  EXPECT_EQ(source.devices().at(0).interface_number, 2);
  EXPECT_EQ(source.devices().at(0).name, "Ink pen");
  EXPECT_EQ(source.devices().at(1).bus, 5);
  EXPECT_EQ(source.devices().at(1).product, 0x0357);
  for (std::size_t i = 0; i < reports.size(); ++i) {
    const auto report = source.next();
    ASSERT_TRUE(report && report->has_value());
    EXPECT_EQ((*report)->device, static_cast<int>(i % 2));
    EXPECT_EQ((*report)->time_us, static_cast<std::int64_t>(i) * 999999);
    EXPECT_TRUE(std::equal(reports[i].begin(), reports[i].end(), (*report)->bytes.begin(), (*report)->bytes.end()));
  }
  EXPECT_FALSE((*source.next()).has_value());
  EXPECT_TRUE(source.problems().empty());
}

TEST(SharedTraces, WrittenAnewHoldTheSameReports) {
  if (!tests::has_shared()) GTEST_SKIP() << "no shared data";
  for (const auto& entry : std::filesystem::directory_iterator(tests::shared_dir() / "hid")) {
    if (entry.path().extension() != ".hid") continue;
    const auto bytes = tests::read_file(entry.path());
    TraceSource source(read_from(bytes));
    TraceWriter writer;
    std::string text;
    std::uint64_t count = 0;
    for (auto report = source.next(); report && report->has_value(); report = source.next(), ++count) {
      writer.report((*report)->device, (*report)->time_us, (*report)->bytes);
    }
    text = writer.take();
    TraceSource first(read_from(bytes));
    TraceSource again(read_from(base::as_bytes(text)));
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto a = first.next();
      const auto b = again.next();
      ASSERT_TRUE(a && b && a->has_value() && b->has_value()) << entry.path();
      ASSERT_EQ((*a)->device, (*b)->device) << entry.path();
      ASSERT_EQ((*a)->time_us, (*b)->time_us) << entry.path();
      ASSERT_TRUE(std::equal((*a)->bytes.begin(), (*a)->bytes.end(), (*b)->bytes.begin(), (*b)->bytes.end()));
    }
    EXPECT_TRUE(again.problems().empty()) << entry.path();
  }
}

}  // namespace
}  // namespace penpose::replay
