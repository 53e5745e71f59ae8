#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/decode_run.h"
#include "tests/support/hands/hand_descriptors.h"
#include "tests/support/hands/pen_path.h"
#include "tests/support/hands/pen_reports.h"
#include "tests/support/hands/trace_text.h"
#include "tests/support/hands/usb_capture.h"

namespace penpose::cli {
namespace {

using tests::Outcome;

class DecodeCommand : public tests::DecodeRun {};

std::string pen_trace(int strokes = 1) {
  tests::TraceText trace;
  trace.device(0, tests::ink_descriptor(), "3 1b96 1000");
  std::int64_t time_us = 0;
  for (const auto& sample : tests::pen_path({24188, 15360, 4095, true, -1}, strokes)) {
    trace.report(time_us, tests::ink_pen(sample));
    time_us += 5000;
  }
  return trace.text();
}

TEST_F(DecodeCommand, PrintsARowForEachReportOfAPen) {
  const Outcome outcome = decode(pen_trace());
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.error, "");
  EXPECT_TRUE(outcome.out.starts_with("# axis x 0 24188 "));
  EXPECT_NE(outcome.out.find("\nreport,time_us,x,y,pressure,tilt_x,tilt_y,distance,in_range,tool,tip,button1,button2\n"
                             "0,0,2418,3840,0,-60,60,,1,eraser,0,0,0\n"),
            std::string::npos)
      << outcome.out;
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 5 + 1 + 21);
}

TEST_F(DecodeCommand, JsonIsOneObject) {
  const auto object = nlohmann::json::parse(decode(pen_trace(), {"--json"}).out, nullptr, false);
  ASSERT_TRUE(object.is_object());
  EXPECT_EQ(object["samples"].size(), 21u);
  EXPECT_EQ(object["devices"][0]["method"], "descriptor");
  const auto empty = nlohmann::json::parse(
      decode(tests::TraceText().device(0, {}, "3 0458 0138").text(), {"--json"}).out, nullptr, false);
  ASSERT_TRUE(empty.is_object());
  EXPECT_TRUE(empty["samples"].empty());
}

TEST_F(DecodeCommand, JsonTellsTheAxesOfEachRecordingWhereTheyAreOthers) {
  decode::PenSample sample;
  sample.in_range = true;
  sample.tool = decode::Tool::pen;
  tests::TraceText trace;
  // The same tablet twice, then one of another size in its place, which is then plugged in again.
  for (int i = 0; i < 4; ++i) {
    if (i < 2) trace.device(0, tests::ink_descriptor(), "3 1b96 1000").report(0, tests::ink_pen(sample));
    if (i >= 2) trace.device(0, {0x05, 0x0d, 0xc0}, "3 256c 006e");
    if (i >= 2) trace.report(5000, {0x08, 0x81, 0x10, 0x27, 0x20, 0x4e, 0xe8, 0x03, 0, 0, 0, 0});
  }
  const auto object = nlohmann::json::parse(decode(trace.text(), {"--json"}).out, nullptr, false);
  ASSERT_TRUE(object.is_object());
  const auto& samples = object["samples"];
  ASSERT_EQ(samples.size(), 4u);
  EXPECT_EQ(object["axes"]["x"]["max"], 24188);
  for (const std::size_t i : {0, 1, 3}) EXPECT_FALSE(samples[i].contains("axes")) << i;
  ASSERT_TRUE(samples[2].contains("axes"));
  EXPECT_NE(samples[2]["axes"]["x"]["max"], 24188);
}

TEST_F(DecodeCommand, SeveralDevicesAddAColumn) {
  tests::TraceText trace;
  trace.device(0, {}, "3 0458 0138").device(1, tests::ink_descriptor(), "3 1b96 1000");
  decode::PenSample sample;
  sample.in_range = true;
  sample.tool = decode::Tool::pen;
  trace.line("D: 0").report(0, {1, 2, 3}).line("D: 1").report(10, tests::ink_pen(sample));
  const Outcome outcome = decode(trace.text());
  EXPECT_NE(outcome.out.find(",button2,device\n1,10,0,0,0,0,0,,1,pen,0,0,0,1\n"), std::string::npos) << outcome.out;
}

TEST_F(DecodeCommand, OfSeveralDevicesEachTellsItsAxesBeforeItsFirstRow) {
  decode::PenSample sample;
  sample.in_range = true;
  sample.tool = decode::Tool::pen;
  tests::TraceText trace;
  trace.device(0, {}, "3 28bd 0907").device(1, tests::ink_descriptor(), "3 1b96 1000");
  const auto vendor = [&](int time_us) {
    trace.line("D: 0").report(time_us, {0x02, 0xa1, 0x10, 0x27, 0x20, 0x4e, 0xe8, 0x03, 0, 0});
  };
  vendor(0);
  trace.line("D: 1").report(10, tests::ink_pen(sample)).report(20, tests::ink_pen(sample));
  vendor(30);
  const std::string out = decode(trace.text()).out;
  EXPECT_TRUE(out.starts_with("# axis x 0 50800 200\n")) << out;
  const auto second = out.find("\n# device 1\n# axis x 0 ");
  ASSERT_NE(second, std::string::npos) << out;
  EXPECT_LT(out.find("\n0,0,10000,20000,"), second) << out;
  EXPECT_GT(out.find("\n1,10,"), second) << out;
  EXPECT_EQ(out.find("# device", second + 3), std::string::npos) << "told once: " << out;
}

TEST_F(DecodeCommand, AGuessIsCalledAGuessUntilTheTabletIsNamed) {
  const std::string trace = tests::TraceText()
                                .device(0, {}, "3 256c 006e")
                                .report(0, {0x08, 0x81, 0x10, 0x27, 0x20, 0x4e, 0xe8, 0x03, 0, 0, 0, 0})
                                .text();
  const Outcome guessed = decode(trace);
  EXPECT_EQ(guessed.status, 0);
  EXPECT_NE(guessed.error.find(": a guess: one of "), std::string::npos) << guessed.error;
  EXPECT_NE(guessed.error.find("256c:006e"), std::string::npos) << guessed.error;
  const auto guess = [&](const std::vector<std::string>& options) {
    return nlohmann::json::parse(decode(trace, options).out, nullptr, false)["devices"][0]["guess"];
  };
  EXPECT_NE(guess({"--json"}).get<std::string>().find("256c:006e, read as "), std::string::npos);
  EXPECT_TRUE(guess({"--json", "--tablet", "New 1060 Plus"}).is_null());
  const Outcome named = decode(trace, {"--tablet", "New 1060 Plus"});
  EXPECT_EQ(named.error, "");
  EXPECT_TRUE(named.out.starts_with("# axis x 0 50800 200\n")) << named.out;
  const Outcome unknown = decode(trace, {"--tablet", "none of these"});
  EXPECT_EQ(unknown.status, 1);
  EXPECT_NE(unknown.error.find("devices --known"), std::string::npos) << unknown.error;
}

TEST_F(DecodeCommand, ARecordingWithoutIdsIsReadAsTheNamedTablet) {
  const auto recording = [](const std::string& ids) {
    tests::TraceText trace;
    trace.line("D: 0").line("N: Test pen");
    if (!ids.empty()) trace.line("I: " + ids);
    trace.report(0, tests::intuos_enter(0x802, 0x1234567));
    std::int64_t time_us = 5000;
    for (const auto& sample : tests::pen_path({31496, 19685, 2047, true, -1}, 1)) {
      if (sample.in_range) trace.report(time_us, tests::intuos_pen(sample));
      time_us += 5000;
    }
    return trace.report(time_us, {3, 0, 0, 5, 0, 0, 0, 0, 0, 0}).text();
  };
  const Outcome wanted = decode(recording("3 056a 0314"));
  EXPECT_GT(std::count(wanted.out.begin(), wanted.out.end(), '\n'), 20);
  const Outcome wanted_pad = decode(recording("3 056a 0314"), {"--pad"});
  EXPECT_NE(wanted_pad.out.find("BTN_"), std::string::npos) << wanted_pad.out;
  for (const char* ids : {"", "3 0000 0000", "0 0000 0000"}) {
    const Outcome named = decode(recording(ids), {"--tablet", "PTH-451"});
    EXPECT_EQ(named.error, "");
    EXPECT_EQ(named.out, wanted.out) << ids;
    EXPECT_EQ(decode(recording(ids), {"--pad", "--tablet", "PTH-451"}).out, wanted_pad.out) << ids;
  }
}

TEST_F(DecodeCommand, AProtocolByNameReadsAnyDevice) {
  const std::string trace = tests::TraceText()
                                .device(0, {0x05, 0x0d, 0xc0}, "3 0000 0000")
                                .report(0, {0x02, 0xa1, 0x10, 0x27, 0x20, 0x4e, 0xe8, 0x03, 0, 0, 0, 0})
                                .text();
  const Outcome outcome = decode(trace, {"--protocol", "xp_pen"});
  EXPECT_NE(outcome.out.find("\n0,0,10000,20000,1000,0,0,,1,pen,1,0,0\n"), std::string::npos) << outcome.out;
  const Outcome unknown = decode(trace, {"--protocol", "no_such"});
  EXPECT_EQ(unknown.status, 1);
  EXPECT_NE(unknown.error.find("no_such"), std::string::npos);
}

TEST_F(DecodeCommand, ACutTraceIsReadUpToTheCut) {
  std::string trace = pen_trace();
  trace.resize(trace.size() - 4);
  const Outcome outcome = decode(trace);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 5 + 1 + 20);
  EXPECT_NE(outcome.error.find("line 26: the last line is cut off"), std::string::npos) << outcome.error;
  EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1);
}

TEST_F(DecodeCommand, ACaptureOfUsbIsReadAsTheTraceOfItsTablet) {
  const tests::UsbTablet ink{1, 9, 0x1b96, 0x1000, {tests::ink_descriptor()}, {}};
  tests::UsbCapture capture;
  tests::UsbCapture late;
  tests::TraceText trace;
  trace.device(0, tests::ink_descriptor(), "3 1b96 1000");
  capture.plug_in(ink);
  std::int64_t time_us = 0;
  for (const auto& sample : tests::pen_path({24188, 15360, 4095, true, -1}, 2)) {
    capture.report(ink, 0, tests::ink_pen(sample));
    late.report(ink, 0, tests::ink_pen(sample));
    trace.report(time_us, tests::ink_pen(sample));
    time_us += 250;
  }
  const auto text_of = [](const tests::Buffer& file) { return std::string(file.begin(), file.end()); };
  const Outcome wanted = decode(trace.text());
  for (const auto& file : {capture.pcap(), capture.pcapng()}) {
    const Outcome outcome = decode(text_of(file));
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.error, "");
    EXPECT_EQ(outcome.out, wanted.out);
  }
  const Outcome unknown = decode(text_of(late.pcap()));
  EXPECT_NE(unknown.error.find("does not say which tablet it is"), std::string::npos) << unknown.error;
  EXPECT_EQ(std::count(unknown.error.begin(), unknown.error.end(), '\n'), 1);
}

TEST_F(DecodeCommand, AMouseGivesNoRowsAndSaysWhy) {
  const Outcome outcome = decode(tests::TraceText().device(0, {}, "3 0458 0138").report(0, {1, 2, 3}).text());
  EXPECT_EQ(outcome.status, 0);
  EXPECT_TRUE(outcome.out.starts_with("report,time_us,"));
  EXPECT_NE(outcome.error.find("no pen that is known"), std::string::npos);
}

TEST_F(DecodeCommand, ReportsWithoutARowSayWhy) {
  // A pen, and beside it the form of a mouse that the tablet has until a driver wakes it.
  tests::Report descriptor = tests::ink_descriptor();
  const tests::Report mouse{0x05, 0x01, 0x09, 0x02, 0xa1, 0x01, 0x85, 0x09, 0x09, 0x01, 0xa1, 0x00,
                            0x05, 0x09, 0x19, 0x01, 0x29, 0x03, 0x15, 0x00, 0x25, 0x01, 0x95, 0x08,
                            0x75, 0x01, 0x81, 0x02, 0x05, 0x01, 0x09, 0x30, 0x09, 0x31, 0x15, 0x81,
                            0x25, 0x7f, 0x75, 0x08, 0x95, 0x02, 0x81, 0x06, 0xc0, 0xc0};
  for (const std::uint8_t byte : mouse) descriptor.push_back(byte);
  tests::TraceText asleep;
  asleep.device(0, descriptor, "3 1b96 1000").report(0, {9, 1, 2, 3}).report(5, {9, 0, 2, 3});
  const Outcome outcome = decode(asleep.text());
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.error.find("2 reports, none of a pen: this is the tablet's mouse mode"), std::string::npos)
      << outcome.error;
  EXPECT_NE(outcome.error.find("penpose record"), std::string::npos);
  const Outcome hands = decode(asleep.text(), {"--pad"});
  EXPECT_NE(hands.error.find("2 reports, none of keys, rings or wheels"), std::string::npos) << hands.error;
  EXPECT_EQ(decode(tests::TraceText().device(0, descriptor, "3 1b96 1000").text()).error.find("none"),
            std::string::npos);
}

TEST_F(DecodeCommand, ATraceOfKeysAloneSaysThatTheyArePrintedOtherwise) {
  const tests::Report key{0xf7, 0xe0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0};
  tests::Report with_pen = tests::ink_descriptor();
  tests::append(with_pen, tests::uclogic_pad_descriptor());
  for (const auto& descriptor : {tests::uclogic_pad_descriptor(), with_pen}) {
    tests::TraceText trace;
    trace.device(0, descriptor, "3 fff0 0001").report(0, key);
    const Outcome outcome = decode(trace.text());
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.error.find("1 report, none of a pen that is near; --pad and --touch print keys"),
              std::string::npos)
        << outcome.error;
    const Outcome hands = decode(trace.text(), {"--pad"});
    EXPECT_NE(hands.out.find("0,0,BTN_0,0,,,,0,0\n"), std::string::npos) << hands.out;
    EXPECT_EQ(hands.error, "");
  }
}

TEST_F(DecodeCommand, NoRowsAreOneLineOverAllInterfaces) {
  tests::TraceText trace;
  trace.device(0, {0x06, 0x00, 0xff, 0xc0}, "3 0458 0138").device(1, {0x06, 0x00, 0xff, 0xc0}, "3 0458 0139");
  trace.line("D: 0").report(0, {1, 2, 3}).line("D: 1").report(1, {1, 2});
  const Outcome two = decode(trace.text());
  EXPECT_EQ(std::count(two.error.begin(), two.error.end(), '\n'), 1) << two.error;
  EXPECT_NE(two.error.find("2 reports, none of a pen: no pen that is known"), std::string::npos) << two.error;
  EXPECT_NE(two.error.find("any other of 2 interfaces"), std::string::npos) << two.error;
  // In the table of tablets, by another interface: this one has reports of two bytes.
  const tests::Report opaque{0x06, 0x00, 0xff, 0x09, 0x01, 0xa1, 0x01, 0x09, 0x01, 0x15,
                             0x00, 0x25, 0x7f, 0x75, 0x08, 0x95, 0x02, 0x81, 0x02, 0xc0};
  const Outcome other = decode(tests::TraceText().device(0, opaque, "3 28bd 0078").report(0, {1, 2}).text());
  EXPECT_NE(other.error.find("1 report, none of a pen: this interface of XP-Pen Star 06"), std::string::npos)
      << other.error;
  EXPECT_EQ(other.error.find("add the tablet"), std::string::npos) << other.error;
  const Outcome none = decode(tests::TraceText().device(0, tests::ink_descriptor(), "3 1b96 1000").text());
  EXPECT_NE(none.error.find("no reports"), std::string::npos) << none.error;
}

TEST_F(DecodeCommand, ARecordingThatDoesNotNameItsTabletSaysHowToNameIt) {
  for (const char* text :
       {"001:002:000:STREAM  5.000000\n 08 80 01\n", "{ 08 80 01 }, Delta:1.000ms\n", "08 80 01\n"}) {
    const Outcome outcome = decode(text);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.error.find("1 report, none of a pen: the recording does not say which tablet"), std::string::npos)
        << outcome.error;
    EXPECT_NE(outcome.error.find("before the tablet is plugged in"), std::string::npos) << outcome.error;
    EXPECT_NE(outcome.error.find("--tablet NAME"), std::string::npos) << outcome.error;
  }
  const Outcome read = decode("08 80 01\n", {"--protocol", "xp_pen"});
  EXPECT_EQ(read.error.find("does not say"), std::string::npos) << read.error;
}

TEST_F(DecodeCommand, RecordingsOneBehindAnotherAreReadEachByItsOwn) {
  decode::PenSample sample;
  sample.in_range = true;
  sample.tool = decode::Tool::pen;
  const std::string other = tests::TraceText()
                                .device(0, {}, "3 28bd 0907")
                                .report(0, {0x02, 0xa1, 0x10, 0x27, 0x20, 0x4e, 0xe8, 0x03, 0, 0})
                                .report(5000, {0x02, 0xa1, 0x11, 0x27, 0x20, 0x4e, 0xe8, 0x03, 0, 0})
                                .text();
  const Outcome outcome = decode(pen_trace() + other + pen_trace());
  EXPECT_EQ(outcome.error, "");
  EXPECT_NE(outcome.out.find("\n# axis x 0 50800 200\n# axis y 0 30480 200\n# axis pressure 0 8191 0\n"),
            std::string::npos)
      << outcome.out;
  // Times go on from the last of the first recording, which has 21 reports.
  EXPECT_NE(outcome.out.find("\n21,100000,10000,20000,1000,"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\n22,105000,10001,20000,1000,"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\n23,105000,2418,3840,"), std::string::npos) << outcome.out;
}

TEST_F(DecodeCommand, ColouredTextOfHidRecorderIsRead) {
  std::string coloured;
  for (const char c : pen_trace()) coloured += c == '\n' ? "\x1b[39m\n\x1b[31m" : std::string(1, c);
  EXPECT_EQ(decode("\x1b[31m" + coloured).out, decode(pen_trace()).out);
}

TEST_F(DecodeCommand, WhatIsNoTraceIsAnError) {
  EXPECT_EQ(decode("hello\n").status, 1);
  EXPECT_EQ(decode("").status, 1);
  EXPECT_EQ(run({"decode", "/no/such/file"}), 1);
  EXPECT_NE(error_.find("/no/such/file: cannot be opened"), std::string::npos);
  EXPECT_EQ(decode(pen_trace(), {"--csv", "--json"}).status, 2);
}

}  // namespace
}  // namespace penpose::cli
