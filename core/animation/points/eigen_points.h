#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/space.h"

namespace penpose::animation {

using geometry::PxPoint;

/// A picture in shades of grey: rows from the top, one byte a pixel.
struct GreyImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
};

/// A picture with marked points.
struct LabelledImage {
  GreyImage image;
  std::vector<PxPoint> points;
  std::string name = {};  ///< for errors; may be empty
};

/// Points that are found from one patch.
struct LabelledFeature {
  std::string name;  ///< for errors; may be empty
  std::vector<std::size_t> points;
};

struct EigenOptions {
  std::size_t patch = 24;  ///< side of a feature's grey patch, samples
  double margin = 0.35;    ///< of the patch around the feature's points, share of their extent
  double kept = 0.995;     ///< share of the variance that the principal components keep
  std::size_t most_components = 24;
  int search_px = 3;  ///< how far a feature may have moved between pictures
};

/// A feature: points that are found from one patch, such as those of the mouth.
struct EigenFeature {
  std::vector<std::size_t> points;
  PxPoint corner;  ///< of the patch in the labelled pictures
  PxPoint size;
  std::vector<double> mean;   ///< of the patch's samples, then of the points' x and y (weighted)
  std::vector<double> basis;  ///< the components, one after the other, each as long as the mean
  std::size_t components = 0;
  std::vector<double> solve;  ///< inverse of the components' products on the patch alone, components squared
  double contrast = 0;        ///< mean RMS of the labelled patches, grey levels
  double point_weight = 1;    ///< weight of points relative to samples
};

/// The linear map from grey patches to point positions that Covell and Bregler learn ("Eigen-points", 1996): principal
/// components of patch and points together; given the patch alone, least squares finds the components' amounts, which
/// give the points.
struct EigenPoints {
  std::size_t patch = 0;
  int search_px = 0;
  std::size_t point_count = 0;
  std::vector<EigenFeature> features;
};

/// Learns from labelled pictures. Patches are normalised to zero mean and equal contrast, so
/// that brighter or darker pictures count the same. Errors: fewer than two pictures, pictures of other sizes or numbers
/// of points than the first, a feature without extent, points that do not exist or are far outside their picture,
/// pictures that are all the same. Their place is the name or number of the picture or feature.
[[nodiscard]] base::Result<EigenPoints> learn_eigen_points(std::span<const LabelledImage> images,
                                                           std::span<const LabelledFeature> features,
                                                           const EigenOptions& options = {});

/// The shift of a feature's patch that centres it on these points.
[[nodiscard]] std::vector<PxPoint> shifts_for(const EigenPoints& learned, std::span<const PxPoint> points);

/// The points found in one picture.
struct EigenFound {
  std::vector<PxPoint> points;
  std::vector<PxPoint> shifts;  ///< one a feature: the shift of its patch, to start the next picture from
  double confidence = 0;        ///< 0..1: how much of the patches the components explain; 0 where all are flat
};

/// Finds the points. Searches each feature's patch within search_px of `shifts` (empty: of where it was learned) for
/// the place that the components explain best. Errors: a picture that is empty.
[[nodiscard]] base::Result<EigenFound> find_eigen_points(const EigenPoints& learned, const GreyImage& image,
                                                         std::span<const PxPoint> shifts);

}  // namespace penpose::animation
