#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/character/demo_head.h"
#include "core/document/features/feature_curves.h"
#include "core/io/picture_lines/svg/write_svg_lines.h"
#include "core/portrait/pose_from_drawing.h"
#include "core/portrait/silhouette.h"
#include "tests/support/command_run.h"
#include "ui/cli/commands.h"

namespace penpose::cli {
namespace {

using Json = nlohmann::json;

/// Drawings of the built-in head by its own curves.
class DrawCommand : public tests::CommandRun {
 protected:
  static void SetUpTestSuite() {
    model_ = new document::Model(character::make_demo_head().value());
    const auto whole = intent::measure_whole_model(*model_->rig);
    curves_ = new std::vector<portrait::FeatureCurve>(document::feature_curves_of(*model_, whole, {}).value().curves);
  }
  static void TearDownTestSuite() {
    delete model_;
    delete curves_;
  }

  /// An SVG of the curves with the jaw so far open.
  [[nodiscard]] static std::string drawing(double jaw) {
    const rig::Rig& rig = *model_->rig;
    rig::Pose pose = rig::rest_pose(rig);
    const auto camera = portrait::camera_of_drawing(rig, *curves_, pose, 0);
    pose[rig::find_parameter(rig.parameters(), "jaw").value()] = jaw;
    std::vector<geometry::ModelPoint> places(rig.vertex_count());
    rig.evaluate(pose, places);
    io::PictureLines out{{}, 1000, 1000};
    for (const portrait::FeatureCurve& curve : *curves_) {
      io::PictureLine line;
      for (const posing::CurvePoint& point : curve.points)
        line.points.push_back(camera.project(portrait::place_of(point, places)).value());
      out.lines.push_back(std::move(line));
    }
    return io::write_svg_lines(out);
  }
  int draw(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "builtin:demo");
    return run("draw", std::move(arguments));
  }
  void expect_failure(const std::vector<std::string>& arguments, const std::string& line) {
    EXPECT_EQ(draw(arguments), k_failure) << out_;
    EXPECT_EQ(out_, "");
    EXPECT_EQ(std::count(error_.begin(), error_.end(), '\n'), 1) << error_;
    EXPECT_NE(error_.find(line), std::string::npos) << error_;
  }

  static inline document::Model* model_ = nullptr;
  static inline std::vector<portrait::FeatureCurve>* curves_ = nullptr;
};

TEST_F(DrawCommand, PosesTheFaceAndWritesIt) {
  save("open.svg", drawing(0.5));
  ASSERT_EQ(draw({path("open.svg"), "--json", "-o", path("open.glb")}), k_success) << error_;
  const Json out = Json::parse(out_);
  EXPECT_EQ(out["model"], "builtin:demo");
  EXPECT_EQ(out["drawing"], path("open.svg"));
  EXPECT_NEAR(out["parameters"]["jaw"].get<double>(), 0.5, 0.1);
  ASSERT_EQ(out["lines"].size(), curves_->size());
  std::size_t right = 0;
  for (std::size_t i = 0; i < curves_->size(); ++i) {
    EXPECT_EQ(out["lines"][i]["index"], i);
    right += out["lines"][i]["curve"] == (*curves_)[i].name ? 1U : 0U;
  }
  EXPECT_GE(right, curves_->size() - 1);
  EXPECT_FALSE(out.contains("drawings") || out.contains("time_s"));
  ASSERT_EQ(run({"info", path("open.glb"), "--json"}), k_success) << error_;
  EXPECT_EQ(Json::parse(out_)["state"], out["state"]);
  ASSERT_EQ(draw({path("open.svg")}), k_success);
  EXPECT_NE(out_.find("line 0: "), std::string::npos) << out_;
  EXPECT_NE(out_.find("  jaw  0.0000 -> 0."), std::string::npos) << out_;
}

TEST_F(DrawCommand, AFolderOfDrawingsIsKeysInTheOrderOfTheirNames) {
  std::filesystem::create_directories(folder_ / "board");
  save("board/face10.svg", drawing(0.25));
  save("board/face2.SVG", drawing(0.6));
  save("board/rest.svg", drawing(0));
  save("board/.left.svg", std::string("no drawing"));
  save("board/notes.txt", std::string("no drawing either"));
  ASSERT_EQ(
      draw({path("board"), "--neutral", path("board/rest.svg"), "--every", "0.5", "--json", "-o", path("keyed.glb")}),
      k_success)
      << error_;
  const Json out = Json::parse(out_);
  ASSERT_EQ(out["drawings"].size(), 2U) << "the face at rest is none of them";
  const Json& first = out["drawings"][0];
  const Json& second = out["drawings"][1];
  EXPECT_EQ(first["drawing"], path("board/face2.SVG"));
  EXPECT_EQ(first["time_s"], 0);
  EXPECT_NEAR(first["parameters"]["jaw"].get<double>(), 0.6, 0.12);
  EXPECT_EQ(second["drawing"], path("board/face10.svg"));
  EXPECT_EQ(second["time_s"], 0.5);
  EXPECT_NEAR(second["parameters"]["jaw"].get<double>(), 0.25, 0.08);
  EXPECT_EQ(second["neutral_lines"].size(), curves_->size());
  ASSERT_EQ(run({"info", path("keyed.glb"), "--json"}), k_success) << error_;
  EXPECT_EQ(Json::parse(out_)["state"], out["state"]);
  // More drawings come behind the keys that are there.
  ASSERT_EQ(run({"draw", path("keyed.glb"), path("board/rest.svg"), path("board/face2.SVG"), "-o", path("more.glb")}),
            k_success)
      << error_;
  EXPECT_NE(out_.find("rest.svg: key at 1.5 s\n"), std::string::npos) << out_;
  EXPECT_NE(out_.find("face2.SVG: key at 2.5 s\n"), std::string::npos) << out_;
}

TEST_F(DrawCommand, LinesOfARenderedHeadGiveItsPoseBack) {
  for (const double jaw : {0.0, 0.5}) {
    ASSERT_EQ(run({"render", "builtin:demo", "--set", "jaw=" + std::to_string(jaw), "--view", "face", "--lines", "-o",
                   path("head.svg")}),
              k_success)
        << error_;
    ASSERT_EQ(draw({path("head.svg"), "--json"}), k_success) << error_;
    const Json out = Json::parse(out_);
    EXPECT_NE(content("head.svg").find("id=\"silhouette_0\""), std::string::npos);
    for (const auto& [name, value] : out["parameters"].items())
      EXPECT_NEAR(value.get<double>(), name == "jaw" ? jaw : 0.0, 0.05) << name << " of a jaw at " << jaw;
  }
}

TEST_F(DrawCommand, ContoursOfARenderedHeadGiveItsPoseBack) {
  ASSERT_EQ(run({"render", "builtin:demo", "--set", "jaw=0.5", "--view", "side", "--lines", "-o", path("side.svg")}),
            k_success)
      << error_;
  // What is called a silhouette alone, and then under other names.
  const std::string all = content("side.svg");
  std::string contours = all.substr(0, all.find("<path"));
  for (std::size_t at = all.find("<path id=\"silhouette_"); at != std::string::npos;
       at = all.find("<path id=\"silhouette_", at + 1))
    contours += all.substr(at, all.find("/>", at) + 2 - at);
  contours += "</g></svg>";
  save("contours.svg", contours);
  std::string other = contours;
  for (std::size_t at = other.find("silhouette_"); at != std::string::npos; at = other.find("silhouette_"))
    other.replace(at, 11, "line");
  save("other.svg", other);
  const std::vector<std::vector<std::string>> calls{{path("contours.svg"), "--yaw", "90", "--json"},
                                                    {path("other.svg"), "--silhouette", "--yaw", "90", "--json"}};
  for (const auto& call : calls) {
    ASSERT_EQ(draw(call), k_success) << error_;
    const Json out = Json::parse(out_);
    EXPECT_NEAR(out["parameters"]["jaw"].get<double>(), 0.5, 0.05);
    for (const auto& [name, value] : out["parameters"].items()) {
      if (name != "jaw") {
        EXPECT_EQ(value, 0.0) << name;
      }
    }
    ASSERT_GE(out["lines"].size(), 3U);
    for (const Json& line : out["lines"]) {
      EXPECT_EQ(line["curve"], "silhouette");
      EXPECT_FALSE(line.contains("from"));
    }
  }
  ASSERT_EQ(draw({path("contours.svg"), "--yaw", "90"}), k_success);
  EXPECT_NE(out_.find("line 0: silhouette\n"), std::string::npos) << out_;
  EXPECT_NE(out_.find("  jaw  0.0000 -> 0."), std::string::npos) << out_;
}

TEST_F(DrawCommand, LinesBesideTheModelAreNoContour) {
  save("off.svg", std::string("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1000 1000'><g fill='none' "
                              "stroke='#000'><path d='M10 10 L40 60 L15 90'/><path d='M960 970 L990 900'/></g></svg>"));
  ASSERT_EQ(draw({path("off.svg"), "--silhouette"}), k_success) << error_;
  EXPECT_EQ(out_,
            "line 0: nothing known\nline 1: nothing known\nno line is a contour of this model, and nothing moves\n");
}

TEST_F(DrawCommand, WhatCannotBeReadIsOneLineThatNamesIt) {
  save("empty.svg", std::string("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'></svg>"));
  save("text.svg", std::string("a face"));
  expect_failure({path("none.svg")}, "none.svg: ");
  expect_failure({path("text.svg")}, "text.svg: is no drawing that can be read; choose an SVG");
  expect_failure({path("empty.svg")}, "empty.svg: it has no lines; draw the features of the face");
  std::filesystem::create_directories(folder_ / "board");
  expect_failure({path("board")}, "board: has no drawing; name a folder of .svg");
  save("board/1.svg", drawing(0.5));
  save("board/2.svg", std::string("a face"));
  expect_failure({path("board"), "-o", path("x.glb")}, "2.svg: is no drawing");
  EXPECT_FALSE(std::filesystem::exists(path("x.glb")));
  save("curves.json", std::string(R"({"curves": {"lip_upper": {"vertices": [0, 99999999]}}})"));
  expect_failure({path("board/1.svg"), "--curves", path("curves.json")}, "the model has no vertex 99999999");
  EXPECT_NE(error_.find("curves.json"), std::string::npos) << error_;
  expect_failure({path("board/1.svg"), path("board/1.svg"), "--every", "3600", "-o", path("board/1.svg")}, "1.svg");
}

TEST_F(DrawCommand, WrongUsageIsTwo) {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{},
                                             {"a.svg", "--silhouette", "--curves", "b.json"},
                                             {"a.svg", "--yaw", "400"},
                                             {"a.svg", "--every", "0"},
                                             {"a.svg", "--every", "nan"}}) {
    EXPECT_EQ(draw(arguments), k_wrong_usage);
  }
}

}  // namespace
}  // namespace penpose::cli
