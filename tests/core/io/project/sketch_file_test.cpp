#include "core/io/project/sketch_file.h"

#include <gtest/gtest.h>

#include "tests/support/models/articulation_models.h"

namespace penpose::io {
namespace {

constexpr const char* k_small = R"({"model": "head.glb", "viewport": [800, 600], "note": "unknown keys are skipped",
 "deformers": [{"name": "jaw", "camera": {"eye": [0, 0, 3], "look_at": [0, 0, 0]},
  "general": [[1, 2], [3, 4.5], [5, 0]], "specific": [[1, 1], [2, 2], [0, 3]], "target": [[0, 0], [9, 9]]}]})";

base::Result<SketchFile> read(const std::string& text) { return read_sketch_file(base::as_bytes(text)); }

/// k_small with one piece of text changed.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = k_small;
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(SketchFile, ReadsWhatScriptsWrite) {
  const auto file = read(k_small);
  ASSERT_TRUE(file.ok()) << file.error().line();
  EXPECT_EQ(file->model, "head.glb");
  EXPECT_EQ(file->viewport, (geometry::Viewport{800, 600}));
  ASSERT_EQ(file->sketches.size(), 1U);
  const articulation::Sketch& sketch = file->sketches[0];
  EXPECT_EQ(sketch.name, "jaw");
  EXPECT_EQ(sketch.viewport, (geometry::Viewport{800, 600}));
  EXPECT_EQ(sketch.camera.eye, geometry::ModelPoint(0, 0, 3));
  EXPECT_EQ(sketch.camera.vertical_fov_degrees, 30);
  EXPECT_EQ(sketch.general[1], (geometry::PxPoint{3, 4.5}));
  EXPECT_TRUE(sketch.reference.empty());
  EXPECT_EQ(sketch.mode, articulation::Mode::automatic);
  EXPECT_EQ(sketch.surface.index(), 0U);
  EXPECT_EQ(sketch.maximum, 1.0);
  EXPECT_EQ(file->skipped, std::vector<std::string>{"/note"});
}

TEST(SketchFile, ListsMembersThatAreMisspelt) {
  const auto file = read(changed("\"target\"", "\"surfase\": {\"mesh\": \"eye\"}, \"target\""));
  ASSERT_TRUE(file.ok()) << file.error().line();
  EXPECT_EQ(file->skipped, (std::vector<std::string>{"/note", "/deformers/0/surfase"}));
}

TEST(SketchFile, ComesBackAsItWasWritten) {
  SketchFile file;
  file.model = "a \"model\".glb";
  file.viewport = {1000, 1000};
  file.sketches = {tests::make_eye().blink(), tests::make_trunk().curl()};
  file.sketches[1].viewport = {640, 480};
  file.sketches[1].mode = articulation::Mode::rotate;
  file.sketches[1].surface = articulation::PartSurface{"skull"};
  file.sketches[1].reference_camera = geometry::CameraPose{{1, 2, 3}, {0, 0.1, 0}, {0, 0, 1}, 44.4};
  file.sketches[1].target_camera = geometry::CameraPose{{1.1, 2, 3}, {0, 0.1, 0}, {0, 0, 1}, 44.4};
  file.sketches[1].minimum = -0.5;
  file.sketches[1].maximum = 1.5;
  file.sketches[1].target[2].x = 1.0 / 3.0;
  file.sketches.push_back(tests::make_eye().blink());
  file.sketches[2].name = "straight";
  file.sketches[2].surface = articulation::Free{};
  const auto back = read(write_sketch_file(file));
  ASSERT_TRUE(back.ok()) << back.error().line();
  EXPECT_EQ(back->model, file.model);
  EXPECT_EQ(back->viewport, file.viewport);
  EXPECT_EQ(back->sketches, file.sketches);
}

TEST(SketchFile, SaysWhereItIsWrong) {
  EXPECT_EQ(read("{\"deformers\": 3}").error().place, "/deformers");
  EXPECT_EQ(read("[]").error().place, "/");
  EXPECT_NE(read("{").error().place.find("byte"), std::string::npos);
  const auto place = [](const char* from, const char* to) {
    const auto file = read(changed(from, to));
    return file ? std::string("read") : file.error().place;
  };
  EXPECT_EQ(place("[800, 600]", "[0, 600]"), "/viewport/0");
  EXPECT_EQ(place("[800, 600]", "7"), "/viewport");
  EXPECT_EQ(place("\"viewport\": [800, 600],", ""), "/deformers/0");
  EXPECT_EQ(place("\"name\": \"jaw\",", ""), "/deformers/0");
  EXPECT_EQ(place("\"jaw\"", "7"), "/deformers/0/name");
  EXPECT_EQ(place("\"jaw\"", "\"\""), "/deformers/0/name");
  EXPECT_EQ(place("\"eye\": [0, 0, 3]", "\"eye\": [0, 0, \"a\"]"), "/deformers/0/camera/eye/2");
  EXPECT_EQ(place("\"eye\": [0, 0, 3]", "\"eye\": [0, 0, 0]"), "/deformers/0/camera/eye");
  EXPECT_EQ(place("\"look_at\": [0, 0, 0]", "\"at\": 0"), "/deformers/0/camera");
  EXPECT_EQ(place("[3, 4.5]", "[3]"), "/deformers/0/general/1");
  EXPECT_EQ(place("[3, 4.5]", "[1e300, 4]"), "/deformers/0/general/1");
  EXPECT_EQ(place("\"specific\"", "\"specif\""), "/deformers/0");
  EXPECT_EQ(place("\"target\": [[0, 0], [9, 9]]", "\"target\": []"), "/deformers/0/target");
  EXPECT_EQ(place("\"target\"", "\"mode\": \"turn\", \"target\""), "/deformers/0/mode");
  EXPECT_EQ(place("\"target\"", "\"surface\": {}, \"target\""), "/deformers/0/surface");
  EXPECT_EQ(place("\"target\"", "\"surface\": {\"mesh\": 3}, \"target\""), "/deformers/0/surface/mesh");
  EXPECT_EQ(place("\"target\"", "\"surface\": {\"sphere\": {\"center\": [0, 0, 0], \"radius\": -1}}, \"target\""),
            "/deformers/0/surface/sphere/radius");
  EXPECT_EQ(place("\"target\"",
                  "\"surface\": {\"mesh\": \"skull\", \"sphere\": {\"center\": [0, 0, 0], \"radius\": 1}}, \"target\""),
            "/deformers/0/surface");
  EXPECT_EQ(place("\"target\"", "\"surface\": {\"sphere\": {\"radius\": 1}}, \"target\""),
            "/deformers/0/surface/sphere");
  EXPECT_EQ(place("\"target\"", "\"range\": [1, 2], \"target\""), "/deformers/0/range");
  EXPECT_EQ(place("\"target\"", "\"target_camera\": {\"eye\": [1, 1, 1]}, \"target\""), "/deformers/0/target_camera");
}

TEST(SketchFile, RefusesTwoDeformersOfOneName) {
  SketchFile file;
  file.sketches = {tests::make_trunk().curl(), tests::make_trunk().curl()};
  EXPECT_EQ(read(write_sketch_file(file)).error().place, "/deformers/1/name");
}

TEST(SketchFile, TakesNullForWhatIsAbsent) {
  const auto file = read(changed("\"target\"",
                                 "\"reference\": null, \"surface\": null, \"target_camera\": null, \"mode\": "
                                 "\"translate\", \"target\""));
  ASSERT_TRUE(file.ok()) << file.error().line();
  EXPECT_EQ(file->sketches[0].mode, articulation::Mode::translate);
  EXPECT_FALSE(file->sketches[0].target_camera.has_value());
}

TEST(SketchFile, OtherTargetsAndCorrectionsComeBackAsTheyWereWritten) {
  auto file = read(k_small).value();
  file.skipped.clear();
  articulation::Sketch& sketch = file.sketches[0];
  sketch.reach = articulation::Reach::front;
  sketch.piece = 2;
  sketch.betweens = {{0.25, {{1, 2}, {3, 4}}, std::nullopt}, {0.5, {{5, 6}, {7, 8}}, sketch.camera}};
  articulation::CorrectionSketch correction{sketch, {{"jaw", 1}, {"smile", 0.75}}};
  correction.sketch.name = "both";
  correction.sketch.betweens.clear();
  file.corrections = {correction};
  const auto again = read(write_sketch_file(file));
  ASSERT_TRUE(again.ok()) << again.error().line();
  EXPECT_EQ(again->sketches, file.sketches);
  EXPECT_EQ(again->corrections, file.corrections);
  EXPECT_TRUE(again->skipped.empty());
}

TEST(SketchFile, BadTargetsAndCorrectionsAreToldWithTheirPlace) {
  const auto place = [](const std::string& member) {
    const auto file = read(changed("\"target\": [[0", member + ", \"target\": [[0"));
    return file ? std::string("none") : file.error().place;
  };
  EXPECT_EQ(place(R"("reach": "behind")"), "/deformers/0/reach");
  EXPECT_EQ(place(R"("piece": -1)"), "/deformers/0/piece");
  EXPECT_EQ(place(R"("betweens": 3)"), "/deformers/0/betweens");
  EXPECT_EQ(place(R"("betweens": [{"value": 0.5}])"), "/deformers/0/betweens/0");
  EXPECT_EQ(place(R"("betweens": [{"value": 5, "target": [[1, 2], [3, 4]]}])"), "/deformers/0/betweens/0/value");
  const auto with = [](const std::string& drivers) {
    std::string text = k_small;
    const std::string one = text.substr(text.find("[{\"name\": \"jaw\""));
    const std::string list = one.substr(0, one.rfind('}'));
    std::string correction = list.substr(0, list.rfind('}')) + drivers + "}]";
    correction.replace(correction.find("jaw"), 3, "fix");
    text.insert(text.rfind('}'), ", \"corrections\": " + correction);
    const auto file = read(text);
    return file ? std::string("none") : file.error().place;
  };
  EXPECT_EQ(with(R"(, "drivers": [["jaw", 1], ["smile", 1]])"), "none");
  EXPECT_EQ(with(""), "/corrections/0");
  EXPECT_EQ(with(R"(, "drivers": [["jaw", 1]])"), "/corrections/0/drivers");
  EXPECT_EQ(with(R"(, "drivers": [["jaw", 1], ["smile"]])"), "/corrections/0/drivers/1");
}

}  // namespace
}  // namespace penpose::io
