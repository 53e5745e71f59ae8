#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/io/model/write_model.h"
#include "core/io/project/write_document.h"
#include "tests/support/command_run.h"
#include "tests/support/document_hand.h"
#include "tests/support/models/gltf_sample.h"
#include "tests/support/models/model_samples.h"
#include "tests/support/shared_data.h"
#include "ui/files/load_model.h"

namespace penpose::cli {
namespace {

class ConvertCommand : public tests::CommandRun {
 protected:
  std::string state(const std::string& name) {
    EXPECT_EQ(run({"info", "--json", path(name)}), 0) << error_;
    return nlohmann::json::parse(out_)["state"];
  }
};

TEST_F(ConvertCommand, GlbKeepsEverythingAndObjThePose) {
  save("in.glb", io::write_glb(tests::full_model()).value());
  ASSERT_EQ(run({"convert", path("in.glb"), path("out.glb")}), 0) << error_;
  EXPECT_EQ(out_ + error_, "");
  EXPECT_EQ(state("out.glb"), state("in.glb"));
  ASSERT_EQ(run({"convert", path("in.glb"), path("out.obj")}), 0) << error_;
  ASSERT_EQ(run({"info", "--json", path("out.obj")}), 0);
  EXPECT_EQ(nlohmann::json::parse(out_)["vertices"], 20);
}

TEST_F(ConvertCommand, BuffersBesideTheModelAreFound) {
  tests::GltfSample sample = tests::square_sample();
  sample.set_buffer();
  sample.json["buffers"][0]["uri"] = "data%201.bin";
  save("square.gltf", sample.json.dump());
  save("data 1.bin", sample.binary);
  EXPECT_EQ(run({"convert", path("square.gltf"), path("square.glb")}), 0) << error_;
  std::filesystem::remove(path("data 1.bin"));
  EXPECT_EQ(run({"convert", path("square.gltf"), path("other.glb")}), 1);
  EXPECT_NE(error_.find("/buffers/0/uri"), std::string::npos);
}

TEST_F(ConvertCommand, WhatWasNotChangedStaysAsItWas) {
  tests::GltfSample sample = tests::morph_sample();
  sample.json["extensions"] = {{"ACME", {{"known", "to nobody"}}}};
  const auto bytes = sample.glb();
  save("in.glb", bytes);
  ASSERT_EQ(run({"convert", path("in.glb"), path("out.glb")}), 0) << error_;
  EXPECT_EQ(content("out.glb"), std::string(bytes.begin(), bytes.end()));
  ASSERT_EQ(run({"convert", path("in.glb"), path("bare.glb"), "--bare"}), 0) << error_;
  EXPECT_EQ(content("bare.glb").find("ACME"), std::string::npos);
  EXPECT_EQ(state("bare.glb"), state("in.glb"));
}

TEST_F(ConvertCommand, ATextFileHasItsBytesBeside) {
  save("in.glb", tests::morph_sample().glb());
  ASSERT_EQ(run({"convert", path("in.glb"), path("out.gltf")}), 0) << error_;
  EXPECT_EQ(state("out.gltf"), state("in.glb"));
  EXPECT_TRUE(std::filesystem::exists(path("out.bin")));
  std::filesystem::create_directory(path("folder"));
  ASSERT_EQ(run({"convert", path("out.gltf"), path("folder/again.gltf")}), 0) << error_;
  EXPECT_EQ(content("folder/again.gltf"), content("out.gltf"));
  EXPECT_EQ(content("folder/out.bin"), content("out.bin"));
  save("folder/out.bin", std::string("something else"));
  EXPECT_EQ(run({"convert", path("out.gltf"), path("folder/again.gltf")}), 1);
  EXPECT_NE(error_.find("out.bin"), std::string::npos) << error_;
  EXPECT_EQ(content("folder/out.bin"), "something else");
}

TEST_F(ConvertCommand, NothingIsHalfWritten) {
  save("in.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  save("bad.obj", std::string("v 0 0 0\nf 1 2 3\n"));
  const std::size_t before = files();
  for (const char* out : {"out.ply", "out", "missing/out.glb"}) {
    EXPECT_EQ(run({"convert", path("in.obj"), path(out)}), 1) << out;
    EXPECT_EQ(std::count(error_.begin(), error_.end(), '\n'), 1);
  }
  EXPECT_EQ(run({"convert", path("bad.obj"), path("out.glb")}), 1);
  EXPECT_EQ(files(), before);
  save("out.glb", std::string("old"));
  EXPECT_EQ(run({"convert", path("bad.obj"), path("out.glb")}), 1);
  EXPECT_EQ(content("out.glb"), "old");
}

/// The sheet with a curve and a target, two keys and a view of a name.
document::Document worked_on() {
  tests::DocumentHand hand;
  hand.does(document::DrawReference{hand.view, hand.line(-0.5, 0, 0.5, 0)});
  hand.does(document::SetKey{0, "rest"});
  hand.does(document::SetParameters{{{hand.document().model->rig->parameters()[0].name, 0.5}}});
  hand.does(document::SetKey{2, "posed"});
  hand.does(document::SaveView{"front", hand.view});
  return hand.document();
}

TEST_F(ConvertCommand, AProjectStaysOne) {
  const auto document = worked_on();
  save("in.glb", io::write_project(document).value());
  ASSERT_EQ(run({"convert", path("in.glb"), path("out.glb")}), 0) << error_;
  EXPECT_EQ(state("out.glb"), state("in.glb"));
  auto back = files::load_document(path("out.glb")).value();
  EXPECT_EQ(back.curves.size(), document.curves.size());
  EXPECT_EQ(back.timeline->keys.size(), 2U);
  EXPECT_EQ(back.views.size(), 1U);
  // With a blend shape more, keys keep the values that they had.
  ASSERT_EQ(run({"convert", path("in.glb"), path("rest.obj")}), 0) << error_;
  ASSERT_EQ(run({"convert", path("in.glb"), path("out.glb"), "--shapes", path("rest.obj")}), 0) << error_;
  back = files::load_document(path("out.glb")).value();
  const auto parameters = back.model->rig->parameters();
  ASSERT_TRUE(rig::find_parameter(parameters, "rest"));
  ASSERT_EQ(back.timeline->keys.size(), 2U);
  const auto& name = document.model->rig->parameters()[0].name;
  EXPECT_EQ(back.timeline->keys[1].pose[rig::find_parameter(parameters, name).value()], 0.5);
}

TEST_F(ConvertCommand, ShapesAreAddedToAnAnimatedModel) {
  save("in.glb", io::write_glb(tests::full_model()).value());
  const auto before = files::load_model(path("in.glb")).value();
  ASSERT_EQ(run({"convert", path("in.glb"), path("posed.obj")}), 0) << error_;
  ASSERT_EQ(run({"convert", path("in.glb"), path("out.glb"), "--shapes", path("posed.obj")}), 0) << error_;
  const auto after = files::load_model(path("out.glb")).value();
  EXPECT_EQ(after.rig->parameters().size(), before.rig->parameters().size() + 1);
  EXPECT_EQ(after.animations.size(), before.animations.size());
  for (std::size_t i = 0; i < before.pose.size(); ++i) {
    const auto& name = before.rig->parameters()[i].name;
    EXPECT_EQ(after.pose[rig::find_parameter(after.rig->parameters(), name).value()], before.pose[i]) << name;
  }
}

TEST_F(ConvertCommand, ShapesOfAFolderAreInTheOrderOfTheirNumbers) {
  save("in.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  std::filesystem::create_directories(path("shapes"));
  for (const char* name : {"k1", "k10", "k2"})
    save("shapes/" + std::string(name) + ".obj", std::string("v 0 0 1\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  ASSERT_EQ(run({"convert", path("in.obj"), path("out.glb"), "--shapes", path("shapes")}), 0) << error_;
  std::vector<std::string> names;
  const auto model = files::load_model(path("out.glb")).value();
  for (const auto& shape : model.shapes->shapes()) names.push_back(shape.parameter.name);
  EXPECT_EQ(names, (std::vector<std::string>{"k1", "k2", "k10"}));
}

TEST_F(ConvertCommand, WhatIsLeftOutIsSaid) {
  save("in.obj", std::string("mtllib x.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  EXPECT_EQ(run({"convert", path("in.obj"), path("out.glb")}), 0);
  EXPECT_NE(error_.find("materials were left out"), std::string::npos);
}

TEST_F(ConvertCommand, AModelWithoutArkitsNamesGivesNoTake) {
  save("in.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  std::filesystem::create_directories(path("shapes"));
  save("shapes/k1.obj", std::string("v 0 0 1\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  ASSERT_EQ(run({"convert", path("in.obj"), path("in.glb"), "--shapes", path("shapes")}), 0) << error_;
  EXPECT_EQ(run({"convert", path("in.glb"), path("out.csv")}), 1);
  EXPECT_NE(error_.find("jawOpen"), std::string::npos) << error_;
  EXPECT_EQ(std::count(error_.begin(), error_.end(), '\n'), 1) << error_;
  EXPECT_FALSE(std::filesystem::exists(path("out.csv")));
}

class SharedArkit : public ConvertCommand {};

/// The face has two brows' and two cheeks' shapes where ARKit has one.
TEST_F(SharedArkit, ATakeComesBackAsItWasWritten) {
  if (!tests::has_shared()) GTEST_SKIP() << "no shared data";
  const std::string face = (tests::shared_dir() / "meshes" / "ict_face.glb").string();
  std::string take = "Timecode,BlendShapeCount,BrowInnerUp,CheekPuff,JawOpen,EyeBlinkRight\n";
  for (int f = 0; f < 40; ++f) {
    take += "0:0:" + std::to_string(f / 24) + ":" + std::to_string(f % 24) + ",4," + std::to_string(f / 40.0) + ",0.5,";
    take += std::to_string((f % 8) / 8.0) + ",0.25\n";
  }
  save("take.csv", take);
  ASSERT_EQ(run({"animate", face, "--track", path("take.csv"), "-o", path("a.glb"), "--json"}), 0) << error_;
  const auto first = nlohmann::json::parse(out_);
  EXPECT_EQ(first["parameters"]["browInnerUp_L"], first["parameters"]["browInnerUp_R"]);
  EXPECT_NEAR(first["fps"].get<double>(), 24, 1e-3);
  ASSERT_EQ(run({"convert", path("a.glb"), path("out.csv"), "--fps", "24"}), 0) << error_;
  EXPECT_EQ(error_, "");
  ASSERT_EQ(run({"animate", face, "--track", path("out.csv"), "-o", path("b.glb"), "--json"}), 0) << error_;
  const auto again = nlohmann::json::parse(out_);
  EXPECT_EQ(again["frames"], 40);
  EXPECT_NEAR(again["fps"].get<double>(), 24, 1e-3);
  for (const auto& [name, values] : first["parameters"].items()) {
    for (std::size_t f = 0; f < 40; ++f) {
      EXPECT_NEAR(again["parameters"][name][f].get<double>(), values[f].get<double>(), 1e-6) << name << " frame " << f;
    }
  }
}

}  // namespace
}  // namespace penpose::cli
