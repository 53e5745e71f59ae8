#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/document/commands/apply.h"
#include "core/io/model/write_model.h"
#include "core/io/project/write_document.h"
#include "tests/support/command_run.h"
#include "tests/support/models/test_rigs.h"
#include "tests/support/shared_data.h"
#include "ui/cli/commands.h"

namespace penpose::cli {
namespace {

using Json = nlohmann::json;

/// A grid with eight shapes; the keyed faces mix two moods, in which the odd shapes go with the even ones.
class SuggestCommand : public tests::CommandRun {
 protected:
  void SetUp() override {
    tests::CommandRun::SetUp();
    mesh_ = tests::grid_mesh(10, 10);
    model_ = document::make_model(mesh_, tests::random_shapes(*mesh_, 8, 3), nullptr).value();
    save("plain.glb", io::write_glb(model_).value());
    save("faces.glb", project(6));
    save("one.glb", project(1));
  }

  [[nodiscard]] std::vector<std::uint8_t> project(int count) const {
    document::Document document = document::make_document(model_);
    document::ApplyWorkspace work;
    tests::Random random(5);
    for (int k = 0; k < count; ++k) {
      document::SetParameters set;
      const double moods[] = {random(0.1, 0.9), random(0.1, 0.9)};
      for (std::size_t pair = 0; pair < 4; ++pair) {
        const double much = moods[pair % 2];
        set.values.push_back({"shape" + std::to_string(2 * pair), much});
        set.values.push_back({"shape" + std::to_string(2 * pair + 1), 0.9 * much});
      }
      document = document::apply(document, set, work).value();
      document = document::apply(document, document::SetKey{0.5 * k, "face " + std::to_string(k)}, work).value();
    }
    document = document::apply(document, document::ResetParameters{}, work).value();
    return io::write_document(document, "x.glb").value();
  }

  std::shared_ptr<const mesh::TriangleMesh> mesh_;
  document::Model model_;
};

TEST_F(SuggestCommand, SuggestsTheRestOfWhatIsSetAndWritesIt) {
  ASSERT_EQ(
      run({"suggest", path("faces.glb"), "--set", "shape0=0.8", "--strength", "1", "--json", "-o", path("out.glb")}),
      k_success)
      << error_;
  const Json out = Json::parse(out_);
  EXPECT_EQ(out["keys"], 6);
  EXPECT_EQ(out["held"], Json::array({"shape0"}));
  EXPECT_EQ(out["parameters"]["shape0"], 0.8);
  EXPECT_NEAR(out["parameters"]["shape1"].get<double>(), 0.72, 0.2) << "it goes with shape 0";
  EXPECT_FALSE(out["suggested"].contains("shape0"));
  ASSERT_EQ(run({"info", path("out.glb"), "--json"}), k_success);
  const Json info = Json::parse(out_);
  EXPECT_EQ(info["state"], out["state"]);
  // The same from a plain model with the poses of a project, for people.
  ASSERT_EQ(run({"suggest", path("plain.glb"), "--keys", path("faces.glb"), "--set", "shape0=0.8"}), k_success);
  EXPECT_EQ(out_.rfind("learned from 6 poses, shrunk by 0.", 0), 0U) << out_;
  EXPECT_NE(out_.find("1 of 8 parameters held"), std::string::npos);
  EXPECT_NE(out_.find("  shape1  0.0000 -> 0."), std::string::npos);
}

TEST_F(SuggestCommand, LeavesOneOut) {
  ASSERT_EQ(run({"suggest", path("faces.glb"), "--leave-one-out", "--hold", "shape0", "--hold", "shape2", "--hold",
                 "shape4", "--hold", "shape6", "--json"}),
            k_success)
      << error_;
  const Json out = Json::parse(out_);
  ASSERT_EQ(out["keys"].size(), 6U);
  EXPECT_EQ(out["keys"][2]["name"], "face 2");
  EXPECT_EQ(out["keys"][2]["held"], 4);
  EXPECT_LT(out["all"]["suggested"].get<double>(), 0.5 * out["all"]["not_moving"].get<double>());
  EXPECT_LT(out["all"]["suggested"].get<double>(), 0.8 * out["all"]["mean"].get<double>());
  EXPECT_LE(out["median"]["suggested"].get<double>(), out["median"]["not_moving"].get<double>());
  // Without --hold the half that moves the model most is held; with a star all that begin so.
  ASSERT_EQ(run({"suggest", path("faces.glb"), "--leave-one-out"}), k_success);
  EXPECT_NE(out_.find("all keys together"), std::string::npos);
  ASSERT_EQ(run({"suggest", path("faces.glb"), "--leave-one-out", "--hold", "shape*", "--json"}), k_success);
  EXPECT_EQ(Json::parse(out_)["all"]["not_moving"], 0) << "nothing is left to suggest";
}

TEST_F(SuggestCommand, WhatCannotBeDoneIsOneLineWithARemedy) {
  const auto fails = [&](std::vector<std::string> arguments, const std::string& file, const std::string& part) {
    arguments.insert(arguments.begin(), "suggest");
    EXPECT_EQ(run(arguments), k_failure) << out_;
    EXPECT_EQ(error_.find('\n'), error_.size() - 1) << error_;
    EXPECT_NE(error_.find(file), std::string::npos) << error_;
    EXPECT_NE(error_.find(part), std::string::npos) << error_;
    EXPECT_TRUE(out_.empty());
  };
  fails({path("plain.glb"), "--set", "shape0=0.8"}, "plain.glb", "neither key poses nor an animation");
  fails({path("one.glb"), "--set", "shape0=0.8"}, "one.glb", "only one pose is keyed yet");
  fails({path("one.glb"), "--leave-one-out"}, "one.glb", "only one pose is keyed yet");
  fails({path("faces.glb")}, "faces.glb", "nothing is posed in it");
  fails({path("faces.glb"), "--hold", "shap3"}, "faces.glb", "did you mean shape3?");
  fails({path("faces.glb"), "--hold", "mouth*"}, "faces.glb", "that begins so");
  fails({path("faces.glb"), "--set", "shape0=7"}, "faces.glb", "out of range");
  fails({path("faces.glb"), "--keys", path("none.glb"), "--set", "shape0=1"}, "none.glb", "cannot be opened");
  save("broken.session", std::string("# penpose session edition=11 program=test\n"));
  fails({path("broken.session")}, "broken.session", "");
  for (const char* strength : {"1.5", "nan", "-0.1"}) {
    EXPECT_EQ(run({"suggest", path("faces.glb"), "--strength", strength, "--set", "shape0=1"}), k_wrong_usage);
  }
  EXPECT_EQ(run({"suggest", path("faces.glb"), "--every", "0", "--set", "shape0=1"}), k_wrong_usage);
  EXPECT_EQ(run({"suggest", path("faces.glb"), "--leave-one-out", "--set", "shape0=1"}), k_wrong_usage);
  fails({path("faces.glb"), "--set", "shape0=1", "-o", path("faces.glb")}, "faces.glb", "");
}

class SharedSuggest : public tests::CommandRun {};

// A face that a tracker followed, every third of a second a key.
TEST_F(SharedSuggest, ATrackedFaceIsForetoldBetterThanByNotMovingAndByTheMean) {
  if (!tests::has_shared()) GTEST_SKIP();
  const auto shared = tests::shared_dir();
  ASSERT_EQ(run({"animate", (shared / "meshes/ict_face.glb").string(), "--track",
                 (shared / "tracks/openface_head_test.csv").string(), "-o", path("clip.glb")}),
            k_success)
      << error_;
  struct Drawn {
    std::vector<std::string> held;
    double beside_the_mean;
  };
  const std::vector<Drawn> drawn{
      {{"mouth*", "jaw*"}, 0.9}, {{"brow*", "eye*"}, 0.9}, {{"mouthSmile*", "mouthFrown*"}, 1.0}};
  for (const auto& [held, beside_the_mean] : drawn) {
    std::vector<std::string> arguments{"suggest", path("clip.glb"), "--every", "10", "--leave-one-out", "--json"};
    for (const std::string& one : held) arguments.insert(arguments.end(), {"--hold", one});
    ASSERT_EQ(run(arguments), k_success) << error_;
    const Json out = Json::parse(out_);
    EXPECT_GE(out["keys"].size(), 29U);
    EXPECT_LT(out["all"]["suggested"].get<double>(), 0.9 * out["all"]["not_moving"].get<double>()) << held.front();
    EXPECT_LT(out["all"]["suggested"].get<double>(), beside_the_mean * out["all"]["mean"].get<double>())
        << held.front();
  }
}

}  // namespace
}  // namespace penpose::cli
