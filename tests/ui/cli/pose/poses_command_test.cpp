#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/command_run.h"
#include "ui/cli/commands.h"

namespace penpose::cli {
namespace {

using Json = nlohmann::json;

class PosesCommand : public tests::CommandRun {};

TEST_F(PosesCommand, KeepsAPoseListsItAndTakesItByItsName) {
  const std::string library = path("library");
  ASSERT_EQ(run({"poses", "builtin:demo", "--keep", "wide", "--set", "jaw=0.5", "--set", "mouth_corner_L=0.8",
                 "--folder", library}),
            k_success)
      << error_;
  save("library/other.txt", std::string_view("no pose"));
  ASSERT_EQ(run({"poses", "--folder", library, "--json"}), k_success);
  const Json listed = Json::parse(out_);
  ASSERT_EQ(listed.size(), 1U);
  EXPECT_EQ(listed[0]["name"], "wide");
  EXPECT_EQ(listed[0]["model"], "builtin:demo");
  EXPECT_NE(error_.find("other.txt"), std::string::npos) << "what is no pose is said";
  ASSERT_EQ(run({"poses", "builtin:demo", "--take", "wide", "--folder", library, "--json", "-o", path("wide.glb")}),
            k_success)
      << error_;
  const Json taken = Json::parse(out_);
  EXPECT_EQ(taken["by"], "names");
  EXPECT_EQ(taken["values"], Json({{"jaw", 0.5}, {"mouth_corner_L", 0.8}}));
  ASSERT_EQ(run({"poses", "builtin:demo", "--take", path("library/wide.pose.json"), "--by", "effects", "--part",
                 "mouth", "--json"}),
            k_success)
      << error_;
  const Json by_effects = Json::parse(out_);
  EXPECT_EQ(by_effects["by"], "effects");
  EXPECT_NEAR(by_effects["values"]["jaw"].get<double>(), 0.5, 0.08);
}

TEST_F(PosesCommand, TakesAPoseToTheOtherSideAndByAShare) {
  const std::string library = path("library");
  ASSERT_EQ(run({"poses", "builtin:demo", "--keep", "half", "--set", "jaw=0.5", "--set", "mouth_corner_L=0.8",
                 "--folder", library}),
            k_success)
      << error_;
  ASSERT_EQ(run({"poses", "builtin:demo", "--take", "half", "--folder", library, "--mirror", "--json"}), k_success)
      << error_;
  EXPECT_EQ(Json::parse(out_)["values"], Json({{"jaw", 0.5}, {"mouth_corner_R", 0.8}}));
  ASSERT_EQ(run({"poses", "builtin:demo", "--take", "half", "--folder", library, "--amount", "0.5", "--json", "-o",
                 path("half.glb")}),
            k_success)
      << error_;
  EXPECT_EQ(Json::parse(out_)["values"], Json({{"jaw", 0.25}, {"mouth_corner_L", 0.4}}));
  ASSERT_EQ(
      run({"poses", path("half.glb"), "--take", "half", "--folder", library, "--amount", "0", "--mirror", "--json"}),
      k_success)
      << error_;
  EXPECT_NEAR(Json::parse(out_)["values"]["mouth_corner_L"].get<double>(), 0.4, 1e-6) << "nothing of the way";
}

TEST_F(PosesCommand, AShareIsFromNothingToAllAndOfAPoseThatIsTaken) {
  EXPECT_EQ(run({"poses", "builtin:demo", "--take", "smile", "--amount", "1.5"}), k_wrong_usage);
  EXPECT_NE(error_.find("0 to 1"), std::string::npos) << error_;
  EXPECT_EQ(run({"poses", "builtin:demo", "--keep", "smile", "--mirror"}), k_wrong_usage);
}

TEST_F(PosesCommand, WhatIsNotThereIsSaidInOneLine) {
  EXPECT_EQ(run({"poses", "builtin:demo", "--take", "smile", "--folder", path("none")}), k_failure);
  EXPECT_NE(error_.find("has no pose of that name"), std::string::npos) << error_;
  EXPECT_EQ(std::count(error_.begin(), error_.end(), '\n'), 1);
  EXPECT_EQ(run({"poses", "--take", "smile"}), k_failure);
  EXPECT_NE(error_.find("MODEL"), std::string::npos) << error_;
}

}  // namespace
}  // namespace penpose::cli
