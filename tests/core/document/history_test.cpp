#include "core/document/history.h"

#include <gtest/gtest.h>

#include "core/document/document_hash.h"
#include "tests/support/random_session.h"

namespace penpose::document {
namespace {

TEST(History, UndoingAllGivesTheFirstStateAndRedoingAllTheLast) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    tests::SessionScript script(make_document(tests::sheet_model()));
    const DocumentState first = script.editor().state();
    tests::RandomHand(script, seed).run(40);
    // What the hand itself undid is brought back, so that everything lies behind.
    while (script.editor().redo()) {
    }
    const DocumentState last = script.editor().state();
    const std::size_t steps = script.editor().history().undo_count();
    std::vector<DocumentState> on_the_way;
    while (script.editor().undo()) on_the_way.push_back(script.editor().state());
    EXPECT_EQ(on_the_way.size(), steps);
    EXPECT_EQ(script.editor().state(), first) << "seed " << seed;
    // Forward again through the same states.
    for (std::size_t i = 0; i + 1 < on_the_way.size(); ++i) {
      ASSERT_TRUE(script.editor().redo());
      EXPECT_EQ(script.editor().state(), on_the_way[on_the_way.size() - 2 - i]) << "seed " << seed << ", step " << i;
    }
    while (script.editor().redo()) {
    }
    EXPECT_EQ(script.editor().state(), last) << "seed " << seed;
  }
}

TEST(History, ACommandAfterUndoGivesUpWhatWasUndone) {
  ApplyWorkspace work;
  History history(make_document(tests::sheet_model()));
  ASSERT_TRUE(history.perform(SetParameters{{{"lift", 0.5}}}, work));
  ASSERT_TRUE(history.perform(SetParameters{{{"lift", 0.75}}}, work));
  ASSERT_TRUE(history.undo());
  EXPECT_EQ(history.document().pose[0], 0.5);
  EXPECT_EQ(history.next_redo(), "set_parameters");
  ASSERT_TRUE(history.perform(SetParameters{{{"lean", 0.25}}}, work));
  EXPECT_EQ(history.redo_count(), 0U);
  const auto nothing = history.redo();
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().what, "there is nothing to redo");
}

TEST(History, AFailedCommandIsNoStep) {
  ApplyWorkspace work;
  History history(make_document(tests::sheet_model()));
  EXPECT_FALSE(history.perform(SetParameters{{{"lift", 7}}}, work));
  EXPECT_EQ(history.undo_count(), 0U);
  EXPECT_FALSE(history.undo());
}

TEST(History, StepsShareTheMesh) {
  ApplyWorkspace work;
  History history(make_document(tests::sheet_model()));
  const auto mesh = history.document().model->mesh;
  const long owners = mesh.use_count();
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(history.perform(SetParameters{{{"lift", i * 0.01}}}, work));
  }
  EXPECT_EQ(history.document().model->mesh, mesh);
  EXPECT_EQ(mesh.use_count(), owners) << "a step holds the model that was there, not a copy";
}

}  // namespace
}  // namespace penpose::document
