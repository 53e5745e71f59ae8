#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <vector>

#include "tests/support/command_run.h"
#include "tests/support/models/gltf_sample.h"
#include "tests/support/shared_data.h"
#include "ui/cli/commands.h"
#include "ui/film/frame_name.h"

namespace penpose::cli {
namespace {

class RenderCommand : public tests::CommandRun {
 protected:
  void SetUp() override {
    CommandRun::SetUp();
    std::ofstream(model()) << "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  }
  [[nodiscard]] std::string model() const { return (folder_ / "model.off").string(); }
  int render(const std::vector<std::string>& arguments) { return run("render", arguments); }
};

class SharedRenderCommand : public RenderCommand {};

TEST_F(RenderCommand, WritesAPngOfTheSizeAskedFor) {
  ASSERT_EQ(render({model(), "--size", "80x48", "-o", path("a.png")}), k_success) << error_;
  const std::string png = content("a.png");
  ASSERT_GT(png.size(), 33U);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_EQ(png.substr(16, 8), std::string("\0\0\0\x50\0\0\0\x30", 8));
  EXPECT_EQ(out_ + error_, "");
}

TEST_F(RenderCommand, ViewsAndCamerasChangeThePicture) {
  std::ofstream(path("camera.json")) << R"({"eye": [3, 3, 3], "look_at": [0.3, 0.3, 0.3]})";
  const std::vector<std::string> start{model(), "--size", "64x64", "-o"};
  const auto with = [&](const char* name, std::vector<std::string> more) {
    auto arguments = start;
    arguments.push_back(path(name));
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(render(arguments), k_success) << error_;
    return content(name);
  };
  const auto front = with("a.png", {"--view", "front"});
  EXPECT_NE(front, with("b.png", {"--view", "side"}));
  EXPECT_NE(front, with("c.png", {"--camera", path("camera.json")}));
  EXPECT_EQ(front, with("d.png", {"--view", "front"})) << "the same picture twice";
}

TEST_F(RenderCommand, FailuresAreOneLineAndLeaveNoFile) {
  std::ofstream(path("broken.glb")) << "glTF";
  std::ofstream(path("camera.json")) << R"({"eye": [3, 3, 3]})";
  const std::vector<std::vector<std::string>> all{
      {path("missing.glb")},
      {path("broken.glb")},
      {model(), "--set", "jawOpen=1"},
      {model(), "--time", "1"},
      {model(), "--camera", path("camera.json")},
      {model(), "--cases", path("missing.json"), "--case", "a"},
  };
  for (auto arguments : all) {
    arguments.insert(arguments.end(), {"-o", path("x.png")});
    EXPECT_EQ(render(arguments), k_failure) << error_;
    EXPECT_EQ(std::count(error_.begin(), error_.end(), '\n'), 1) << error_;
    EXPECT_EQ(out_, "");
    EXPECT_FALSE(std::filesystem::exists(path("x.png")));
  }
}

TEST_F(RenderCommand, DrawsLinesAsAnSvg) {
  ASSERT_EQ(render({"builtin:demo", "--lines", "-o", path("head.svg")}), k_success) << error_;
  const std::string svg = content("head.svg");
  for (const char* id : {"id=\"jaw\"", "id=\"lip_upper\"", "id=\"silhouette_0\""})
    EXPECT_NE(svg.find(id), std::string::npos) << id;
  ASSERT_EQ(render({model(), "--lines", "-o", path("model.svg")}), k_success);
  EXPECT_NE(error_.find("no features of a face were found; the silhouette is drawn alone"), std::string::npos);
  EXPECT_NE(content("model.svg").find("silhouette_0"), std::string::npos);
  EXPECT_EQ(render({model(), "--lines", "-o", path("x.png")}), k_failure);
  EXPECT_FALSE(std::filesystem::exists(path("x.png")));
  EXPECT_EQ(render({model(), "--lines", "--clay", "-o", path("x.svg")}), k_wrong_usage);
}

TEST_F(RenderCommand, WrongUsageIsTwo) {
  const std::vector<std::vector<std::string>> all{
      {},
      {model()},
      {model(), "-o", path("x.png"), "--size", "0x5"},
      {model(), "-o", path("x.png"), "--size", "100000x100000"},
      {model(), "-o", path("x.png"), "--size", "big"},
      {model(), "-o", path("x.png"), "--view", "inside"},
      {model(), "-o", path("x.png"), "--case", "a"},
  };
  for (const auto& arguments : all) EXPECT_EQ(render(arguments), k_wrong_usage);
}

TEST_F(SharedRenderCommand, PosesAnimationsAndCasesShow) {
  if (!tests::has_shared()) GTEST_SKIP();
  const auto meshes = tests::shared_dir() / "meshes";
  const auto picture = [&](const char* file, std::vector<std::string> more) {
    std::vector<std::string> arguments{(meshes / file).string(), "--size", "96x96", "-o", path("p.png")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(render(arguments), k_success) << error_;
    return content("p.png");
  };
  const auto rest = picture("ict_face.glb", {});
  EXPECT_NE(rest, picture("ict_face.glb", {"--set", "jawOpen=1"}));
  EXPECT_EQ(rest, picture("ict_face.glb", {"--set", "jawOpen=0"}));
  EXPECT_NE(rest, picture("ict_face.glb",
                          {"--cases", (meshes / "ict_face_pose_cases.json").string(), "--case", "open_smile"}));
  EXPECT_NE(picture("cesium_man.glb", {"--time", "0.2"}), picture("cesium_man.glb", {"--time", "0.9"}));
  EXPECT_NE(picture("animated_morph_cube.glb", {}), picture("animated_morph_cube.glb", {"--time", "1.5"}));
}

TEST_F(RenderCommand, ShowsAMomentOfTheAnimationThatIsNamed) {
  tests::GltfSample sample = tests::morph_sample();
  const auto times = sample.add_accessor(std::vector<float>{0, 1}, "SCALAR", 1, 5126);
  for (const float end : {0.0F, 1.0F}) {
    const auto weights = sample.add_accessor(std::vector<float>{0, end}, "SCALAR", 1, 5126);
    sample.add("animations", {{"name", end == 0 ? "still" : "lifted"},
                              {"samplers", {{{"input", times}, {"output", weights}}}},
                              {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}}});
  }
  const auto bytes = sample.glb();
  std::ofstream(path("two.glb"), std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  const auto picture = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments{path("two.glb"), "--size", "64x64", "-o", path("p.png")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(render(arguments), k_success) << error_;
    return content("p.png");
  };
  const auto still = picture({"--time", "1"});
  EXPECT_EQ(picture({"--animation", "still", "--time", "1"}), still) << "the first one where none is named";
  const auto lifted = picture({"--animation", "lifted", "--time", "1"});
  EXPECT_NE(lifted, still);
  EXPECT_NE(picture({"--animation", "lifted", "--time", "0.5"}), lifted);
  EXPECT_EQ(picture({"--animation", "2", "--time", "1"}), lifted) << "or by its number";
  EXPECT_EQ(render({path("two.glb"), "--animation", "lift", "--time", "1", "-o", path("q.png")}), k_failure);
  EXPECT_NE(error_.find("did you mean lifted?"), std::string::npos) << error_;
}

TEST_F(RenderCommand, NamesTheFramesOfASequenceAsBlenderDoes) {
  EXPECT_EQ(film::frame_name("out/smile", 1), "out/smile0001.png");
  EXPECT_EQ(film::frame_name("out/smile.png", 12), "out/smile0012.png");
  EXPECT_EQ(film::frame_name("smile_######", 12345), "smile_012345.png");
  EXPECT_EQ(film::frame_name("smile##.png", 100), "smile100.png");
}

TEST_F(RenderCommand, WritesAPictureAFrame) {
  std::ofstream(folder_ / "take.csv") << "Timecode,BlendShapeCount,Jaw\n0:0:0:0,1,0\n0:0:0:24,1,0.8\n";
  const std::string clip = path("clip.glb");
  ASSERT_EQ(run({"animate", "builtin:demo", "--track", path("take.csv"), "-o", clip}), k_success) << error_;
  ASSERT_EQ(render({clip, "--frames", "--fps", "10", "--size", "64x64", "-o", path("clip.png")}), k_success) << error_;
  // 0.4 s: frames at 0, 0.1, ..., 0.4.
  for (const char* name : {"clip0001.png", "clip0005.png"})
    EXPECT_TRUE(std::filesystem::exists(folder_ / name)) << name;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "clip0006.png"));
  EXPECT_NE(content("clip0001.png"), content("clip0005.png"));
  // A folder that is not there is made; one that cannot be is said in one line.
  ASSERT_EQ(render({clip, "--frames", "--fps", "10", "--size", "64x64", "-o", path("new/clip/f##")}), k_success)
      << error_;
  EXPECT_EQ(content("new/clip/f05.png"), content("clip0005.png"));
  EXPECT_EQ(render({clip, "--frames", "--fps", "10", "--size", "64x64", "-o", path("take.csv/f")}), k_failure);
  EXPECT_NE(error_.find("its folder cannot be made"), std::string::npos) << error_;
  EXPECT_NE(error_.find("name another folder"), std::string::npos) << error_;
  EXPECT_EQ(std::count(error_.begin(), error_.end(), '\n'), 1) << error_;
  EXPECT_EQ(render({model(), "--frames", "--size", "64x64", "-o", path("none.png")}), k_failure);
  EXPECT_NE(error_.find("--frames"), std::string::npos);
}

}  // namespace
}  // namespace penpose::cli
