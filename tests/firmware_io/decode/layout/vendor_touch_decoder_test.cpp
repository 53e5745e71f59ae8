#include "firmware_io/decode/layout/vendor_touch_decoder.h"

#include <gtest/gtest.h>

#include "firmware_io/decode/layout/protocol.h"
#include "firmware_io/decode/table/tablet_reader.h"
#include "tests/support/hands/pen_reports.h"

namespace penpose::decode {
namespace {

using tests::Report;

/// Two fingers of four bytes each: number, 1 while it is down, x, y.
constexpr const char* k_file = R"({"penpose_tablets": 1, "protocols": {"mine": {"rules": [
  {"when": "0=05", "gives": "touch", "contacts": {"from": 1, "size": 4, "most": 2, "ids": [3, 4], "id": "0",
   "down": "1=01", "x": "2", "y": "3"}},
  {"when": "0=06", "gives": "pad", "ring": "1", "second_ring": "2 if 2!=00", "strip": "3", "second_strip": "4"}]}},
  "tablets": [{"vendor": "Me", "name": "Mine", "size_mm": [100, 100], "max": [1, 1], "max_pressure": 1, "strips": 2,
  "touch": {"max": [200, 100], "size_mm": [100, 100], "contacts": 2},
  "identifiers": [{"id": "1234:0001", "protocol": "mine"}]}]})";

TEST(VendorTouchDecoder, FingersOfATabletFile) {
  const auto table = read_tablet_file(k_file);
  ASSERT_TRUE(table.ok()) << table.error().line();
  const Tablet& tablet = table->tablets()[0];
  EXPECT_EQ(tablet.strips, 2);
  VendorTouchDecoder touch(tablet.identifiers[0].protocol, &tablet);
  EXPECT_EQ(touch.axes().x.maximum, 200);
  EXPECT_EQ(touch.axes().x.units_per_mm, 2);
  EXPECT_EQ(touch.axes().contacts, 2u);
  ASSERT_TRUE(touch.decode(Report{5, 4, 1, 70, 80, 3, 1, 50, 60}));
  ASSERT_EQ(touch.contacts().size(), 2u);
  EXPECT_EQ(touch.contacts()[0].x, 50);
  EXPECT_EQ(touch.contacts()[1].y, 80);
  // Other numbers are no fingers, and a report may end before the last.
  ASSERT_TRUE(touch.decode(Report{5, 9, 1, 1, 1}));
  EXPECT_EQ(touch.contacts().size(), 2u);
  ASSERT_TRUE(touch.decode(Report{5, 3, 0, 0, 0}));
  ASSERT_EQ(touch.contacts().size(), 1u);
  EXPECT_EQ(touch.contacts()[0].x, 70);
  EXPECT_FALSE(touch.decode(Report{5, 3, 0, 0}));
  EXPECT_FALSE(touch.decode(Report{6, 3, 0, 0, 0}));
}

TEST(VendorTouchDecoder, WhatIsWrongInContactsIsNamed) {
  const auto error_of = [](const std::string& from, const std::string& to) {
    std::string text = k_file;
    text.replace(text.find(from), from.size(), to);
    const auto table = read_tablet_file(text);
    return table.ok() ? std::string() : table.error().place;
  };
  EXPECT_EQ(error_of("\"x\": \"2\"", "\"x\": \"4\""), "/protocols/mine/rules/0/contacts/x");
  EXPECT_EQ(error_of("[3, 4]", "[4, 3]"), "/protocols/mine/rules/0/contacts/ids");
  EXPECT_EQ(error_of("[3, 4]", "[3]"), "/protocols/mine/rules/0/contacts/ids");
  EXPECT_EQ(error_of("\"most\": 2", "\"most\": 65"), "/protocols/mine/rules/0/contacts/most");
  EXPECT_EQ(error_of("[200, 100]", "[200]"), "/tablets/0/touch/max");
  EXPECT_EQ(error_of("\"strips\": 2", "\"strips\": 3"), "/tablets/0/strips");
}

TEST(VendorTouchDecoder, OnlyProtocolsWithFingersHaveTouch) {
  EXPECT_TRUE(has_touch(*known_protocols().at("wacom_touch64")));
  EXPECT_TRUE(has_touch(*known_protocols().at("wacom_intuos_v2_skip1")));
  EXPECT_FALSE(has_touch(*known_protocols().at("xp_pen")));
}

}  // namespace
}  // namespace penpose::decode
