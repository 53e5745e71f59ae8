#include "core/model_io/picture_scale.h"

namespace penpose::model_io {

void scale_to_picture(std::vector<TrackRow>& rows, std::optional<PictureSize> picture,
                      std::vector<std::string>& notes) {
  for (const TrackRow& row : rows) {
    for (const animation::PxPoint& p : row.points) {
      if (!(p.x >= -1 && p.x <= 2 && p.y >= -1 && p.y <= 2)) return;
    }
  }
  if (!picture) {
    notes.emplace_back("the size of the picture is not known and is taken as square; give it with --picture WxH");
    picture = PictureSize{1000, 1000};
  }
  for (TrackRow& row : rows) {
    for (animation::PxPoint& p : row.points) p = {p.x * picture->width, p.y * picture->height};
    for (double& depth : row.depths) depth *= picture->width;
  }
}

}  // namespace penpose::model_io
