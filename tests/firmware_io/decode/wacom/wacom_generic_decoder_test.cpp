#include "firmware_io/decode/wacom/wacom_generic_decoder.h"

#include <gtest/gtest.h>

#include "tests/support/hands/pen_reports.h"

namespace penpose::decode {
namespace {

void append(tests::Report& to, const tests::Report& bytes) {
  for (const std::uint8_t byte : bytes) to.push_back(byte);
}

// One frame: tip, barrel, barrel2, invert, in range, sense, two bits of padding; X, Y, pressure of 16 bits.
tests::Report frame_items(bool with_valid_bit = false) {
  tests::Report items;
  if (with_valid_bit) items = {0x0a, 0xd0, 0x01};
  for (const int usage : {0x42, 0x44, 0x5a, 0x3c, 0x32, 0x36}) {
    items.push_back(0x09);
    items.push_back(static_cast<std::uint8_t>(usage));
  }
  const std::uint8_t bits = with_valid_bit ? 7 : 6;
  const auto padding = static_cast<std::uint8_t>(8 - bits);
  append(items, {0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, bits, 0x81, 0x02, 0x95, padding, 0x81, 0x03});
  append(items, {0x75, 0x10, 0x95, 0x01, 0x26, 0x10, 0x27, 0x0a, 0x30, 0x01, 0x81, 0x02,
                 0x0a, 0x31, 0x01, 0x81, 0x02, 0x26, 0xff, 0x1f, 0x09, 0x30, 0x81, 0x02});
  return items;
}

tests::Report descriptor_of(const std::vector<tests::Report>& parts) {
  tests::Report bytes{0x06, 0x0d, 0xff, 0x09, 0x02, 0xa1, 0x01, 0x85, 0x10};
  for (const auto& part : parts) append(bytes, part);
  bytes.push_back(0xc0);
  return bytes;
}

WacomGenericDecoder decoder_for(const tests::Report& descriptor) {
  const auto parsed = hid::parse_report_descriptor(descriptor);
  EXPECT_TRUE(parsed.ok()) << (parsed ? "" : parsed.error().line());
  return WacomGenericDecoder(*find_pens(*parsed, Dialect::wacom));
}

constexpr std::uint8_t k_tip = 1, k_barrel = 2, k_barrel2 = 4, k_invert = 8, k_in_range = 16, k_sense = 32;

tests::Report frame(std::uint8_t state, std::int32_t x, std::int32_t y, std::int32_t pressure) {
  return {0x10,          state,          tests::low(x),        tests::high(x),
          tests::low(y), tests::high(y), tests::low(pressure), tests::high(pressure)};
}

TEST(WacomGenericDecoder, SenseKeepsAPenThatHasNoPosition) {
  auto decoder = decoder_for(descriptor_of({frame_items()}));
  EXPECT_EQ(decoder.decode(frame(0, 0, 0, 0)), ReportKind::ignored);
  ASSERT_EQ(decoder.decode(frame(k_sense | k_in_range | k_tip, 100, 200, 300)), ReportKind::pen);
  EXPECT_TRUE(decoder.sample().tip);
  ASSERT_EQ(decoder.decode(frame(k_sense, 9, 9, 9)), ReportKind::pen);
  EXPECT_TRUE(decoder.sample().in_range);
  EXPECT_EQ(decoder.sample().x, 100);
  EXPECT_FALSE(decoder.sample().tip);
  ASSERT_EQ(decoder.decode(frame(0, 0, 0, 0)), ReportKind::pen);
  EXPECT_FALSE(decoder.sample().in_range);
  EXPECT_EQ(decoder.decode(frame(0, 0, 0, 0)), ReportKind::ignored);
}

TEST(WacomGenericDecoder, TheToolIsSettledOnEntering) {
  auto decoder = decoder_for(descriptor_of({frame_items()}));
  decoder.decode(frame(k_sense | k_in_range | k_invert, 1, 1, 0));
  EXPECT_EQ(decoder.sample().tool, Tool::eraser);
  decoder.decode(frame(k_sense | k_in_range, 1, 1, 0));
  EXPECT_EQ(decoder.sample().tool, Tool::eraser);
  decoder.decode(frame(0, 0, 0, 0));
  decoder.decode(frame(k_sense | k_in_range, 1, 1, 0));
  EXPECT_EQ(decoder.sample().tool, Tool::pen);
}

TEST(WacomGenericDecoder, OnlyArtPensSenseTheirRotationAQuarterTurnOff) {
  // Behind the frame: rotation of -900 to 899, then the tool's number (0x77), both of 16 bits.
  tests::Report items = frame_items();
  append(items, {0x16, 0x7c, 0xfc, 0x26, 0x83, 0x03, 0x75, 0x10, 0x95, 0x01, 0x09, 0x41,
                 0x81, 0x02, 0x15, 0x00, 0x26, 0xff, 0x7f, 0x09, 0x77, 0x81, 0x02});
  const auto rotated = [&](std::uint32_t tool, std::int32_t raw) {
    auto decoder = decoder_for(descriptor_of({items}));
    tests::Report report = frame(k_sense | k_in_range, 1, 1, 0);
    for (const std::int32_t word : {raw, static_cast<std::int32_t>(tool)}) {
      report.push_back(tests::low(word));
      report.push_back(tests::high(word));
    }
    EXPECT_EQ(decoder.decode(report), ReportKind::pen);
    EXPECT_EQ(decoder.sample().tool_id, tool);
    return decoder.sample().rotation;
  };
  for (const std::uint32_t art_pen : {0x204u, 0x804u, 0x885u}) {
    EXPECT_EQ(rotated(art_pen, -900), -450);
    EXPECT_EQ(rotated(art_pen, 0), 450);
    EXPECT_EQ(rotated(art_pen, 899), -451);
  }
  EXPECT_EQ(rotated(0x802, 300), 0);
}

TEST(WacomGenericDecoder, ElectrostaticPensTellTheirNumbersInFieldsOfTheTouchPage) {
  // 0xff00005b of 16 bits is the tool, the serial number follows with 32 and 8 bits; logical ranges of 0 to 1 are
  // wrong.
  tests::Report items = frame_items();
  append(items, {0x15, 0x00, 0x25, 0x01, 0x06, 0x00, 0xff, 0x09, 0x5b, 0x75, 0x10, 0x95, 0x01, 0x81, 0x02, 0x05,
                 0x0d, 0x09, 0x5b, 0x75, 0x20, 0x81, 0x02, 0x06, 0x00, 0xff, 0x09, 0x00, 0x75, 0x08, 0x81, 0x02});
  auto decoder = decoder_for(descriptor_of({items}));
  tests::Report report = frame(k_sense | k_in_range, 5, 6, 7);
  append(report, {0xf6, 0x67, 0x78, 0x56, 0x34, 0x92, 0x0b});
  ASSERT_EQ(decoder.decode(report), ReportKind::pen);
  EXPECT_EQ(decoder.sample().tool, Tool::pen);  // whatever the number's bits say
  EXPECT_EQ(decoder.sample().tool_id, 0x67f6u);
  EXPECT_EQ(decoder.sample().serial, 0x0b92345678u);
}

TEST(WacomGenericDecoder, BothBarrelSwitchesAreTheThirdButtonOfPensWithALongSerial) {
  // Serial Hi (0x5c), 32 bits behind the frame.
  const tests::Report serial_high{0x75, 0x20, 0x95, 0x01, 0x27, 0xff, 0xff, 0xff, 0x7f, 0x09, 0x5c, 0x81, 0x02};
  for (const bool long_serial : {false, true}) {
    tests::Report items = frame_items();
    if (long_serial) append(items, serial_high);
    auto decoder = decoder_for(descriptor_of({items}));
    const auto buttons = [&](std::uint8_t switches) {
      tests::Report report = frame(static_cast<std::uint8_t>(k_sense | k_in_range | switches), 1, 1, 0);
      if (long_serial) append(report, {1, 0, 0, 0});
      decoder.decode(report);
      return decoder.sample().buttons;
    };
    EXPECT_EQ(buttons(k_barrel), 1u);
    EXPECT_EQ(buttons(k_barrel2), 2u);
    EXPECT_EQ(buttons(k_barrel | k_barrel2), long_serial ? 4u : 3u) << long_serial;
  }
}

TEST(WacomGenericDecoder, ValuesOutsideOfTheRangeAreNoValues) {
  auto decoder = decoder_for(descriptor_of({frame_items()}));
  decoder.decode(frame(k_sense | k_in_range, 100, 200, 0));
  decoder.decode(frame(k_sense | k_in_range, 10001, 201, 0));
  EXPECT_EQ(decoder.sample().x, 100);
  EXPECT_EQ(decoder.sample().y, 201);
}

TEST(WacomGenericDecoder, EveryValidFrameOfAReportIsASample) {
  tests::Report part{0x09, 0x20, 0xa1, 0x00};
  const tests::Report items = frame_items(true);
  append(part, items);
  part.push_back(0xc0);
  auto decoder = decoder_for(descriptor_of({part, part, part}));
  tests::Report report{0x10};
  const auto add = [&](std::uint8_t state, std::int32_t x) {
    const tests::Report one = frame(state, x, x + 1, 0);
    for (std::size_t i = 1; i < one.size(); ++i) report.push_back(one[i]);
  };
  const auto near = static_cast<std::uint8_t>((k_sense | k_in_range) << 1);
  add(near | 1, 10);
  add(near | 1, 20);
  add(near, 30);
  ASSERT_EQ(decoder.decode(report), ReportKind::pen);
  ASSERT_EQ(decoder.frames().size(), 2u);
  EXPECT_EQ(decoder.frames()[0].x, 10);
  EXPECT_EQ(decoder.frames()[1].x, 20);
  EXPECT_EQ(decoder.sample().y, 21);
}

TEST(WacomGenericDecoder, WaitsForThePenToSayWhoItIs) {
  // Serial of 32 bits, its upper part, and a tool number of 16 bits.
  const tests::Report numbers{0x27, 0xff, 0xff, 0xff, 0x7f, 0x75, 0x20, 0x09, 0x5b, 0x81, 0x02, 0x09, 0x5c,
                              0x81, 0x02, 0x27, 0xff, 0xff, 0x00, 0x00, 0x75, 0x10, 0x09, 0x77, 0x81, 0x02};
  auto decoder = decoder_for(descriptor_of({frame_items(), numbers}));
  const auto report = [&](std::uint8_t state, std::uint8_t serial, std::uint8_t kind, std::int32_t tool) {
    tests::Report whole = frame(state, 5, 6, 0);
    append(whole, {serial, 0, 0, 0, 1, 0, kind, 0, tests::low(tool), tests::high(tool)});
    return whole;
  };
  tests::Report unknown = frame(k_sense | k_in_range, 5, 6, 0);
  unknown.resize(18);
  EXPECT_EQ(decoder.decode(unknown), ReportKind::ignored);
  // Upper part 0x00100001: the mark of electromagnetic pens and tool number bits.
  ASSERT_EQ(decoder.decode(report(k_sense | k_in_range, 0x2a, 0x10, 0x080a)), ReportKind::pen);
  EXPECT_EQ(decoder.sample().tool, Tool::eraser);
  EXPECT_EQ(decoder.sample().serial, 0x001000010000002aull);
}

TEST(WacomGenericDecoder, ResetForgetsEverything) {
  auto decoder = decoder_for(descriptor_of({frame_items()}));
  decoder.decode(frame(k_sense | k_in_range | k_invert | k_tip, 1, 1, 9));
  decoder.reset();
  EXPECT_EQ(decoder.sample(), PenSample{});
  decoder.decode(frame(k_sense | k_in_range, 1, 1, 0));
  EXPECT_EQ(decoder.sample().tool, Tool::pen);
}

}  // namespace
}  // namespace penpose::decode
