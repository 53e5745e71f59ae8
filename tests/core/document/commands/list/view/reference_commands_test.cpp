#include "core/document/commands/list/view/reference_commands.h"

#include <gtest/gtest.h>

#include "tests/support/document_hand.h"

namespace penpose::document {
namespace {

using tests::DocumentHand;

TEST(ReferenceCommands, OneIsPlacedReplacedAndTakenAway) {
  DocumentHand hand;
  ReferencePicture picture;
  picture.file = "take.mp4";
  hand.does(SetReference{picture});
  picture.opacity = 0.25;
  hand.does(SetReference{picture});
  EXPECT_EQ(*hand.document().reference, picture);
  hand.does(RemoveReference{});
  EXPECT_EQ(hand.document().reference, nullptr);
  hand.refuses(RemoveReference{});
}

TEST(ReferenceCommands, NumbersOutOfTheirRangesAreRefusedByName) {
  DocumentHand hand;
  const auto refused = [&](auto change) {
    ReferencePicture picture;
    picture.file = "a.png";
    change(picture);
    return hand.refuses(SetReference{picture}).place;
  };
  EXPECT_EQ(refused([](ReferencePicture& p) { p.file.clear(); }), "file");
  EXPECT_EQ(refused([](ReferencePicture& p) { p.opacity = 1.5; }), "opacity");
  EXPECT_EQ(refused([](ReferencePicture& p) { p.height = 0; }), "height");
  EXPECT_EQ(refused([](ReferencePicture& p) { p.card_height = 3; }), "card_height");
  EXPECT_EQ(refused([](ReferencePicture& p) { p.card.x = 7; }), "card");
  EXPECT_EQ(refused([](ReferencePicture& p) { p.offset_s = 1e9; }), "offset_s");
}

}  // namespace
}  // namespace penpose::document
