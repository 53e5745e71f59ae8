#include "ui/demo/contact_sheet.h"

#include <gtest/gtest.h>

#include "core/head/head.h"

namespace penpose::demo {
namespace {

TEST(ContactSheet, ShowsEveryCellInItsPlace) {
  const document::Model model = head::make_head();
  std::vector<SheetCell> cells(k_sheet_columns + 1, SheetCell{"a", model.pose, {}});
  cells.back().title = "";
  cells.back().regions.overlay.assign(model.mesh->vertex_count(), render::Color{0, 1, 0, 1});
  const auto sheet = draw_contact_sheet(model, cells);
  ASSERT_TRUE(sheet.ok()) << sheet.error().line();
  EXPECT_EQ(sheet->width, k_sheet_columns * k_sheet_cell.width);
  EXPECT_EQ(sheet->height, 2 * k_sheet_cell.height);
  const int x = k_sheet_cell.width / 2;
  const int y = k_sheet_cell.height / 2;
  const std::uint8_t* first = sheet->at(x, y);
  const std::uint8_t* second = sheet->at(x + k_sheet_cell.width, y);
  EXPECT_TRUE(std::equal(first, first + 3, second));
  const std::uint8_t* green = sheet->at(x, y + k_sheet_cell.height);
  EXPECT_GT(green[1], 2 * green[0]);
  EXPECT_GT(first[0], first[1]);
  const std::uint8_t* empty = sheet->at(x + k_sheet_cell.width, y + k_sheet_cell.height);
  EXPECT_LT(empty[0], 80) << "as dark as the pictures' own ground";
  EXPECT_EQ(empty[3], 255);
}

}  // namespace
}  // namespace penpose::demo
