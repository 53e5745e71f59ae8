#include "core/document/words/control_words.h"

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>

#include "core/character/demo_head.h"
#include "core/document/features/feature_curves.h"
#include "core/document/words/face_deeds.h"
#include "core/io/model/read_model.h"
#include "tests/support/models/stick_figure.h"
#include "tests/support/shared_data.h"

namespace penpose::document {
namespace {

/// Controls of the built-in head, as shapes of a file that calls them otherwise.
using Called = std::vector<std::pair<std::string, std::string>>;

/// A shape that does what a pose does.
rig::BlendShape shape_of(const Model& model, const std::string& name, const rig::Pose& pose) {
  std::vector<geometry::ModelPoint> rest(model.rig->vertex_count());
  std::vector<geometry::ModelPoint> posed(rest.size());
  model.rig->evaluate(rig::rest_pose(*model.rig), rest);
  model.rig->evaluate(pose, posed);
  rig::BlendShape shape{{name, 0, 0, 1}, {}, {}, {}};
  for (std::uint32_t v = 0; v < rest.size(); ++v) {
    const glm::vec3 delta(posed[v] - rest[v]);
    if (delta == glm::vec3(0)) continue;
    shape.vertices.push_back(v);
    shape.deltas.push_back(delta);
  }
  return shape;
}

/// The built-in head with these controls as shapes.
Model head_of(const Called& called) {
  const Model demo = character::make_demo_head().value();
  std::vector<rig::BlendShape> shapes;
  for (const auto& [control, name] : called) {
    rig::Pose pose = rig::rest_pose(*demo.rig);
    const std::size_t i = *rig::find_parameter(demo.rig->parameters(), control);
    pose[i] = demo.rig->parameters()[i].maximum;
    shapes.push_back(shape_of(demo, name, pose));
  }
  auto made = rig::BlendShapes::make(std::move(shapes), demo.mesh->vertex_count()).value();
  Model model = make_model(demo.mesh, std::move(made), nullptr).value();
  model.curves = demo.curves;
  return model;
}

std::map<std::string, std::string> words_by_name(const Model& model) {
  const intent::WholeModel whole = intent::measure_whole_model(*model.rig);
  const auto features = feature_curves_of(model, whole, {});
  std::vector<portrait::FeatureCurve> curves;
  if (features) curves = features->curves;
  const auto words = control_words(model, whole, curves);
  std::map<std::string, std::string> out;
  for (std::size_t i = 0; i < words.size(); ++i) out[model.rig->parameters()[i].name] = words[i].text();
  return out;
}

TEST(ControlWords, SayWhatAControlDoesWhateverItIsCalled) {
  const auto words = words_by_name(head_of({{"eyelid_upper_L", "a"},
                                            {"eyelid_lower_R", "b"},
                                            {"brow_inner_L", "c"},
                                            {"brow_outer_R", "d"},
                                            {"mouth_corner_L", "e"},
                                            {"mouth_frown_R", "f"},
                                            {"jaw", "g"},
                                            {"lip_upper", "h"},
                                            {"cheek_L", "i"}}));
  EXPECT_EQ(words.at("a"), "eye closes, left");
  EXPECT_EQ(words.at("b"), "lower lid raised, right");
  EXPECT_EQ(words.at("c"), "inner brow raised, left");
  EXPECT_EQ(words.at("d"), "outer brow raised, right");
  EXPECT_EQ(words.at("e"), "smile, left");
  EXPECT_EQ(words.at("f"), "mouth corner down, right");
  EXPECT_EQ(words.at("g"), "jaw opens");
  EXPECT_EQ(words.at("h"), "upper lip raised");
  EXPECT_EQ(words.at("i"), "cheek raised, left");
}

TEST(ControlWords, ANameThatSaysOtherwiseThanTheFaceIsNotBelieved) {
  const auto words = words_by_name(head_of({{"jaw", "browInnerUp"}, {"brow_inner_L", "jawOpen"}}));
  EXPECT_EQ(words.at("browInnerUp"), "jaw opens");
  EXPECT_EQ(words.at("jawOpen"), "inner brow raised, left");
}

TEST(ControlWords, ANameSpeaksWhereTheFaceShowsNothing) {
  Model model = head_of({{"jaw", "jaw"}});
  std::vector<rig::BlendShape> shapes(model.shapes->shapes().begin(), model.shapes->shapes().end());
  // A vertex that no feature has.
  shapes.push_back({{"tongueOut", 0, 0, 1}, {0}, {glm::vec3(0, 0, 1e-6F)}, {}});
  shapes.push_back({{"earWiggle_L", 0, 0, 1}, {0}, {glm::vec3(0, 0, 1e-6F)}, {}});
  const auto curves = model.curves;
  model = make_model(model.mesh, rig::BlendShapes::make(shapes, model.mesh->vertex_count()).value(), nullptr).value();
  model.curves = curves;
  const auto words = words_by_name(model);
  EXPECT_EQ(words.at("tongueOut"), "tongue out");
  EXPECT_EQ(words.at("earWiggle_L"), "ear wiggle, left");
}

TEST(ControlWords, AreOfOneControlAlone) {
  const auto words = words_by_name(head_of(
      {{"jaw", "one"}, {"jaw", "two"}, {"jaw", "three"}, {"mouth_corner_L", "four"}, {"mouth_corner_L", "five"}}));
  std::set<std::string> texts;
  for (const auto& [name, text] : words) texts.insert(text);
  EXPECT_EQ(texts.size(), words.size());
  EXPECT_TRUE(texts.contains("jaw opens")) << "one of those that are alike has the plain words";
}

TEST(ControlWords, OfASketchedControlAreItsName) {
  const Model demo = character::make_demo_head().value();
  const auto words = words_by_name(demo);
  EXPECT_EQ(words.at("mouth_corner_L"), "mouth corner, left");
  EXPECT_EQ(words.at("jaw"), "jaw");
}

TEST(ControlWords, AreTheSameEachTime) {
  const Model model = head_of({{"jaw", "a"}, {"jaw", "b"}, {"brow_inner_L", "c"}});
  EXPECT_EQ(words_by_name(model), words_by_name(model));
}

/// A figure in a T-pose that faces +z, with hands of five fingers.
tests::StickFigure figure() {
  tests::StickFigure body(1, true);
  const auto hips = body.add(-1, {0, 1, 0}, {0, 1.2, 0});
  const auto at = [](std::size_t joint) { return static_cast<std::int32_t>(joint); };
  const auto chest = body.add(at(hips), {0, 1.2, 0}, {0, 1.5, 0});
  const auto neck = body.add(at(chest), {0, 1.5, 0}, {0, 1.6, 0});
  body.add(at(neck), {0, 1.6, 0}, {0, 1.8, 0});
  for (const double side : {1.0, -1.0}) {
    const auto thigh = body.add(at(hips), {side * 0.1, 0.95, 0}, {side * 0.1, 0.5, 0.01});
    const auto shin = body.add(at(thigh), {side * 0.1, 0.5, 0.01}, {side * 0.1, 0.1, 0});
    body.add(at(shin), {side * 0.1, 0.1, 0}, {side * 0.1, 0.05, 0.2});
    const auto upper = body.add(at(chest), {side * 0.2, 1.45, 0}, {side * 0.45, 1.45, -0.01});
    body.add(at(upper), {side * 0.45, 1.45, -0.01}, {side * 0.7, 1.45, 0});
  }
  return body;
}

TEST(ControlWords, OfJointsComeFromTheShapeOfTheBody) {
  const tests::StickFigure body = figure();
  const auto rig = body.rig();
  const auto mesh = std::make_shared<const mesh::TriangleMesh>(rig->mesh());
  const auto words = words_by_name(make_model(mesh, nullptr, body.skeleton()).value());
  std::set<std::string> texts;
  for (const auto& [name, text] : words) texts.insert(text);
  EXPECT_EQ(texts.size(), words.size());
  for (const char* text : {"head turns", "head nods", "head tilts", "neck turns", "upper leg swings forward, left",
                           "lower arm raises, right", "upper arm twists, left"})
    EXPECT_TRUE(texts.contains(text)) << text;
}

/// What people call ARKit's shapes, without their side.
const std::map<std::string, std::set<std::string>>& arkit_words() {
  static const std::map<std::string, std::set<std::string>> words{
      {"browDown", {"brow down"}},
      {"browInnerUp", {"inner brow raised"}},
      {"browOuterUp", {"outer brow raised", "brow raised"}},
      {"cheekPuff", {"cheek puffs"}},
      {"cheekSquint", {"cheek raised"}},
      {"eyeBlink", {"eye closes"}},
      {"eyeLookDown", {"eye looks down"}},
      {"eyeLookIn", {"eye looks in"}},
      {"eyeLookOut", {"eye looks out"}},
      {"eyeLookUp", {"eye looks up"}},
      {"eyeSquint", {"lower lid raised", "eye narrows"}},
      {"eyeWide", {"eye wide"}},
      {"jawForward", {"jaw forward"}},
      {"jawLeft", {"jaw left"}},
      {"jawOpen", {"jaw opens"}},
      {"jawRight", {"jaw right"}},
      {"mouthClose", {"lips close"}},
      {"mouthDimple", {"dimple"}},
      {"mouthFrown", {"mouth corner down"}},
      {"mouthFunnel", {"lips funnel"}},
      {"mouthLeft", {"mouth left"}},
      {"mouthLowerDown", {"lower lip down"}},
      {"mouthPress", {"lips press"}},
      {"mouthPucker", {"lips pucker"}},
      {"mouthRight", {"mouth right"}},
      {"mouthRollLower", {"lower lip rolls in"}},
      {"mouthRollUpper", {"upper lip rolls in"}},
      {"mouthShrugLower", {"lower lip raised", "chin raised"}},
      {"mouthShrugUpper", {"upper lip raised"}},
      {"mouthSmile", {"smile"}},
      {"mouthStretch", {"mouth stretches"}},
      {"mouthUpperUp", {"upper lip raised"}},
      {"noseSneer", {"nose wrinkles"}}};
  return words;
}

class SharedControlWords : public ::testing::TestWithParam<const char*> {};

TEST_P(SharedControlWords, NineInTenAreWhatPeopleWouldSayWithoutTheirNames) {
  if (!tests::has_shared()) GTEST_SKIP() << "no shared data";
  const std::string file = GetParam();
  const Model read = io::read_model(tests::read_file(tests::shared_dir() / "meshes" / file), file).value();
  std::vector<rig::BlendShape> shapes(read.shapes->shapes().begin(), read.shapes->shapes().end());
  std::vector<std::string> names;
  for (rig::BlendShape& shape : shapes) {
    names.push_back(shape.parameter.name);
    shape.parameter.name = "c" + std::to_string(names.size());
  }
  Model model =
      make_model(read.mesh, rig::BlendShapes::make(shapes, read.mesh->vertex_count()).value(), read.skeleton).value();
  model.front_yaw_degrees = read.front_yaw_degrees;
  const auto words = words_by_name(model);
  int known = 0;
  int right = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool sided = names[i].ends_with("_L") || names[i].ends_with("_R");
    const auto meant = arkit_words().find(sided ? names[i].substr(0, names[i].size() - 2) : names[i]);
    if (meant == arkit_words().end()) continue;
    ++known;
    std::string said = words.at("c" + std::to_string(i + 1));
    if (sided) {
      const std::string side = names[i].back() == 'L' ? ", left" : ", right";
      EXPECT_TRUE(said.ends_with(side)) << names[i] << ": " << said;
      said = said.substr(0, said.find(side));
    }
    if (meant->second.contains(said)) {
      ++right;
    } else {
      std::cout << names[i] << ": " << said << '\n';
    }
  }
  EXPECT_GE(known, 50);
  EXPECT_GE(10 * right, 9 * known);
}

INSTANTIATE_TEST_SUITE_P(Faces, SharedControlWords,
                         ::testing::Values("ict_face.glb", "ict_face_narrow.glb", "ict_avatar.glb",
                                           "carry_head_answer.glb"));

}  // namespace
}  // namespace penpose::document
