#include "firmware_io/decode/table/tablet_reader.h"

#include <gtest/gtest.h>

namespace penpose::decode {
namespace {

/// A tablet file with `members` put into its one tablet and `identifier` into its one identifier.
std::string file_with(const std::string& members = "", const std::string& identifier = R"("protocol": "xp_pen")") {
  return R"({"penpose_tablets": 1, "tablets": [{"vendor": "V", "name": "N", "size_mm": [100, 50], "max": [1000, 500],
    "max_pressure": 8191, )" +
         members + R"("identifiers": [{"id": "1234:abcd", )" + identifier + "}]}]}";
}

TEST(TabletReader, WholeTablet) {
  const auto table = read_tablet_file(file_with(
      R"("pen_buttons": 2, "pad_keys": 8, "mouse_buttons": 3, "hide_from_desktop": true, "feature_delay_ms": 150,
         "wheels": [{"kind": "ring", "steps": 71, "zero_degrees": 90, "buttons": 1}],
         "pads": [{"id": "1234:abce", "input": 64, "protocol": "wacom_touch64"}], )",
      R"("input": 12, "output": 8, "feature": 0, "interface": 1, "strings": {"201": "A_\\d+$", "4": "B"},
         "read_strings": [100, 123], "send_features": ["0202", "0400"], "send_outputs": ["02b004"], "protocol": "uclogic")"));
  ASSERT_TRUE(table.ok()) << table.error().line();
  ASSERT_EQ(table->tablets().size(), 1U);
  const auto& tablet = table->tablets()[0];
  EXPECT_EQ(tablet.vendor, "V");
  EXPECT_EQ(tablet.max_x, 1000);
  EXPECT_EQ(tablet.height_mm, 50);
  EXPECT_EQ(tablet.feature_delay_ms, 150);
  EXPECT_TRUE(tablet.hide_from_desktop);
  ASSERT_EQ(tablet.wheels.size(), 1U);
  EXPECT_TRUE(tablet.wheels[0].is_ring);
  EXPECT_EQ(tablet.pads.at(0).protocol->name, "wacom_touch64");
  const auto& identifier = tablet.identifiers.at(0);
  EXPECT_EQ(identifier.vendor, 0x1234);
  EXPECT_EQ(identifier.product, 0xabcd);
  EXPECT_EQ(identifier.input_report_length, 12);
  EXPECT_EQ(identifier.output_report_length, 8);
  EXPECT_EQ(identifier.feature_report_length, 0);
  EXPECT_EQ(identifier.interface_number, 1);
  ASSERT_EQ(identifier.strings.size(), 2U);
  EXPECT_EQ(identifier.read_strings, (std::vector<std::uint8_t>{100, 123}));
  EXPECT_EQ(identifier.send_features.at(1), (std::vector<std::uint8_t>{0x04, 0x00}));
  EXPECT_EQ(identifier.send_outputs.at(0), (std::vector<std::uint8_t>{0x02, 0xb0, 0x04}));
  EXPECT_EQ(identifier.protocol->name, "uclogic");
}

TEST(TabletReader, ALayoutOfTheUsersOwnDecodes) {
  const auto table = read_tablet_file(R"({"penpose_tablets": 1,
    "protocols": {"mine": {"shortest": 2, "rules": [
      {"when": "1=c0", "gives": "leave"},
      {"gives": "pen", "x": "3 2", "y": "5 4", "pressure": "7 6.0-3", "tip": "1.0", "tilt_x": "8 signed negated"}]}},
    "tablets": [{"vendor": "Mine", "name": "One", "size_mm": [200, 100], "max": [20000, 10000], "max_pressure": 4095,
      "identifiers": [{"id": "dead:beef", "protocol": "mine"}]}]})");
  ASSERT_TRUE(table.ok()) << table.error().line();
  DeviceIdentity device;
  device.vendor = 0xdead;
  device.product = 0xbeef;
  const auto match = find_tablet(device, &*table);
  ASSERT_TRUE(match.has_value());
  EXPECT_TRUE(match->certain);
  const auto decoder = make_tablet_decoder(*match);
  const std::vector<std::uint8_t> report{0x01, 0x81, 0x12, 0x34, 0x0a, 0xbc, 0x0f, 0x02, 0xfe};
  EXPECT_EQ(decoder->decode(report), ReportKind::pen);
  EXPECT_EQ(decoder->sample().x, 0x1234);
  EXPECT_EQ(decoder->sample().y, 0x0abc);
  EXPECT_EQ(decoder->sample().pressure, 0xf02);
  EXPECT_EQ(decoder->sample().tilt_x, 2);
  EXPECT_TRUE(decoder->sample().tip);
  EXPECT_EQ(decoder->axes().x.maximum, 20000);
  EXPECT_EQ(decoder->axes().x.units_per_mm, 100);
  EXPECT_EQ(decoder->axes().pressure.maximum, 4095);
}

TEST(TabletReader, OneLineErrorsPointAtThePlace) {
  const auto place = [](const std::string& text) {
    const auto table = read_tablet_file(text);
    EXPECT_FALSE(table.ok()) << text;
    if (table.ok()) return std::string();
    EXPECT_EQ(table.error().line("f.json").find('\n'), std::string::npos);
    EXPECT_FALSE(table.error().remedy.empty());
    return table.error().place;
  };
  EXPECT_EQ(place("[]"), "/");
  EXPECT_EQ(place("{}"), "/");
  EXPECT_EQ(place(R"({"penpose_tablets": 2})"), "/penpose_tablets");
  EXPECT_EQ(place(R"({"penpose_tablets": 1, "tablet": []})"), "/tablet");
  EXPECT_EQ(place(R"({"penpose_tablets": 1, "tablets": [{}]})"), "/tablets/0/vendor");
  EXPECT_EQ(place(file_with(R"("pen_buttons": -1, )")), "/tablets/0/pen_buttons");
  EXPECT_EQ(place(file_with(R"("wheels": [{"kind": "ball"}], )")), "/tablets/0/wheels/0/kind");
  EXPECT_EQ(place(file_with("", R"("protocol": "none")")), "/tablets/0/identifiers/0/protocol");
  EXPECT_EQ(place(file_with("", R"("input": "8", "protocol": "xp_pen")")), "/tablets/0/identifiers/0/input");
  EXPECT_EQ(place(file_with("", R"("strings": {"201": "("}, "protocol": "xp_pen")")),
            "/tablets/0/identifiers/0/strings/201");
  EXPECT_EQ(place(file_with("", R"("strings": {"x": "a"}, "protocol": "xp_pen")")),
            "/tablets/0/identifiers/0/strings/x");
  EXPECT_EQ(place(file_with("", R"("send_features": ["0"], "protocol": "xp_pen")")),
            "/tablets/0/identifiers/0/send_features/0");
  EXPECT_EQ(place(file_with("", R"("Protocol": "xp_pen")")), "/tablets/0/identifiers/0/Protocol");
  EXPECT_EQ(place("{\"penpose_tablets\": 1"), "byte 21");
}

TEST(TabletReader, ErrorsAreTheFirstInTheFile) {
  const auto table = read_tablet_file(R"({"penpose_tablets": 1, "tablets": [{"vendor": 1, "name": 2}]})");
  ASSERT_FALSE(table.ok());
  EXPECT_EQ(table.error().line("my.json"), "my.json: /tablets/0/vendor: is no text; write a text in quotes");
}

}  // namespace
}  // namespace penpose::decode
