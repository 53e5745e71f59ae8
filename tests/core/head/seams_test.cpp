#include <gtest/gtest.h>

#include "core/head/head.h"
#include "tests/support/models/sheet_lines.h"

namespace penpose::head {
namespace {

class Seams : public testing::TestWithParam<HeadEdition> {};

TEST_P(Seams, LinesNeverLeaveTheSheetThatTheyAreOn) {
  const document::Model head = make_head(GetParam());
  tests::SheetLines lines(*head.mesh, curve::Holding::firm);
  EXPECT_GT(lines.draw(400, 11, false), 200);
  EXPECT_GT(lines.draw(400, 12, true), 200) << "along seams";
}

INSTANTIATE_TEST_SUITE_P(Editions, Seams,
                         testing::Values(HeadEdition::first, HeadEdition::second, HeadEdition::third,
                                         HeadEdition::fourth));

}  // namespace
}  // namespace penpose::head
