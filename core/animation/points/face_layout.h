#pragma once

#include <span>
#include <vector>

#include "core/animation/points/eigen_points.h"

namespace penpose::animation {

/// The shape of all points of a face in labelled pictures: their principal components after aligning each face with the
/// mean by a similarity (Cootes et al., "Active shape models", 1995). The turn of a head is one of them.
struct FaceLayout {
  std::vector<double> mean;   ///< x and y in turn, about 0, of extent 1
  std::vector<double> basis;  ///< the components, one after the other, of length one
  std::size_t components = 0;
  double usual = 0;  ///< RMS residual of a labelled face when it is left out of the learning
};

/// Nothing (no components, usual 0) where there are fewer than four pictures or points.
[[nodiscard]] FaceLayout learn_layout(std::span<const LabelledImage> images);

/// The points projected onto the layout, and their distance from it.
struct Laid {
  std::vector<PxPoint> points;
  double apart = 0;  ///< RMS, as a multiple of `usual`; 0 where there is no layout
};
[[nodiscard]] Laid lay(const FaceLayout& layout, std::span<const PxPoint> points);

/// As find_eigen_points, but searches outlying features again where the others suggest. The confidence also includes
/// how well all points fit together: it is below 0.2 where they are twice as far off as usual.
[[nodiscard]] base::Result<EigenFound> find_face(const EigenPoints& learned, const FaceLayout& layout,
                                                 const GreyImage& image, std::span<const PxPoint> shifts);

}  // namespace penpose::animation
