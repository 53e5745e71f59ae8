#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <vector>

#include "tests/support/command_run.h"
#include "tests/support/shared_data.h"

// Recordings of tablets that once were read wrongly (cases/pens of the shared folder).

namespace penpose::cli {
namespace {

using Rows = std::vector<std::string>;

class SharedPens : public tests::CommandRun {
 protected:
  void SetUp() override {
    CommandRun::SetUp();
    if (!tests::has_shared()) GTEST_SKIP();
  }
  static std::string file(const std::string& name) { return (tests::shared_dir() / "cases" / "pens" / name).string(); }

  static tests::Outcome decode(const std::string& name, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"decode", file(name)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return tests::run_program(arguments);
  }
  /// The rows behind the names of the columns, from the third column on.
  static Rows rows(const tests::Outcome& outcome) {
    Rows found;
    std::size_t at = outcome.out.find("report,time_us");
    while (at != std::string::npos && (at = outcome.out.find('\n', at)) != std::string::npos) {
      const std::string row = outcome.out.substr(at + 1, outcome.out.find('\n', at + 1) - at - 1);
      const std::size_t time = row.find(',');
      if (time == std::string::npos) break;
      found.push_back(row.substr(row.find(',', time + 1) + 1));
      ++at;
    }
    return found;
  }
  /// Lines of the ranges.
  static Rows axes(const tests::Outcome& outcome) {
    Rows found;
    for (std::size_t at = 0; outcome.out.compare(at, 7, "# axis ") == 0; at = outcome.out.find('\n', at) + 1) {
      found.push_back(outcome.out.substr(at + 7, outcome.out.find('\n', at) - at - 7));
    }
    return found;
  }
};

TEST_F(SharedPens, AnEraserButtonInTheAirTouchesNothing) {
  const auto outcome = decode("eraser-button-in-the-air/xppen_deco01.hid");
  const Rows all = rows(outcome);
  ASSERT_GT(all.size(), 8U);
  for (const std::string& row : all) EXPECT_NE(row.find(",0,0,0"), std::string::npos) << row;
  EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const auto& row) { return row.find("eraser") != row.npos; }));
  const auto replay =
      tests::run_program({"replay", file("eraser-button-in-the-air/xppen_deco01.hid"), "-o", path("o.glb"), "--json"});
  EXPECT_EQ(replay.status, 0) << replay.error;
  EXPECT_EQ(replay.error.find("no curve under the eraser"), std::string::npos) << replay.error;
}

TEST_F(SharedPens, TheLaterFirmwareOfAKamvasIsTold) {
  const Rows wanted{"24836,20649,3363,-12,4,,1,pen,1,0,0", "24846,20635,3932,-11,4,,1,pen,1,0,0",
                    "24923,20251,8707,-11,4,,1,pen,1,0,0", "25085,20408,16383,-9,3,,1,pen,1,0,0",
                    "25091,20409,16383,-8,3,,1,pen,1,0,0"};
  EXPECT_EQ(rows(decode("kamvas-16-gen-3/offset.hid")), wanted);
  EXPECT_EQ(rows(decode("kamvas-16-gen-3/offset.hid", {"--tablets", file("kamvas-16-gen-3/config.json")})), wanted);
  EXPECT_EQ(rows(decode("hid-recorder-in-colour/colour.hid")), wanted);
}

TEST_F(SharedPens, ConfigurationsOfOpenTabletDriverNameTheirTablets) {
  for (const auto& [config, name] : {std::pair{"kamvas-16-gen-3/config.json", "Huion Kamvas 16 (Gen 3)"},
                                     std::pair{"otd-config-of-0.5/config.json", "Huion Kamvas Pro 12"}}) {
    const auto outcome = tests::run_program({"devices", "--known", "--tablets", file(config)});
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_TRUE(outcome.out.starts_with(name)) << outcome.out.substr(0, 80);
  }
}

TEST_F(SharedPens, TheStringOfARecordingTellsTheModel) {
  const auto outcome = decode("own-recording-forgets-model/as_recorded.hid");
  EXPECT_EQ(axes(outcome), (Rows{"x 0 50800 200", "y 0 31750 200", "pressure 0 8191 0"}));
  EXPECT_EQ(outcome.error, "");
  std::ifstream in(file("own-recording-forgets-model/as_recorded.hid"));
  std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  const std::size_t at = text.find("# string");
  ASSERT_NE(at, std::string::npos);
  text.erase(at, text.find('\n', at) + 1 - at);
  save("none.hid", text);
  const auto guessed = tests::run_program({"decode", path("none.hid")});
  EXPECT_NE(guessed.error.find("a guess"), std::string::npos) << guessed.error;
  const auto named = tests::run_program({"decode", path("none.hid"), "--tablet", "Huion New 1060 Plus"});
  EXPECT_EQ(named.out, outcome.out);
}

TEST_F(SharedPens, KeysThatLinuxDescribesAreKeys) {
  EXPECT_EQ(rows(decode("pad-described-by-linux/huion_h640p_uclogic.hid", {"--pad"})),
            (Rows{"BTN_0,,,,,0,0", "-,,,,,0,0", "BTN_1,,,,,0,0", "-,,,,,0,0"}));
  EXPECT_EQ(rows(decode("pad-described-by-linux/deco01v3_hid_bpf.hid", {"--pad"})),
            (Rows{"BTN_0,,,,,0,0", "BTN_0+BTN_1,,,,,0,0", "BTN_7,,,,,0,0", "-,,,,,0,0"}));
}

TEST_F(SharedPens, APenThatNumbersItsContactsIsAPen) {
  const auto outcome = decode("pen-with-contact-id/goodix_27c6_0113.hid");
  const Rows ranges = axes(outcome);
  ASSERT_GE(ranges.size(), 3U);
  EXPECT_TRUE(ranges[0].starts_with("x 0 3600 "));
  EXPECT_TRUE(ranges[1].starts_with("y 0 5760 "));
  EXPECT_EQ(ranges[2], "pressure 0 4095 0");
  const Rows all = rows(outcome);
  ASSERT_EQ(all.size(), 8U);
  EXPECT_NE(all[1].find("2048,1500,0,,1,pen,1,0,0"), std::string::npos) << all[1];
  EXPECT_NE(all[2].find("2100,1500,0,,1,pen,1,0,0"), std::string::npos) << "In Range falls while the tip moves";
  EXPECT_NE(all[6].find("1000,0,0,,1,eraser,1,0,0"), std::string::npos) << all[6];
}

TEST_F(SharedPens, AMouseModeSaysSo) {
  const auto outcome = decode("reports-but-no-word/veikk_a30_mouse_mode.hid");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.error.find("4 reports, none of a pen: this is the tablet's mouse mode"), std::string::npos);
  EXPECT_NE(outcome.error.find("record with `penpose record`"), std::string::npos);
}

TEST_F(SharedPens, ASecondaryTipSwitchIsTheSecondButton) {
  const Rows all = rows(decode("secondary-tip-switch/huion_frego_m_bt.hid"));
  ASSERT_EQ(all.size(), 6U);
  EXPECT_TRUE(all[1].ends_with(",pen,0,1,0")) << all[1];
  EXPECT_TRUE(all[2].ends_with(",pen,0,0,1")) << all[2];
}

TEST_F(SharedPens, ATabletsOwnReportsHaveTheirOwnRanges) {
  const auto pro = decode("wacom-two-pen-reports/intuos_pro_m_2025.hid");
  const Rows ranges = axes(pro);
  ASSERT_GE(ranges.size(), 5U);
  EXPECT_TRUE(ranges[0].starts_with("x 0 52600 ")) << ranges[0];
  EXPECT_TRUE(ranges[1].starts_with("y 0 29600 ")) << ranges[1];
  EXPECT_EQ(ranges[2], "pressure 0 8191 0");
  EXPECT_EQ(ranges[3], "tilt_x -90 90 1");
  EXPECT_EQ(rows(pro)[2], "52600,29600,8191,45,-45,0,1,pen,1,0,0");
  const auto one = decode("wacom-two-pen-reports/wacom_one_13_touch.hid");
  EXPECT_EQ(rows(one)[1], "14688,8262,2047,45,-45,0,1,pen,1,0,0");
  EXPECT_EQ(axes(one)[3], "tilt_x -90 90 1");
}

TEST_F(SharedPens, WheelsOfXpPenTurn) {
  EXPECT_EQ(rows(decode("xppen-wheel/m908_artist24.hid", {"--pad"})),
            (Rows{"-,,,,,1,0", "-,,,,,-1,0", "BTN_0,,,,,0,0", "BTN_0,,,,,1,0", "-,,,,,0,0"}));
}

}  // namespace
}  // namespace penpose::cli
