#include <gtest/gtest.h>

#include "firmware_io/decode/decoder_factory.h"
#include "replay/recording/recording.h"
#include "replay/trace/trace_source.h"

namespace penpose::replay {
namespace {

/// Each report as its device, time and length; what is known of the devices goes to `devices`.
std::vector<std::string> read_lines(const std::string& text, std::map<int, decode::DeviceIdentity>* devices = nullptr) {
  TraceSource source(read_recording(read_from(base::as_bytes(text))));
  std::vector<std::string> out;
  for (;;) {
    const auto report = source.next();
    EXPECT_TRUE(report);
    if (!report || !report->has_value()) break;
    out.push_back(std::to_string((*report)->device) + " " + std::to_string((*report)->time_us) + " " +
                  std::to_string((*report)->bytes.size()));
  }
  if (devices != nullptr) *devices = source.devices();
  return out;
}

using Lines = std::vector<std::string>;

TEST(TabletDebugger, ReportsWithTheirTimes) {
  EXPECT_EQ(read_lines("#First button\n"
                       "{ 07 80 DB 00 }, Delta:104.745ms, Position:[219,300], ReportType:X\n"
                       "{ 07 80 DB 01 }, Delta:2.430ms, Pressure:0\n"
                       "{ 07 80 DB }, Delta:1002,5ms\n"),
            (Lines{"0 0 4", "0 2430 4", "1 1004930 3"}));
}

TEST(TabletDebugger, BytesAloneHaveNoTimes) {
  EXPECT_EQ(read_lines("08 80 01 02\r\n08 80 01 03\r\n\r\n# keys\r\n08 E0 01 01\r\n"),
            (Lines{"0 0 4", "0 5000 4", "0 10000 4"}));
  EXPECT_TRUE(read_lines("08 80 01 02\nand more\n").empty());
  EXPECT_TRUE(read_lines("08 80 01 0g\n").empty());
}

TEST(TabletDebugger, TheTabletIsFoundByItsName) {
  const std::string line =
      "Device:XP-Pen Star 03, { 02 A1 10 27 20 4E E8 03 00 00 }, Delta:5.000ms, Position:[1,2], ReportType:X\n";
  std::map<int, decode::DeviceIdentity> devices;
  EXPECT_EQ(read_lines(line + line, &devices), (Lines{"0 0 10", "0 5000 10"}));
  EXPECT_EQ(devices.at(0).vendor, 0x28bd);
  EXPECT_EQ(devices.at(0).product, 0x0907);
  EXPECT_EQ(devices.at(0).name, "XP-Pen Star 03");
  const auto recognition = decode::make_decoder(devices.at(0));
  ASSERT_TRUE(recognition) << recognition.error().line();
  EXPECT_EQ(recognition->method, "protocol xp_pen");
  EXPECT_EQ(recognition->decoder->axes().x.maximum, 50800);

  EXPECT_EQ(read_lines("Device:Nobody's, { 02 A1 }, Delta:5.000ms\n", &devices), (Lines{"0 0 2"}));
  EXPECT_EQ(devices.at(0).vendor, 0);
}

}  // namespace
}  // namespace penpose::replay
