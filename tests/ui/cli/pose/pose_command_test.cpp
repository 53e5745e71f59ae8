#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/document/document_hash.h"
#include "core/io/model/write_model.h"
#include "core/io/project/write_document.h"
#include "tests/support/command_run.h"
#include "tests/support/models/test_rigs.h"
#include "tests/support/shared_data.h"
#include "ui/cli/commands.h"
#include "ui/files/load_model.h"

namespace penpose::cli {
namespace {

using Json = nlohmann::json;

class PoseCommand : public tests::CommandRun {
 protected:
  void SetUp() override {
    CommandRun::SetUp();
    mesh_ = tests::grid_mesh(12, 12);
    model_ = document::make_model(mesh_, tests::random_shapes(*mesh_, 6, 2), nullptr).value();
    const auto glb = io::write_glb(model_).value();
    save("m.glb", std::string(glb.begin(), glb.end()));
    save("c.json", cases().dump());
  }
  /// Two cases: where a row lies when shape 3 or shape 1 is at 0.8.
  [[nodiscard]] Json cases() const {
    Json file = {{"mesh", "m.glb"}, {"cases", Json::array()}};
    for (const std::size_t shape : {3U, 1U}) {
      rig::Pose pose(6, 0.0);
      pose[shape] = 0.8;
      const auto at = tests::all_positions(*model_.rig, pose);
      Json reference = {{"vertices", Json::array()}, {"target", Json::array()}};
      for (std::uint32_t v = 0; v < at.size(); v += 3) {
        reference["vertices"].push_back(v);
        reference["target"].push_back({at[v].x, at[v].y, at[v].z});
      }
      file["cases"].push_back({{"name", "case" + std::to_string(shape)},
                               {"free", {"shape" + std::to_string(shape), "shape5"}},
                               {"references", {reference}}});
    }
    return file;
  }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) found.push_back(entry.path().filename());
    std::sort(found.begin(), found.end());
    return found;
  }
  int pose(const std::vector<std::string>& arguments) { return run("pose", arguments); }
  /// The work fails with one line that names the file, the place in it and a remedy; results are not printed.
  void expect_failure(std::vector<std::string> arguments, const std::string& file, const std::string& place) {
    EXPECT_EQ(pose(std::move(arguments)), k_failure);
    EXPECT_EQ(out_, "");
    EXPECT_EQ(error_.rfind("penpose: " + file, 0), 0U) << error_;
    EXPECT_NE(error_.find(place), std::string::npos) << error_;
    EXPECT_NE(error_.find("; "), std::string::npos) << "no remedy: " << error_;
    EXPECT_EQ(std::count(error_.begin(), error_.end(), '\n'), 1) << error_;
  }

  std::shared_ptr<const mesh::TriangleMesh> mesh_;
  document::Model model_;
};

class SharedPoseCommand : public PoseCommand {};

TEST_F(PoseCommand, AProjectKeepsItsKeys) {
  auto document = document::make_document(model_);
  document.timeline = std::make_shared<const document::Timeline>(
      document::Timeline{{{0, rig::Pose(6, 0.0), "rest"}, {1, rig::Pose(6, 0.25), "other"}}});
  const auto glb = io::write_project(document).value();
  save("p.glb", std::string(glb.begin(), glb.end()));
  ASSERT_EQ(pose({path("p.glb"), "--cases", path("c.json"), "--case", "case3", "-o", path("out.glb"), "--json"}), 0);
  const auto back = files::load_document(path("out.glb")).value();
  EXPECT_EQ(*back.timeline, *document.timeline);
  EXPECT_NEAR(back.pose[3], 0.8, 0.01);
  EXPECT_EQ(document::DocumentHasher()(back).whole.hex(), Json::parse(out_)["state"]);
}

TEST_F(PoseCommand, PrintsOneJsonObjectWithTheKeysThatScriptsRelyOn) {
  ASSERT_EQ(pose({path("m.glb"), "--cases", path("c.json"), "--json"}), k_success) << error_;
  EXPECT_EQ(error_, "");
  const Json result = Json::parse(out_);
  EXPECT_EQ(result.at("model"), path("m.glb"));
  EXPECT_GE(result.at("state").get<std::string>().size(), 32U);
  ASSERT_EQ(result.at("cases").size(), 2U);
  for (const Json& one : result.at("cases")) {
    EXPECT_TRUE(one.at("name").is_string());
    EXPECT_GT(one.at("variables").get<int>(), 0);
    EXPECT_LT(one.at("energy").get<double>(), 0.01 * one.at("energy_start").get<double>());
    EXPECT_LT(one.at("max_distance").get<double>(), 0.02);
    EXPECT_EQ(one.at("parameters").size(), 6U);
    EXPECT_GT(one.at("evaluations").get<int>(), 0);
    for (const auto& other : one.at("others")) {
      EXPECT_TRUE(other.at("above").is_number());
      EXPECT_TRUE(other.at("parameters").is_object());
    }
    EXPECT_GT(one.at("solve_us").get<double>(), 0);
  }
  EXPECT_NEAR(result.at("cases")[0].at("parameters").at("shape3").get<double>(), 0.8, 0.01);
  EXPECT_NEAR(result.at("cases")[1].at("parameters").at("shape1").get<double>(), 0.8, 0.01);
}

TEST_F(PoseCommand, SolvesTheCaseAskedForWithTheParametersAskedFor) {
  ASSERT_EQ(pose({path("m.glb"), "--cases", path("c.json"), "--case", "case1", "--free", "case", "--json"}), k_success);
  const Json result = Json::parse(out_);
  ASSERT_EQ(result.at("cases").size(), 1U);
  EXPECT_EQ(result.at("cases")[0].at("name"), "case1");
  EXPECT_LE(result.at("cases")[0].at("variables").get<int>(), 2);
  for (const char* name : {"shape0", "shape2", "shape3", "shape4"})
    EXPECT_EQ(result.at("cases")[0].at("parameters").at(name), 0.0);
}

TEST_F(PoseCommand, TheSameCallGivesTheSameState) {
  const auto state = [&] {
    EXPECT_EQ(pose({path("m.glb"), "--cases", path("c.json"), "--json"}), k_success);
    Json result = Json::parse(out_);
    for (Json& one : result.at("cases")) one.erase("solve_us");
    return result;
  };
  EXPECT_EQ(state(), state());
}

TEST_F(PoseCommand, WritesThePosedModel) {
  ASSERT_EQ(pose({path("m.glb"), "--cases", path("c.json"), "--case", "case3", "-o", path("out.glb"), "--json"}),
            k_success);
  const Json result = Json::parse(out_);
  const auto written = files::load_model(path("out.glb")).value();
  EXPECT_NEAR(written.pose[3], 0.8, 0.01);
  EXPECT_EQ(document::state_hash(written).hex(), result.at("state"));
  EXPECT_EQ(names(), (std::vector<std::string>{"c.json", "m.glb", "out.glb"}));
}

TEST_F(PoseCommand, TellsPeopleWhatItFound) {
  ASSERT_EQ(pose({path("m.glb"), "--cases", path("c.json")}), k_success);
  EXPECT_NE(out_.find("case3"), std::string::npos);
  EXPECT_NE(out_.find("shape3 = 0.8"), std::string::npos) << out_;
  EXPECT_EQ(error_, "");
}

TEST_F(PoseCommand, ThePapersPresetAndTheDrawnFormSolveToo) {
  for (const std::vector<std::string>& extra :
       {std::vector<std::string>{"--preset", "paper"}, {"--preset", "default"}, {"--form", "points"}}) {
    std::vector<std::string> arguments{path("m.glb"), "--cases", path("c.json"), "--free", "case", "--json"};
    arguments.insert(arguments.end(), extra.begin(), extra.end());
    ASSERT_EQ(pose(arguments), k_success) << error_;
    const Json one = Json::parse(out_).at("cases")[0];
    EXPECT_LT(one.at("energy").get<double>(), one.at("energy_start").get<double>());
  }
  // A line of two points instead of one target a vertex.
  Json file = cases();
  Json& reference = file["cases"][0]["references"][0];
  reference["vertices"] = {26, 28, 30, 33, 36};
  reference["target"] = {{0.1, 0.2, 0}, {0.9, 0.2, 0}};
  file["cases"].erase(1);
  save("line.json", file.dump());
  EXPECT_EQ(pose({path("m.glb"), "--cases", path("line.json"), "--form", "drawn", "--json"}), k_success) << error_;
  expect_failure({path("m.glb"), "--cases", path("line.json"), "--form", "points", "--json"}, path("line.json"),
                 "/cases/0/references/0/target");
}

TEST_F(PoseCommand, ExplainsHowALineCanBeRead) {
  Json file = cases();
  file["cases"].erase(1);
  Json& reference = file["cases"][0]["references"][0];
  reference["vertices"] = {26, 28, 30, 33, 36};
  reference["target"] = {{0.1, 0.2, 0}, {0.9, 0.25, 0}};
  save("line.json", file.dump());
  const std::vector<std::string> drawn{path("m.glb"), "--cases", path("line.json"), "--form", "drawn", "--explain"};
  ASSERT_EQ(pose(drawn), k_success) << error_;
  for (const char* word : {"reading 1", "evidence", "energy", "probability", "weight"})
    EXPECT_NE(out_.find(word), std::string::npos) << out_;
  auto as_json = drawn;
  as_json.emplace_back("--json");
  ASSERT_EQ(pose(as_json), k_success) << error_;
  double sum = 0;
  const Json answer = Json::parse(out_);
  for (const Json& reading : answer.at("cases")[0].at("readings")) {
    sum += reading.at("probability").get<double>();
    double energy = 0;
    for (const auto& [name, pair] : reading.at("terms").items())
      energy += pair[0].get<double>() * pair[1].get<double>();
    EXPECT_NEAR(reading.at("energy").get<double>(), energy, 1e-4);
  }
  EXPECT_NEAR(sum, 1, 1e-4);
}

TEST_F(PoseCommand, WrongUsageExitsWithTwo) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{},
                                                    {path("m.glb")},
                                                    {"--cases", path("c.json")},
                                                    {path("m.glb"), "--cases", path("c.json"), "--free", "none"},
                                                    {path("m.glb"), "--cases", path("c.json"), "--form", "dots"},
                                                    {path("m.glb"), "--cases", path("c.json"), "--preset", "fast"},
                                                    {path("m.glb"), "--cases", path("c.json"), "--no-such-option"},
                                                    {path("m.glb"), path("m.glb"), "--cases", path("c.json")}}) {
    EXPECT_EQ(pose(arguments), k_wrong_usage);
    EXPECT_EQ(out_, "");
    EXPECT_NE(error_, "");
  }
  EXPECT_EQ(pose({"--help"}), k_success);
  EXPECT_NE(out_.find("--cases"), std::string::npos);
  EXPECT_EQ(run({"no-such-command"}), k_wrong_usage);
}

TEST_F(PoseCommand, WhatFailsNamesFilePlaceAndRemedy) {
  const std::string model = path("m.glb");
  expect_failure({path("missing.glb"), "--cases", path("c.json")}, path("missing.glb"), "cannot be opened");
  expect_failure({folder_.string(), "--cases", path("c.json")}, folder_.string(), "is a folder");
  expect_failure({model, "--cases", path("missing.json")}, path("missing.json"), "cannot be opened");
  expect_failure({path("c.json"), "--cases", path("c.json")}, path("c.json"), "");
  expect_failure({model, "--cases", model}, model, "");

  const auto with = [&](auto spoil) {
    Json file = cases();
    spoil(file);
    save("bad.json", file.dump());
    return std::vector<std::string>{model, "--cases", path("bad.json"), "--json"};
  };
  const std::string bad = path("bad.json");
  expect_failure(with([](Json& f) { f["cases"][1]["free"][0] = "nobody"; }), bad, "/cases/1/free/0");
  expect_failure(with([](Json& f) { f["cases"][0]["references"][0]["vertices"][2] = 169; }), bad,
                 "/cases/0/references/0/vertices/2");
  expect_failure(with([](Json& f) { f["cases"][0]["references"][0]["vertices"][2] = -1; }), bad,
                 "/cases/0/references/0/vertices/2");
  expect_failure(with([](Json& f) { f["cases"][0]["references"][0]["vertices"] = {4}; }), bad,
                 "/cases/0/references/0/vertices");
  expect_failure(with([](Json& f) {
                   f["cases"][0]["references"][0]["vertices"] = {4, 4, 4};
                 }),
                 bad, "/cases/0/references/0/");
  expect_failure(with([](Json& f) { f["cases"][1]["references"][0]["target"].erase(3); }), bad,
                 "/cases/1/references/0/target");
  expect_failure(with([](Json& f) { f["cases"][1]["name"] = f["cases"][0]["name"]; }), bad, "/cases/1/name");
  expect_failure(with([](Json& f) { f["cases"] = Json::array(); }), bad, "/cases");
  expect_failure(with([](Json& f) { f["cases"][0].erase("references"); }), bad, "references");
  expect_failure({model, "--cases", path("c.json"), "--case", "frown"}, path("c.json"), "frown");

  save("truncated.glb", [&] {
    std::ifstream file(folder_ / "m.glb", std::ios::binary);
    std::string whole{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    return whole.substr(0, whole.size() / 2);
  }());
  expect_failure({path("truncated.glb"), "--cases", path("c.json")}, path("truncated.glb"), "");
}

TEST_F(PoseCommand, NothingIsHalfWrittenOnFailure) {
  const auto before = names();
  // Two cases do not fit into one file; an unknown format; a folder that does not exist.
  expect_failure({path("m.glb"), "--cases", path("c.json"), "-o", path("out.glb")}, path("out.glb"), "--case");
  EXPECT_EQ(pose({path("m.glb"), "--cases", path("c.json"), "--case", "case1", "-o", path("out.ply")}), k_failure);
  EXPECT_NE(error_.find("out.ply"), std::string::npos);
  EXPECT_EQ(pose({path("m.glb"), "--cases", path("c.json"), "--case", "case1", "-o", path("no/out.glb")}), k_failure);
  EXPECT_EQ(names(), before);
  // A file that stands there already keeps its content.
  save("kept.glb", "old");
  Json file = cases();
  file["cases"][0]["free"][0] = "nobody";
  save("bad.json", file.dump());
  EXPECT_EQ(pose({path("m.glb"), "--cases", path("bad.json"), "--case", "case1", "-o", path("kept.glb")}), k_failure);
  std::ifstream kept(folder_ / "kept.glb");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(kept), {}), "old");
}

TEST_F(PoseCommand, CaseFilesOfAnyBytesAreAnErrorNotACrash) {
  const std::string whole = cases().dump();
  tests::Random random(7);
  for (int run = 0; run < 150; ++run) {
    std::string text = whole.substr(0, run % 3 == 0 ? random.index(whole.size()) : whole.size());
    for (std::size_t i = 0; i < 1 + random.index(4) && !text.empty(); ++i)
      text[random.index(text.size())] = static_cast<char>(random.index(256));
    save("any.json", text);
    const int status =
        pose({path("m.glb"), "--cases", path("any.json"), "--case", "case1", "--free", "case", "--json"});
    EXPECT_TRUE(status == k_success || status == k_failure);
    EXPECT_EQ(std::count(error_.begin(), error_.end(), '\n'), status == k_success ? 0 : 1) << error_;
  }
}

TEST_F(SharedPoseCommand, PosesTheRealFaceFromEveryCaseFile) {
  if (!tests::has_shared()) GTEST_SKIP();
  const auto meshes = tests::shared_dir() / "meshes";
  for (const char* file : {"ict_face_pose_cases.json", "ict_face_sketch_cases.json"}) {
    ASSERT_EQ(pose({(meshes / "ict_face.glb").string(), "--cases", (meshes / file).string(), "--json"}), k_success)
        << error_;
    EXPECT_EQ(error_, "");
    for (const Json& one : Json::parse(out_).at("cases"))
      EXPECT_LT(one.at("energy").get<double>(), one.at("energy_start").get<double>()) << one.at("name");
  }
}

}  // namespace
}  // namespace penpose::cli
