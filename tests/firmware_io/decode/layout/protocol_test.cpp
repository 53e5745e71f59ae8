#include "firmware_io/decode/layout/protocol.h"

#include <gtest/gtest.h>
#include <initializer_list>
#include <vector>

namespace penpose::decode {
namespace {

using Report = std::vector<std::uint8_t>;

Report bytes_of(std::initializer_list<int> values) {
  Report bytes;
  for (const int value : values) bytes.push_back(static_cast<std::uint8_t>(value));
  return bytes;
}

ReportKind feed(PenDecoder& decoder, std::initializer_list<int> bytes) { return decoder.decode(bytes_of(bytes)); }

TEST(Protocol, AllAreThere) {
  EXPECT_EQ(protocol_names().size(), 59U);
  for (const auto& name : protocol_names()) EXPECT_NE(make_protocol_decoder(name), nullptr) << name;
  EXPECT_EQ(make_protocol_decoder("nobody"), nullptr);
}

TEST(Protocol, BothFirmwaresOfAKamvasOfTheThirdGenerationAreToldByTheirReports) {
  // x 0x12345, y 0x4567, pressure 0x0d23: with the third byte of x behind the others, and behind the pressure.
  const auto expect_pen = [](const PenDecoder& decoder) {
    EXPECT_EQ(decoder.sample().x, 0x12345);
    EXPECT_EQ(decoder.sample().y, 0x4567);
    EXPECT_EQ(decoder.sample().pressure, 0x0d23);
    EXPECT_EQ(decoder.sample().tilt_x, -12);
    EXPECT_EQ(decoder.sample().tilt_y, 4);
  };
  const auto later = make_protocol_decoder("huion_kamvas");
  ASSERT_EQ(feed(*later, {8, 0x81, 0x45, 0x23, 1, 0x67, 0x45, 0x23, 0x0d, 0, 12, 0xfc, 3, 0}), ReportKind::pen);
  expect_pen(*later);
  const auto earlier = make_protocol_decoder("huion_kamvas");
  ASSERT_EQ(feed(*earlier, {8, 0x81, 0x45, 0x23, 0x67, 0x45, 0x23, 0x0d, 1, 0, 12, 0xfc, 3, 0}), ReportKind::pen);
  expect_pen(*earlier);
  // A report that either may send is read as the ones before it.
  ASSERT_EQ(feed(*earlier, {8, 0x81, 0x45, 0x23, 0, 0x45, 0x23, 0x0d, 1, 0, 12, 0xfc, 3, 0}), ReportKind::pen);
  EXPECT_EQ(earlier->sample().y, 0x4500);
  EXPECT_EQ(earlier->sample().pressure, 0x0d23);
  earlier->reset();
  ASSERT_EQ(feed(*earlier, {8, 0x81, 0x45, 0x23, 1, 0x67, 0x45, 0x23, 0x0d, 0, 12, 0xfc, 3, 0}), ReportKind::pen);
  expect_pen(*earlier);
}

TEST(Protocol, TenMoonsPressureFallsWhereOthersRise) {
  const auto decoder = make_protocol_decoder("ten_moons");
  ASSERT_EQ(feed(*decoder, {6, 0x0a, 0x10, 0x03, 0x20, 0x05, 0x72, 0, 0, 0, 0, 0xff, 0x33}), ReportKind::pen);
  EXPECT_EQ(decoder->sample().x, 0x0a10);
  EXPECT_EQ(decoder->sample().y, 0x0320);
  EXPECT_EQ(decoder->sample().pressure, 0x672 - 0x572);
  ASSERT_EQ(feed(*decoder, {6, 0, 1, 0xff, 0xf0, 0x07, 0x00, 0, 0, 6, 0, 0xff, 0x33}), ReportKind::pen);
  EXPECT_EQ(decoder->sample().y, 0) << "above the area";
  EXPECT_EQ(decoder->sample().pressure, 0);
  EXPECT_FALSE(decoder->sample().tip);
  EXPECT_EQ(decoder->sample().buttons, 3U);
  ASSERT_EQ(feed(*decoder, {6, 0, 1, 0, 0, 7, 0, 0, 0, 0, 0, 0x7f, 0x33}), ReportKind::pad);
  EXPECT_EQ(decoder->pad().keys, 1U << 1);
  ASSERT_EQ(feed(*decoder, {6, 0, 1, 0, 0, 7, 0, 0, 0, 0, 0, 0xfb, 0x33}), ReportKind::pad);
  EXPECT_EQ(decoder->pad().keys, 1U << 11);
  ASSERT_EQ(feed(*decoder, {6, 0, 1, 0, 0, 7, 0, 0, 0, 0, 0, 0xfe, 0x13}), ReportKind::pad);
  EXPECT_EQ(decoder->pad().keys, 1U << 8);
}

TEST(Protocol, ASecondButtonThatComesAsATouchWithoutPressureIsAButton) {
  const auto decoder = make_protocol_decoder("waltop");
  ASSERT_EQ(feed(*decoder, {16, 0x13, 1, 0, 2, 0, 0, 0, 0, 0}), ReportKind::pen);
  EXPECT_FALSE(decoder->sample().tip);
  EXPECT_EQ(decoder->sample().buttons, 2U);
  ASSERT_EQ(feed(*decoder, {16, 0x13, 1, 0, 2, 0, 9, 0, 0, 0}), ReportKind::pen);
  EXPECT_TRUE(decoder->sample().tip);
  EXPECT_EQ(decoder->sample().buttons, 1U);
  ASSERT_EQ(feed(*decoder, {16, 0, 1, 0, 2, 0, 0, 0, 0, 0}), ReportKind::pen);
  EXPECT_FALSE(decoder->sample().in_range);
}

TEST(Protocol, WheelsOfXpPenAndItsKin) {
  const auto steps = [](const char* name, std::initializer_list<int> report) {
    const auto decoder = make_protocol_decoder(name);
    EXPECT_EQ(feed(*decoder, report), ReportKind::pad) << name;
    return decoder->pad().wheel_delta;
  };
  for (const char* name : {"xp_pen", "xp_pen_offset_pressure", "xp_pen_gen2", "xp_pen_remote"}) {
    EXPECT_EQ(steps(name, {2, 0xf0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0}), 1) << name;
    EXPECT_EQ(steps(name, {2, 0xf0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0}), -1) << name;
  }
  EXPECT_EQ(steps("parblo_intangbo", {2, 0xf0, 8, 1, 0, 0, 0, 0}), 1);
  const auto parblo = make_protocol_decoder("parblo_intangbo");
  ASSERT_EQ(feed(*parblo, {2, 0xf0, 8, 0, 0, 0, 0, 0}), ReportKind::pad);
  EXPECT_EQ(parblo->pad().keys, 1U << 3);
}

TEST(Protocol, ReportsOfAnyLengthAreTaken) {
  for (const auto& name : protocol_names()) {
    const auto decoder = make_protocol_decoder(name);
    std::uint32_t noise = 12345;
    for (std::size_t length = 0; length < 1200; length += length < 80 ? 1 : 97) {
      for (int round = 0; round < 40; ++round) {
        Report report(length);
        for (auto& byte : report) {
          noise = noise * 1664525 + 1013904223;
          byte = static_cast<std::uint8_t>(noise >> 24);
        }
        decoder->decode(report);
        const auto& sample = decoder->sample();
        ASSERT_EQ(sample.in_range, sample.tool != Tool::none) << name;
        ASSERT_TRUE(sample.in_range || !sample.tip) << name;
      }
    }
  }
}

TEST(Protocol, LeavingEndsThePen) {
  const auto check = [](const char* protocol, std::initializer_list<int> pen, std::initializer_list<int> leave) {
    const auto decoder = make_protocol_decoder(protocol);
    EXPECT_EQ(feed(*decoder, pen), ReportKind::pen) << protocol;
    EXPECT_TRUE(decoder->sample().in_range) << protocol;
    EXPECT_EQ(feed(*decoder, leave), ReportKind::pen) << protocol;
    EXPECT_FALSE(decoder->sample().in_range) << protocol;
    EXPECT_FALSE(decoder->sample().tip) << protocol;
  };
  check("uclogic", {8, 0x81, 1, 0, 1, 0, 9, 9}, {8, 0xc0, 0, 0, 0, 0, 0, 0});
  check("uclogic_v1", {7, 0x41, 1, 0, 1, 0, 9, 9}, {7, 0x00});
  check("uclogic_v2", {8, 0x81, 1, 0, 1, 0, 9, 9, 0, 0, 0, 0}, {8, 0xc0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  check("huion_giano", {8, 0x81, 1, 0, 1, 0, 9, 9, 0, 0, 0, 0}, {8, 0x00, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  check("huion_inspiroy", {8, 0x81, 1, 0, 1, 0, 9, 9, 0, 0, 0, 0}, {8, 0x00});
  check("xp_pen", {2, 0xa1, 1, 0, 1, 0, 9, 9}, {2, 0xc0});
  check("xencelabs", {2, 0x21, 1, 0, 1, 0, 9, 9, 0, 0}, {2, 0x00});
  check("veikk", {9, 0x41, 0xa0, 1, 0, 0, 1, 0, 0, 1, 1}, {9, 0x41, 0xc0});
  check("robotpen", {2, 0x42, 0, 0, 0, 0, 1, 1, 1, 1, 1, 0}, {2, 0x40});
  check("wacom_intuos", {2, 0xe1, 1, 0, 1, 0, 9, 9}, {2, 0x80});
  check("wacom_pl", {2, 0xe0, 1, 1, 0x08, 1, 1, 0}, {2, 0x80});
}

TEST(Protocol, KeysAndWheels) {
  auto decoder = make_protocol_decoder("huion_ring");
  EXPECT_EQ(feed(*decoder, {8, 0xe0, 1, 1, 0x01, 0x30, 0x08}), ReportKind::pad);
  EXPECT_EQ(decoder->pad().keys, 1U | 1U << 12 | 1U << 18);
  EXPECT_EQ(decoder->pad().wheel_buttons, 1U);
  feed(*decoder, {8, 0xf0, 1, 1, 0, 12});
  EXPECT_EQ(decoder->pad().wheel_position, 11);
  feed(*decoder, {8, 0xf0, 1, 1, 0, 0});
  EXPECT_EQ(decoder->pad().wheel_position, -1);

  decoder = make_protocol_decoder("wacom_intuos_v3");
  EXPECT_EQ(feed(*decoder, {0x11, 0xf0, 0, 0x01, 0x7f, 0x02}), ReportKind::pad);
  EXPECT_EQ(decoder->pad().keys, 0x1f0U);
  EXPECT_EQ(decoder->pad().wheel_delta, -1);
  EXPECT_EQ(decoder->pad().second_wheel_delta, 2);

  decoder = make_protocol_decoder("veikk_v1");
  EXPECT_EQ(feed(*decoder, {0x03, 0x00, 0x19, 0x3e}), ReportKind::pad);
  EXPECT_EQ(decoder->pad().keys, 1U | 1U << 3);
  feed(*decoder, {0x03, 0x01, 0x19});
  EXPECT_EQ(decoder->pad().keys, 1U << 5);

  decoder = make_protocol_decoder("genius_v2");
  feed(*decoder, {0x05, 0, 0, 24});
  EXPECT_EQ(decoder->pad().keys, 1U << 11);
  feed(*decoder, {0x05, 0, 0, 0});
  EXPECT_EQ(decoder->pad().keys, 0U);

  decoder = make_protocol_decoder("wacom_touch64");
  Report touch(64, 0);
  touch[1] = 2;
  touch[2] = 0x02;
  touch[10] = 0x80;
  touch[11] = 0x0a;
  EXPECT_EQ(decoder->decode(touch), ReportKind::pad);
  EXPECT_EQ(decoder->pad().keys, 0x0aU);
  touch[10] = 0x03;
  EXPECT_EQ(decoder->decode(touch), ReportKind::ignored);

  // A pen report of these may carry keys as well.
  decoder = make_protocol_decoder("wacom_bamboo");
  EXPECT_EQ(feed(*decoder, {0x02, 0x80, 1, 0, 1, 0, 0, 0x28}), ReportKind::pen);
  EXPECT_EQ(decoder->pad().keys, 0b101U);
}

TEST(Protocol, WacomToolCarriesEraserSerialAndId) {
  const auto decoder = make_protocol_decoder("wacom_intuos4");
  EXPECT_EQ(feed(*decoder, {0x02, 0xc2, 0x80, 0xa1, 0x23, 0x45, 0x67, 0x81, 0x10, 0x00}), ReportKind::ignored);
  EXPECT_FALSE(decoder->sample().in_range);
  feed(*decoder, {0x02, 0xe0, 1, 2, 3, 4, 0, 0, 0, 0});
  EXPECT_EQ(decoder->sample().tool, Tool::eraser);
  EXPECT_EQ(decoder->sample().serial, 0x12345678U);
  EXPECT_EQ(decoder->sample().tool_id, 0x11080aU);
  feed(*decoder, {0x02, 0x80});
  EXPECT_FALSE(decoder->sample().in_range);
  feed(*decoder, {0x02, 0xe0, 1, 2, 3, 4, 0, 0, 0, 0});
  EXPECT_EQ(decoder->sample().tool, Tool::pen);
  EXPECT_EQ(decoder->sample().serial, 0U);
}

TEST(Protocol, WacomSecondPacketsKeepWhatTheyLack) {
  const auto decoder = make_protocol_decoder("wacom_intuos_v1");
  feed(*decoder, {0x02, 0xe4, 1, 0xf4, 3, 0xe8, 0x57, 0x80 | 38, 0x1e, 0});
  feed(*decoder, {0x02, 0xea, 0, 5, 0, 6, 0x7d, 0xa0, 0, 0x40});
  EXPECT_EQ(decoder->sample().x, 10);
  EXPECT_EQ(decoder->sample().y, 12);
  EXPECT_EQ(decoder->sample().rotation, -848);
  EXPECT_EQ(decoder->sample().pressure, 700);
  EXPECT_EQ(decoder->sample().tilt_x, 12);
  EXPECT_EQ(decoder->sample().tilt_y, -34);
  EXPECT_EQ(decoder->sample().buttons, 2U);
  EXPECT_EQ(decoder->sample().distance, 16);
  feed(*decoder, {0x02, 0xf4, 0, 5, 0, 6, 0xff, 0xc0 | 32, 0x00 | 64, 0});
  EXPECT_EQ(decoder->sample().wheel, 1023);
  EXPECT_EQ(decoder->sample().pressure, 700);
  EXPECT_EQ(decoder->sample().tilt_x, 0);
  EXPECT_EQ(decoder->sample().tilt_y, 0);
  EXPECT_EQ(feed(*decoder, {0x02, 0x21, 0, 5, 0, 6, 0, 0, 0, 0}), ReportKind::ignored);
}

TEST(Protocol, MiceAreMice) {
  auto decoder = make_protocol_decoder("wacom_intuos3");
  EXPECT_EQ(feed(*decoder, {0x02, 0xf0, 0, 5, 0, 6, 0, 0, 0x15, 0}), ReportKind::pen);
  EXPECT_EQ(decoder->sample().tool, Tool::mouse);
  EXPECT_EQ(decoder->sample().buttons, 0b11U);
  EXPECT_EQ(decoder->sample().wheel, 1);
  EXPECT_FALSE(decoder->sample().tip);
  decoder = make_protocol_decoder("genius");
  feed(*decoder, {0x11, 0x05, 1, 2, 3, 4, 0xff});
  EXPECT_EQ(decoder->sample().tool, Tool::mouse);
  EXPECT_EQ(decoder->sample().x, 0x201);
  EXPECT_EQ(decoder->sample().wheel, -1);
}

}  // namespace
}  // namespace penpose::decode
