#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/document/document_hash.h"
#include "core/document/time/animation_sampling.h"
#include "core/io/project/write_document.h"
#include "core/io/tracks/label_file.h"
#include "core/io/tracks/read_track.h"
#include "tests/support/command_run.h"
#include "tests/support/models/figure_sample.h"
#include "tests/support/models/rendered_track.h"
#include "ui/cli/commands.h"
#include "ui/files/load_model.h"

namespace penpose::cli {
namespace {

/// Tracks of the demo head: the points of some of its curves, seen while its jaw opens.
class AnimateCommand : public tests::CommandRun {
 protected:
  int animate(const std::vector<std::string>& arguments) { return run("animate", arguments); }
  /// A track of the head's lips while its jaw opens by half in 20 frames.
  void write_jaw_track() {
    const auto head = files::load_model("builtin:demo").value();
    const auto camera = geometry::frame_box(document::rest_world_box(head), {640, 640}, 0);
    nlohmann::json frames = nlohmann::json::array();
    const auto jaw = rig::find_parameter(head.rig->parameters(), "jaw").value();
    for (int f = 0; f < 20; ++f) {
      auto moment = head;
      moment.pose[jaw] = 0.5 * f / 19;
      const auto positions = document::posed_positions(moment);
      nlohmann::json curves;
      for (const auto& curve : head.curves) {
        if (!curve.name.starts_with("lip") && curve.name != "nose_bridge") continue;
        for (const auto& point : curve.points) {
          const auto px = camera.project(mesh::position_of(point, head.mesh->triangles(), positions)).value();
          curves[curve.name].push_back({px.x, px.y});
        }
      }
      frames.push_back({{"curves", f == 7 ? nlohmann::json() : curves}});
    }
    save("track.json", nlohmann::json{{"fps", 25}, {"frames", frames}}.dump());
    save("map.json", R"({"format": "curves", "stable": ["nose_bridge"], "free": ["jaw", "lips_pucker"], "curves": [
      {"track": "lip_upper", "reference": "lip_upper"}, {"track": "lip_lower", "reference": "lip_lower"},
      {"track": "lip_lower_inner", "reference": "lip_lower_inner"}]})");
  }
};

TEST_F(AnimateCommand, OpensTheJawOfASketchedHead) {
  write_jaw_track();
  ASSERT_EQ(animate({"builtin:demo", "--track", path("track.json"), "--map", path("map.json"), "-o", path("out.glb"),
                     "--json"}),
            k_success)
      << error_;
  const auto json = nlohmann::json::parse(out_);
  EXPECT_EQ(json["frames"], 20);
  EXPECT_EQ(json["held"], nlohmann::json({7}));
  EXPECT_NEAR(json["fps"].get<double>(), 25, 1e-6);
  EXPECT_GT(json["solve_us"].get<double>(), 0);
  ASSERT_EQ(json["parameters"]["jaw"].size(), 20U);
  EXPECT_NEAR(json["parameters"]["jaw"][19].get<double>(), 0.5, 0.08);
  EXPECT_NEAR(json["parameters"]["jaw"][0].get<double>(), 0, 0.04);
  const auto model = files::load_model(path("out.glb"));
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(document::state_hash(*model).hex(), json["state"]);
  const auto end = document::model_at(*model, document::sample(*model, model->animations[0], 100)).value();
  const auto jaw = rig::find_parameter(model->rig->parameters(), "jaw").value();
  EXPECT_NEAR(end.pose[jaw], json["parameters"]["jaw"][19].get<double>(), 1e-6);
  // The same again gives the same bits.
  ASSERT_EQ(animate({"builtin:demo", "--track", path("track.json"), "--map", path("map.json"), "-o", path("out.glb"),
                     "--json"}),
            k_success);
  EXPECT_EQ(nlohmann::json::parse(out_)["state"], json["state"]);
}

TEST_F(AnimateCommand, TakesATrackOfCurvesWithTheNamesOfTheHeadWithoutAMap) {
  write_jaw_track();
  // As `penpose track` writes it.
  const std::string given = nlohmann::json::parse(std::ifstream(folder_ / "track.json")).dump();
  const auto track = io::read_curve_track(base::as_bytes(given), io::FrameOrder::none).value();
  save("track.json", io::write_curve_track(track, 25));
  ASSERT_EQ(animate({"builtin:demo", "--track", path("track.json"), "-o", path("out.glb"), "--json"}), k_success)
      << error_;
  const auto json = nlohmann::json::parse(out_);
  EXPECT_NEAR(json["parameters"]["jaw"][19].get<double>(), 0.5, 0.08);
  EXPECT_NEAR(json["parameters"]["jaw"][0].get<double>(), 0, 0.04);
  EXPECT_EQ(json["held"], nlohmann::json({7}));
  EXPECT_NE(error_.find("the track has no curve brow_R, brow_L, eyelid_upper_R"), std::string::npos) << error_;
  EXPECT_EQ(error_.find("counts as still"), std::string::npos) << error_;
  // Named, it is the same map.
  ASSERT_EQ(
      animate({"builtin:demo", "--track", path("track.json"), "--map", "curves", "-o", path("out.glb"), "--json"}),
      k_success)
      << error_;
  EXPECT_EQ(nlohmann::json::parse(out_)["state"], json["state"]);
}

TEST_F(AnimateCommand, SaysWhichCurvesTheBundledMapLacksAndWouldTake) {
  write_jaw_track();
  auto track = nlohmann::json::parse(std::ifstream(folder_ / "track.json"));
  for (auto& frame : track["frames"]) {
    auto& curves = frame["curves"];
    if (!curves.is_object()) continue;
    curves["lip_loer"] = curves["lip_lower"];
    for (const char* name : {"lip_lower", "nose_bridge"}) curves.erase(name);
  }
  save("track.json", track.dump());
  ASSERT_EQ(animate({"builtin:demo", "--track", path("track.json"), "-o", path("out.glb"), "--head", "apply"}),
            k_success)
      << error_;
  EXPECT_NE(error_.find("lip_lower; what they drive is left out"), std::string::npos) << error_;
  EXPECT_NE(error_.find("no use for the track's lip_loer"), std::string::npos) << error_;
  const auto still = error_.find("the head counts as still: the track has no curve of the names nose_bridge");
  EXPECT_NE(still, std::string::npos) << error_;
  EXPECT_EQ(error_.find("still", still + 30), std::string::npos) << error_;
  for (auto& frame : track["frames"]) {
    auto& curves = frame["curves"];
    if (curves.is_object()) curves = {{"mouth", curves["lip_upper"]}};
  }
  save("track.json", track.dump());
  EXPECT_EQ(animate({"builtin:demo", "--track", path("track.json"), "-o", path("out.glb")}), k_failure);
  EXPECT_NE(error_.find("none of the curves"), std::string::npos) << error_;
  EXPECT_NE(error_.find("name its curves brow_R, brow_L, eyelid_upper_R"), std::string::npos) << error_;
  EXPECT_EQ(std::count(error_.begin(), error_.end(), '\n'), 1) << error_;
}

TEST_F(AnimateCommand, AProjectKeepsItsViewsLocksAndKeys) {
  auto document = files::load_document("builtin:demo").value();
  rig::Pose open = document.pose;
  const auto jaw = rig::find_parameter(document.model->rig->parameters(), "jaw").value();
  open[jaw] = 1;
  document.timeline =
      std::make_shared<const document::Timeline>(document::Timeline{{{0, document.pose, "rest"}, {1, open, "open"}}});
  document.views = {std::make_shared<const document::NamedView>(document::NamedView{"front", {}})};
  document.locked = {"lip_upper"};
  const auto project = io::write_project(document).value();
  save("project.glb", std::string(project.begin(), project.end()));
  save("take.csv", "Timecode,BlendShapeCount,Jaw\n0:0:0:0,1,0.25\n0:0:0:1,1,0.5\n");
  ASSERT_EQ(animate({path("project.glb"), "--track", path("take.csv"), "-o", path("out.glb"), "--json"}), k_success)
      << error_;
  const auto back = files::load_document(path("out.glb")).value();
  EXPECT_EQ(document::DocumentHasher()(back).whole.hex(), nlohmann::json::parse(out_)["state"]);
  EXPECT_EQ(back.views.size(), 1U);
  EXPECT_EQ(back.locked, std::vector<std::string>{"lip_upper"});
  const auto jaw_at_end = [&](std::size_t animation) {
    return document::model_at(*back.model, document::sample(*back.model, back.model->animations[animation], 10))
        .value()
        .pose[jaw];
  };
  ASSERT_EQ(back.model->animations.size(), 2U);  // what was tracked plays first, the keys are kept
  EXPECT_NEAR(jaw_at_end(0), 0.5, 1e-6);
  EXPECT_NEAR(jaw_at_end(1), 1.0, 1e-6);
}

TEST_F(AnimateCommand, TakesArkitValuesByNameAndListsTheRest) {
  save("take.csv",
       "Timecode,BlendShapeCount,Jaw,LipUpper,TongueOut,HeadRoll\n0:0:0:0,4,0.5,0.1,0.7,0.3\n"
       "0:0:0:1,4,9,nan,0,0\n0:0:0:2,4,9,0,0,0.1\n");
  ASSERT_EQ(animate({"builtin:demo", "--track", path("take.csv"), "-o", path("out.glb"), "--json"}), k_success)
      << error_;
  const auto json = nlohmann::json::parse(out_);
  EXPECT_EQ(json["unmatched"], (nlohmann::json{"TongueOut", "HeadRoll"}));
  EXPECT_EQ(json["parameters"]["jaw"][0], 0.5);
  EXPECT_EQ(json["held"], nlohmann::json({1}));
  EXPECT_LE(json["parameters"]["jaw"][2].get<double>(), 2.0);  // within its range, whatever the take says
  EXPECT_NE(error_.find("line 3"), std::string::npos);
  EXPECT_NE(error_.find("column Jaw: 1 values are cut to"), std::string::npos) << error_;
}

TEST_F(AnimateCommand, PlaysAVrmAnimationOnAnAvatarAndWritesOne) {
  save("avatar.vrm", tests::avatar_sample(tests::turned_bones()).glb());
  save("motion.vrma", tests::motion_sample(tests::upright_bones()).glb());
  ASSERT_EQ(animate({path("avatar.vrm"), "--track", path("motion.vrma"), "-o", path("clip.glb")}), 0) << error_;
  const auto model = files::load_model(path("clip.glb")).value();
  ASSERT_EQ(model.animations.size(), 1U);
  EXPECT_EQ(model.animations[0].channels.size(), 6U) << "four bones, the hips' way and the face";
  EXPECT_EQ(document::sample(model, model.animations[0], 1).weights, std::vector<double>{0.5});
  ASSERT_EQ(animate({path("avatar.vrm"), "--track", path("motion.vrma"), "-o", path("again.vrma")}), 0) << error_;
  ASSERT_EQ(animate({path("avatar.vrm"), "--track", path("again.vrma"), "-o", path("twice.glb")}), 0) << error_;
  const auto twice = files::load_model(path("twice.glb")).value();
  for (std::size_t j = 0; j < model.skeleton->joints().size(); ++j) {
    const auto one = document::sample(model, model.animations[0], 0.5).joints[j].rotation;
    const auto two = document::sample(twice, twice.animations[0], 0.5).joints[j].rotation;
    EXPECT_NEAR(std::abs(glm::dot(one, two)), 1, 1e-6) << model.skeleton->joints()[j].name;
  }
}

TEST_F(AnimateCommand, ATextOfTwoBytesALetterIsNamed) {
  save("take.csv", std::string("\xff\xfeT\0i\0", 6));
  EXPECT_EQ(animate({"builtin:demo", "--track", path("take.csv"), "-o", path("out.glb")}), k_failure);
  EXPECT_NE(error_.find("UTF-8"), std::string::npos) << error_;
}

TEST_F(AnimateCommand, AppliesTheHeadsTurn) {
  save("take.csv", "Timecode,BlendShapeCount,Jaw,HeadYaw,HeadPitch,HeadRoll\n0:0:0:0,4,0,0,0,0\n0:0:0:1,4,0,0.3,0,0\n");
  ASSERT_EQ(animate({"builtin:demo", "--track", path("take.csv"), "-o", path("out.glb"), "--head", "apply"}), k_success)
      << error_;
  const auto model = files::load_model(path("out.glb")).value();
  ASSERT_TRUE(model.skeleton);
  EXPECT_EQ(model.animations[0].channels.size(), 4U);
}

TEST_F(AnimateCommand, SaysWhyAHeadCannotBeFollowed) {
  write_jaw_track();
  const auto says = [&](const std::string& track, const std::string& map, const char* expected) {
    std::vector<std::string> arguments{"builtin:demo", "--track", path(track.c_str()), "-o", path("out.glb"),
                                       "--head",       "apply"};
    if (!map.empty()) arguments.insert(arguments.end(), {"--map", path(map.c_str())});
    ASSERT_EQ(animate(arguments), k_success) << error_;
    EXPECT_NE(error_.find(expected), std::string::npos) << error_;
  };
  auto map = nlohmann::json::parse(std::ifstream(folder_ / "map.json"));
  map["stable"] = nlohmann::json::array();
  save("none.json", map.dump());
  says("track.json", "none.json", "the map lists no stable points");
  map["stable"] = {0};
  save("one.json", map.dump());
  says("track.json", "one.json", "the map lists a single stable point");
  save("take.csv", "Timecode,Jaw\n0:0:0:0,0\n0:0:0:1,0\n");
  says("take.csv", "", "no column HeadYaw");
}

TEST_F(AnimateCommand, SaysWhatIsWrongInOneLine) {
  write_jaw_track();
  const auto fails = [&](const std::vector<std::string>& arguments, const char* expected) {
    EXPECT_EQ(animate(arguments), k_failure);
    EXPECT_NE(error_.find(expected), std::string::npos) << error_;
    EXPECT_EQ(std::count(error_.begin(), error_.end(), '\n'), 1) << error_;
  };
  const std::string track = path("track.json");
  const std::string out = path("out.glb");
  save("wrong.json", R"({"format": "curves", "curves": [{"track": "lip_upper", "reference": "lip_uper"}]})");
  fails({"builtin:demo", "--track", track, "--map", path("wrong.json"), "-o", out}, "did you mean lip_upper");
  save("wrong.json", R"({"format": "curves", "curves": [{"track": "lips", "reference": "lip_upper"}]})");
  fails({"builtin:demo", "--track", track, "--map", path("wrong.json"), "-o", out}, "/curves/0/track");
  save("wrong.json",
       R"({"format": "curves", "free": ["jaww"], "curves": [{"track": "lip_upper", "reference": "lip_upper"}]})");
  fails({"builtin:demo", "--track", track, "--map", path("wrong.json"), "-o", out}, "did you mean 'jaw'?");
  save("wrong.json",
       R"({"format": "curves", "curves": [{"track": "lip_upper", "reference": "lip_upper", "meets": "lid"}]})");
  fails({"builtin:demo", "--track", track, "--map", path("wrong.json"), "-o", out}, "/curves/0/meets");
  save("wrong.csv", "Timecode,BlendShapeCount,TongueOut\n0:0:0:0,1,0.5\n");
  fails({"builtin:demo", "--track", path("wrong.csv"), "-o", out}, "a control for none");
  save("wrong.csv", "frame,confidence,x_0,y_0\n");
  fails({"builtin:demo", "--track", path("wrong.csv"), "-o", out}, "x_1");
  fails({"builtin:head", "--track", track, "--map", path("map.json"), "-o", out}, "articulate");
  fails({"builtin:demo", "--track", track, "--map", path("map.json"), "-o", path("out.obj")}, ".glb");
  fails({"builtin:demo", "--track", track, "--map", path("map.json"), "-o", out, "--neutral", "20"},
        "the track has 20");
  EXPECT_EQ(animate({"builtin:demo", "-o", out}), k_wrong_usage);
  EXPECT_EQ(animate({"builtin:demo", "--track", track, "-o", out, "--neutral", "-1"}), k_wrong_usage);
  EXPECT_EQ(animate({"builtin:demo", "--track", track, "-o", out, "--fps", "nan"}), k_wrong_usage);
}

TEST_F(AnimateCommand, SaysWhichMembersOfAMapItSkipsAndWhichFramesItHolds) {
  write_jaw_track();
  auto map = nlohmann::json::parse(std::ifstream(folder_ / "map.json"));
  map["hed"] = "apply";
  map["curves"][1]["weigth"] = 2;
  save("map.json", map.dump());
  ASSERT_EQ(animate({"builtin:demo", "--track", path("track.json"), "--map", path("map.json"), "-o", path("out.glb")}),
            k_success);
  EXPECT_NE(error_.find("/hed is not known"), std::string::npos) << error_;
  EXPECT_NE(error_.find("/curves/1/weigth is not known"), std::string::npos) << error_;
  EXPECT_NE(out_.find("held: frame 7\n"), std::string::npos) << out_;
}

TEST_F(AnimateCommand, NamesTheFileOfAFolderThatItCannotRead) {
  std::filesystem::create_directories(folder_ / "points");
  for (int f = 1; f <= 3; ++f) {
    std::string text = f == 1 ? "\xef\xbb\xbfversion: 1\nn_points: 68\n{\n" : "version: 1\nn_points: 68\n{\n";
    for (int i = 0; i < 68 && (f != 2 || i < 49); ++i)
      text += std::to_string(100 + 9 * (i % 17)) + " " + std::to_string(100 + (i * i) % 61) + "\n";
    save(("points/face_000" + std::to_string(f) + (f == 3 ? ".PTS" : ".pts")), text + "}\n");
  }
  ASSERT_EQ(animate({"builtin:demo", "--track", path("points"), "-o", path("out.glb"), "--json"}), k_success) << error_;
  EXPECT_EQ(nlohmann::json::parse(out_)["held"], nlohmann::json({1}));
  EXPECT_NE(error_.find("face_0002.pts: "), std::string::npos) << error_;
}

TEST_F(AnimateCommand, ReadsAFolderOfPointFiles) {
  std::filesystem::create_directories(folder_ / "points");
  for (const int f : {1, 2, 4}) {
    std::string text = "version: 1\nn_points: 68\n{\n";
    for (int i = 0; i < 68; ++i)
      text += std::to_string(100 + 9 * (i % 17)) + " " + std::to_string(100 + (i * i) % 61) + "\n";
    save(("points/face_000" + std::to_string(f) + ".pts"), text + "}\n");
  }
  ASSERT_EQ(animate({"builtin:demo", "--track", path("points"), "-o", path("out.glb"), "--json"}), k_success) << error_;
  const auto json = nlohmann::json::parse(out_);
  EXPECT_EQ(json["frames"], 4);
  EXPECT_EQ(json["held"], nlohmann::json({2}));
}

}  // namespace
}  // namespace penpose::cli
