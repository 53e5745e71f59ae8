#include <gtest/gtest.h>

#include "core/head/head.h"
#include "tests/support/models/sheet_lines.h"

namespace penpose::head {
namespace {

TEST(Seams, LinesNeverLeaveTheSheetThatTheyAreOn) {
  const document::Model head = make_head();
  tests::SheetLines lines(*head.mesh);
  EXPECT_GT(lines.draw(400, 11, false), 200);
  EXPECT_GT(lines.draw(400, 12, true), 200) << "along seams";
}

}  // namespace
}  // namespace penpose::head
