#include "replay/recording/usb/usb_recording.h"

#include <gtest/gtest.h>

#include "replay/recording/recording.h"
#include "replay/trace/trace_source.h"
#include "tests/support/hands/pen_reports.h"
#include "tests/support/hands/usb_capture.h"

namespace penpose::replay {
namespace {

using tests::Buffer;
using tests::CaptureForm;
using tests::UsbCapture;
using tests::UsbTablet;

/// The text of a recording, or its error.
std::string text_of(const Buffer& file) {
  const ReadBytes read = read_recording(read_from(file));
  std::string text;
  Buffer piece(1000);
  for (;;) {
    const auto got = read(piece);
    if (!got) return got.error().line("x.pcap");
    if (*got == 0) return text;
    text += base::as_text(base::Bytes(piece).first(*got));
  }
}

UsbTablet huion() {
  return {1, 5, 0x256c, 0x006d, {{5, 13, 9, 2}, {5, 1, 9, 6}}, {{2, "Huion Tablet"}, {201, "HUION_T173_200101"}}};
}

const std::string k_huion =
    "D: 0\nR: 4 05 0d 09 02\nN: Huion Tablet\nP: usb-001:005/input0\nI: 3 256c 006d\n"
    "# string 2: \"Huion Tablet\"\n# string 201: \"HUION_T173_200101\"\n"
    "D: 1\nR: 4 05 01 09 06\nN: Huion Tablet\nP: usb-001:005/input1\nI: 3 256c 006d\n"
    "# string 2: \"Huion Tablet\"\n# string 201: \"HUION_T173_200101\"\n";

TEST(UsbRecording, ATabletThatIsPluggedInAndDrawnWithBecomesATrace) {
  for (const CaptureForm form : {CaptureForm::usbmon, CaptureForm::usbmon_mmapped, CaptureForm::usbpcap}) {
    for (const bool high_first : {false, true}) {
      UsbCapture capture(form, high_first);
      capture.plug_in(huion()).wait_us(2'000'000).report(huion(), 0, {8, 0x80, 1, 2, 3});
      capture.wait_us(4'875).report(huion(), 1, {1, 0}).report(huion(), 0, {8, 0, 1, 2, 3});
      const std::string wanted = k_huion +
                                 "D: 0\nE: 0.000000 5 08 80 01 02 03\n"
                                 "D: 1\nE: 0.005125 2 01 00\nD: 0\nE: 0.005375 5 08 00 01 02 03\n";
      EXPECT_EQ(text_of(capture.pcap()), wanted);
      EXPECT_EQ(text_of(capture.pcapng(9)), wanted);
    }
  }
}

TEST(UsbRecording, WhatQemuCapturesIsReadToo) {
  UsbCapture capture;
  capture.plug_in(huion()).report(huion(), 0, {8, 1}).as_qemu_writes();
  EXPECT_EQ(text_of(capture.pcap()), k_huion + "D: 0\nE: 0.000000 2 08 01\n");
}

TEST(UsbRecording, EachTabletOfACaptureIsADevice) {
  const UsbTablet ink{2, 7, 0x1b96, 0x1000, {tests::ink_descriptor()}, {{1, "N-trig"}, {2, "Pen"}}};
  UsbCapture capture;
  capture.plug_in(huion()).report(huion(), 0, {8, 1}).plug_in(ink).report(ink, 0, {7, 2}).report(huion(), 0, {8, 3});
  const Buffer file = capture.pcap();
  TraceSource source(read_recording(read_from(file)));
  std::vector<int> devices;
  for (auto report = source.next(); report && report->has_value(); report = source.next()) {
    devices.push_back((*report)->device);
  }
  EXPECT_EQ(devices, (std::vector<int>{0, 2, 0}));
  ASSERT_EQ(source.devices().size(), 3u);
  EXPECT_EQ(source.devices().at(0).product, 0x006d);
  EXPECT_EQ(source.devices().at(1).interface_number, 1);
  EXPECT_EQ(source.devices().at(2).name, "N-trig Pen");
  EXPECT_EQ(source.devices().at(2).report_descriptor, tests::ink_descriptor());
  EXPECT_NE(source.devices().at(2).unit, source.devices().at(0).unit);
  EXPECT_EQ(source.devices().at(1).unit, source.devices().at(0).unit);
  EXPECT_TRUE(source.problems().empty());
}

TEST(UsbRecording, WhatWasPluggedInBeforeHasNoIdsButReports) {
  UsbCapture capture;
  UsbTablet hub;
  hub.address = 1;
  capture.report(hub, 0, {2}).report(huion(), 0, {8, 1, 2}).report(huion(), 1, {1, 1});
  EXPECT_EQ(text_of(capture.pcap()),
            "D: 0\nR: 0\nN: USB device without descriptors\nP: usb-001:005\nI: 3 0000 0000\nE: 0.000000 3 08 01 02\n"
            "D: 1\nR: 0\nN: USB device without descriptors\nP: usb-001:005\nI: 3 0000 0000\nE: 0.000250 2 01 01\n");
}

TEST(UsbRecording, WithoutReportDescriptorsTheIdsAreKnown) {
  // As USBPcap puts in front what it is told to inject.
  const UsbTablet wacom{1, 3, 0x056a, 0x00b8, {{}}, {}};
  UsbCapture capture(CaptureForm::usbpcap);
  capture.plug_in(wacom).report(wacom, 0, {2, 0xc2});
  EXPECT_EQ(text_of(capture.pcap()),
            "D: 0\nR: 0\nN: HID 056a:00b8\nP: usb-001:003/input0\nI: 3 056a 00b8\nE: 0.000000 2 02 c2\n");
}

TEST(UsbRecording, ADescriptorThatIsAskedForLaterIsDeclaredThen) {
  UsbCapture capture;
  UsbTablet ink{1, 6, 0x1b96, 0x1000, {tests::ink_descriptor()}, {}};
  capture.report(ink, 0, {7, 1}).plug_in(ink).tell_string(ink, 200, "late").report(ink, 0, {7, 2});
  capture.tell_string(ink, 201, "later").report(ink, 0, {7, 3});
  const Buffer file = capture.pcap();
  TraceSource source(read_recording(read_from(file)));
  ASSERT_TRUE(source.read_header());
  EXPECT_EQ(source.devices().at(0).vendor, 0);
  while (const auto report = source.next()) {
    if (!report->has_value()) break;
  }
  EXPECT_EQ(source.devices().rbegin()->second.report_descriptor, tests::ink_descriptor());
  const std::string text = text_of(capture.pcap());
  EXPECT_NE(text.find("I: 3 1b96 1000\n# string 200: \"late\"\nE: "), std::string::npos) << text;
  EXPECT_NE(text.find("02\n# string 201: \"later\"\nE: "), std::string::npos) << text;
}

TEST(UsbRecording, AnotherDeviceInTheSamePlaceIsAnotherOne) {
  UsbCapture capture;
  UsbTablet ink{1, 5, 0x1b96, 0x1000, {tests::ink_descriptor()}, {}};
  capture.plug_in(huion()).report(huion(), 0, {8, 1}).plug_in(huion()).report(huion(), 0, {8, 2});
  capture.plug_in(ink).report(ink, 0, {7, 3});
  const std::string text = text_of(capture.pcap());
  EXPECT_TRUE(text.starts_with(k_huion + "D: 0\nE: 0.000000 2 08 01\nE: ")) << text;
  EXPECT_NE(text.find("D: 2\nR: "), std::string::npos);
  EXPECT_NE(text.find("N: HID 1b96:1000\nP: usb-001:005/input0\nI: 3 1b96 1000\nE: "), std::string::npos) << text;
}

TEST(UsbRecording, WhatIsNoReportOfAHidInterfaceIsLeftOut) {
  UsbTablet stick = huion();
  stick.address = 9;
  stick.interface_class = 8;
  stick.report_descriptors = {{}};
  UsbCapture capture;
  capture.plug_in(stick).report(stick, 0, {1, 2, 3}).plug_in(huion());
  // Refused, and of a string that the device does not have.
  capture.ask(huion(), 5, {0x80, 6, 100, 3, 9, 4, 255, 0}, {4, 3, 'x', 0}, -32);
  capture.report(huion(), 0, {8, 1}).report(huion(), 0, {});
  EXPECT_EQ(text_of(capture.pcap()), k_huion + "D: 0\nE: 0.000000 2 08 01\n");
}

TEST(UsbRecording, ReportsThatWereCapturedInPartAreToldAndLeftOut) {
  UsbCapture capture;
  capture.plug_in(huion()).report(huion(), 0, {8, 1, 2, 3}, 2).report(huion(), 0, {8, 4});
  const Buffer file = capture.pcap();
  TraceSource source(read_recording(read_from(file)));
  const auto report = source.next();
  ASSERT_TRUE(report && report->has_value());
  EXPECT_EQ(Buffer((*report)->bytes.begin(), (*report)->bytes.end()), (Buffer{8, 4}));
  ASSERT_EQ(source.problems().size(), 1u);
  EXPECT_EQ(source.problems()[0].what, "the line has fewer bytes than its length says and was left out");
}

TEST(UsbRecording, ACaptureThatIsCutIsReadUpToThereAndTold) {
  UsbCapture capture;
  capture.plug_in(huion()).report(huion(), 0, {8, 1}).report(huion(), 0, {8, 2});
  Buffer file = capture.pcap();
  file.pop_back();
  TraceSource source(read_recording(read_from(file)));
  int reports = 0;
  while (const auto report = source.next()) {
    if (!report->has_value()) break;
    ++reports;
  }
  EXPECT_EQ(reports, 1);
  ASSERT_EQ(source.problems().size(), 1u);
  EXPECT_TRUE(source.problems()[0].what.starts_with("the last line is cut off")) << source.problems()[0].what;
}

TEST(UsbRecording, AClockThatIsSetBackMakesNoTimeDecrease) {
  UsbCapture capture;
  capture.plug_in(huion()).report(huion(), 0, {8, 1}).wait_us(1000).report(huion(), 0, {8, 2});
  capture.wait_us(-5'000'000).report(huion(), 0, {8, 3}).wait_us(5'000'000).report(huion(), 0, {8, 4});
  EXPECT_TRUE(text_of(capture.pcap())
                  .ends_with("E: 0.000000 2 08 01\nE: 0.001250 2 08 02\nE: 0.001250 2 08 03\n"
                             "E: 0.001750 2 08 04\n"))
      << text_of(capture.pcap());
}

TEST(UsbRecording, ACaptureWithoutReportsSaysSoAndWhatToDo) {
  const std::string how = "; capture usbmon0 on Linux (all buses) or with USBPcap on Windows, and draw meanwhile";
  UsbCapture capture;
  EXPECT_EQ(text_of(capture.pcap()), "x.pcap: is a capture without a whole packet" + how);
  capture.ask(huion(), 5, {0x80, 6, 0, 1, 0, 0, 18, 0}, {});
  EXPECT_EQ(text_of(capture.pcap()),
            "x.pcap: is a capture without reports of a tablet: 2 packets of USB, none of a HID interface" + how);
  UsbCapture wires(static_cast<CaptureForm>(288));
  wires.report(huion(), 0, {8, 1});
  EXPECT_EQ(text_of(wires.pcapng()), "x.pcap: is a capture of something else than USB requests (link type 288)" + how);
}

TEST(UsbRecording, TextThatWiresharkMadeOfACaptureIsNamedWithWhatToDo) {
  for (const std::string text :
       {"[\n  {\n    \"_index\": \"packets-2024-05-01\",\n    \"_type\": \"doc\",\n",
        "<?xml version=\"1.0\"?>\n<pdml version=\"0\" creator=\"wireshark/4.0.17\">\n",
        "No.     Time           Source                Destination           Protocol Length Info\n",
        "\"No.\",\"Time\",\"Source\",\"Destination\",\"Protocol\",\"Length\",\"Info\"\n"}) {
    EXPECT_EQ(text_of(Buffer(text.begin(), text.end())),
              "x.pcap: is Wireshark's text; save the capture as a file of Wireshark (pcapng) and give that");
  }
  // A trace whose tablet is called so is a trace.
  const std::string trace = "D: 0\nR: 1 05\nN: Frame 3: 72 bytes on wire (\nI: 3 056a 0010\nE: 0.000000 1 05\n";
  EXPECT_EQ(text_of(Buffer(trace.begin(), trace.end())), trace);
}

TEST(UsbRecording, DescriptorsThatLieHarmNothing) {
  UsbCapture capture;
  const UsbTablet tablet = huion();
  capture.plug_in(tablet);
  // Lengths of 0, beyond the end and of nothing, types that were not asked for.
  for (const Buffer& answer :
       {Buffer{}, Buffer{0}, Buffer{255}, Buffer{0, 2}, Buffer{9, 2, 255, 255, 9, 1, 0, 0, 0, 0, 4},
        Buffer{9, 2, 255, 255, 9, 1, 0, 0, 0, 200, 4}, Buffer{1, 3, 65}, Buffer{18, 1}, Buffer{3, 3, 65}}) {
    for (const std::uint8_t type : Buffer{1, 2, 3, 0x21, 0x22}) {
      capture.ask(tablet, 5, {0x80, 6, 7, type, 0, 0, 255, 0}, answer);
      capture.ask(tablet, 5, {0x81, 6, 0, type, 200, 7, 255, 0}, answer);
    }
  }
  capture.report(tablet, 0, {8, 1});
  const std::string text = text_of(capture.pcap());
  EXPECT_TRUE(text.starts_with("D: 0\nR: ")) << text;
  EXPECT_TRUE(text.ends_with("E: 0.000000 2 08 01\n")) << text;
}

TEST(UsbRecording, ADescriptorThatIsAlwaysAnotherIsDeclaredAFewTimes) {
  UsbCapture capture;
  capture.plug_in(huion());
  for (std::uint8_t i = 0; i < 100; ++i) {
    capture.ask(huion(), 5, {0x81, 6, 0, 0x22, 0, 0, 255, 0}, {i}).report(huion(), 0, {8, i});
  }
  const std::string text = text_of(capture.pcap());
  std::size_t declared = 0;
  std::size_t reports = 0;
  for (std::size_t at = text.find("\nR: "); at != std::string::npos; at = text.find("\nR: ", at + 1)) ++declared;
  for (std::size_t at = text.find("\nE: "); at != std::string::npos; at = text.find("\nE: ", at + 1)) ++reports;
  EXPECT_EQ(declared, 17u);
  EXPECT_EQ(reports, 100u);
}

TEST(UsbRecording, MemoryDoesNotGrowWithWhatACaptureClaims) {
  UsbCapture capture;
  UsbTablet tablet = huion();
  tablet.report_descriptors = {Buffer(60'000, 1)};
  for (int device = 2; device < 128; ++device) {
    tablet.address = static_cast<std::uint8_t>(device);
    tablet.product = static_cast<std::uint16_t>(device);
    capture.plug_in(tablet).report(tablet, 0, {1});
  }
  const Buffer file = capture.pcap();
  TraceSource source(read_recording(read_from(file)));
  std::size_t kept = 0;
  while (const auto report = source.next()) {
    if (!report->has_value()) break;
  }
  for (const auto& [number, device] : source.devices()) kept += device.report_descriptor.size();
  EXPECT_EQ(source.devices().size(), 126u);
  EXPECT_LE(kept, std::size_t{1} << 22);
}

}  // namespace
}  // namespace penpose::replay
