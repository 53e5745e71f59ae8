#include "ui/cli/tablet/sample_printer.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace penpose::cli {
namespace {

decode::PenAxes axes() {
  decode::PenAxes result;
  result.x = {0, 1000, 100, true};
  result.y = {0, 800, 100, true};
  result.pressure = {0, 1023, 0, true};
  return result;
}

TEST(SamplePrinter, CsvLeavesCellsEmptyThatADeviceDoesNotHave) {
  decode::PenSample sample;
  sample.x = 1;
  sample.y = -2;
  sample.pressure = 3;
  sample.in_range = sample.tip = true;
  sample.tool = decode::Tool::eraser;
  sample.buttons = 2;
  const decode::PenAxes ranges = axes();
  std::string out;
  append_csv_header(out, ranges, false);
  append_csv_row(out, {7, 8000, 1, &sample, &ranges}, false);
  append_csv_row(out, {8, 9000, 1, &sample, &ranges}, true);
  EXPECT_EQ(out,
            "# axis x 0 1000 100\n# axis y 0 800 100\n# axis pressure 0 1023 0\n"
            "report,time_us,x,y,pressure,tilt_x,tilt_y,distance,in_range,tool,tip,button1,button2\n"
            "7,8000,1,-2,3,,,,1,eraser,1,0,1\n8,9000,1,-2,3,,,,1,eraser,1,0,1,1\n");
}

TEST(SamplePrinter, JsonHasTheSameFacts) {
  decode::PenSample sample;
  sample.x = 5;
  sample.serial = 0xffffffffffffffffull;
  decode::PenAxes ranges = axes();
  ranges.tilt_x = {-64, 63, 1, true};
  std::string out = "{\"axes\": {";
  append_json_axes(out, ranges);
  out += "}, ";
  append_json_sample(out, {7, 8000, 1, &sample, &ranges});
  out += '}';
  const auto object = nlohmann::json::parse(out, nullptr, false);
  ASSERT_TRUE(object.is_object()) << out;
  EXPECT_EQ(object["axes"]["tilt_x"]["min"], -64);
  EXPECT_EQ(object["x"], 5);
  EXPECT_EQ(object["serial"], 0xffffffffffffffffull);
  EXPECT_TRUE(object["tool"].is_null());
  EXPECT_FALSE(object.contains("tilt_y"));
}

}  // namespace
}  // namespace penpose::cli
