#include "firmware_io/decode/table/tablet_table.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>
#include <string>

#include "firmware_io/decode/table/tablet_reader.h"

namespace penpose::decode {
namespace {

/// A text that a pattern of the table matches: the first of every alternative, the least of every quantifier.
/// Look-ahead is passed over, so the caller checks that the pattern is really found.
std::string example_of(std::string_view pattern) {
  std::string text;
  bool skipping = false;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern.substr(i).starts_with("(?!")) {
      for (int depth = 0;; ++i) {
        depth += pattern[i] == '(' ? 1 : pattern[i] == ')' ? -1 : 0;
        if (depth == 0) break;
      }
      continue;
    }
    if (pattern.substr(i).starts_with("(?:")) {
      i += 2;
      continue;
    }
    const char letter = pattern[i];
    if (letter == '(') continue;
    if (letter == '|') {
      skipping = true;
    } else if (letter == ')') {
      skipping = false;
    } else if (skipping || letter == '^' || letter == '$') {
      continue;
    } else if (letter == '*') {
      text.pop_back();
    } else if (letter == '{') {
      const auto count = std::stoul(std::string(pattern.substr(i + 1)));
      text.append(count - 1, text.back());
      i = pattern.find('}', i);
    } else if (letter == '\\') {
      const char kind = pattern[++i];
      text += kind == 'd' ? '4' : kind == 'x' ? '\0' : kind;
      if (kind == 'x') i += 2;
    } else {
      text += letter;
    }
  }
  return text;
}

/// The device that an identifier describes, with everything known that can be known of it.
DeviceIdentity device_of(const TabletIdentifier& identifier) {
  DeviceIdentity device;
  device.vendor = identifier.vendor;
  device.product = identifier.product;
  device.interface_number = identifier.interface_number.value_or(0);
  device.input_report_length = identifier.input_report_length.value_or(8);
  if (identifier.output_report_length) device.output_report_length = identifier.output_report_length;
  for (const auto& check : identifier.strings) device.strings[check.index] = example_of(check.pattern.text());
  return device;
}

std::string name_of(const Tablet& tablet) { return tablet.vendor + " " + tablet.name; }

DeviceIdentity huion(std::uint16_t product, const std::string& firmware) {
  DeviceIdentity device;
  device.vendor = 0x256c;
  device.product = product;
  device.input_report_length = 12;
  if (!firmware.empty()) device.strings[201] = firmware;
  return device;
}

TEST(TabletTable, AllTabletsAreThereAndDecodable) {
  const auto tablets = known_tablets().tablets();
  ASSERT_EQ(tablets.size(), 324U);
  std::set<std::string> names;
  std::size_t identifiers = 0;
  for (const auto& tablet : tablets) {
    SCOPED_TRACE(name_of(tablet));
    names.insert(name_of(tablet));
    identifiers += tablet.identifiers.size();
    if (tablet.identifiers.empty()) {
      EXPECT_GT(tablet.pad_keys, 0) << "neither a pen nor keys";
      continue;
    }
    EXPECT_GT(tablet.width_mm, 0);
    EXPECT_GT(tablet.max_x, 0);
    EXPECT_GT(tablet.max_pressure, 0);
    for (const auto& identifier : tablet.identifiers) {
      ASSERT_NE(identifier.protocol, nullptr);
      const auto decoder = make_tablet_decoder({&tablet, &identifier, false, true});
      EXPECT_EQ(decoder->axes().x.present, identifier.protocol->name != "wacom_touch64");
    }
  }
  EXPECT_EQ(names.size(), 324U);
  EXPECT_EQ(identifiers, 493U);
}

TEST(TabletTable, EveryDeviceFindsItsTablet) {
  for (const auto& tablet : known_tablets().tablets()) {
    for (const auto& identifier : tablet.identifiers) {
      const auto device = device_of(identifier);
      for (const auto& check : identifier.strings) {
        ASSERT_TRUE(check.pattern.found_in(device.strings.at(check.index))) << check.pattern.text();
      }
      const auto match = known_tablets().find(device);
      ASSERT_TRUE(match.has_value()) << name_of(tablet);
      EXPECT_EQ(name_of(*match->tablet), name_of(tablet)) << identifier.protocol->name;
    }
  }
}

TEST(TabletTable, NoTwoTabletsAreIndistinguishable) {
  const auto tablets = known_tablets().tablets();
  const auto differ = [](const auto& a, const auto& b) { return a && b && *a != *b; };
  const auto strings = [](const TabletIdentifier& identifier) {
    std::set<std::string> all;
    for (const auto& check : identifier.strings) all.insert(std::to_string(check.index) + "=" + check.pattern.text());
    return all;
  };
  for (std::size_t i = 0; i < tablets.size(); ++i) {
    for (std::size_t j = i + 1; j < tablets.size(); ++j) {
      for (const auto& a : tablets[i].identifiers) {
        for (const auto& b : tablets[j].identifiers) {
          if (a.vendor != b.vendor || a.product != b.product) continue;
          EXPECT_TRUE(differ(a.input_report_length, b.input_report_length) ||
                      differ(a.output_report_length, b.output_report_length) ||
                      differ(a.interface_number, b.interface_number) || strings(a) != strings(b))
              << name_of(tablets[i]) << " and " << name_of(tablets[j]);
        }
      }
    }
  }
}

TEST(TabletTable, FirmwareNameTellsSharedIdsApart) {
  const auto match = known_tablets().find(huion(0x006d, "HUION_T173_190523"));
  ASSERT_TRUE(match.has_value());
  EXPECT_EQ(name_of(*match->tablet), "Huion H640P");
  EXPECT_TRUE(match->certain);
  auto other = huion(0x006d, "HUION_T999_190523");
  other.strings[6] = other.strings[121] = other.strings[2] = "x";
  EXPECT_FALSE(known_tablets().find(other).has_value());
  const auto unknown = known_tablets().find(huion(0x006d, ""));
  ASSERT_TRUE(unknown.has_value());
  EXPECT_FALSE(unknown->certain);
}

TEST(TabletTable, LengthsTellSharedIdsApart) {
  DeviceIdentity device;
  device.vendor = 0x056a;
  device.product = 0x0317;
  device.input_report_length = 10;
  auto match = known_tablets().find(device);
  ASSERT_TRUE(match.has_value());
  EXPECT_EQ(match->identifier->protocol->name, "wacom_intuos_pro");
  device.input_report_length = 64;
  match = known_tablets().find(device);
  ASSERT_TRUE(match.has_value());
  EXPECT_TRUE(match->is_pad);
  EXPECT_EQ(match->identifier->protocol->name, "wacom_touch64");
  device.input_report_length = 33;
  EXPECT_FALSE(known_tablets().find(device).has_value());
}

TEST(TabletTable, TheNameHelpsWhereStringsWereNotRead) {
  auto device = huion(0x006d, "");
  device.name = "Gaomon Tablet_ S830";
  const auto match = known_tablets().find(device);
  ASSERT_TRUE(match.has_value());
  EXPECT_EQ(match->tablet->name, "S830");
  EXPECT_FALSE(match->certain);
}

TEST(TabletTable, ATabletsOwnNameHelpsToo) {
  auto device = huion(0x006d, "");
  device.name = "HUION Huion Tablet_H640P Pen";
  EXPECT_EQ(known_tablets().find(device)->tablet->name, "H640P");
  device.name = "HUION Huion Tablet_H640PX Pen";
  EXPECT_NE(known_tablets().find(device)->tablet->name, "H640P");
}

TEST(TabletTable, TheOnlyTabletOfItsIdsIsKnownWhateverItsReports) {
  DeviceIdentity device;
  device.vendor = 0x28bd;
  device.product = 0x0936;
  ASSERT_NE(known_tablets().only_one(device), nullptr);
  EXPECT_EQ(known_tablets().only_one(device)->name, "Deco M");
  device.vendor = 0x256c;
  device.product = 0x006e;  // of a hundred tablets
  EXPECT_EQ(known_tablets().only_one(device), nullptr);
  device.name = "Tablet H640P";
  ASSERT_NE(known_tablets().only_one(device), nullptr);
  EXPECT_EQ(known_tablets().only_one(device)->name, "H640P");
  device.vendor = 0x1234;
  EXPECT_EQ(known_tablets().only_one(device), nullptr);
}

TEST(TabletTable, ATabletCanBeChosenByItsName) {
  DeviceIdentity device;
  device.vendor = 0x256c;
  device.product = 0x006e;
  const auto guessed = known_tablets().find(device);
  ASSERT_TRUE(guessed);
  EXPECT_GT(guessed->others, 0u);
  device.strings[201] = "HUION_T174_170519";
  EXPECT_EQ(known_tablets().find(device)->others, 0u);
  device.strings.clear();
  for (const char* name : {"New 1060 Plus", "huion new 1060 plus"}) {
    const auto chosen = known_tablets().choose(name);
    ASSERT_TRUE(chosen.ok()) << chosen.error().line();
    EXPECT_TRUE(chosen->is_choice());
    const auto found = chosen->find(device);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->tablet->name, "New 1060 Plus");
    EXPECT_EQ(found->others, 0u);
    DeviceIdentity mouse;
    mouse.vendor = 0x046d;
    EXPECT_FALSE(chosen->find(mouse));
  }
  const auto unknown = known_tablets().choose("H640");
  ASSERT_FALSE(unknown.ok());
  EXPECT_NE(unknown.error().remedy.find("Huion H640P"), std::string::npos) << unknown.error().line();
  EXPECT_FALSE(known_tablets().choose("").ok());
}

TEST(TabletTable, AWholeNameTellsMoreThanAWordOfIt) {
  DeviceIdentity device;
  device.vendor = 0x256c;
  device.product = 0x006e;
  for (const char* name : {"New 1060 Plus", "1060 Plus", "H640P"}) {
    device.name = std::string("Huion ") + name;
    const auto found = known_tablets().find(device);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->tablet->name, name);
    EXPECT_EQ(found->others, 0u) << name;
  }
}

TEST(TabletTable, WhatNothingTellsApartIsReadAsMostOfItIs) {
  auto device = huion(0x006e, "");
  device.input_report_length = 8;
  const auto match = known_tablets().find(device);
  ASSERT_TRUE(match.has_value());
  EXPECT_EQ(match->identifier->protocol->name, "uclogic");
  EXPECT_FALSE(match->certain);
}

TEST(TabletTable, OwnTabletsGoFirst) {
  const auto own = read_tablet_file(R"({"penpose_tablets": 1, "tablets": [{"vendor": "Mine", "name": "One",
    "size_mm": [1, 1], "max": [1, 1], "max_pressure": 1, "identifiers": [{"id": "256c:006d", "protocol": "xp_pen"}]}]})");
  ASSERT_TRUE(own.ok());
  const auto device = huion(0x006d, "HUION_T173_190523");
  EXPECT_EQ(find_tablet(device, &*own)->tablet->vendor, "Mine");
  EXPECT_EQ(find_tablet(device)->tablet->vendor, "Huion");
  EXPECT_EQ(find_tablet(huion(0x0064, "HUION_T203_190523"), &*own)->tablet->vendor, "Huion");
  EXPECT_FALSE(find_tablet(DeviceIdentity{}).has_value());
}

TEST(TabletTable, AxesHaveTheTabletsRanges) {
  const auto match = known_tablets().find(huion(0x006d, "HUION_T173_190523"));
  ASSERT_TRUE(match.has_value());
  const auto decoder = make_tablet_decoder(*match);
  EXPECT_EQ(decoder->axes().x.maximum, match->tablet->max_x);
  EXPECT_DOUBLE_EQ(decoder->axes().x.units_per_mm, 200);
  EXPECT_EQ(decoder->axes().pressure.maximum, 8191);
}

}  // namespace
}  // namespace penpose::decode
