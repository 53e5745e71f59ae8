#include "core/document/commands/list/time/bookmark_commands.h"

#include <gtest/gtest.h>

#include "tests/support/document_hand.h"

namespace penpose::document {
namespace {

using tests::DocumentHand;

Bookmarks bookmarks(const DocumentHand& hand) {
  return hand.document().bookmarks ? *hand.document().bookmarks : Bookmarks();
}

TEST(BookmarkCommands, TheyStandInTheOrderOfTimeOneAMoment) {
  DocumentHand hand;
  hand.does(SetBookmark{2, "hit", 1});
  hand.does(SetBookmark{0.5, "", 0});
  EXPECT_EQ(bookmarks(hand), (Bookmarks{{0.5, "", 0}, {2, "hit", 1}}));
  EXPECT_FALSE(is_plain(hand.document())) << "saved as a project";
  hand.does(SetBookmark{2, "land", 3});
  EXPECT_EQ(bookmarks(hand), (Bookmarks{{0.5, "", 0}, {2, "land", 3}})) << "in place of the one that was there";
  hand.does(MoveBookmark{0.5, 4});
  EXPECT_EQ(bookmarks(hand), (Bookmarks{{2, "land", 3}, {4, "", 0}}));
  hand.does(MoveBookmark{4, 2});
  EXPECT_EQ(bookmarks(hand), (Bookmarks{{2, "", 0}}));
  hand.does(DeleteBookmark{{2}});
  EXPECT_EQ(hand.document().bookmarks, nullptr);
  ASSERT_TRUE(hand.undo().ok());
  EXPECT_EQ(bookmarks(hand), (Bookmarks{{2, "", 0}}));
}

TEST(BookmarkCommands, WhatIsNoBookmarkIsRefused) {
  DocumentHand hand;
  EXPECT_EQ(hand.refuses(SetBookmark{-1, "", 0}).place, "time_s");
  EXPECT_EQ(hand.refuses(SetBookmark{36001, "", 0}).place, "time_s");
  EXPECT_EQ(hand.refuses(SetBookmark{0, std::string(201, 'a'), 0}).place, "name");
  EXPECT_EQ(hand.refuses(SetBookmark{0, "", k_bookmark_colors}).place, "color");
  EXPECT_EQ(hand.refuses(MoveBookmark{1, 2}).what, "there is no bookmark at that moment");
  EXPECT_EQ(hand.refuses(DeleteBookmark{{1}}).what, "there is no bookmark at that moment");
  hand.does(SetBookmark{1, "", 0});
  EXPECT_EQ(hand.refuses(MoveBookmark{1, -1}).place, "to_s");
  for (std::size_t i = 1; i < k_most_bookmarks; ++i) hand.does(SetBookmark{1 + static_cast<double>(i), "", 0});
  EXPECT_EQ(hand.refuses(SetBookmark{0.5, "", 0}).what, "there are 1000 bookmarks already");
  hand.does(SetBookmark{1, "again", 0});
}

TEST(BookmarkCommands, EachClipHasItsOwnAndATrimmedOneTakesThemAlong) {
  DocumentHand hand;
  hand.does(SetKey{0, ""});
  hand.does(SetKey{4, ""});
  hand.does(SetBookmark{1, "a", 0});
  hand.does(SetBookmark{3, "b", 2});
  hand.does(AddClip{"other", false});
  EXPECT_EQ(hand.document().bookmarks, nullptr);
  hand.does(ShowClip{0});
  EXPECT_EQ(bookmarks(hand).size(), 2U);
  hand.does(TrimClip{2, 4});
  EXPECT_EQ(bookmarks(hand), (Bookmarks{{1, "b", 2}}));
}

}  // namespace
}  // namespace penpose::document
