#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/command_run.h"
#include "tests/support/shared_data.h"
#include "ui/cli/commands.h"

// Lines of artists on small rigs that once were read as something else (cases/rigs of the shared folder).

namespace penpose::cli {
namespace {

using Json = nlohmann::json;
using Values = std::map<std::string, double>;

class SharedLines : public tests::CommandRun {
 protected:
  void SetUp() override {
    CommandRun::SetUp();
    if (!tests::has_shared()) GTEST_SKIP();
  }
  /// What each case moved from rest.
  std::map<std::string, Values> moved(const std::string& folder, const std::string& model, const std::string& cases) {
    const auto at = tests::shared_dir() / "cases" / "rigs" / folder;
    EXPECT_EQ(run({"pose", (at / model).string(), "--cases", (at / cases).string(), "--form", "drawn", "--json"}), 0)
        << error_;
    std::map<std::string, Values> out;
    const Json printed = Json::parse(out_);
    for (const Json& one : printed.at("cases")) {
      Values& values = out[one["name"]];
      for (const auto& [name, value] : one["parameters"].items()) {
        if (value.get<double>() != 0.0) values[name] = value.get<double>();
      }
    }
    return out;
  }
};

TEST_F(SharedLines, ABrowMovesTheBrowAndNotTheHeadThatCarriesIt) {
  for (const char* model : {"head_rig.glb", "head_plain.glb"}) {
    const auto cases = moved("head_turns_for_brow", model, "head_cases.json");
    ASSERT_EQ(cases.size(), 5U);
    for (const auto& [name, values] : cases) {
      ASSERT_EQ(values.size(), 1U) << model << " " << name;
      EXPECT_EQ(values.begin()->first, name.starts_with("brow_up") ? "browUp_R" : "browDown_R") << model << " " << name;
    }
    EXPECT_NEAR(cases.at("brow_up_6mm").at("browUp_R"), 0.64, 0.05) << model;
  }
}

TEST_F(SharedLines, ANarrowerMouthIsNarrowedTheMoreTheNarrowerItIsDrawn) {
  const auto cases = moved("narrow_mouth_ignored", "mouth_pucker.glb", "mouth_pucker_cases.json");
  double before = 0;
  for (const char* name : {"narrow_90", "narrow_80", "narrow_70", "narrow_60"}) {
    ASSERT_EQ(cases.at(name).count("mouthPucker"), 1U) << name;
    const double value = cases.at(name).at("mouthPucker");
    EXPECT_GE(value, before) << name;
    before = value;
  }
  EXPECT_NEAR(cases.at("narrow_90").at("mouthPucker"), 0.4, 0.15);
  EXPECT_GT(before, 0.9);
}

TEST_F(SharedLines, AnEvenSmileIsNoMouthPulledToBothSides) {
  for (const auto& [name, values] : moved("smile_by_mouth_left_and_right", "mouth.glb", "mouth_cases.json")) {
    EXPECT_EQ(values.size(), 2U) << name;
    EXPECT_EQ(values.count("mouthSmileLeft"), 1U) << name;
    EXPECT_EQ(values.count("mouthSmileRight"), 1U) << name;
  }
}

TEST_F(SharedLines, APictureOfAFaceDrawnBackGivesItsPoseAgain) {
  const std::string model = (tests::shared_dir() / "meshes" / "ict_face_narrow.glb").string();
  for (const double smile : {0.0, 0.7}) {
    const std::string value = std::to_string(smile);
    ASSERT_EQ(run({"render", model, "--set", "mouthSmile_L=" + value, "--set", "mouthSmile_R=" + value, "--view",
                   "face", "--lines", "-o", path("face.svg")}),
              0)
        << error_;
    ASSERT_EQ(run({"draw", model, path("face.svg"), "--json"}), 0) << error_;
    const Json printed = Json::parse(out_);
    for (const auto& [name, found] : printed.at("parameters").items())
      EXPECT_NEAR(found.get<double>(), name.starts_with("mouthSmile") ? smile : 0.0, 0.05) << name;
  }
}

}  // namespace
}  // namespace penpose::cli
