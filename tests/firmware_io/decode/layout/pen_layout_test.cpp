#include "firmware_io/decode/layout/pen_layout.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "firmware_io/decode/described/descriptor_decoder.h"
#include "tests/support/hands/pen_reports.h"

namespace penpose::decode {
namespace {

hid::ReportDescriptor parsed(const tests::Report& bytes) {
  auto result = hid::parse_report_descriptor(bytes);
  EXPECT_TRUE(result.ok()) << (result ? "" : result.error().line());
  return result ? std::move(result).value() : hid::ReportDescriptor{};
}

TEST(PenLayout, FindsAPenWithItsRangesAndUnits) {
  const auto pens = find_pens(parsed(tests::ink_descriptor()), Dialect::standard);
  ASSERT_TRUE(pens);
  ASSERT_EQ(pens->reports.size(), 1u);
  EXPECT_EQ(pens->reports[0].id, 7);
  EXPECT_EQ(pens->reports[0].length, 12u);
  EXPECT_EQ(pens->reports[0].needed, 12u);
  EXPECT_TRUE(pens->reports[0].has_tip);
  EXPECT_TRUE(pens->reports[0].has_proximity);
  EXPECT_EQ(pens->axes.x.maximum, 24188);
  EXPECT_DOUBLE_EQ(pens->axes.x.units_per_mm, 24188 / 242.8);
  EXPECT_EQ(pens->axes.pressure.maximum, 4095);
  EXPECT_EQ(pens->axes.tilt_x.minimum, -9000);
  EXPECT_DOUBLE_EQ(pens->axes.tilt_x.units_per_mm, 100);
  EXPECT_FALSE(pens->axes.distance.present);
}

TEST(PenLayout, AMouseIsNoPen) {
  const tests::Report mouse{0x05, 0x01, 0x09, 0x02, 0xa1, 0x01, 0x09, 0x01, 0xa1, 0x00, 0x05, 0x09, 0x19, 0x01, 0x29,
                            0x03, 0x15, 0x00, 0x25, 0x01, 0x95, 0x08, 0x75, 0x01, 0x81, 0x02, 0x05, 0x01, 0x09, 0x30,
                            0x09, 0x31, 0x15, 0x81, 0x25, 0x7f, 0x75, 0x08, 0x95, 0x02, 0x81, 0x06, 0xc0, 0xc0};
  EXPECT_FALSE(find_pens(parsed(mouse), Dialect::standard));
  EXPECT_FALSE(find_pens(parsed(mouse), Dialect::wacom));
}

TEST(PenLayout, AFingerIsNoPen) {
  // A touch screen: contact with identifier, tip switch and position within a Finger collection.
  const tests::Report touch{0x05, 0x0d, 0x09, 0x04, 0xa1, 0x01, 0x85, 0x01, 0x09, 0x22, 0xa1, 0x02,
                            0x09, 0x42, 0x15, 0x00, 0x25, 0x01, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02,
                            0x09, 0x51, 0x25, 0x7f, 0x81, 0x02, 0x05, 0x01, 0x09, 0x30, 0x09, 0x31,
                            0x26, 0xff, 0x0f, 0x75, 0x10, 0x95, 0x02, 0x81, 0x02, 0xc0, 0xc0};
  EXPECT_FALSE(find_pens(parsed(touch), Dialect::standard));
  EXPECT_FALSE(find_pens(parsed(touch), Dialect::wacom));
  // The same fields of an application called Digitizer, as some drivers' descriptors have it.
  tests::Report digitizer = touch;
  digitizer[3] = 0x01;
  EXPECT_FALSE(find_pens(parsed(digitizer), Dialect::standard));
}

TEST(PenLayout, OnlyReportsThatAreLongEnoughAreFound) {
  const auto pens = find_pens(parsed(tests::ink_descriptor()), Dialect::standard);
  ASSERT_TRUE(pens);
  tests::Report report = tests::ink_pen({});
  EXPECT_NE(pens->find(report), nullptr);
  report.push_back(0);
  EXPECT_NE(pens->find(report), nullptr);
  report.resize(11);
  EXPECT_EQ(pens->find(report), nullptr);
  report = tests::ink_pen({});
  report[0] = 8;
  EXPECT_EQ(pens->find(report), nullptr);
  EXPECT_EQ(pens->find({}), nullptr);
}

TEST(PenLayout, ReadsWacomsMirrorOfTheDigitizerPage) {
  // Application ff0d0002, switches of page ff0d, X and Y on sub-page 1.
  const tests::Report vendor{0x06, 0x0d, 0xff, 0x09, 0x02, 0xa1, 0x01, 0x85, 0x10, 0x09, 0x42, 0x09, 0x32, 0x09,
                             0x36, 0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x08, 0x81, 0x02, 0x0a, 0x30, 0x01,
                             0x0a, 0x31, 0x01, 0x26, 0xff, 0x7f, 0x75, 0x10, 0x95, 0x02, 0x81, 0x02, 0xc0};
  EXPECT_FALSE(find_pens(parsed(vendor), Dialect::standard));
  const auto pens = find_pens(parsed(vendor), Dialect::wacom);
  ASSERT_TRUE(pens);
  EXPECT_TRUE(pens->reports[0].has_sense);
  EXPECT_EQ(pens->axes.y.maximum, 0x7fff);
}

TEST(PenLayout, SerialNumbersOf64BitsComeWhole) {
  // In Range and seven bits of nothing, the serial number, X and Y.
  const tests::Report bytes{0x05, 0x0d, 0x09, 0x02, 0xa1, 0x01, 0x85, 0x02, 0x09, 0x20, 0xa1, 0x00, 0x09, 0x32,
                            0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x01, 0x81, 0x02, 0x95, 0x07, 0x81, 0x03,
                            0x09, 0x5b, 0x75, 0x40, 0x95, 0x01, 0x81, 0x02, 0x05, 0x01, 0x09, 0x30, 0x09, 0x31,
                            0x26, 0xff, 0x7f, 0x75, 0x10, 0x95, 0x02, 0x81, 0x02, 0xc0, 0xc0};
  auto pens = find_pens(parsed(bytes), Dialect::standard);
  ASSERT_TRUE(pens);
  DescriptorDecoder decoder(std::move(*pens));
  const tests::Report report{0x02, 0x01, 0x88, 0x77, 0x66, 0xf5, 0x44, 0x33, 0x22, 0x91, 1, 0, 2, 0};
  ASSERT_EQ(decoder.decode(report), ReportKind::pen);
  EXPECT_EQ(decoder.sample().serial, 0x91223344f5667788u);
  EXPECT_EQ(decoder.sample().y, 2);
}

TEST(PenLayout, AnUndefinedUsageBetweenInvertAndInRangeIsTheSecondButton) {
  tests::Report bytes{0x05, 0x0d, 0x09, 0x02, 0xa1, 0x01, 0x85, 0x02, 0x09, 0x20, 0xa1, 0x00, 0x09, 0x42,
                      0x09, 0x44, 0x09, 0x45, 0x09, 0x3c, 0x09, 0x00, 0x09, 0x32, 0x15, 0x00, 0x25, 0x01,
                      0x75, 0x01, 0x95, 0x06, 0x81, 0x02, 0x95, 0x02, 0x81, 0x03, 0x05, 0x01, 0x09, 0x30,
                      0x09, 0x31, 0x26, 0xff, 0x7f, 0x75, 0x10, 0x95, 0x02, 0x81, 0x02, 0xc0, 0xc0};
  const auto pens = find_pens(parsed(bytes), Dialect::wacom);
  ASSERT_TRUE(pens);
  const auto& controls = pens->reports[0].controls;
  EXPECT_TRUE(std::any_of(controls.begin(), controls.end(), [](const PenControl& control) {
    return control.role == PenRole::barrel2 && control.bit_offset == 12;
  }));
}

// A pen's report: tip, In Range and six bits of nothing; X, Y and pressure of 16 bits.
tests::Report pen_report(std::uint8_t id, std::uint16_t most_xy, std::uint16_t most_pressure,
                         std::uint8_t second_switch = 0x44) {
  const auto low = [](std::uint16_t v) { return static_cast<std::uint8_t>(v & 0xff); };
  const auto high = [](std::uint16_t v) { return static_cast<std::uint8_t>(v >> 8); };
  return {0x05,
          0x0d,
          0x09,
          0x02,
          0xa1,
          0x01,
          0x85,
          id,
          0x09,
          0x20,
          0xa1,
          0x00,
          0x09,
          0x42,
          0x09,
          0x32,
          0x09,
          second_switch,
          0x15,
          0x00,
          0x25,
          0x01,
          0x75,
          0x01,
          0x95,
          0x03,
          0x81,
          0x02,
          0x95,
          0x05,
          0x81,
          0x03,
          0x75,
          0x10,
          0x95,
          0x01,
          0x05,
          0x01,
          0x26,
          low(most_xy),
          high(most_xy),
          0x09,
          0x30,
          0x81,
          0x02,
          0x09,
          0x31,
          0x81,
          0x02,
          0x05,
          0x0d,
          0x26,
          low(most_pressure),
          high(most_pressure),
          0x09,
          0x30,
          0x81,
          0x02,
          0xc0,
          0xc0};
}

TEST(PenLayout, ReportsOfSeveralRangesAreSaidInTheFinest) {
  // The coarse form of Windows Ink stands first.
  tests::Report bytes = pen_report(6, 10000, 1023);
  const tests::Report fine = pen_report(30, 20000, 4095);
  bytes.insert(bytes.end(), fine.begin(), fine.end());
  for (const Dialect dialect : {Dialect::standard, Dialect::wacom}) {
    const auto pens = find_pens(parsed(bytes), dialect);
    ASSERT_TRUE(pens);
    EXPECT_EQ(pens->axes.x.maximum, 20000);
    EXPECT_EQ(pens->axes.pressure.maximum, 4095);
    const auto control = [&](std::size_t report, PenRole role) {
      const auto& all = pens->reports[report].controls;
      return *std::find_if(all.begin(), all.end(), [&](const PenControl& one) { return one.role == role; });
    };
    EXPECT_EQ(control(0, PenRole::x).scaled(5000), 10000);
    EXPECT_EQ(control(0, PenRole::x).scaled(10000), 20000);
    EXPECT_EQ(control(0, PenRole::pressure).scaled(512), 2050) << "512 / 1023 of 4095, to the nearest";
    EXPECT_EQ(control(1, PenRole::x).scaled(19999), 19999);
    EXPECT_EQ(control(1, PenRole::tip).scaled(1), 1);
  }
}

TEST(PenLayout, APenThatNumbersItsContactsIsAPen) {
  // Application Pen, with Contact Identifier (0x51) in place of a second switch: Goodix' panels.
  const auto pens = find_pens(parsed(pen_report(8, 3600, 4095, 0x51)), Dialect::standard);
  ASSERT_TRUE(pens);
  EXPECT_EQ(pens->reports[0].id, 8);
}

TEST(PenLayout, TheSecondaryTipSwitchIsTheSecondButton) {
  const auto pens = find_pens(parsed(pen_report(2, 100, 100, 0x43)), Dialect::standard);
  ASSERT_TRUE(pens);
  const auto& controls = pens->reports[0].controls;
  EXPECT_TRUE(std::any_of(controls.begin(), controls.end(),
                          [](const PenControl& control) { return control.role == PenRole::barrel2; }));
}

}  // namespace
}  // namespace penpose::decode
