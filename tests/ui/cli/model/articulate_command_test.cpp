#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/io/model/write_model.h"
#include "core/io/project/sketch_file.h"
#include "core/io/project/write_document.h"
#include "tests/support/command_run.h"
#include "tests/support/models/sketched_models.h"
#include "tests/support/shared_data.h"
#include "ui/cli/commands.h"
#include "ui/files/load_model.h"

namespace penpose::cli {
namespace {

class ArticulateCommand : public tests::CommandRun {
 protected:
  void SetUp() override {
    CommandRun::SetUp();
    const tests::Trunk trunk = tests::make_trunk();
    const auto bytes = io::write_glb(tests::bare_trunk(trunk)).value();
    save("model.glb", std::string(bytes.begin(), bytes.end()));
    file_.viewport = trunk.viewport;
    file_.sketches = {trunk.curl()};
    save("sketch.json", io::write_sketch_file(file_));
  }
  int articulate(const std::vector<std::string>& arguments) { return run("articulate", arguments); }

  io::SketchFile file_;
};

class SharedElephant : public ArticulateCommand {};

TEST_F(ArticulateCommand, AProjectKeepsItsKeysAndViews) {
  auto document = files::load_document(path("model.glb")).value();
  document.timeline =
      std::make_shared<const document::Timeline>(document::Timeline{{{0, rig::Pose(), ""}, {1, rig::Pose(), ""}}});
  document.views = {std::make_shared<const document::NamedView>(document::NamedView{"front", {}})};
  const auto project = io::write_project(document).value();
  save("project.glb", std::string(project.begin(), project.end()));
  ASSERT_EQ(articulate({path("project.glb"), "--sketch", path("sketch.json"), "-o", path("out.glb")}), k_success)
      << error_;
  const auto back = files::load_document(path("out.glb")).value();
  ASSERT_TRUE(back.model->deformers);
  ASSERT_EQ(back.timeline->keys.size(), 2U);
  EXPECT_EQ(back.timeline->keys[1].pose.size(), back.model->rig->parameters().size());
  EXPECT_EQ(back.views.size(), 1U);
}

TEST_F(ArticulateCommand, WritesAModelWithTheNewControl) {
  ASSERT_EQ(articulate({path("model.glb"), "--sketch", path("sketch.json"), "-o", path("out.glb"), "--json"}),
            k_success)
      << error_;
  const auto json = nlohmann::json::parse(out_);
  EXPECT_EQ(json["deformers"][0]["name"], "curl");
  EXPECT_EQ(json["deformers"][0]["mode"], "rotate");
  EXPECT_GE(json["state"].get<std::string>().size(), 32U);
  const auto model = files::load_model(path("out.glb"));
  ASSERT_TRUE(model.ok()) << model.error().line();
  ASSERT_TRUE(model->deformers);
  EXPECT_EQ(document::state_hash(*model).hex(), json["state"]);
  // A second sketch adds to the first.
  file_.sketches[0].name = "second";
  save("second.json", io::write_sketch_file(file_));
  ASSERT_EQ(articulate({path("out.glb"), "--sketch", path("second.json"), "-o", path("both.glb")}), k_success);
  EXPECT_NE(out_.find("second: rotate"), std::string::npos);
  EXPECT_EQ(files::load_model(path("both.glb"))->deformers->size(), 2U);
}

/// How many targets beside the sample a curl was baked to, and how far it is off, share of the size.
struct Baked {
  int targets = -1;
  double error = -1;
};
Baked baked_of(const std::string& error) {
  Baked baked;
  const auto targets = error.find("baked to ");
  const auto off = error.find("off by over ");
  if (targets != std::string::npos) baked.targets = std::stoi(error.substr(targets + 9));
  if (off != std::string::npos) baked.error = std::stod(error.substr(off + 12)) / 100;
  return baked;
}

TEST_F(ArticulateCommand, BakesAsExactlyAsAsked) {
  ASSERT_EQ(articulate({path("model.glb"), "--sketch", path("sketch.json"), "-o", path("out.glb")}), k_success);
  const Baked first = baked_of(error_);
  EXPECT_GT(first.targets, 0) << error_;
  EXPECT_LE(first.error, 1e-4) << error_;
  const auto again = [&](const char* command, const char* tolerance) {
    const std::string to = path("again.glb");
    std::vector<std::string> arguments{command};
    if (arguments[0] == "convert") arguments.insert(arguments.end(), {path("out.glb"), to});
    if (arguments[0] == "articulate")
      arguments.insert(arguments.end(), {path("model.glb"), "--sketch", path("sketch.json"), "-o", to});
    if (arguments[0] == "animate")
      arguments.insert(arguments.end(), {path("out.glb"), "--track", path("take.csv"), "-o", to});
    arguments.insert(arguments.end(), {"--tolerance", tolerance});
    return run(arguments);
  };
  save("take.csv", "Timecode,BlendShapeCount,curl\n0:0:0:0,1,0\n0:0:1:0,1,1\n");
  for (const char* command : {"articulate", "convert", "animate"}) {
    ASSERT_EQ(again(command, "1e-3"), k_success) << error_;
    const Baked usual = baked_of(error_);
    EXPECT_LE(usual.error, 1e-3) << command << error_;
    ASSERT_EQ(again(command, "0.02"), k_success) << error_;
    const Baked loose = baked_of(error_);
    EXPECT_LT(loose.targets, usual.targets) << command << error_;
    EXPECT_GT(loose.error, usual.error) << command << error_;
    EXPECT_LE(loose.error, 0.02) << command << error_;
    ASSERT_EQ(again(command, "2e-5"), k_success) << error_;
    const Baked tight = baked_of(error_);
    EXPECT_GT(tight.targets, usual.targets) << command << error_;
    EXPECT_LE(tight.error, 2e-5) << command << error_;
    for (const char* bad : {"0", "1e-7", "0.2", "nan", "-1", "x"}) EXPECT_EQ(again(command, bad), k_wrong_usage) << bad;
  }
}

TEST_F(ArticulateCommand, SaysWhereASketchIsWrong) {
  const auto fails = [&](const char* expected) {
    save("bad.json", io::write_sketch_file(file_));
    EXPECT_EQ(articulate({path("model.glb"), "--sketch", path("bad.json"), "-o", path("out.glb")}), k_failure);
    EXPECT_NE(error_.find(expected), std::string::npos) << error_;
    EXPECT_NE(error_.find("bad.json"), std::string::npos) << error_;
    EXPECT_FALSE(std::filesystem::exists(path("out.glb")));
  };
  const auto good = file_.sketches[0];
  file_.sketches[0].reference = {{1, 1}, {5, 5}};
  fails("/deformers/0/reference");
  file_.sketches[0] = good;
  file_.sketches[0].surface = articulation::PartSurface{"skull"};
  fails("/deformers/0/surface/mesh");
  file_.sketches.clear();
  fails("/deformers");
}

TEST_F(ArticulateCommand, RefusesANameThatIsTakenAndOutputsThatCannotHoldDeformers) {
  ASSERT_EQ(articulate({path("model.glb"), "--sketch", path("sketch.json"), "-o", path("out.glb")}), k_success);
  EXPECT_EQ(articulate({path("out.glb"), "--sketch", path("sketch.json"), "-o", path("two.glb")}), k_failure);
  EXPECT_NE(error_.find("/deformers/0/name"), std::string::npos);
  EXPECT_EQ(articulate({path("model.glb"), "--sketch", path("sketch.json"), "-o", path("out.obj")}), k_failure);
  EXPECT_EQ(articulate({path("model.glb"), "-o", path("out.glb")}), k_wrong_usage);
}

TEST_F(ArticulateCommand, ByThePaperWarnsOfATargetThatWasTurnedRound) {
  file_.sketches[0].paper = true;
  save("sketch.json", io::write_sketch_file(file_));
  const std::vector<std::string> arguments{path("model.glb"), "--sketch", path("sketch.json"), "-o", path("out.glb")};
  ASSERT_EQ(articulate(arguments), k_success) << error_;
  EXPECT_EQ(out_.find("warning"), std::string::npos) << out_;
  auto as_json = arguments;
  as_json.emplace_back("--json");
  ASSERT_EQ(articulate(as_json), k_success);
  EXPECT_EQ(nlohmann::json::parse(out_)["deformers"][0]["target_turned_round"], false);
  EXPECT_TRUE(nlohmann::json::parse(out_)["deformers"][0]["notes"].empty());

  auto& target = file_.sketches[0].target;
  std::reverse(target.begin(), target.end());
  save("sketch.json", io::write_sketch_file(file_));
  ASSERT_EQ(articulate(arguments), k_success) << error_;
  EXPECT_NE(out_.find("warning: the target was turned round"), std::string::npos) << out_;
  ASSERT_EQ(articulate(as_json), k_success);
  EXPECT_EQ(nlohmann::json::parse(out_)["deformers"][0]["target_turned_round"], true);
  EXPECT_EQ(nlohmann::json::parse(out_)["deformers"][0]["notes"].size(), 1U);
  // A curve that goes straight is turned round without harm.
  file_.sketches[0].mode = articulation::Mode::translate;
  save("sketch.json", io::write_sketch_file(file_));
  ASSERT_EQ(articulate(arguments), k_success) << error_;
  EXPECT_EQ(out_.find("warning"), std::string::npos) << out_;
}

TEST_F(ArticulateCommand, WarnsOfATargetThatWasTurnedRound) {
  auto& target = file_.sketches[0].target;
  std::reverse(target.begin(), target.end());
  save("sketch.json", io::write_sketch_file(file_));
  ASSERT_EQ(articulate({path("model.glb"), "--sketch", path("sketch.json"), "-o", path("out.glb")}), k_success);
  EXPECT_NE(out_.find("warning: the target ran against the feature and was turned round"), std::string::npos) << out_;
}

TEST_F(ArticulateCommand, WarnsOfStrokesDrawnOnAnotherModelAndOfMembersItDoesNotKnow) {
  file_.model = "/somewhere/model.glb";
  save("sketch.json", io::write_sketch_file(file_));
  const std::vector<std::string> arguments{path("model.glb"), "--sketch", path("sketch.json"), "-o", path("out.glb")};
  ASSERT_EQ(articulate(arguments), k_success) << error_;
  EXPECT_EQ(out_.find("warning"), std::string::npos) << out_;

  file_.model = "horse.glb";
  std::string text = io::write_sketch_file(file_);
  text.replace(text.find("\"name\""), 6, "\"rang\": [0, 2], \"name\"");
  save("sketch.json", text);
  ASSERT_EQ(articulate(arguments), k_success) << error_;
  EXPECT_NE(out_.find("drawn on horse.glb"), std::string::npos) << out_;
  EXPECT_NE(out_.find("/deformers/0/rang is not known"), std::string::npos) << out_;
}

using Curve = std::vector<geometry::ModelPoint>;

geometry::ModelVector end_direction(const Curve& curve) {
  return geometry::normalized(curve.back() - curve[curve.size() - 3]);
}

/// The amount at which the end of the curve has turned by so much.
double amount_of_bend(const articulation::Deformer& deformer, double degrees) {
  const auto start = end_direction(deformer.curve_at(0));
  const double wanted = std::cos(degrees * tests::k_degree);
  double low = 0;
  double high = 1;
  EXPECT_LT(glm::dot(start, end_direction(deformer.curve_at(high))), wanted) << "the whole bend is less";
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    (glm::dot(start, end_direction(deformer.curve_at(middle))) > wanted ? low : high) = middle;
  }
  return high;
}

/// Every segment's length goes straight from that of the reference to that of the target.
void expect_exact_lengths(const articulation::Deformer& deformer) {
  const auto r = deformer.reference();
  const auto t = deformer.target();
  for (const double amount : {0.25, 0.5, 1.0}) {
    const Curve now = deformer.curve_at(amount);
    for (std::size_t j = 0; j + 1 < r.size(); ++j) {
      const double from = geometry::distance(r[j], r[j + 1]);
      const double to = geometry::distance(t[j], t[j + 1]);
      EXPECT_NEAR(geometry::distance(now[j], now[j + 1]), from + amount * (to - from), 1e-12);
    }
  }
}

/// Of pairs of vertices that face each other across the trunk, the largest change of their mean distance in one of
/// eight sections along it.
double largest_change_of_width(const articulation::Deformer& deformer, const Curve& rest, const Curve& now) {
  constexpr std::size_t k_sections = 8;
  const auto line = deformer.reference();
  const auto place = [&](const geometry::ModelPoint& p) {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
      if (geometry::distance(p, line[i]) < geometry::distance(p, line[nearest])) nearest = i;
    }
    return nearest;
  };
  std::vector<std::uint32_t> full;
  for (std::size_t i = 0; i < deformer.vertices().size(); ++i) {
    if (deformer.weights()[i] == 1.0) full.push_back(deformer.vertices()[i]);
  }
  std::array<double, k_sections> before{};
  std::array<double, k_sections> after{};
  std::array<int, k_sections> pairs{};
  for (const std::uint32_t a : full) {
    const std::size_t k = place(rest[a]);
    if (k == 0 || k + 1 >= line.size()) continue;  // its foot and its tip have no section
    const auto along = geometry::normalized(line[k + 1] - line[k - 1]);
    for (const std::uint32_t b : full) {
      const auto across = rest[b] - rest[a];
      if (b <= a || geometry::length(across) < 0.02 ||
          std::abs(glm::dot(across, along)) > 0.2 * geometry::length(across))
        continue;
      const std::size_t section = k * k_sections / line.size();
      before[section] += geometry::length(across);
      after[section] += geometry::distance(now[a], now[b]);
      ++pairs[section];
    }
  }
  double worst = 0;
  int measured = 0;
  for (std::size_t i = 0; i < k_sections; ++i) {
    if (pairs[i] < 8) continue;
    ++measured;
    worst = std::max(worst, std::abs(after[i] / before[i] - 1.0));
  }
  EXPECT_GE(measured, 5);
  return worst;
}

TEST_F(SharedElephant, CurlsItsTrunkFromFourStrokes) {
  if (!tests::has_shared()) GTEST_SKIP();
  articulation::Sketch trunk;
  trunk.name = "trunk_curl";
  trunk.viewport = {1000, 1000};
  trunk.camera = {{1.6, 0.3, 0.9}, {0, 0.3, 0.05}, {0, 1, 0}, 18};
  trunk.general = {{260, 400}, {350, 395}, {470, 360}, {500, 320}, {760, 310}, {760, 60}, {300, 120}, {260, 250}};
  trunk.specific = {{270, 310}, {380, 330}, {470, 310}, {520, 285}, {740, 280}, {740, 80}, {330, 140}};
  trunk.reference = {{390, 325}, {400, 260}, {450, 220}, {530, 190}, {620, 185}, {670, 205}};
  trunk.target = {{390, 325}, {395, 250}, {435, 195}, {505, 180}, {570, 205}, {600, 260}, {572, 305}};
  file_.sketches = {trunk};
  save("elephant.json", io::write_sketch_file(file_));
  const std::string elephant = (tests::shared_dir() / "meshes" / "elephant.glb").string();
  ASSERT_EQ(articulate({elephant, "--sketch", path("elephant.json"), "-o", path("out.glb")}), k_success) << error_;
  auto model = files::load_model(path("out.glb")).value();
  ASSERT_TRUE(model.deformers);
  const auto& deformer = *model.deformers->deformers()[0];
  EXPECT_EQ(deformer.mode(), articulation::Mode::rotate);
  const auto rest = document::posed_positions(model);
  model.pose = {1.0};
  const auto curled = document::posed_positions(model);
  std::vector<bool> moves(rest.size(), false);
  for (const std::uint32_t v : deformer.vertices()) moves[v] = true;
  double farthest = 0;
  std::uint32_t lowest_moved = 0;
  for (std::uint32_t v = 0; v < rest.size(); ++v) {
    if (!moves[v]) {
      EXPECT_EQ(curled[v], rest[v]);
    }
    if (moves[v] && rest[v].y < rest[lowest_moved].y) lowest_moved = v;
    farthest = std::max(farthest, geometry::distance(curled[v], rest[v]));
  }
  EXPECT_GT(farthest, 0.08);  // the trunk is about 0.2 long there
  EXPECT_LT(farthest, 0.25);
  for (std::uint32_t v = 0; v < rest.size(); ++v) EXPECT_TRUE(!moves[v] || rest[v].y > 0.3);
  expect_exact_lengths(deformer);
  const double right_angle = amount_of_bend(deformer, 90);
  model.pose = {right_angle};
  EXPECT_LT(largest_change_of_width(deformer, rest, document::posed_positions(model)), 0.10);
}

}  // namespace
}  // namespace penpose::cli
