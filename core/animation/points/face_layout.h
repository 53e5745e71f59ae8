#pragma once

#include <span>
#include <vector>

#include "core/animation/points/eigen_points.h"

namespace penpose::animation {

/// How all points of a face lie to one another in labelled pictures: their principal components once each face is
/// carried onto the mean by a similarity (Cootes et al., "Active shape models", 1995). A head that turns is one of
/// them.
struct FaceLayout {
  std::vector<double> mean;   ///< x and y in turn, about 0, of extent 1
  std::vector<double> basis;  ///< the components, one after the other, of length one
  std::size_t components = 0;
  double usual = 0;  ///< what is left of a labelled face, RMS, when it is not among those that were learned from
};

/// Nothing (no components, usual 0) where there are fewer than four pictures or points.
[[nodiscard]] FaceLayout learn_layout(std::span<const LabelledImage> images);

/// Points as the layout would have them, and how far the given ones are from that.
struct Laid {
  std::vector<PxPoint> points;
  double apart = 0;  ///< RMS, as a multiple of what is usual; 0 where there is no layout
};
[[nodiscard]] Laid lay(const FaceLayout& layout, std::span<const PxPoint> points);

/// As find_eigen_points, with features that went astray looked for again where the others say they are. The confidence
/// counts how well all that was found fits together, too: less than 0.2 where it is twice as far apart as is usual.
[[nodiscard]] base::Result<EigenFound> find_face(const EigenPoints& learned, const FaceLayout& layout,
                                                 const GreyImage& image, std::span<const PxPoint> shifts);

}  // namespace penpose::animation
