#include "core/drawing/editor.h"

#include <gtest/gtest.h>

#include "tests/support/models/sheet_model.h"

namespace penpose::drawing {
namespace {

Editor sheet_editor() { return Editor(document::make_document(tests::sheet_model())); }

/// Across the picture at a height, 0 at its top and 1 at its bottom.
curve::Stroke across(const document::View& view, double height) {
  curve::Stroke stroke;
  for (int i = 0; i <= 20; ++i) {
    stroke.push_back({{view.viewport.width * (0.35 + 0.015 * i), view.viewport.height * height}, 0.5, i});
  }
  return stroke;
}

TEST(Editor, OpensWithTheWholeModelInSight) {
  const Editor editor = sheet_editor();
  const auto camera = geometry::Camera::make(editor.view().camera, editor.view().viewport).value();
  for (const auto& p : posed_positions(*editor.document().model)) {
    const auto px = camera.project(p);
    ASSERT_TRUE(px.has_value());
    EXPECT_TRUE(px->x > 0 && px->x < 1000 && px->y > 0 && px->y < 1000);
  }
  EXPECT_EQ(editor.tool(), Tool{});
}

TEST(Editor, AStrokeIsDrawnInTheViewItBeganIn) {
  Editor editor = sheet_editor();
  const document::View before = editor.view();
  document::View turned = before;
  turned.camera.eye.x += 2;
  ASSERT_TRUE(editor.set_view(turned).ok());
  ASSERT_TRUE(editor.draw(across(before, 0.35), before, false).ok());
  ASSERT_TRUE(editor.draw(across(before, 0.3), before, false).ok());
  ASSERT_EQ(editor.document().curves.size(), 1U);
  EXPECT_EQ(editor.document().curves[0]->target->view, before);
}

TEST(Editor, AViewThatCannotBeIsRefusedAndTheOldOneStays) {
  Editor editor = sheet_editor();
  const document::View before = editor.view();
  document::View wrong = before;
  wrong.camera.vertical_fov_degrees = 0;
  EXPECT_FALSE(editor.set_view(wrong).ok());
  wrong = before;
  wrong.viewport.width = 0;
  EXPECT_FALSE(editor.set_view(wrong).ok());
  EXPECT_EQ(editor.view(), before);
}

TEST(Editor, TheToolDecidesWhatAStrokeMeans) {
  Editor editor = sheet_editor();
  Tool pin;
  pin.kind = ToolKind::pin;
  editor.set_tool(pin);
  ASSERT_TRUE(editor.draw(across(editor.view(), 0.5), editor.view(), false).ok());
  EXPECT_EQ(editor.document().curves[0]->points.size(), 1U);
  editor.set_tool(Tool{});
  EXPECT_TRUE(editor.draw(across(editor.view(), 0.5), editor.view(), true).ok()) << "the eraser end";
  EXPECT_TRUE(editor.document().curves.empty());
  Tool none;
  none.kind = ToolKind::none;
  editor.set_tool(none);
  EXPECT_FALSE(editor.draw(across(editor.view(), 0.5), editor.view(), false).ok());
}

TEST(Editor, UndoAndRedoGoBetweenStates) {
  Editor editor = sheet_editor();
  const auto first = editor.state();
  ASSERT_TRUE(editor.draw(across(editor.view(), 0.35), editor.view(), false).ok());
  const auto drawn = editor.state();
  ASSERT_TRUE(editor.perform(document::SetParameters{{{"lift", 0.5}}}).ok());
  const auto posed = editor.state();
  EXPECT_FALSE(drawn == first || posed == drawn);
  EXPECT_FALSE(editor.perform(document::SetParameters{{{"lift", 5}}}).ok());
  EXPECT_EQ(editor.state(), posed);
  ASSERT_TRUE(editor.undo().ok());
  EXPECT_EQ(editor.state(), drawn);
  ASSERT_TRUE(editor.undo().ok());
  EXPECT_EQ(editor.state(), first);
  EXPECT_FALSE(editor.undo().ok());
  ASSERT_TRUE(editor.redo().ok());
  ASSERT_TRUE(editor.redo().ok());
  EXPECT_EQ(editor.state(), posed);
  EXPECT_FALSE(editor.redo().ok());
}

TEST(Editor, TheSameCallsGiveTheSameState) {
  const auto run = [] {
    Editor editor = sheet_editor();
    static_cast<void>(editor.draw(across(editor.view(), 0.35), editor.view(), false));
    static_cast<void>(editor.draw(across(editor.view(), 0.3), editor.view(), false));
    return editor.state();
  };
  EXPECT_EQ(run(), run());
  EXPECT_FALSE(run() == sheet_editor().state());
}

}  // namespace
}  // namespace penpose::drawing
