#include "ui/cli/convert_command.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/model_io/write_model.h"
#include "tests/support/command_run.h"
#include "tests/support/gltf_sample.h"
#include "tests/support/model_samples.h"

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
  save("in.glb", model_io::write_glb(tests::full_model()).value());
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

TEST_F(ConvertCommand, WhatIsLeftOutIsSaid) {
  save("in.obj", std::string("mtllib x.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  EXPECT_EQ(run({"convert", path("in.obj"), path("out.glb")}), 0);
  EXPECT_NE(error_.find("materials were left out"), std::string::npos);
}

}  // namespace
}  // namespace penpose::cli
