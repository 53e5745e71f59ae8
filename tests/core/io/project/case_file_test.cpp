#include "core/io/project/case_file.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/io/model/read_model.h"
#include "tests/support/models/gltf_sample.h"
#include "tests/support/shared_data.h"

namespace penpose::io {
namespace {

nlohmann::json good_file() {
  return nlohmann::json::parse(
      R"({"mesh": "square.glb", "cases": [{"name": "up", "free": ["lift"], "view_yaw_degrees": 30,
    "references": [{"curve": "edge", "vertices": [1, 2], "target": [[1, 0, 0], [1, 1, 0.5]]}],
    "constraints": [{"curve": "base", "vertices": [0, 3]}], "weights": {"lift": 1}, "rest_energy": 0.5,
    "optimum_energy": 0, "something new": true}]})");
}

base::Result<CaseFile> read(const nlohmann::json& json) { return read_cases(base::as_bytes(json.dump())); }

std::string place_of_error(const nlohmann::json& json) {
  const auto file = read(json);
  return file ? "(no error)" : file.error().place;
}

TEST(CaseFile, ReadsEverything) {
  const auto file = read(good_file());
  ASSERT_TRUE(file.ok()) << file.error().line();
  EXPECT_EQ(file->mesh, "square.glb");
  ASSERT_EQ(file->cases.size(), 1U);
  const PoseCase& pose_case = file->cases[0];
  EXPECT_EQ(pose_case.name, "up");
  EXPECT_EQ(pose_case.free, std::vector<std::string>{"lift"});
  EXPECT_EQ(pose_case.view_yaw_degrees, 30);
  EXPECT_EQ(pose_case.references[0].vertices, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(pose_case.references[0].target[1], geometry::ModelPoint(1, 1, 0.5));
  EXPECT_EQ(pose_case.constraints[0].curve, "base");
  EXPECT_EQ(pose_case.weights[0].second, 1);
  EXPECT_EQ(pose_case.rest_energy, 0.5);
  EXPECT_EQ(pose_case.optimum_energy, 0);
}

TEST(CaseFile, NamesThePlaceOfEveryFault) {
  const auto bent = [](const char* pointer, const nlohmann::json& value) {
    auto file = good_file();
    file[nlohmann::json::json_pointer(pointer)] = value;
    return place_of_error(file);
  };
  EXPECT_EQ(place_of_error(nlohmann::json::array()), "/");
  EXPECT_EQ(bent("/cases", 3), "/cases");
  EXPECT_EQ(bent("/cases", nlohmann::json::array()), "/cases");
  EXPECT_EQ(bent("/cases/0", 3), "/cases/0");
  EXPECT_EQ(bent("/cases/0/name", 3), "/cases/0/name");
  EXPECT_EQ(bent("/cases/0/free", "lift"), "/cases/0/free");
  EXPECT_EQ(bent("/cases/0/free/0", 1), "/cases/0/free/0");
  EXPECT_EQ(bent("/cases/0/references", nlohmann::json::array()), "/cases/0/references");
  EXPECT_EQ(bent("/cases/0/references/0/vertices", {1}), "/cases/0/references/0/vertices");
  EXPECT_EQ(bent("/cases/0/references/0/vertices/1", -1), "/cases/0/references/0/vertices/1");
  EXPECT_EQ(bent("/cases/0/references/0/vertices/1", 1.5), "/cases/0/references/0/vertices/1");
  EXPECT_EQ(bent("/cases/0/references/0/target", {{1, 0, 0}}), "/cases/0/references/0/target");
  EXPECT_EQ(bent("/cases/0/references/0/target", {{1, 0, 0}, {1, 0, 0}}), "/cases/0/references/0/target");
  EXPECT_EQ(bent("/cases/0/references/0/target/1", {1, 2}), "/cases/0/references/0/target/1");
  EXPECT_EQ(bent("/cases/0/references/0/target/1/2", nullptr), "/cases/0/references/0/target/1/2");
  EXPECT_EQ(bent("/cases/0/references/0/target/1/2", 1e200), "/cases/0/references/0/target/1/2");
  EXPECT_EQ(bent("/cases/0/constraints/0/vertices", "all"), "/cases/0/constraints/0/vertices");
  EXPECT_EQ(bent("/cases/0/weights/lift", "much"), "/cases/0/weights/lift");
  EXPECT_EQ(bent("/cases/0/view_yaw_degrees", "left"), "/cases/0/view_yaw_degrees");
  auto twice = good_file();
  twice["cases"].push_back(twice["cases"][0]);
  EXPECT_EQ(place_of_error(twice), "/cases/1/name");
  auto nameless = good_file();
  nameless["cases"][0].erase("name");
  EXPECT_EQ(place_of_error(nameless), "/cases/0");
}

TEST(CaseFile, ChecksAgainstAModel) {
  const auto model = tests::morph_sample().read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  const auto place = [&](const char* pointer, const nlohmann::json& value, TargetForm form = TargetForm::points) {
    auto json = good_file();
    json[nlohmann::json::json_pointer(pointer)] = value;
    const auto file = read(json);
    if (!file) return "read: " + file.error().place;
    const auto status = check_cases(*file, *model, form);
    return status ? std::string("fits") : status.error().place;
  };
  EXPECT_EQ(place("/mesh", "x"), "fits");
  EXPECT_EQ(place("/cases/0/free/0", "smile"), "/cases/0/free/0");
  EXPECT_EQ(place("/cases/0/weights/smile", 1), "/cases/0/weights/smile");
  EXPECT_EQ(place("/cases/0/references/0/vertices/1", 4), "/cases/0/references/0/vertices/1");
  EXPECT_EQ(place("/cases/0/references/0/vertices/1", 1), "/cases/0/references/0/vertices");
  EXPECT_EQ(place("/cases/0/constraints/0/vertices/0", 99), "/cases/0/constraints/0/vertices/0");
  const nlohmann::json three = {{1, 0, 0}, {1, 1, 0}, {1, 2, 0}};
  EXPECT_EQ(place("/cases/0/references/0/target", three), "/cases/0/references/0/target");
  EXPECT_EQ(place("/cases/0/references/0/target", three, TargetForm::drawn), "fits");
}

TEST(SharedCaseFiles, FitTheFace) {
  if (!tests::has_shared()) GTEST_SKIP();
  const auto meshes = tests::shared_dir() / "meshes";
  for (const char* mesh : {"ict_face.glb", "ict_face_narrow.glb"}) {
    const auto model = read_model(tests::read_file(meshes / mesh), mesh);
    ASSERT_TRUE(model.ok()) << model.error().line();
    for (const char* name : {"ict_face_pose_cases.json", "ict_face_sketch_cases.json"}) {
      const auto cases = read_cases(tests::read_file(meshes / name));
      ASSERT_TRUE(cases.ok()) << cases.error().line();
      EXPECT_EQ(cases->cases.size(), 12U);
      EXPECT_TRUE(check_cases(*cases, *model).ok()) << mesh << " " << name;
    }
  }
}

}  // namespace
}  // namespace penpose::io
