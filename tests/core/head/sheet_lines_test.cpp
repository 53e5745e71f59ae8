#include "tests/support/sheet_lines.h"

#include <gtest/gtest.h>

#include "core/head/head.h"

namespace penpose::head {
namespace {

TEST(HeadLines, NeverLeaveTheSheetThatTheyAreOn) {
  for (const HeadEdition edition : {HeadEdition::first, HeadEdition::second}) {
    const document::Model model = make_head(edition);
    tests::SheetLines lines(*model.mesh);
    EXPECT_GT(lines.seam_count(), 100U);
    EXPECT_GT(lines.draw(250, 11, false), 100);
    EXPECT_GT(lines.draw(250, 12, true), 100) << "along lips, lids and other seams";
  }
}

}  // namespace
}  // namespace penpose::head
