#include <gtest/gtest.h>
#include <string>

#include "firmware_io/decode/decoder_factory.h"
#include "firmware_io/decode/hand_factory.h"
#include "replay/recording/recording.h"
#include "replay/trace/trace_source.h"

namespace penpose::replay {
namespace {

/// A pen with eraser, tilt and numbers of tools, as evemu-record writes what a Wacom tablet says.
const std::string k_pen =
    "# EVEMU 1.3\n"
    "# Input device name: \"Wacom Intuos4 6x9 Pen\"\n"
    "#   Supported events:\n"
    "#     Event type 0 (EV_SYN)\n"
    "N: Wacom Intuos4 6x9 Pen\n"
    "I: 0003 056a 00b9 0110\n"
    "P: 01 00 00 00 00 00 00 00\n"
    "B: 00 1b 00 00 00 00 00 00 00\n"
    "B: 01 00 00 00 00 00 00 00 00\n"
    "B: 01 00 00 00 00 00 00 00 00\n"
    "B: 01 00 00 00 00 00 00 00 00\n"
    "B: 01 00 00 00 00 00 00 00 00\n"
    "B: 01 00 00 00 00 00 00 00 00\n"
    "B: 01 03 1c 00 00 00 00 00 00\n"
    "B: 02 00 00 00 00 00 00 00 00\n"
    "B: 03 03 00 00 0f 00 01 00 00\n"
    "B: 04 01 00 00 00 00 00 00 00\n"
    "A: 00 0 44704 4 0 200\n"
    "A: 01 0 27940 4 0 200\n"
    "A: 18 0 2047 0 0 0\n"
    "A: 19 0 63 0 0 0\n"
    "A: 1a -64 63 0 0 57\n"
    "A: 1b -64 63 0 0 57\n"
    "A: 28 0 0 0 0 0\n"
    "################################\n"
    "#      Waiting for events      #\n"
    "E: 1471231.250000 0003 0000 21044\t# EV_ABS / ABS_X                21044\n"
    "E: 1471231.250000 0003 0001 0311\t# EV_ABS / ABS_Y                311\n"
    "E: 1471231.250000 0003 001a -012\t# EV_ABS / ABS_TILT_X           -12\n"
    "E: 1471231.250000 0003 0028 2082\n"
    "E: 1471231.250000 0001 0140 0001\t# EV_KEY / BTN_TOOL_PEN         1\n"
    "E: 1471231.250000 0004 0000 -1771834365\n"
    "E: 1471231.250000 0000 0000 0000\t# ------------ SYN_REPORT (0) ----------\n"
    "E: 1471231.257000 0003 0018 0512\n"
    "E: 1471231.257000 0001 014a 0001\n"
    "E: 1471231.257000 0000 0000 0000\n";

std::vector<decode::PenSample> samples_of(const std::string& text, std::vector<std::int64_t>* times = nullptr) {
  TraceSource source(read_recording(read_from(base::as_bytes(text))));
  std::unique_ptr<decode::PenDecoder> decoder;
  source.listen({}, [&](int, const decode::DeviceIdentity& identity) {
    auto found = decode::make_decoder(identity);
    decoder = found ? std::move(found->decoder) : nullptr;
  });
  std::vector<decode::PenSample> samples;
  for (auto report = source.next(); report && report->has_value(); report = source.next()) {
    if (!decoder) continue;
    decoder->decode((*report)->bytes);
    samples.push_back(decoder->sample());
    if (times != nullptr) times->push_back((*report)->time_us);
  }
  return samples;
}

TEST(EvemuRecording, APenIsReadByWhatItSaysOfItself) {
  std::vector<std::int64_t> times;
  const auto samples = samples_of(k_pen, &times);
  decode::PenSample first;
  first.in_range = true;
  first.tool = decode::Tool::pen;
  first.x = 21044;
  first.y = 311;
  first.tilt_x = -12;
  first.tool_id = 2082;
  first.serial = 0x9663f403;
  decode::PenSample second = first;
  second.pressure = 512;
  second.tip = true;
  EXPECT_EQ(samples, (std::vector{first, second}));
  EXPECT_EQ(times, (std::vector<std::int64_t>{0, 7000}));
}

TEST(EvemuRecording, WithoutResolutionsAsInItsFirstEdition) {
  std::string text = k_pen;
  text.replace(text.find("1.3"), 3, "1.0");
  for (std::string::size_type at; (at = text.find(" 0 200\n")) != std::string::npos;) text.replace(at, 6, " 0");
  EXPECT_EQ(samples_of(text), samples_of(k_pen));
}

TEST(EvemuRecording, OneBehindTheOtherAreTwoDevices) {
  std::string other = k_pen;
  other.replace(other.find("A: 00 0 44704"), 13, "A: 00 0 15000");
  std::vector<std::int64_t> times;
  const auto samples = samples_of(k_pen + other, &times);
  ASSERT_EQ(samples.size(), 4U);
  EXPECT_EQ(samples[1].x, 21044);
  EXPECT_EQ(samples[3].x, 15000) << "its range ends there";
  EXPECT_EQ(times, (std::vector<std::int64_t>{0, 7000, 7000, 14000})) << "times that begin anew go on";
}

TEST(EvemuRecording, DamagedLinesAreLeftOut) {
  std::string text = k_pen;
  const std::string last = text.substr(text.find("E: 1471231.257000 0000"));
  text.insert(text.find("E: 1471231.257000 0003"),
              "E: 1471231.25700 0003 0000 1\nE: x\nE: 1471231.257000 0003 0000 99999999999\nE:\n" + last);
  EXPECT_EQ(samples_of(text), samples_of(k_pen));
  EXPECT_TRUE(samples_of("# EVEMU 1.3\nB: 01 ff\nA: zz 0 1 0 0\nE: 0.000000 0000 0000 0000\n").empty());
}

}  // namespace
}  // namespace penpose::replay
