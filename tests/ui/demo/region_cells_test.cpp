#include "ui/demo/region_cells.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "core/character/demo_head.h"
#include "core/head/head.h"

namespace penpose::demo {
namespace {

TEST(RegionCells, FadeFromTheColourIntoTheSkinWithTheWeight) {
  const auto model = character::make_demo_head();
  ASSERT_TRUE(model.ok());
  const auto cells = region_cells(*model);
  ASSERT_FALSE(cells.empty());
  std::size_t names = 0;
  for (const RegionCell& cell : cells) {
    names += cell.legends.size();
    ASSERT_EQ(cell.overlay.size(), model->mesh->vertex_count());
  }
  EXPECT_EQ(names, 11U);  // seven pairs, jaw, upper lip, pucker, nose

  const auto& lid = *model->deformers->deformers()[0];
  const Legend& legend = cells[0].legends[0];
  EXPECT_EQ(legend.text, "eyelid_upper");
  for (std::size_t k = 0; k < lid.vertices().size(); ++k) {
    // Regions of one picture may share vertices that both move little.
    if (lid.weights()[k] <= 0.4) continue;
    const render::Color color = cells[0].overlay[lid.vertices()[k]];
    EXPECT_FLOAT_EQ(color.a, static_cast<float>(lid.weights()[k]));
    EXPECT_EQ(color.r, legend.color.r);
    if (lid.weights()[k] == 1.0) {
      EXPECT_EQ(color, legend.color);
    }
  }
  EXPECT_EQ(cells[0].overlay.back(), (render::Color{0, 0, 0, 0}));  // hair moves with nothing
}

TEST(RegionCells, AModelWithoutDeformersHasNone) { EXPECT_TRUE(region_cells(head::make_head()).empty()); }

}  // namespace
}  // namespace penpose::demo
