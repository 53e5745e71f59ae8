#pragma once

#include <span>
#include <string>

#include "core/base/result.h"
#include "core/document/model.h"
#include "ui/demo/region_cells.h"
#include "ui/render/picture/image.h"

namespace penpose::demo {

/// One picture of the sheet.
struct SheetCell {
  std::string title;
  rig::Pose pose;
  RegionCell regions;  ///< no overlay: the model's own colours
};

/// Where the sheet's pictures look from.
[[nodiscard]] geometry::CameraPose sheet_camera();

inline constexpr int k_sheet_columns = 5;
inline constexpr geometry::Viewport k_sheet_cell{300, 330};

/// All pictures side by side with their titles, row by row. Works without a display. Errors: no OpenGL.
[[nodiscard]] base::Result<render::Image> draw_contact_sheet(const document::Model& model,
                                                             std::span<const SheetCell> cells);

}  // namespace penpose::demo
