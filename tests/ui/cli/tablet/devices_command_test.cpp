#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <unistd.h>
#include <vector>

#include "tests/support/command_run.h"

namespace penpose::cli {
namespace {

using tests::run_program;

class DevicesCommand : public tests::CommandRun {
 protected:
  void write(const std::string& text) const { save("own.json", text); }
  [[nodiscard]] std::string own() const { return path("own.json"); }
};

TEST_F(DevicesCommand, ListsALineForEachTablet) {
  const auto outcome = run_program({"devices", "--known"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 325);
  EXPECT_NE(outcome.out.find("Huion H640P: 160 x 100 mm, pressure 0..8191,"), std::string::npos);
  EXPECT_NE(outcome.out.find("324 tablets\n"), std::string::npos);
  EXPECT_EQ(outcome.error, "");
}

TEST_F(DevicesCommand, SaysWhatTheHandFindsOnATabletWhoeverDecodesIt) {
  const auto outcome = run_program({"devices", "--known"});
  const auto line = [&](const std::string& begin) {
    const auto at = outcome.out.find(begin);
    return at == std::string::npos ? "no " + begin : outcome.out.substr(at, outcome.out.find('\n', at) - at);
  };
  // Rings, strips and fingers of Wacom's tablets as libwacom has them.
  EXPECT_NE(line("Wacom PTH-650:").find("; 8 keys, 1 ring, touch"), std::string::npos) << line("Wacom PTH-650:");
  EXPECT_NE(line("Wacom PTH-660:").find("; 8 keys, 1 ring, touch"), std::string::npos) << line("Wacom PTH-660:");
  EXPECT_NE(line("Wacom PTZ-930:").find("; 8 keys, 2 strips"), std::string::npos) << line("Wacom PTZ-930:");
  EXPECT_NE(line("Wacom PTZ-431W:").find("; 4 keys, 1 strip"), std::string::npos) << line("Wacom PTZ-431W:");
  EXPECT_NE(line("Wacom CTH-460:").find("; 4 keys, touch"), std::string::npos) << line("Wacom CTH-460:");
  EXPECT_EQ(line("Wacom ET-0405-U:").find("touch"), std::string::npos) << line("Wacom ET-0405-U:");
  EXPECT_NE(line("Huion HS610:").find("; 12 keys, 1 ring"), std::string::npos) << line("Huion HS610:");
}

TEST_F(DevicesCommand, JsonIsOneObject) {
  const auto outcome = run_program({"devices", "--known", "--json"});
  EXPECT_EQ(outcome.status, 0);
  const auto object = nlohmann::json::parse(outcome.out, nullptr, false);
  ASSERT_TRUE(object.is_object());
  EXPECT_EQ(object["count"], 324);
  ASSERT_EQ(object["tablets"].size(), 324U);
  for (const auto& tablet : object["tablets"]) {
    const auto& interfaces = tablet[tablet["identifiers"].empty() ? "pads" : "identifiers"];
    ASSERT_FALSE(interfaces.empty());
    EXPECT_FALSE(interfaces[0]["protocol"].get<std::string>().empty());
  }
}

TEST_F(DevicesCommand, OwnTabletsComeFirst) {
  write(R"({"penpose_tablets": 1, "tablets": [{"vendor": "Mine", "name": "One", "size_mm": [1, 2], "max": [3, 4],
    "max_pressure": 5, "identifiers": [{"id": "0001:0002", "protocol": "xp_pen"}]}]})");
  const auto outcome = run_program({"devices", "--known", "--tablets", own()});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out.rfind("Mine One: 1 x 2 mm, pressure 0..5, 0001:0002, xp_pen\n", 0), 0U);
  EXPECT_NE(outcome.out.find("325 tablets"), std::string::npos);
}

TEST_F(DevicesCommand, ATabletThatIsNamedIsListedAloneAndOnce) {
  const auto outcome = run_program({"devices", "--known", "--tablet", "H640P"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_TRUE(outcome.out.starts_with("Huion H640P: 160 x 100 mm")) << outcome.out;
  EXPECT_TRUE(outcome.out.ends_with("\n1 tablet\n")) << outcome.out;
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 2);
  const auto object =
      nlohmann::json::parse(run_program({"devices", "--known", "--tablet", "H640P", "--json"}).out, nullptr, false);
  EXPECT_EQ(object["count"], 1);
  EXPECT_EQ(object["tablets"].size(), 1U);
}

TEST_F(DevicesCommand, ErrorsNameFileAndPlace) {
  write(R"({"penpose_tablets": 1, "tablets": 3})");
  const auto outcome = run_program({"devices", "--known", "--tablets", own()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.error, "penpose: " + own() + ": /tablets: is no array; put [ ] around its items\n");
  EXPECT_EQ(run_program({"devices", "--known", "--tablets", "/nonexistent"}).status, 1);
}

TEST_F(DevicesCommand, OneQuestionAtATime) {
  EXPECT_EQ(run_program({"devices", "--known", "--udev-rule"}).status, 2);
  EXPECT_EQ(run_program({"devices", "--rules-folder", "/tmp"}).status, 2);
}

TEST_F(DevicesCommand, TheRuleThatIsInstalledIsTheOneThatIsPrinted) {
  write(R"({"penpose_tablets": 1, "tablets": [{"vendor": "Mine", "name": "One", "size_mm": [1, 2], "max": [3, 4],
    "max_pressure": 5, "identifiers": [{"id": "0abc:0def", "protocol": "xp_pen"}]}]})");
  const auto folder = std::filesystem::path(own()).parent_path() / ("penpose_rules_" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  const auto printed = run_program({"devices", "--udev-rule", "--tablets", own()});
  const auto installed =
      run_program({"devices", "--install-udev-rule", "--rules-folder", folder.string(), "--tablets", own()});
  std::ifstream file(folder / "70-penpose.rules");
  const std::string rule{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  std::filesystem::remove_all(folder);
  EXPECT_EQ(printed.status, 0);
  EXPECT_EQ(installed.status, 0);
  EXPECT_EQ(rule, printed.out);
  EXPECT_NE(rule.find("*:0ABC:0DEF.*"), std::string::npos) << "the user's own tablet";
  EXPECT_EQ(run_program({"devices", "--install-udev-rule", "--rules-folder", "/nonexistent"}).status, 1);
}

TEST_F(DevicesCommand, SaysWhatWouldDrawPictures) {
  const auto outcome = run_program({"devices", "--json"});
  if (outcome.status != 0) GTEST_SKIP() << "devices cannot be listed here: " << outcome.error;
  const auto draw = nlohmann::json::parse(outcome.out, nullptr, false)["draw"];
  ASSERT_EQ(draw.size(), 3U);
  EXPECT_EQ(draw[0]["way"], "gl");
  EXPECT_EQ(draw[1]["way"], "es");
  EXPECT_EQ(draw[2]["way"], "cpu");
  std::string first;
  for (const auto& one : draw) {
    EXPECT_NE(one["driver"].is_null(), one["missing"].is_null());
    if (first.empty() && !one["driver"].is_null()) first = one["way"];
  }
  EXPECT_NE(run_program({"devices"}).out.find("pictures are drawn by " + first + " ("), std::string::npos);
}

}  // namespace
}  // namespace penpose::cli
