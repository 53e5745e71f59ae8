#include "ui/cli/tablet/hand_printer.h"

#include <gtest/gtest.h>

namespace penpose::cli {
namespace {

TEST(HandPrinter, CellsAreEmptyWhereThePadHasNoSuchThing) {
  decode::PadSample sample;
  sample.ring = {7, 8};
  sample.strip = {9, 10};
  sample.wheel = {-1, 2};
  decode::PadFeatures features;
  const auto row = [&] {
    std::string out;
    append_csv_pad(out, {3, 250, 1, &sample, &features}, false);
    return out;
  };
  EXPECT_EQ(row(), "3,250,-,,,,,-1,2\n");
  features.rings = 1;
  features.strips = 2;
  EXPECT_EQ(row(), "3,250,-,7,,9,10,-1,2\n");
}

TEST(HandPrinter, TheKeyThatLinuxLosesIsInNoRow) {
  decode::PadSample sample;
  sample.keys = {decode::PadKey::program2, decode::PadKey::program3};
  const decode::PadFeatures features;
  std::string out;
  append_csv_pad(out, {0, 0, 0, &sample, &features}, true);
  EXPECT_EQ(out, "0,0,KEY_PROG2,,,,,0,0,0\n");
  out = "{";
  append_json_pad(out, {0, 0, 0, &sample, &features}, {});
  EXPECT_NE(out.find("\"KEY_PROG3\""), std::string::npos);
}

TEST(HandPrinter, FingersStandInTheOrderOfTheirPlaces) {
  const std::vector<decode::TouchContact> contacts{{1, 900, 5}, {2, 20, 7}, {3, 20, 6}};
  std::string out;
  append_csv_touch(out, {4, 1000, 2, contacts}, true);
  EXPECT_EQ(out, "4,1000,20:6 20:7 900:5,2\n");
  out.clear();
  append_csv_touch(out, {4, 1000, 2, {}}, false);
  EXPECT_EQ(out, "4,1000,-\n");
}

TEST(HandPrinter, TheBatteryIsToldOfWhereItIsKnown) {
  const decode::PadSample sample;
  const decode::PadFeatures features;
  std::string out = "{";
  append_json_pad(out, {0, 0, 0, &sample, &features}, {});
  EXPECT_EQ(out.find("battery"), std::string::npos);
  out = "{";
  append_json_pad(out, {0, 0, 0, &sample, &features}, {42, true});
  EXPECT_NE(out.find("\"battery\": 42, \"charging\": true"), std::string::npos);
}

}  // namespace
}  // namespace penpose::cli
