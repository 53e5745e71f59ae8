#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/command_run.h"

namespace penpose::cli {
namespace {

using DemoCommand = tests::CommandRun;

TEST_F(DemoCommand, WritesARiggedHeadAndAPicture) {
  ASSERT_EQ(run({"demo", "-o", path("new/folder"), "--json"}), 0) << error_;
  EXPECT_EQ(error_, "");
  const auto json = nlohmann::json::parse(out_);
  EXPECT_EQ(json["deformers"].size(), 18U);
  EXPECT_GE(json["expressions"].size(), 6U);
  EXPECT_EQ(json["state"].get<std::string>().size(), 32U);
  EXPECT_EQ(content("new/folder/demo.png").substr(1, 3), "PNG");
  ASSERT_EQ(run({"info", path("new/folder/demo.glb"), "--json"}), 0) << error_;
  const auto info = nlohmann::json::parse(out_);
  EXPECT_EQ(info["state"], json["state"]);
  EXPECT_EQ(info["parameters"].size(), 18U);
}

TEST_F(DemoCommand, SaysWhatItDid) {
  ASSERT_EQ(run({"demo", "-o", path("here")}), 0) << error_;
  EXPECT_NE(out_.find("18 deformers from "), std::string::npos);
  EXPECT_NE(out_.find("smile: "), std::string::npos);
  EXPECT_NE(out_.find("pictures, row by row: neutral, "), std::string::npos);
}

TEST_F(DemoCommand, AFolderThatCannotBeMadeIsAnError) {
  save("file", std::string("x"));
  EXPECT_EQ(run({"demo", "-o", path("file/folder")}), 1);
  EXPECT_NE(error_.find("file/folder"), std::string::npos);
}

TEST_F(DemoCommand, BuiltInModelsAreModelsLikeAnyOther) {
  ASSERT_EQ(run({"info", "builtin:head", "--json"}), 0) << error_;
  EXPECT_EQ(nlohmann::json::parse(out_)["parameters"].size(), 0U);
  ASSERT_EQ(run({"info", "builtin:demo", "--json"}), 0) << error_;
  EXPECT_EQ(nlohmann::json::parse(out_)["parameters"].size(), 18U);
  EXPECT_EQ(run({"info", "builtin:heda"}), 1);
  EXPECT_NE(error_.find("builtin:head"), std::string::npos);
}

}  // namespace
}  // namespace penpose::cli
