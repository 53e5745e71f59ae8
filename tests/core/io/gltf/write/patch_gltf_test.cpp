#include "core/io/gltf/write/patch_gltf.h"

#include <gtest/gtest.h>

#include "core/document/time/animation_building.h"
#include "core/io/gltf/read/read_gltf.h"
#include "core/io/project/read_document.h"
#include "core/io/project/write_document.h"
#include "tests/support/file_parts.h"
#include "tests/support/models/textured_trunk.h"
#include "tests/support/shared_data.h"

namespace penpose::io {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Json = nlohmann::json;
using Parts = tests::FileParts;
using tests::expect_kept;
using tests::parts_of;
using tests::with_curl;

document::Model read(const Bytes& bytes) { return tests::read_glb(bytes); }
tests::GltfSample avatar() { return tests::textured_trunk(); }

TEST(PatchGltf, AModelWithoutAChangeIsTheFile) {
  const Bytes bytes = avatar().glb();
  EXPECT_EQ(write_glb(read(bytes)).value(), bytes);
  for (const std::string& note : read(bytes).notes)
    EXPECT_TRUE(note.find("textur") == std::string::npos || note.find("left out") == std::string::npos) << note;
}

TEST(PatchGltf, APoseChangesItsWeightAlone) {
  const Bytes bytes = avatar().glb();
  document::Model model = read(bytes);
  model.pose[0] = 0.75;
  const Bytes posed = write_glb(model).value();
  expect_kept(bytes, posed, {"/meshes/0/weights"});
  const Parts parts = parts_of(posed);
  EXPECT_EQ(parts.json["meshes"][0]["weights"], Json({0.75}));
  EXPECT_EQ(parts.binary.size(), parts_of(bytes).binary.size());
  EXPECT_EQ(document::state_hash(read(posed)), document::state_hash(model));
  EXPECT_EQ(read(posed).pose, model.pose);
  EXPECT_EQ(write_glb(read(posed)).value(), posed);
}

TEST(PatchGltf, ASketchedControlIsATargetMoreAndAllElseStays) {
  const Bytes bytes = avatar().glb();
  document::Model model = with_curl(read(bytes));
  const std::size_t curl = 1;
  model.pose[curl] = 0.5;
  WriteReport report;
  const Bytes written = write_glb(model, {}, &report).value();
  EXPECT_TRUE(report.notes.empty());
  expect_kept(bytes, written, {"/animations/0/samplers/0/output", "/animations/1/samplers/0/output"});
  const Json json = parts_of(written).json;
  const Json& mesh = json["meshes"][0];
  const std::size_t targets = mesh["primitives"][0]["targets"].size();
  ASSERT_GE(targets, 2U);
  EXPECT_EQ(mesh["extras"]["targetNames"].size(), targets);
  EXPECT_EQ(mesh["extras"]["targetNames"][1], "curl");
  EXPECT_EQ(mesh["weights"].size(), targets);
  EXPECT_EQ(mesh["weights"][1], 0.5);
  const Json& target = mesh["primitives"][0]["targets"][1];
  EXPECT_TRUE(target.contains("NORMAL"));
  EXPECT_TRUE(target.contains("TANGENT"));
  EXPECT_EQ(json["accessors"][target["TANGENT"].get<std::size_t>()]["type"], "VEC3");
  for (const Json& animation : json["animations"]) {
    EXPECT_EQ(json["accessors"][animation["samplers"][0]["output"].get<std::size_t>()]["count"], 2 * targets);
  }
  const document::Model again = read(written);
  EXPECT_EQ(document::state_hash(again), document::state_hash(model));
  ASSERT_TRUE(again.deformers);
  EXPECT_EQ(write_glb(again).value(), written) << "and the file stays the file";
}

TEST(PatchGltf, AControlThatIsDeletedTakesItsTargetsAlong) {
  const document::Model model = with_curl(read(avatar().glb()));
  const document::Model again = read(write_glb(model).value());
  const document::Model without = document::with_deformers(again, nullptr).value();
  const Bytes written = write_glb(without).value();
  const Json json = parts_of(written).json;
  EXPECT_EQ(json["meshes"][0]["extras"]["targetNames"], Json({"lift"}));
  EXPECT_EQ(json["meshes"][0]["primitives"][0]["targets"].size(), 1U);
  EXPECT_EQ(document::state_hash(read(written)), document::state_hash(without));
}

TEST(PatchGltf, AnimationsAreAddedChangedAndRemoved) {
  const Bytes bytes = avatar().glb();
  document::Model model = read(bytes);
  document::Animation made = model.animations[0];
  made.name = "made";
  model.animations.push_back(made);
  const Bytes more = write_glb(model).value();
  expect_kept(bytes, more);
  EXPECT_EQ(parts_of(more).json["animations"][2]["name"], "made");
  EXPECT_EQ(document::state_hash(read(more)), document::state_hash(model));

  model = read(bytes);
  model.animations[1].channels[0].values = {0.5, 1};
  const Bytes changed = write_glb(model).value();
  expect_kept(bytes, changed, {"/animations/1"});
  const Json clip = parts_of(changed).json["animations"][1];
  EXPECT_EQ(clip["channels"].size(), 2U) << "the camera still moves";
  EXPECT_EQ(document::state_hash(read(changed)), document::state_hash(model));

  model = read(bytes);
  model.animations.erase(model.animations.begin());
  model.animations.insert(model.animations.begin(), made);
  const Bytes other = write_glb(model).value();
  EXPECT_EQ(document::state_hash(read(other)), document::state_hash(model)) << "in the order of the model";
  EXPECT_EQ(parts_of(other).json["animations"][0]["name"], "over");
}

TEST(PatchGltf, WeightsBeyondOneAreHelped) {
  const Bytes bytes = avatar().glb();
  document::Model model = read(bytes);
  model.pose[0] = 1.25;
  const Bytes posed = write_glb(model).value();
  expect_kept(bytes, posed, {"/meshes/0/weights", "/animations"});
  const document::Model again = read(posed);
  EXPECT_EQ(document::state_hash(again), document::state_hash(model));
  EXPECT_EQ(write_glb(again).value(), posed);
  document::Model back = again;
  back.pose[0] = 0.5;
  EXPECT_EQ(document::state_hash(read(write_glb(back).value())), document::state_hash(back));
}

TEST(PatchGltf, JointsArePosedWhereTheyAre) {
  tests::GltfSample sample = tests::skin_sample();
  sample.json["nodes"][2].erase("translation");
  sample.json["nodes"][2]["matrix"] = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1};
  sample.json["nodes"][2]["extras"] = {{"acme", 1}};
  const Bytes bytes = sample.glb();
  document::Model model = read(bytes);
  ASSERT_EQ(model.pose.size(), 6U);
  model.pose[5] = 0.5;
  const Bytes posed = write_glb(model).value();
  expect_kept(bytes, posed, {"/nodes/2/matrix"});
  const document::Model again = read(posed);
  EXPECT_EQ(document::state_hash(again), document::state_hash(model));
  EXPECT_EQ(again.pose, model.pose);
  const Json node = parts_of(posed).json["nodes"][2];
  EXPECT_FALSE(node.contains("matrix"));
  EXPECT_NEAR(node["rotation"][2].get<double>(), std::sin(0.5 * (1.5707963267948966 + 0.5)), 1e-9);
}

TEST(PatchGltf, AHeadThatMovesAsAWholeGetsANodeAboveIt) {
  const Bytes bytes = avatar().glb();
  document::Model model = read(bytes);
  const std::vector<double> times{0, 1};
  model.animations.push_back(document::make_animation(model, "tracked", times, std::vector<rig::Pose>{{0}, {0.5}}));
  const std::vector<document::Placement> placements{{}, {glm::dquat(0.8, 0, 0.6, 0), {0.1, 0, 0}, 1.2}};
  model = document::with_placements(std::move(model), 2, {0, 0, 0}, times, placements).value();
  WriteReport report;
  const Bytes written = write_glb(model, {}, &report).value();
  EXPECT_TRUE(report.notes.empty());
  expect_kept(bytes, written, {"/scenes/0/nodes"});
  const Json json = parts_of(written).json;
  EXPECT_EQ(json["scenes"][0]["nodes"], Json({3}));
  EXPECT_EQ(json["nodes"][3]["children"], Json({0}));
  EXPECT_EQ(document::state_hash(read(written)), document::state_hash(model));
}

TEST(PatchGltf, AProjectKeepsTheFileToo) {
  const Bytes bytes = avatar().glb();
  document::Document document = document::make_document(read(bytes));
  document.locked = {"lift"};
  const Bytes written = write_project(document).value();
  expect_kept(bytes, written);
  const auto again = read_document(written, "a.glb").value();
  EXPECT_EQ(again.locked, document.locked);
  EXPECT_EQ(write_project(again).value(), written);
}

TEST(PatchGltf, BareFilesHaveWhatPenposeKnowsAlone) {
  const document::Model model = read(avatar().glb());
  WriteReport report;
  const Bytes bare = write_glb(model, {.bare = true}, &report).value();
  EXPECT_FALSE(parts_of(bare).json.contains("textures"));
  EXPECT_EQ(document::state_hash(read(bare)), document::state_hash(model));
  ASSERT_EQ(report.notes.size(), 1U);
  EXPECT_NE(report.notes[0].find("textures, texture coordinates"), std::string::npos) << report.notes[0];
}

TEST(PatchGltf, AnotherSurfaceIsWrittenAnew) {
  document::Model model = read(avatar().glb());
  auto other = document::make_model(tests::bare_trunk(tests::make_trunk()).mesh, nullptr, nullptr).value();
  other.source = model.source;
  WriteReport report;
  EXPECT_TRUE(write_glb(other, {}, &report).ok());
  ASSERT_EQ(report.notes.size(), 1U);
  EXPECT_NE(report.notes[0].find("its surface is another one"), std::string::npos) << report.notes[0];
}

/// The avatar as a .gltf with two buffers and a picture beside it.
struct Beside {
  std::string json;
  std::map<std::string, Bytes> files;
  [[nodiscard]] document::Model read() const {
    auto model = read_gltf(base::as_bytes(json), [this](const std::string& path) -> base::Result<Bytes> {
      const auto found = files.find(path);
      if (found == files.end()) return base::Error{"is not there", "", ""};
      return found->second;
    });
    EXPECT_TRUE(model.ok()) << model.error().line();
    return std::move(model).value();
  }
};
Beside beside() {
  tests::GltfSample sample = avatar();
  sample.json["images"] = {{{"uri", "tex/skin%201.png"}}, {{"uri", "gone.png"}}};
  const Bytes more{1, 2, 3, 4, 5};
  sample.json["bufferViews"].push_back({{"buffer", 1}, {"byteOffset", 1}, {"byteLength", 4}});
  sample.json["buffers"] = {{{"byteLength", sample.binary.size()}, {"uri", "trunk.bin"}},
                            {{"byteLength", more.size()}, {"uri", "more.bin"}}};
  return {sample.json.dump(),
          {{"trunk.bin", sample.binary}, {"more.bin", more}, {"tex/skin 1.png", {0x89, 'P', 'N', 'G', 9}}}};
}

TEST(PatchGltf, FilesBesideTheModelArePackedIntoOne) {
  const Beside from = beside();
  const document::Model model = from.read();
  const Bytes packed = write_glb(model).value();
  const Parts parts = parts_of(packed);
  expect_kept(Json::parse(from.json), parts.json, {"/buffers", "/bufferViews", "/images/0"});
  ASSERT_EQ(parts.json["buffers"].size(), 1U);
  EXPECT_FALSE(parts.json["buffers"][0].contains("uri"));
  const auto bytes_of = [&](const Json& view) {
    const auto first = parts.binary.begin() + view["byteOffset"].get<std::ptrdiff_t>();
    return Bytes(first, first + view["byteLength"].get<std::ptrdiff_t>());
  };
  const std::size_t views = Json::parse(from.json)["bufferViews"].size();
  EXPECT_EQ(bytes_of(parts.json["bufferViews"][views - 1]), (Bytes{2, 3, 4, 5}));
  const Json& image = parts.json["images"][0];
  EXPECT_EQ(image["mimeType"], "image/png");
  EXPECT_FALSE(image.contains("uri"));
  EXPECT_EQ(bytes_of(parts.json["bufferViews"][image["bufferView"].get<std::size_t>()]),
            from.files.at("tex/skin 1.png"));
  EXPECT_EQ(document::state_hash(read(packed)), document::state_hash(model));
}

TEST(PatchGltf, ATextFileLeavesThemBeside) {
  const Beside from = beside();
  document::Model model = from.read();
  WriteReport report;
  const Bytes same = write_gltf(model, {.stem = "out"}, &report).value();
  EXPECT_EQ(std::string(same.begin(), same.end()), from.json);
  EXPECT_EQ(report.files, from.files);
  model = with_curl(model);
  const Bytes text = write_gltf(model, {.stem = "out"}, &report).value();
  Beside written{std::string(text.begin(), text.end()), report.files};
  EXPECT_TRUE(written.files.contains("out.bin"));
  for (const auto& [name, bytes] : from.files) EXPECT_EQ(written.files[name], bytes) << name;
  expect_kept(Json::parse(from.json), Json::parse(written.json),
              {"/animations/0/samplers/0/output", "/animations/1/samplers/0/output"});
  EXPECT_EQ(document::state_hash(written.read()), document::state_hash(model));
  const Bytes glb = write_glb(model).value();
  report = {};
  const Bytes split = write_gltf(read(glb), {.stem = "out"}, &report).value();
  EXPECT_EQ(report.files.size(), 1U);
  EXPECT_EQ(document::state_hash(Beside{std::string(split.begin(), split.end()), report.files}.read()),
            document::state_hash(model));
}

TEST(PatchGltf, PrimitivesOfOneMeshGetAsManyTargets) {
  tests::GltfSample sample = avatar();
  Json line = sample.json["meshes"][0]["primitives"][0];
  const auto points = sample.add_vec3({0, 0, 0, 1, 1, 1});
  sample.json["accessors"][points]["min"] = {0, 0, 0};
  line = {{"attributes", {{"POSITION", points}}}, {"mode", 1}, {"targets", {{{"POSITION", points}}}}};
  sample.json["meshes"][0]["primitives"].push_back(line);
  const Bytes bytes = sample.glb();
  const document::Model model = with_curl(read(bytes));
  const Bytes written = write_glb(model).value();
  const Json json = parts_of(written).json;
  const Json& primitives = json["meshes"][0]["primitives"];
  EXPECT_EQ(primitives[0]["targets"].size(), primitives[1]["targets"].size());
  EXPECT_EQ(primitives[1]["targets"][0], line["targets"][0]);
  EXPECT_EQ(document::state_hash(read(written)), document::state_hash(model));
}

TEST(SharedPatchGltf, RealModelsKeepWhatWasNotPosed) {
  if (!tests::has_shared()) GTEST_SKIP() << "the shared data is not there";
  std::vector<std::filesystem::path> paths{tests::shared_dir() / "cases/rigs/textures_and_uv_lost/textured.glb"};
  for (const auto& entry : std::filesystem::directory_iterator(tests::shared_dir() / "meshes")) {
    if (entry.path().extension() == ".glb") paths.push_back(entry.path());
  }
  for (const auto& path : paths) {
    SCOPED_TRACE(path.string());
    const Bytes bytes = tests::read_file(path);
    document::Model model = read(bytes);
    EXPECT_EQ(write_glb(model).value(), bytes);
    for (std::size_t i = 0; i < model.pose.size(); i += 3) model.pose[i] = 0.25 * model.rig->parameters()[i].maximum;
    const Bytes posed = write_glb(model).value();
    const Json before = parts_of(bytes).json;
    std::vector<std::string> but{"/extras/penpose"};
    for (std::size_t m = 0; m < before["meshes"].size(); ++m)
      but.push_back("/meshes/" + std::to_string(m) + "/weights");
    for (std::size_t n = 0; n < before["nodes"].size(); ++n) {
      for (const char* member : {"/rotation", "/matrix", "/weights", "/extras/penpose"}) {
        but.push_back("/nodes/" + std::to_string(n) + member);
      }
    }
    expect_kept(bytes, posed, but);
    EXPECT_EQ(document::state_hash(read(posed)), document::state_hash(model));
  }
}

}  // namespace
}  // namespace penpose::io
