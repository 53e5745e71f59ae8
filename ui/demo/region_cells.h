#pragma once

#include <string>
#include <vector>

#include "core/document/model.h"
#include "ui/render/picture/color.h"

namespace penpose::demo {

/// A line of text in a colour.
struct Legend {
  std::string text;
  render::Color color;
};

/// One picture of deformer regions: what to lay over every vertex, and what the colours mean.
struct RegionCell {
  std::vector<render::Color> overlay;  ///< one a vertex, clear where no region is
  std::vector<Legend> legends;
};

/// The regions of all deformers, each fading from its colour into the skin with its weight, so that no
/// edge of a triangle shows as a border. A left and a right deformer of
/// one name share a colour. Regions that lie over each other go into different pictures, as few as a first-fit gives.
[[nodiscard]] std::vector<RegionCell> region_cells(const document::Model& model);

}  // namespace penpose::demo
