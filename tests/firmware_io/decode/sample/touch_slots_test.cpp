#include "firmware_io/decode/sample/touch_slots.h"

#include <gtest/gtest.h>

namespace penpose::decode {
namespace {

void put(TouchSlots& slots, std::int32_t key, std::int32_t x, std::int32_t y) {
  const auto slot = slots.slot_of(key);
  ASSERT_TRUE(slot.has_value());
  slots.set(*slot, true);
  slots.move(*slot, x, y);
}

TEST(TouchSlots, AFingerKeepsItsNumberUntilItIsLifted) {
  TouchSlots slots(4);
  put(slots, 9, 1, 2);
  put(slots, 7, 3, 4);
  slots.end_frame();
  slots.publish();
  ASSERT_EQ(slots.contacts().size(), 2u);
  const TouchContact second = slots.contacts()[1];
  EXPECT_EQ(second.x, 3);
  slots.set(*slots.slot_of(9), false);
  put(slots, 7, 5, 6);
  slots.end_frame();
  slots.publish();
  ASSERT_EQ(slots.contacts().size(), 1u);
  EXPECT_EQ(slots.contacts()[0], (TouchContact{second.id, 5, 6}));
  put(slots, 9, 0, 0);
  slots.publish();
  ASSERT_EQ(slots.contacts().size(), 2u);
  EXPECT_NE(slots.contacts()[0].id, second.id);
  EXPECT_GT(slots.contacts()[0].id, second.id);
}

TEST(TouchSlots, NothingShowsBeforeItIsPublished) {
  TouchSlots slots(2);
  EXPECT_FALSE(slots.has_news());
  put(slots, 1, 10, 20);
  EXPECT_TRUE(slots.contacts().empty());
  EXPECT_TRUE(slots.has_news());
  slots.publish();
  EXPECT_FALSE(slots.has_news());
  EXPECT_EQ(slots.contacts().size(), 1u);
}

TEST(TouchSlots, AFingerMoreThanThereAreSlotsIsLeftOut) {
  TouchSlots slots(2);
  put(slots, 1, 0, 0);
  put(slots, 2, 0, 0);
  EXPECT_FALSE(slots.slot_of(3).has_value());
  EXPECT_TRUE(slots.slot_of(2).has_value());
}

TEST(TouchSlots, ASlotThatWasFreedIsGivenOutInTheNextFrame) {
  TouchSlots slots(1);
  put(slots, 1, 0, 0);
  slots.end_frame();
  slots.set(*slots.slot_of(1), false);
  EXPECT_FALSE(slots.slot_of(2).has_value());
  slots.end_frame();
  EXPECT_TRUE(slots.slot_of(2).has_value());
}

TEST(TouchSlots, FramesMayDropWhatTheyDoNotMention) {
  TouchSlots slots(3);
  put(slots, 1, 0, 0);
  put(slots, 2, 7, 8);
  slots.end_frame();
  put(slots, 2, 9, 9);
  slots.end_frame(true);
  slots.publish();
  ASSERT_EQ(slots.contacts().size(), 1u);
  EXPECT_EQ(slots.contacts()[0].x, 9);
  slots.clear();
  EXPECT_TRUE(slots.contacts().empty());
  EXPECT_FALSE(slots.any_active());
}

}  // namespace
}  // namespace penpose::decode
