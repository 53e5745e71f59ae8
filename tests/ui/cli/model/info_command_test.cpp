#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/io/model/write_model.h"
#include "tests/support/command_run.h"
#include "tests/support/models/figure_sample.h"
#include "tests/support/models/model_samples.h"
#include "tests/support/models/whole_avatar.h"
#include "tests/support/shared_data.h"

namespace penpose::cli {
namespace {

class InfoCommand : public tests::CommandRun {};
class SharedInfoCommand : public tests::CommandRun {};

TEST_F(InfoCommand, JsonSaysWhatIsInTheModel) {
  save("full.glb", io::write_glb(tests::full_model()).value());
  ASSERT_EQ(run({"info", "--json", path("full.glb")}), 0) << error_;
  const auto info = nlohmann::json::parse(out_);
  EXPECT_EQ(info["vertices"], 20);
  EXPECT_EQ(info["faces"], 10);
  EXPECT_EQ(info["components"], 5);
  EXPECT_EQ(info["parts"][3]["name"], "arm");
  EXPECT_EQ(info["blend_shapes"], 4);
  EXPECT_EQ(info["joints"], 4);
  EXPECT_EQ(info["parameters"].size(), 13U);
  EXPECT_EQ(info["parameters"][1], nlohmann::json({{"name", "all over"},
                                                   {"minimum", -1.0},
                                                   {"maximum", 2.0},
                                                   {"rest", 0.25},
                                                   {"value", -0.75},
                                                   {"words", "all over"}}));
  EXPECT_TRUE(info["doubles"].is_array());
  EXPECT_EQ(info["curves"][0], nlohmann::json({{"name", "brow"}, {"points", 2}}));
  EXPECT_EQ(info["animations"][0]["name"], "wave");
  EXPECT_EQ(info["animations"][0]["duration_s"], 2.0);
  EXPECT_EQ(info["bounding_box"]["minimum"].size(), 3U);
  EXPECT_EQ(info["state"].get<std::string>().size(), 32U);
  EXPECT_EQ(error_, "");
}

TEST_F(InfoCommand, SaysWhatControlsDo) {
  save("avatar.vrm", tests::whole_avatar(1).glb());
  ASSERT_EQ(run({"info", path("avatar.vrm")}), 0) << error_;
  EXPECT_NE(out_.find("1.5708  head turns\n"), std::string::npos) << out_;
  ASSERT_EQ(run({"info", "--json", path("avatar.vrm")}), 0) << error_;
  const auto parameters = nlohmann::json::parse(out_)["parameters"];
  const auto turns =
      std::find_if(parameters.begin(), parameters.end(), [](const auto& one) { return one["words"] == "head turns"; });
  ASSERT_NE(turns, parameters.end());
  EXPECT_EQ((*turns)["name"], "bone 4.ry");
}

TEST_F(InfoCommand, ListsTheExpressionsOfAnAvatar) {
  save("avatar.vrm", tests::avatar_sample(tests::upright_bones()).glb());
  ASSERT_EQ(run({"info", path("avatar.vrm")}), 0) << error_;
  EXPECT_NE(out_.find("expressions 1\n  happy = 0.5000 lift\n"), std::string::npos) << out_;
  ASSERT_EQ(run({"info", "--json", path("avatar.vrm")}), 0) << error_;
  EXPECT_EQ(nlohmann::json::parse(out_)["expressions"],
            nlohmann::json::parse(R"([{"name": "happy", "values": {"lift": 0.5}}])"));
}

TEST_F(InfoCommand, NamesHeadEyesAndJawOfAFigure) {
  save("avatar.vrm", tests::whole_avatar(1).glb());
  ASSERT_EQ(run({"info", path("avatar.vrm")}), 0) << error_;
  const char* line = "humanoid    20 bones; neck bone 3, head bone 4, leftEye bone 5, rightEye bone 6, jaw bone 7\n";
  EXPECT_NE(out_.find(line), std::string::npos) << out_;
  ASSERT_EQ(run({"info", "--json", path("avatar.vrm")}), 0) << error_;
  const auto humanoid = nlohmann::json::parse(out_)["humanoid"];
  EXPECT_EQ(humanoid.size(), 20U);
  EXPECT_EQ(humanoid["leftHand"], "bone 16");
  save("morph.glb", tests::morph_sample().glb());
  ASSERT_EQ(run({"info", path("morph.glb")}), 0) << error_;
  EXPECT_EQ(out_.find("humanoid"), std::string::npos) << out_;
}

TEST_F(InfoCommand, TextNamesPartsParametersAndCurves) {
  save("full.glb", io::write_glb(tests::full_model()).value());
  ASSERT_EQ(run({"info", path("full.glb")}), 0) << error_;
  for (const char* word : {"vertices    20", "arm", "all over", "at -0.7500", "ball.rx", "brow", "wave"}) {
    EXPECT_NE(out_.find(word), std::string::npos) << word << "\n" << out_;
  }
}

TEST_F(InfoCommand, SaysWhichAxisOfASurfaceIsUp) {
  save("lying.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 2 4\nf 1 4 3\n"));
  ASSERT_EQ(run({"info", path("lying.obj")}), 0) << error_;
  EXPECT_NE(out_.find("up          y in the file; if the model lies on its back, z is: --up z"), std::string::npos)
      << out_;
  ASSERT_EQ(run({"info", "--up", "z", path("lying.obj")}), 0) << error_;
  EXPECT_NE(out_.find("up          z in the file\n"), std::string::npos) << out_;
  EXPECT_NE(out_.find("to  1.0000 3.0000 0.0000"), std::string::npos) << out_;
  // Saved, it stands, and says nothing of it any more.
  ASSERT_EQ(run({"convert", "--up", "z", path("lying.obj"), path("standing.glb")}), 0) << error_;
  ASSERT_EQ(run({"info", path("standing.glb")}), 0) << error_;
  EXPECT_NE(out_.find("to  1.0000 3.0000 0.0000"), std::string::npos) << out_;
  EXPECT_EQ(out_.find("up  "), std::string::npos) << out_;
  EXPECT_EQ(run({"info", "--up", "z", path("standing.glb")}), 1);
  EXPECT_NE(error_.find("--up"), std::string::npos) << error_;
}

TEST_F(InfoCommand, FaultsAreOneLineAndStatusOne) {
  save("cut.glb", std::string("glTF\2\0\0\0", 8));
  save("bad.obj", std::string("v 0 0 0\nf 1 2 3\n"));
  for (const char* name : {"cut.glb", "bad.obj", "missing.glb"}) {
    EXPECT_EQ(run({"info", path(name)}), 1);
    EXPECT_EQ(out_, "");
    EXPECT_EQ(std::count(error_.begin(), error_.end(), '\n'), 1);
    EXPECT_NE(error_.find(name), std::string::npos);
  }
  EXPECT_EQ(run({"info", path("bad.obj")}), 1);
  EXPECT_NE(error_.find("line 2"), std::string::npos);
  EXPECT_EQ(run({"info"}), 2);
}

TEST_F(SharedInfoCommand, IctFace) {
  if (!tests::has_shared()) GTEST_SKIP();
  ASSERT_EQ(run({"info", "--json", (tests::shared_dir() / "meshes" / "ict_face.glb").string()}), 0) << error_;
  const auto info = nlohmann::json::parse(out_);
  EXPECT_EQ(info["vertices"], 26719);
  EXPECT_EQ(info["components"], 56);
  EXPECT_EQ(info["parameters"].size(), 53U);
  EXPECT_NEAR(info["bounding_box"]["maximum"][1].get<double>(), 14.5047, 1e-4);
}

}  // namespace
}  // namespace penpose::cli
