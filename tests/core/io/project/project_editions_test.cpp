#include <algorithm>
#include <gtest/gtest.h>

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
  bytes[key + 10] = static_cast<std::uint8_t>(digit);
  return bytes;
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
  const auto bytes = of_edition(write_glb(*hand.document().model).value(), '9');
  const auto document = read_document(bytes, "model.glb");
  ASSERT_TRUE(document) << document.error().line();
  EXPECT_TRUE(document->model->notes.empty());
}

TEST(ProjectEditions, AProjectOfAnotherKeepsWhatItWasBakedTo) {
  const auto document = read_document(of_edition(drawn_project(), '9'), "project.glb");
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
