#include "core/io/tracks/picture_scale.h"

namespace penpose::io {

void scale_to_picture(std::vector<TrackRow>& rows, std::optional<PictureSize> picture,
                      std::vector<std::string>& notes) {
  // Most points tell: a tracker that errs puts one anywhere.
  std::size_t near = 0;
  std::size_t all = 0;
  for (const TrackRow& row : rows) {
    for (const animation::PxPoint& p : row.points) {
      near += p.x >= -1 && p.x <= 2 && p.y >= -1 && p.y <= 2 ? 1 : 0;
      ++all;
    }
  }
  if (2 * near <= all) {
    if (picture) notes.emplace_back("its points are in px already; the size of the picture is not used");
    return;
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

}  // namespace penpose::io
