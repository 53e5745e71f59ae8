#include "firmware_io/decode/table/open_tablet_driver.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "firmware_io/decode/layout/protocol.h"
#include "firmware_io/decode/table/tablet_reader.h"

namespace penpose::decode {
namespace {

/// A configuration of a made-up tablet with every member that is read. `parser` names the report parser, `more` is put
/// into the identifier.
std::string configuration(const std::string& parser, const std::string& more = "") {
  std::string text = R"json({"Name": "Maker Model 5 (Variant 2)",
  "Specifications": {
    "Digitizer": {"Width": 200.5, "Height": 100.25, "MaxX": 40100.0, "MaxY": 20050},
    "Pen": {"MaxPressure": 8191, "Buttons": {"ButtonCount": 2}},
    "AuxiliaryButtons": {"ButtonCount": 6}, "MouseButtons": null,
    "Touch": {"Width": 150.5, "Height": 90, "MaxX": 4095.0, "MaxY": 2047},
    "Wheel": {"StepCount": 71, "IsRelative": false, "AngleOfZeroReading": 180.0, "Buttons": {"ButtonCount": 1}}},
  "DigitizerIdentifiers": [{"VendorID": 4660, "ProductID": 43981, "InputReportLength": 12, "OutputReportLength": null,
    "ReportParser": "PARSER", "FeatureInitReport": ["AgI=", "BAA="], "OutputInitReport": "ArAE",
    "DeviceStrings": {"201": "MAKER_T1\\d{2}$"}, "InitializationStrings": [100, 200]MORE}],
  "AuxilaryDeviceIdentifiers": [{"VendorID": 4660, "ProductID": 43982, "InputReportLength": 64,
    "ReportParser": "OpenTabletDriver.Configurations.Parsers.Wacom.Wacom64bAuxReportParser"}],
  "Attributes": {"libinputoverride": "1", "FeatureInitDelayMs": "150", "Interface": "1", "SomethingNew": "x"}})json";
  text.replace(text.find("PARSER"), 6, parser);
  text.replace(text.find("MORE"), 4, more);
  return text;
}

TEST(OpenTabletDriver, ConfigurationAsItIs) {
  const auto table = read_tablet_file(configuration("OpenTabletDriver.Configurations.Parsers.Huion.GianoReportParser"));
  ASSERT_TRUE(table.ok()) << table.error().line();
  const auto& tablet = table->tablets()[0];
  EXPECT_EQ(tablet.vendor, "Maker");
  EXPECT_EQ(tablet.name, "Model 5 (Variant 2)");
  EXPECT_EQ(tablet.width_mm, 200.5);
  EXPECT_EQ(tablet.max_x, 40100);
  EXPECT_EQ(tablet.max_pressure, 8191);
  EXPECT_EQ(tablet.pen_buttons, 2);
  EXPECT_EQ(tablet.pad_keys, 6);
  EXPECT_TRUE(tablet.hide_from_desktop);
  ASSERT_TRUE(tablet.touch.has_value());
  EXPECT_EQ(tablet.touch->width_mm, 150.5);
  EXPECT_EQ(tablet.touch->max_x, 4095);
  EXPECT_EQ(tablet.touch->max_y, 2047);
  EXPECT_EQ(tablet.feature_delay_ms, 150);
  ASSERT_EQ(tablet.wheels.size(), 1U);
  EXPECT_TRUE(tablet.wheels[0].is_ring);
  EXPECT_EQ(tablet.wheels[0].buttons, 1);
  const auto& identifier = tablet.identifiers.at(0);
  EXPECT_EQ(identifier.vendor, 0x1234);
  EXPECT_EQ(identifier.product, 0xabcd);
  EXPECT_EQ(identifier.input_report_length, 12);
  EXPECT_FALSE(identifier.output_report_length.has_value());
  EXPECT_EQ(identifier.interface_number, 1);
  EXPECT_EQ(identifier.protocol->name, "huion_giano");
  EXPECT_EQ(identifier.send_features.at(0), (std::vector<std::uint8_t>{2, 2}));
  EXPECT_EQ(identifier.send_features.at(1), (std::vector<std::uint8_t>{4, 0}));
  EXPECT_EQ(identifier.send_outputs.at(0), (std::vector<std::uint8_t>{0x02, 0xb0, 0x04}));
  EXPECT_EQ(identifier.read_strings, (std::vector<std::uint8_t>{100, 200}));
  EXPECT_TRUE(identifier.strings.at(0).pattern.found_in("MAKER_T123"));
  EXPECT_EQ(tablet.pads.at(0).protocol->name, "wacom_touch64");
}

TEST(OpenTabletDriver, IndicesOfStringsInQuotes) {
  auto text = configuration("OpenTabletDriver.Vendors.Huion.GianoReportParser");
  const std::string plain = "[100, 200]";
  text.replace(text.find(plain), plain.size(), R"(["100", 200])");
  const auto table = read_tablet_file(text);
  ASSERT_TRUE(table.ok()) << table.error().line();
  EXPECT_EQ(table->tablets()[0].identifiers.at(0).read_strings, (std::vector<std::uint8_t>{100, 200}));

  for (const std::string wrong : {R"(["256"])", R"(["-1"])", R"([""])", R"(["two"])"}) {
    text = configuration("OpenTabletDriver.Vendors.Huion.GianoReportParser");
    text.replace(text.find(plain), plain.size(), wrong);
    const auto refused = read_tablet_file(text);
    ASSERT_FALSE(refused.ok()) << wrong;
    EXPECT_NE(refused.error().line().find("/DigitizerIdentifiers/0/InitializationStrings/0"), std::string::npos);
  }
}

TEST(OpenTabletDriver, OlderButtonCountAndMissingParts) {
  const auto table = read_tablet_file(R"({"Name": "Single", "Specifications": {
    "Digitizer": {"Width": 10, "Height": 10, "MaxX": 100, "MaxY": 100}, "Pen": {"MaxPressure": 511, "ButtonCount": 3}},
    "DigitizerIdentifiers": [{"VendorID": 1, "ProductID": 2, "ReportParser": "OpenTabletDriver.Plugin.Tablet.TabletReportParser"}]})");
  ASSERT_TRUE(table.ok()) << table.error().line();
  EXPECT_EQ(table->tablets()[0].pen_buttons, 3);
  EXPECT_EQ(table->tablets()[0].vendor, "Single");
  EXPECT_EQ(table->tablets()[0].identifiers[0].protocol->name, "generic");
}

TEST(OpenTabletDriver, RangesInTheIdentifierAsBeforeVersion06) {
  const auto table = read_tablet_file(R"({"Name": "Maker Old", "DigitizerIdentifiers": [{"Width": 128.0, "Height": 98,
    "MaxX": 5104.0, "MaxY": 3712.0, "MaxPressure": 512, "VendorID": 1, "ProductID": 2, "InputReportLength": 8,
    "ReportParser": null, "FeatureInitReport": "AgI="}]})");
  ASSERT_TRUE(table.ok()) << table.error().line();
  EXPECT_EQ(table->tablets()[0].max_y, 3712);
  EXPECT_EQ(table->tablets()[0].max_pressure, 512);
  EXPECT_EQ(table->tablets()[0].identifiers[0].send_features.at(0), (std::vector<std::uint8_t>{2, 2}));
}

TEST(OpenTabletDriver, WheelsOfEveryRelease) {
  const auto wheels = [](const std::string& text) {
    const auto table = read_tablet_file(R"({"Name": "A B", "Specifications": {"Digitizer": {"Width": 1, "Height": 1,
      "MaxX": 1, "MaxY": 1}, "Pen": {"MaxPressure": 1}, )" +
                                        text + R"(}, "DigitizerIdentifiers": [{"VendorID": 1, "ProductID": 2}]})");
    EXPECT_TRUE(table.ok()) << table.error().line();
    return table.ok() ? table->tablets()[0].wheels : std::vector<TabletWheel>{};
  };
  auto found = wheels(R"("Wheel": {"StepCount": 24, "IsRelative": true, "ButtonCount": 1})");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_FALSE(found[0].is_ring);
  EXPECT_EQ(found[0].steps, 24);
  EXPECT_EQ(found[0].buttons, 1);
  found = wheels(R"("Wheels": [{"RelativeWheelSteps": 24}, {"AbsoluteWheelMax": 71, "AngleOfZeroReading": 90}])");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_FALSE(found[0].is_ring);
  EXPECT_TRUE(found[1].is_ring);
  EXPECT_EQ(found[1].steps, 71);
  EXPECT_EQ(found[1].zero_degrees, 90);
}

TEST(OpenTabletDriver, ErrorsPointAtThePlace) {
  const auto place = [](const std::string& text) {
    const auto table = read_tablet_file(text);
    return table.ok() ? std::string("none") : table.error().place;
  };
  EXPECT_EQ(place(R"({"DigitizerIdentifiers": []})"), "/Name");
  EXPECT_EQ(place(R"({"Name": "A B", "DigitizerIdentifiers": [{"VendorID": 70000}]})"),
            "/Specifications/Digitizer/Width");
  EXPECT_EQ(place(configuration("XENXReportParser", R"(, "Attributes": {"Interface": "x"})")),
            "/DigitizerIdentifiers/0/Attributes/Interface");
}

TEST(OpenTabletDriver, AReportParserThatIsNotKnownIsNamedAndTheRestIsRead) {
  const auto table = read_tablet_file(configuration("Made.Up.Parser"));
  ASSERT_TRUE(table.ok()) << table.error().line();
  const Tablet& tablet = table->tablets()[0];
  EXPECT_EQ(tablet.unread_parsers, std::vector<std::string>{"Made.Up.Parser"});
  EXPECT_GT(tablet.max_x, 0);
  for (const TabletIdentifier& identifier : tablet.identifiers) EXPECT_NE(identifier.protocol, nullptr);
}

TEST(OpenTabletDriver, EveryProtocolHasAParser) {
  std::size_t without = 0;
  for (const auto* const parser :
       {"AcepenReportParser", "AuxReportParser", "BambooReportParser", "GianoReportParser", "IntuosV2ReportParser",
        "SkipByteTabletReportParser", "UCLogicTiltReportParser", "KamvasOffsetReportParser", "PassthroughReportParser",
        "TenMoonReportParser", "TiltTabletReportParser", "WacomDriverIntuosV3ReportParser",
        "WacomDriverIntuosV1ReportParser", "XP_PenReportParser"}) {
    const auto protocol = protocol_of_parser(std::string("Some.Name.Space.") + parser);
    EXPECT_NE(make_protocol_decoder(protocol), nullptr) << parser;
    without += protocol.empty() ? 1 : 0;
  }
  EXPECT_EQ(without, 0U);
  EXPECT_EQ(protocol_of_parser("GianoReportParserX"), "");
}

}  // namespace
}  // namespace penpose::decode
