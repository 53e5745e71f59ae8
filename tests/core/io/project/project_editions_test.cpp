#include <algorithm>
#include <cstring>
#include <functional>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/edition.h"
#include "core/io/model/write_model.h"
#include "core/io/project/read_document.h"
#include "core/io/project/write_document.h"
#include "tests/support/document_hand.h"

namespace penpose::io {
namespace {

/// A project with a control, and a line drawn to pose by it.
std::vector<std::uint8_t> drawn_project() {
  tests::DocumentHand hand;
  hand.does(document::BeginDeformer{"bump", articulation::Mode::translate, {}, 0, 1});
  const auto sketch = [&](articulation::CurveRole role, const std::vector<geometry::PxPoint>& line) {
    hand.does(document::SketchCurve{role, hand.view, line});
  };
  sketch(articulation::CurveRole::general, hand.diamond(0.8));
  sketch(articulation::CurveRole::specific, hand.diamond(0.4));
  sketch(articulation::CurveRole::reference, hand.line(-0.2, 0, 0.2, 0));
  sketch(articulation::CurveRole::target, hand.line(-0.2, 0.2, 0.2, 0.2));
  hand.does(document::DrawReference{hand.view, hand.line(-0.5, 0.5, 0.5, 0.5)});
  return write_project(hand.document()).value();
}

/// The same bytes with another digit as the extras' edition, so that the file keeps its lengths.
std::vector<std::uint8_t> of_edition(std::vector<std::uint8_t> bytes, char digit) {
  const std::string text(bytes.begin(), bytes.end());
  const std::size_t key = text.find("\"edition\":");
  EXPECT_NE(key, std::string::npos);
  // In as many letters as this edition's number has.
  bytes[key + 10] = ' ';
  bytes[key + 11] = static_cast<std::uint8_t>(digit);
  return bytes;
}

/// The same of an edition to come, which has one digit more; the name of the program that wrote it has one letter less.
std::vector<std::uint8_t> of_newer_edition(const std::vector<std::uint8_t>& bytes) {
  std::string text(bytes.begin(), bytes.end());
  const std::string program = "\"generator\":\"";
  const std::size_t name = text.find(program);
  EXPECT_NE(name, std::string::npos);
  text.erase(name + program.size(), 1);
  const std::size_t key = text.find("\"edition\":");
  EXPECT_NE(key, std::string::npos);
  text.insert(key + 10, "9");
  return {text.begin(), text.end()};
}

TEST(ProjectEditions, AProjectOfThisOneIsDrawnOn) {
  const auto document = read_document(drawn_project(), "project.glb");
  ASSERT_TRUE(document) << document.error().line();
  ASSERT_NE(document->model->deformers, nullptr);
  EXPECT_EQ(document->model->deformers->parameters()[0].name, "bump");
  EXPECT_EQ(document->curves.size(), 1U);
}

/// The same bytes with the name of a member changed to another of its length.
std::vector<std::uint8_t> renamed(std::vector<std::uint8_t> bytes, std::string_view name, std::string_view other) {
  const std::string text(bytes.begin(), bytes.end());
  const std::size_t key = text.find(name);
  EXPECT_NE(key, std::string::npos);
  std::copy(other.begin(), other.end(), bytes.begin() + static_cast<std::ptrdiff_t>(key));
  return bytes;
}

TEST(ProjectEditions, OneOfBeforeThereWereEditionsIsOfAnother) {
  const auto document = read_document(renamed(drawn_project(), "\"edition\"", "\"version\""), "project.glb");
  ASSERT_TRUE(document) << document.error().line();
  EXPECT_EQ(document->model->deformers, nullptr);
  EXPECT_TRUE(rig::find_parameter(document->model->rig->parameters(), "bump"));
}

TEST(ProjectEditions, AModelWithNothingDrawnIsOfEveryEdition) {
  tests::DocumentHand hand;
  const auto bytes = of_newer_edition(write_glb(*hand.document().model).value());
  const auto document = read_document(bytes, "model.glb");
  ASSERT_TRUE(document) << document.error().line();
  EXPECT_TRUE(document->model->notes.empty());
}

bool has_note(const document::Document& document, std::string_view text) {
  const auto& notes = document.model->notes;
  return std::any_of(notes.begin(), notes.end(),
                     [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

TEST(ProjectEditions, OneOfAnOlderEditionIsDrawnOn) {
  for (const char edition : {'1', '2', '3', '4', '5', '6', '7', '8', '9'}) {
    const auto document = read_document(of_edition(drawn_project(), edition), "project.glb");
    ASSERT_TRUE(document) << document.error().line();
    ASSERT_NE(document->model->deformers, nullptr) << edition;
    EXPECT_EQ(document->model->deformers->parameters()[0].name, "bump");
    EXPECT_EQ(document->curves.size(), 1U);
    EXPECT_TRUE(has_note(*document, std::string("was drawn in edition ") + edition + ": 1 of its 1 controls"));
  }
}

/// The project of a hand, with its extras changed.
std::vector<std::uint8_t> changed_project(const document::Document& document,
                                          const std::function<void(nlohmann::json& root)>& change) {
  const auto bytes = write_project(document).value();
  std::uint32_t size = 0;
  std::memcpy(&size, bytes.data() + 12, 4);
  auto root = nlohmann::json::parse(bytes.begin() + 20, bytes.begin() + 20 + size);
  change(root);
  std::string text = root.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::vector<std::uint8_t> out(bytes.begin(), bytes.begin() + 20);
  out.insert(out.end(), text.begin(), text.end());
  out.insert(out.end(), bytes.begin() + 20 + size, bytes.end());
  const std::uint32_t lengths[] = {static_cast<std::uint32_t>(out.size()), static_cast<std::uint32_t>(text.size())};
  std::memcpy(out.data() + 8, &lengths[0], 4);
  std::memcpy(out.data() + 12, &lengths[1], 4);
  return out;
}

/// Draws a control of the sheet.
void sketch(tests::DocumentHand& hand, const std::string& name, double from_y, double to_y) {
  hand.does(document::BeginDeformer{name, articulation::Mode::translate, {}, -1, 1});
  const auto draws = [&](articulation::CurveRole role, const std::vector<geometry::PxPoint>& line) {
    hand.does(document::SketchCurve{role, hand.view, line});
  };
  draws(articulation::CurveRole::general, hand.diamond(0.8));
  draws(articulation::CurveRole::specific, hand.diamond(0.4));
  draws(articulation::CurveRole::reference, hand.line(-0.2, from_y, 0.2, from_y));
  draws(articulation::CurveRole::target, hand.line(-0.2, to_y, 0.2, to_y));
}

// Up to edition 4 a timeline said one interpolation for all its keys.
TEST(ProjectEditions, TheInterpolationOfAnOlderTimelineIsThatOfItsKeys) {
  tests::DocumentHand hand;
  sketch(hand, "bump", 0, 0.2);
  hand.does(document::SetKey{0, {}});
  hand.does(document::SetParameters{{{"bump", 0.5}}});
  hand.does(document::SetKey{1, "up"});
  for (const auto& [interpolation, kind] :
       {std::pair("linear", document::KeyKind::linear), std::pair("smooth", document::KeyKind::smooth)}) {
    const auto document = read_document(changed_project(hand.document(),
                                                        [&](nlohmann::json& root) {
                                                          auto& own = root["extras"]["penpose"];
                                                          own["edition"] = 4;
                                                          own["project"]["timeline"]["interpolation"] = interpolation;
                                                        }),
                                        "project.glb");
    ASSERT_TRUE(document) << document.error().line();
    ASSERT_EQ(document->timeline->keys.size(), 2U);
    EXPECT_EQ(document->timeline->keys[1].name, "up");
    for (const document::PoseKey& key : document->timeline->keys) {
      for (std::size_t p = 0; p < key.pose.size(); ++p) EXPECT_EQ(key.controls[p].kind, kind);
    }
  }
}

// What the mesh of the file shows is what the control did then; one that would do something else today stays that.
TEST(ProjectEditions, AControlThatIsBuiltOtherwiseTodayStaysItsShapeAndIsNamedAndKeysKeepTheirControls) {
  tests::DocumentHand hand;
  sketch(hand, "first", 0, 0.2);
  sketch(hand, "second", 0, -0.2);
  hand.does(document::SetParameters{{{"first", -0.5}, {"second", 0.75}, {"lift", 0.125}}});
  hand.does(document::SetKey{1, {}});
  hand.does(document::SetKeyKind{{{1}, {"second"}}, document::KeyKind::stepped});
  const document::Document& drawn = hand.document();
  const auto bytes = changed_project(drawn, [](nlohmann::json& root) {
    auto& own = root["extras"]["penpose"];
    own["edition"] = 5;
    // In edition 5 the first control went somewhere else for the same lines.
    for (auto& point : own["deformers"][0]["target"]) point[1] = point[1].get<double>() - 40;
  });
  const auto document = read_document(bytes, "project.glb");
  ASSERT_TRUE(document) << document.error().line();
  ASSERT_NE(document->model->deformers, nullptr);
  ASSERT_EQ(document->model->deformers->size(), 1U);
  EXPECT_EQ(document->model->deformers->parameters()[0].name, "second");
  EXPECT_TRUE(has_note(*document, "was drawn in edition 5: 1 of its 2 controls"));
  EXPECT_TRUE(has_note(*document, "deformer first cannot be built again from its strokes and stays a blend shape"));
  const auto parameters = document->model->rig->parameters();
  const auto first = rig::find_parameter(parameters, "first");
  ASSERT_TRUE(first);
  EXPECT_EQ(parameters[*first].minimum, -1);
  // The key and the pose have every control at the value that it had, and it looks as it did.
  ASSERT_EQ(document->timeline->keys.size(), 1U);
  const document::PoseKey& key = document->timeline->keys[0];
  const auto was = drawn.model->rig->parameters();
  for (std::size_t p = 0; p < was.size(); ++p) {
    const auto now = rig::find_parameter(parameters, was[p].name);
    ASSERT_TRUE(now) << was[p].name;
    EXPECT_NEAR(key.pose[*now], drawn.pose[p], 1e-6) << was[p].name;
    EXPECT_NEAR(document->pose[*now], drawn.pose[p], 1e-6) << was[p].name;
    EXPECT_EQ(key.controls[*now].kind,
              was[p].name == "second" ? document::KeyKind::stepped : document::KeyKind::smooth);
  }
  const auto before = document::posed_positions(document::model_of(drawn));
  const auto after = document::posed_positions(document::model_of(*document));
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t v = 0; v < before.size(); ++v) EXPECT_LT(glm::distance(before[v], after[v]), 1e-5) << v;
}

TEST(ProjectEditions, AProjectOfANewerOneKeepsWhatItWasBakedTo) {
  const auto document = read_document(of_newer_edition(drawn_project()), "project.glb");
  ASSERT_TRUE(document) << document.error().line();
  EXPECT_EQ(document->model->deformers, nullptr);
  EXPECT_TRUE(document->curves.empty());
  EXPECT_TRUE(rig::find_parameter(document->model->rig->parameters(), "bump"));
  const auto& notes = document->model->notes;
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(),
                          [](const std::string& note) { return note.find("another edition") != std::string::npos; }));
}

}  // namespace
}  // namespace penpose::io
