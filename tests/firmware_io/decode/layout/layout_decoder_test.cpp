#include "firmware_io/decode/layout/layout_decoder.h"

#include <gtest/gtest.h>
#include <initializer_list>
#include <vector>

#include "firmware_io/decode/layout/layout_reader.h"

namespace penpose::decode {
namespace {

/// A decoder of the one protocol whose rules are given.
std::unique_ptr<LayoutDecoder> decoder_of(const std::string& rules) {
  const auto tree = parse_json(R"({"protocols": {"p": {"shortest": 1, "tip_above": 10, "rules": )" + rules + "}}}");
  EXPECT_TRUE(tree.ok());
  base::Error error;
  const auto protocols = read_protocols(JsonPlace(*tree, error));
  EXPECT_EQ(error.what, "");
  return std::make_unique<LayoutDecoder>(protocols.at("p"));
}

ReportKind decode(PenDecoder& decoder, std::initializer_list<int> bytes) {
  std::vector<std::uint8_t> report;
  for (const int byte : bytes) report.push_back(static_cast<std::uint8_t>(byte));
  return decoder.decode(report);
}

TEST(LayoutDecoder, TipIsABitOrAPressure) {
  const auto bit = decoder_of(R"([{"gives": "pen", "pressure": "1", "tip": "0.0"}])");
  decode(*bit, {1, 0});
  EXPECT_TRUE(bit->sample().tip);
  decode(*bit, {0, 200});
  EXPECT_FALSE(bit->sample().tip);
  const auto pressure = decoder_of(R"([{"gives": "pen", "pressure": "1"}])");
  decode(*pressure, {0, 10});
  EXPECT_FALSE(pressure->sample().tip);
  decode(*pressure, {0, 11});
  EXPECT_TRUE(pressure->sample().tip);
}

TEST(LayoutDecoder, ReportsTooShortChangeNothing) {
  const auto decoder = decoder_of(R"([{"when": "0=01", "gives": "pen", "x": "1 2"}, {"gives": "leave"}])");
  decode(*decoder, {1, 5, 6});
  const auto before = decoder->sample();
  EXPECT_EQ(decode(*decoder, {1, 9}), ReportKind::ignored);
  EXPECT_EQ(decode(*decoder, {}), ReportKind::ignored);
  EXPECT_EQ(decoder->sample(), before);
  EXPECT_EQ(decode(*decoder, {2}), ReportKind::pen);
  EXPECT_FALSE(decoder->sample().in_range);
  EXPECT_EQ(decoder->sample().x, 0x605);
}

TEST(LayoutDecoder, NearDecidesWhetherThereIsATool) {
  const auto decoder = decoder_of(R"([{"gives": "pen", "x": "1", "tip": "0.0", "near": "0.7", "buttons": "0.1-2"}])");
  decode(*decoder, {0x83, 7});
  EXPECT_EQ(decoder->sample().tool, Tool::pen);
  EXPECT_TRUE(decoder->sample().tip);
  EXPECT_EQ(decoder->sample().buttons, 1U);
  decode(*decoder, {0x03, 8});
  EXPECT_EQ(decoder->sample().tool, Tool::none);
  EXPECT_FALSE(decoder->sample().in_range);
  EXPECT_FALSE(decoder->sample().tip);
  EXPECT_EQ(decoder->sample().buttons, 0U);
  EXPECT_EQ(decoder->sample().x, 8);
}

TEST(LayoutDecoder, EraserButtonIsDecidedOnEntering) {
  const auto decoder =
      decoder_of(R"([{"when": "!0.0", "gives": "leave"}, {"gives": "pen", "buttons": "1.0-1", "eraser_button": 2}])");
  decode(*decoder, {1, 2});
  EXPECT_EQ(decoder->sample().tool, Tool::eraser);
  EXPECT_EQ(decoder->sample().buttons, 0U);
  decode(*decoder, {0, 0});
  decode(*decoder, {1, 0});
  EXPECT_EQ(decoder->sample().tool, Tool::pen);
  decode(*decoder, {1, 3});
  EXPECT_EQ(decoder->sample().tool, Tool::pen);
  EXPECT_EQ(decoder->sample().buttons, 3U);
  decoder->reset();
  decode(*decoder, {1, 2});
  EXPECT_EQ(decoder->sample().tool, Tool::eraser);
}

TEST(LayoutDecoder, KeysComeAndGoOneAtATime) {
  const auto decoder = decoder_of(R"([{"gives": "pad", "key_changed": "0", "key_down": "1.0"}])");
  decode(*decoder, {0x01, 1});
  decode(*decoder, {0x08, 1});
  EXPECT_EQ(decoder->pad().keys, 0x09U);
  decode(*decoder, {0x00, 0});
  EXPECT_EQ(decoder->pad().keys, 0x09U);
  decode(*decoder, {0x01, 0});
  EXPECT_EQ(decoder->pad().keys, 0x08U);
}

TEST(LayoutDecoder, WheelsRingAndDials) {
  const auto decoder = decoder_of(R"([{"gives": "pad", "ring": "0.0-6 if 0.7", "wheel_buttons": "1.0",
    "dial": {"forward": "1.4", "backward": "1.5"}, "second_dial": "2 signed"}])");
  EXPECT_EQ(decode(*decoder, {0x85, 0x11, 0xff}), ReportKind::pad);
  EXPECT_EQ(decoder->pad().wheel_position, 5);
  EXPECT_EQ(decoder->pad().wheel_buttons, 1U);
  EXPECT_EQ(decoder->pad().wheel_delta, 1);
  EXPECT_EQ(decoder->pad().second_wheel_delta, -1);
  decode(*decoder, {0x05, 0x20, 0x00});
  EXPECT_EQ(decoder->pad().wheel_position, -1);
  EXPECT_EQ(decoder->pad().wheel_delta, -1);
}

TEST(LayoutDecoder, AxesAreThoseOfTheLayouts) {
  const auto decoder = decoder_of(R"([{"gives": "pen", "x": "1", "y": "2", "tilt_x": "3"}])");
  EXPECT_TRUE(decoder->axes().x.present);
  EXPECT_TRUE(decoder->axes().tilt_x.present);
  EXPECT_FALSE(decoder->axes().tilt_y.present);
  EXPECT_FALSE(decoder->axes().pressure.present);
  EXPECT_FALSE(decoder->axes().distance.present);
}

}  // namespace
}  // namespace penpose::decode
