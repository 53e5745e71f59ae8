#include "ui/app/session/step_list.h"

#include <gtest/gtest.h>

#include "tests/support/document_hand.h"

namespace penpose::app {
namespace {

using document::GoToTime;
using document::SetHand;
using document::SetKey;

class Steps : public ::testing::Test {
 protected:
  document::History history{document::make_document(tests::sheet_model())};
  document::ApplyWorkspace work;
  JoinedCommands joined;

  void does(const document::Command& command, bool joins = false) {
    joined.performed(history.undo_count(), joins);
    ASSERT_TRUE(history.perform(command, work).ok());
  }
  void undo() {
    for (std::size_t n = commands_to_undo(history, joined); n > 0; --n) ASSERT_TRUE(history.undo().ok());
  }
  void redo() {
    for (std::size_t n = commands_to_redo(history, joined); n > 0; --n) ASSERT_TRUE(history.redo().ok());
  }
};

TEST_F(Steps, MovesInTimeAreNone) {
  does(GoToTime{1});
  EXPECT_EQ(commands_to_undo(history, joined), 0U) << "there is nothing to undo yet";
  EXPECT_TRUE(listed_steps(history, joined).empty());
  does(SetHand{2});
  does(GoToTime{2});
  does(GoToTime{3});
  EXPECT_EQ(listed_steps(history, joined).size(), 1U);
  undo();
  EXPECT_EQ(history.document().hand, 1);
  EXPECT_EQ(history.document().time_s, 1);
  redo();
  EXPECT_EQ(history.document().hand, 2);
}

TEST_F(Steps, WhatIsJoinedGoesAndComesTogether) {
  does(SetHand{2});
  does(SetKey{0, {}}, true);
  does(SetKey{1, {}}, true);
  does(SetHand{3});
  ASSERT_EQ(listed_steps(history, joined).size(), 2U);
  undo();
  EXPECT_EQ(history.document().hand, 2);
  undo();
  EXPECT_TRUE(history.document().timeline->keys.empty());
  EXPECT_EQ(history.document().hand, 1);
  EXPECT_EQ(commands_to_undo(history, joined), 0U);
  redo();
  EXPECT_EQ(history.document().timeline->keys.size(), 2U);
  EXPECT_EQ(history.document().hand, 2);
}

TEST_F(Steps, WhatIsDoneAnewBelongsToNothingThatWasUndone) {
  does(SetHand{2});
  does(SetKey{0, {}}, true);
  undo();
  does(SetHand{3});
  does(SetKey{0, {}});
  const auto steps = listed_steps(history, joined);
  ASSERT_EQ(steps.size(), 2U) << "the key stands where one was joined before";
  EXPECT_EQ(steps[1].end, 2U);
}

}  // namespace
}  // namespace penpose::app
