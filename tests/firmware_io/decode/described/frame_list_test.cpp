#include "firmware_io/decode/described/frame_list.h"

#include <gtest/gtest.h>

namespace penpose::decode {
namespace {

TEST(FrameList, KeepsTheNewestWhenThereAreTooMany) {
  FrameList list;
  EXPECT_TRUE(list.empty());
  PenSample sample;
  for (sample.x = 0; sample.x < 20; ++sample.x) list.add(sample);
  ASSERT_EQ(list.all().size(), FrameList::k_most);
  EXPECT_EQ(list.all().front().x, 0);
  EXPECT_EQ(list.all().back().x, 19);
  list.clear();
  EXPECT_TRUE(list.all().empty());
}

}  // namespace
}  // namespace penpose::decode
