#include <gtest/gtest.h>

#include "replay/recording/recording.h"
#include "replay/trace/trace_source.h"

namespace penpose::replay {
namespace {

struct Read {
  std::vector<std::string> reports;  ///< "DEVICE TIME: BYTES"
  std::map<int, decode::DeviceIdentity> devices;
  std::vector<base::Error> problems;
};

Read read_dump(const std::string& text) {
  TraceSource source(read_recording(read_from(base::as_bytes(text))));
  Read out;
  for (;;) {
    const auto report = source.next();
    EXPECT_TRUE(report);
    if (!report || !report->has_value()) break;
    std::string line = std::to_string((*report)->device) + " " + std::to_string((*report)->time_us) + ":";
    for (const std::uint8_t byte : (*report)->bytes) line += " " + std::to_string(byte);
    out.reports.push_back(line);
  }
  out.devices = source.devices();
  out.problems = source.problems();
  return out;
}

using Lines = std::vector<std::string>;

TEST(UsbhidDump, DescriptorsAndReportsOfSeveralInterfaces) {
  const Read read = read_dump(
      "003:004:001:DESCRIPTOR         1542013940.000001\n 05 0D 09 02 C0\n\n"
      "003:004:000:DESCRIPTOR         1542013940.000002\n"
      " 06 00 FF 09 01 A1 01 85 08 75 08 95 0B 09 01 81\n 02 C0\n\n"
      "Starting dumping interrupt transfer stream\nwith 1 minute timeout.\n\n"
      "003:004:000:STREAM             1542013945.696547\n 08 80 01\n\n"
      "003:004:001:STREAM             1542013945.700532\n 02 00\n\n"
      "003:004:000:STREAM             1542013945.700533\n 08 81 FF\n");
  EXPECT_EQ(read.reports, (Lines{"1 0: 8 128 1", "0 3985: 2 0", "1 3986: 8 129 255"}));
  ASSERT_EQ(read.devices.size(), 2u);
  EXPECT_EQ(read.devices.at(0).report_descriptor, (std::vector<std::uint8_t>{0x05, 0x0d, 0x09, 0x02, 0xc0}));
  EXPECT_EQ(read.devices.at(0).interface_number, 1);
  EXPECT_EQ(read.devices.at(1).input_report_length, 12);
  EXPECT_EQ(read.devices.at(0).unit, read.devices.at(1).unit);
  EXPECT_TRUE(read.problems.empty());
}

TEST(UsbhidDump, IdsComeFromTheTextAroundIt) {
  const std::string stream = "002:007:000:STREAM             1.000000\n 01\n\n";
  const Read by_list = read_dump("Bus 002 Device 006: ID 1d6b:0002 Linux Foundation hub\n" + stream +
                                 "Bus 002 Device 007: ID 256c:006e HUION PenTablet\n");
  EXPECT_EQ(by_list.devices.at(0).vendor, 0x256c);
  EXPECT_EQ(by_list.devices.at(0).product, 0x006e);
  EXPECT_EQ(by_list.devices.at(0).name, "HUION PenTablet");
  for (const char* command : {"$ sudo usbhid-dump -m 28bd:0907 -es\n", "# usbhid-dump --model=28bd:907 -e stream\n",
                              "usbhid-dump -d28bd:0907\n"}) {
    const Read by_command = read_dump(command + stream);
    EXPECT_EQ(by_command.devices.at(0).vendor, 0x28bd) << command;
    EXPECT_EQ(by_command.devices.at(0).product, 0x0907) << command;
  }
  EXPECT_EQ(read_dump(stream).devices.at(0).vendor, 0);
}

TEST(UsbhidDump, QuotedAndOldFormsAreRead) {
  EXPECT_EQ(read_dump("> 003:004:000:STREAM      7.000000\r\n>  08 80\r\n>\r\n").reports, (Lines{"0 0: 8 128"}));
  // Of 2010: without bus and device.
  EXPECT_EQ(
      read_dump("000:STREAM        1281177973.455956\n 02 FB\n\n001:STREAM      1281177973.459910\n 03\n").reports,
      (Lines{"0 0: 2 251", "1 3954: 3"}));
}

TEST(UsbhidDump, ADamagedReportIsToldAndTheRestIsRead) {
  const Read read = read_dump(
      "001:002:000:STREAM  5.000000\n 01 0\n\n001:002:000:STREAM  5.000001\n\n"
      "001:002:000:STREAM  5.000002\n 02 03\n001:002:000:STREAM  5.000003\n 04\nnote\n");
  EXPECT_EQ(read.reports, (Lines{"0 0: 2 3", "0 1: 4"}));
  ASSERT_EQ(read.problems.size(), 1u);
  EXPECT_EQ(read.problems[0].place, "line 3");
}

TEST(UsbhidDump, WhatOnlyLooksLikeItIsNone) {
  for (const char* line : {"003:004:256:STREAM 1.000000", "003:004:000:STREAM", "003:004:000:STREAM 1.0",
                           "003:004:000:OTHER 1.000000", "1:2:3:4:STREAM 1.000000", "003:004:000:STREAM 1.000000 x"}) {
    const std::string text = std::string(line) + "\n 01 02\n";
    EXPECT_TRUE(read_dump(text).reports.empty()) << line;
  }
}

}  // namespace
}  // namespace penpose::replay
