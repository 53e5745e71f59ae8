#pragma once

#include <optional>
#include <string>

#include "ui/app/widgets/internal/pose_picture.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {

struct PictureTile {
  float width = 0;                               ///< of the square picture
  std::optional<PosePictures::Corners> picture;  ///< nothing: not drawn yet
  std::string text;                              ///< under it, as far as it fits
  bool chosen = false;
};

/// How high a tile is.
[[nodiscard]] float picture_tile_height(const PanelContext& context, float width);
/// A button with a picture and a text under it. True when it is pressed.
bool picture_tile(PanelContext& context, const char* label, const PictureTile& tile);

}  // namespace penpose::app
