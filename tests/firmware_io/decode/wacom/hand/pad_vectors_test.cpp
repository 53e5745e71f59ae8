#include <gtest/gtest.h>
#include <set>
#include <string>
#include <vector>

#include "firmware_io/decode/hand_factory.h"
#include "tests/support/hands/pen_reports.h"

// Reports of keys, rings and dials of vendors' protocols and what they mean, worked out by hand from what the report
// parsers of OpenTabletDriver read; `source` is the parser. Where Linux's drivers know better, it says so.

namespace penpose::decode {
namespace {

struct PadVector {
  std::string protocol;
  std::string source;
  std::vector<std::uint8_t> report;
  std::uint64_t keys = 0;  ///< bit i: key i; the buttons in wheels from bit 20
  int ring = -1;           ///< -1: nothing touches
  int wheel = 0;
  int second_wheel = 0;
};

constexpr std::uint64_t bits(std::initializer_list<int> numbers) {
  std::uint64_t mask = 0;
  for (const int number : numbers) mask |= std::uint64_t{1} << number;
  return mask;
}

std::vector<std::uint8_t> touch64(std::vector<std::uint8_t> begin) {
  begin.resize(64);
  return begin;
}

const std::vector<PadVector>& vectors() {
  static const std::vector<PadVector> all{
      {"xp_pen", "XP_PenReportParser", {0x02, 0xf0, 0x05, 0x80, 0x03}, bits({0, 2, 15, 16, 17})},
      {"xp_pen_offset_pressure", "XP_PenOffsetPressureReportParser", {0x02, 0xf0, 0x00, 0x01, 0x08}, bits({8, 19})},
      {"xp_pen_offset_aux",
       "XP_PenOffsetAuxReportParser",
       {0x02, 0xa0, 0, 0, 0x05, 0x80, 0x03},
       bits({0, 2, 15, 16, 17})},
      {"huion_giano", "GianoReportParser", {0x08, 0xe0, 0x01, 0x01, 0x05, 0x80, 0x03}, bits({0, 2, 15, 16, 17})},
      {"huion_giano", "GianoReportParser, one dial of two", {0x08, 0xf1, 0x01, 0x01, 0x00, 0x01}, 0, -1, 1, 0},
      {"huion_giano", "GianoReportParser, the other", {0x08, 0xf1, 0x01, 0x02, 0x00, 0x02}, 0, -1, 0, -1},
      {"huion_inspiroy", "InspiroyReportParser", {0x08, 0xe0, 0x01, 0x01, 0x22, 0x01, 0x00}, bits({1, 5, 8})},
      {"huion_inspiroy",
       "InspiroyReportParser, group buttons",
       {0x08, 0xe3, 0x01, 0x01, 0x01, 0x00, 0x08},
       bits({0, 19})},
      {"huion_inspiroy", "Linux hid-uclogic: its dial", {0x08, 0xf1, 0x01, 0x01, 0x00, 0x02}, 0, -1, -1},
      {"huion_ring", "HuionWheelReportParser", {0x08, 0xf0, 0x01, 0x01, 0x00, 0x0c}, 0, 11},
      {"uclogic", "UCLogicReportParser", {0x08, 0xe0, 0x01, 0x01, 0x11, 0x00, 0x01}, bits({0, 4, 16})},
      {"uclogic_tilt", "UCLogicTiltReportParser", {0x08, 0xe0, 0x01, 0x01, 0x00, 0x22, 0x00}, bits({9, 13})},
      {"uclogic_v2", "UCLogicV2ReportParser", {0x08, 0xe0, 0x01, 0x01, 0x40, 0x00, 0x04}, bits({6, 18})},
      {"uclogic_v2", "Linux hid-uclogic: its ring", {0x08, 0xf0, 0x01, 0x01, 0x00, 0x03, 0x00}, 0, 2},
      {"veikk", "VeikkReportParser", {0x09, 0x42, 0x01, 0x01, 0x05, 0x08}, bits({0, 2, 11})},
      {"veikk", "VeikkReportParser: all are let go", {0x09, 0x42, 0x01, 0x00, 0x05, 0x08}, 0},
      {"veikk", "VeikkReportParser: its dial", {0x09, 0x42, 0x03, 0x01, 0x01}, 0, -1, -1},
      {"veikk_tilt", "VeikkTiltReportParser", {0x09, 0x42, 0x00, 0x01, 0x80, 0x01}, bits({7, 8})},
      {"veikk_v1", "VeikkV1ReportParser", {0x03, 0x00, 0x3e, 0x00, 0x00, 0x00, 0x00, 0x00}, bits({0})},
      {"acepen", "AcepenReportParser", {0x02, 0x42, 0x00, 0x01, 0x04}, bits({2})},
      {"genius_v2", "GeniusReportParserV2", {0x05, 0x00, 0x00, 0x18}, bits({11})},
      {"xenx", "XENXReportParser", {0x02, 0, 0x01, 0, 0, 0, 0, 0, 0, 0, 0, 0xff}, bits({0, 9})},
      {"generic_keypad", "AuxReportParser", {0x00, 0x00, 0x00, 0x05}, bits({0, 2})},
      {"wacom_intuos_v1", "IntuosV1ReportParser", {0x03, 0, 0, 0, 0x81, 0, 0, 0, 0, 0}, bits({0, 7})},
      {"wacom_intuos_v2", "IntuosV2ReportParser", {0x11, 0x05, 0x00, 0x01, 0x85}, bits({0, 2, 20}), 5},
      {"wacom_intuos_v3", "IntuosV3ReportParser", {0x11, 0x81, 0x00, 0x02, 0x7f, 0x02}, bits({0, 8, 9}), -1, -1, 2},
      {"wacom_intuos3", "Intuos3ReportParser", {0x0c, 0, 0, 0, 0, 0x05, 0x08, 0, 0, 0}, bits({0, 2, 7})},
      {"wacom_intuos4", "Intuos4ReportParser", {0x0c, 0x85, 0x01, 0x81, 0, 0, 0, 0, 0, 0}, bits({0, 7, 20}), 5},
      {"wacom_intuos_pro", "IntuosProReportParser", {0x03, 0, 0xc7, 0x00, 0x81, 0, 0, 0, 0, 0}, bits({0, 7}), 71},
      {"wacom_cintiq_v1",
       "CintiqV1ReportParser; the keys numbered as Linux does",
       {0x0c, 0, 0, 0, 0, 0x01, 0x80, 0x01, 0x01, 0x02},
       bits({0, 8, 9, 10, 19})},
      {"wacom_bamboo", "BambooReportParser", {0x02, 0, 0, 0, 0, 0, 0, 0x28}, bits({0, 2})},
      {"wacom_graphire", "GraphireReportParser", {0x02, 0, 0, 0, 0, 0, 0, 0x80}, bits({1})},
      {"wacom_touch64", "Wacom64bAuxReportParser", touch64({0x02, 0x01, 0x80, 0x05}), bits({0, 2})},
  };
  return all;
}

TEST(PadVectors, EveryReportMeansWhatItsSourceReads) {
  std::set<std::string> protocols;
  for (const PadVector& one : vectors()) {
    SCOPED_TRACE(one.protocol + ": " + one.source);
    protocols.insert(one.protocol);
    const auto hand = make_protocol_hand_decoders(one.protocol);
    ASSERT_NE(hand.pad, nullptr);
    ASSERT_TRUE(hand.pad->decode(one.report));
    const PadSample& sample = hand.pad->sample();
    EXPECT_EQ(key_names(sample.keys), key_names(numbered_keys(one.keys, k_numbered_keys)));
    EXPECT_EQ(sample.ring_touched[0] ? sample.ring[0] : -1, one.ring);
    EXPECT_EQ(sample.wheel[0], one.wheel);
    EXPECT_EQ(sample.wheel[1], one.second_wheel);
  }
  EXPECT_GE(protocols.size(), 20U);
}

TEST(PadVectors, KeysThatComeOneByOneAddUp) {
  const auto hand = make_protocol_hand_decoders("acepen");
  const auto after = [&](std::uint8_t down, std::uint8_t key) {
    EXPECT_TRUE(hand.pad->decode(tests::Report{0x02, 0x42, 0x00, down, key}));
    return key_names(hand.pad->sample().keys);
  };
  EXPECT_EQ(after(1, 0x04), "BTN_2");
  EXPECT_EQ(after(1, 0x01), "BTN_0+BTN_2");
  EXPECT_EQ(after(0, 0x04), "BTN_0");
  EXPECT_EQ(after(1, 0x00), "BTN_0") << "no key";
}

}  // namespace
}  // namespace penpose::decode
