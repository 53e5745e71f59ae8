#include "core/animation/points/eigen_points.h"

#include <algorithm>
#include <cmath>

#include "core/algebra/symmetric_eigen.h"
#include "core/algebra/vectors.h"
#include "core/base/numbers.h"

namespace penpose::animation {
namespace {

/// Grey at a place between pixels; the border goes on outside.
double grey_at(const GreyImage& image, double x, double y) {
  x = std::clamp(x - 0.5, 0.0, static_cast<double>(image.width - 1));
  y = std::clamp(y - 0.5, 0.0, static_cast<double>(image.height - 1));
  const int x0 = std::min(static_cast<int>(x), std::max(0, image.width - 2));
  const int y0 = std::min(static_cast<int>(y), std::max(0, image.height - 2));
  const int x1 = std::min(x0 + 1, image.width - 1);
  const int y1 = std::min(y0 + 1, image.height - 1);
  const auto at = [&](int px, int py) {
    return static_cast<double>(image.pixels[static_cast<std::size_t>(py) * static_cast<std::size_t>(image.width) +
                                            static_cast<std::size_t>(px)]);
  };
  const double u = x - x0;
  const double v = y - y0;
  return (at(x0, y0) * (1 - u) + at(x1, y0) * u) * (1 - v) + (at(x0, y1) * (1 - u) + at(x1, y1) * u) * v;
}

/// The samples of a patch, each a mean over its cell, freed of mean, of the slope of the light across it and of
/// contrast, which is returned (RMS, grey levels).
double take_patch(const GreyImage& image, PxPoint corner, PxPoint size, std::size_t side, std::span<double> out) {
  const double cell_x = size.x / static_cast<double>(side);
  const double cell_y = size.y / static_cast<double>(side);
  const int nx = std::clamp(static_cast<int>(cell_x + 0.5), 1, 8);
  const int ny = std::clamp(static_cast<int>(cell_y + 0.5), 1, 8);
  double mean = 0;
  for (std::size_t j = 0; j < side; ++j) {
    for (std::size_t i = 0; i < side; ++i) {
      double sum = 0;
      for (int b = 0; b < ny; ++b) {
        for (int a = 0; a < nx; ++a) {
          sum += grey_at(image, corner.x + cell_x * (static_cast<double>(i) + (a + 0.5) / nx),
                         corner.y + cell_y * (static_cast<double>(j) + (b + 0.5) / ny));
        }
      }
      out[j * side + i] = sum / (nx * ny);
      mean += out[j * side + i];
    }
  }
  const double count = static_cast<double>(side * side);
  mean /= count;
  const double middle = 0.5 * static_cast<double>(side - 1);
  double slope_x = 0;
  double slope_y = 0;
  double square = 0;
  for (std::size_t j = 0; j < side; ++j) {
    for (std::size_t i = 0; i < side; ++i) {
      const double value = out[j * side + i] - mean;
      slope_x += value * (static_cast<double>(i) - middle);
      slope_y += value * (static_cast<double>(j) - middle);
      square += (static_cast<double>(i) - middle) * (static_cast<double>(i) - middle);
    }
  }
  slope_x /= square;
  slope_y /= square;
  double energy = 0;
  for (std::size_t j = 0; j < side; ++j) {
    for (std::size_t i = 0; i < side; ++i) {
      double& value = out[j * side + i];
      value -= mean + slope_x * (static_cast<double>(i) - middle) + slope_y * (static_cast<double>(j) - middle);
      energy += value * value;
    }
  }
  const double contrast = std::sqrt(energy / count);
  for (double& value : out.first(side * side)) value /= std::max(contrast, 1e-3);
  return contrast;
}

/// Inverse of a small symmetric matrix from its eigenvalues; directions that it does not know are left out.
std::vector<double> pseudo_inverse(const std::vector<double>& matrix, std::size_t n) {
  const algebra::SymmetricEigen eigen = algebra::symmetric_eigen(matrix, n);
  std::vector<double> inverse(n * n, 0.0);
  for (std::size_t e = 0; e < n; ++e) {
    if (!(eigen.values[e] > 1e-3 * eigen.values[0])) continue;
    const double* v = eigen.vectors.data() + e * n;
    for (std::size_t r = 0; r < n; ++r) {
      for (std::size_t c = 0; c < n; ++c) inverse[r * n + c] += v[r] * v[c] / eigen.values[e];
    }
  }
  return inverse;
}

base::Error wrong(const char* what, std::string place, const char* remedy = "label the pictures again") {
  return {what, std::move(place), remedy};
}

std::string place_of(const char* kind, const std::string& name, std::size_t number) {
  return std::string(kind) + " " + (name.empty() ? std::to_string(number) : name);
}

base::Result<EigenFeature> learn_feature(std::span<const LabelledImage> images, const std::vector<std::size_t>& points,
                                         const EigenOptions& options, const std::string& place) {
  EigenFeature feature;
  feature.points = points;
  PxPoint low{1e300, 1e300};
  PxPoint high{-1e300, -1e300};
  for (const LabelledImage& labelled : images) {
    for (const std::size_t i : points) {
      if (i >= labelled.points.size()) return wrong("it names a point that does not exist", place);
      low = {std::min(low.x, labelled.points[i].x), std::min(low.y, labelled.points[i].y)};
      high = {std::max(high.x, labelled.points[i].x), std::max(high.y, labelled.points[i].y)};
    }
  }
  const double extent = std::max(high.x - low.x, high.y - low.y);
  if (points.empty()) return wrong("it has no points", place, "name the curves that it is of");
  if (!(extent > 1e-6)) {
    return wrong("all its points lie at one place in every picture", place, "mark them along what is to be found");
  }
  if (!(extent < 1e6)) return wrong("it is over 1,000,000 px large", place, "give points in px of the pictures");
  const double border = options.margin * extent;
  feature.corner = low - PxPoint{border, border};
  feature.size = high - low + PxPoint{2 * border, 2 * border};

  const std::size_t samples = options.patch * options.patch;
  const std::size_t length = samples + 2 * points.size();
  const std::size_t n = images.size();
  std::vector<double> rows(n * length);
  for (std::size_t k = 0; k < n; ++k) {
    double* row = rows.data() + k * length;
    const double contrast = take_patch(images[k].image, feature.corner, feature.size, options.patch, {row, samples});
    feature.contrast += contrast / static_cast<double>(n);
    for (std::size_t i = 0; i < points.size(); ++i) {
      row[samples + 2 * i] = images[k].points[points[i]].x;
      row[samples + 2 * i + 1] = images[k].points[points[i]].y;
    }
  }
  feature.mean.assign(length, 0.0);
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < length; ++i) feature.mean[i] += rows[k * length + i] / static_cast<double>(n);
  }
  double of_samples = 0;
  double of_points = 0;
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < length; ++i) {
      double& value = rows[k * length + i];
      value -= feature.mean[i];
      (i < samples ? of_samples : of_points) += value * value;
    }
  }
  // Both kinds vary alike in all, so that neither drowns the other.
  feature.point_weight = of_points > 0 ? std::sqrt(of_samples / of_points) : 1.0;
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = samples; i < length; ++i) rows[k * length + i] *= feature.point_weight;
  }
  for (std::size_t i = samples; i < length; ++i) feature.mean[i] *= feature.point_weight;

  std::vector<double> products(n * n);
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = a; b < n; ++b) {
      products[a * n + b] = products[b * n + a] = algebra::dot_in_order(&rows[a * length], &rows[b * length], length);
    }
  }
  const algebra::SymmetricEigen eigen = algebra::symmetric_eigen(std::move(products), n);
  double all = 0;
  for (const double value : eigen.values) all += std::max(0.0, value);
  double kept = 0;
  for (std::size_t e = 0; e < n && feature.components < options.most_components; ++e) {
    if (!(eigen.values[e] > 1e-9 * eigen.values[0]) || kept >= options.kept * all) break;
    kept += eigen.values[e];
    ++feature.components;
    const double scale = 1.0 / std::sqrt(eigen.values[e]);
    const std::size_t begin = feature.basis.size();
    feature.basis.resize(begin + length, 0.0);
    for (std::size_t k = 0; k < n; ++k) {
      const double share = eigen.vectors[e * n + k] * scale;
      for (std::size_t i = 0; i < length; ++i) feature.basis[begin + i] += share * rows[k * length + i];
    }
  }
  const std::size_t m = feature.components;
  if (m == 0) {
    return wrong("its patch and its points are the same in all labelled pictures", place,
                 "label pictures in which the face does different things");
  }
  std::vector<double> on_patch(m * m);
  for (std::size_t a = 0; a < m; ++a) {
    for (std::size_t b = 0; b < m; ++b) {
      on_patch[a * m + b] = algebra::dot_in_order(&feature.basis[a * length], &feature.basis[b * length], samples);
    }
  }
  feature.solve = pseudo_inverse(on_patch, m);
  return feature;
}

/// A point may lie a little outside, where the picture cuts the face; far outside it was marked in another picture.
base::Status check_inside(const LabelledImage& labelled, std::size_t number, const LabelledFeature& feature,
                          std::size_t feature_number) {
  constexpr double k_outside = 0.25;  // of the picture's larger side
  const double width = labelled.image.width;
  const double height = labelled.image.height;
  const double margin = k_outside * std::max(width, height);
  for (std::size_t i = 0; i < feature.points.size(); ++i) {
    if (feature.points[i] >= labelled.points.size()) continue;  // learn_feature says so
    const PxPoint& p = labelled.points[feature.points[i]];
    if (p.x >= -margin && p.y >= -margin && p.x <= width + margin && p.y <= height + margin) continue;
    return base::Error{
        "point " + std::to_string(i) + " lies at " + base::format_fixed(p.x, 1) + ", " + base::format_fixed(p.y, 1) +
            " px, far outside the picture of " + std::to_string(labelled.image.width) + "x" +
            std::to_string(labelled.image.height) + " px",
        place_of("picture", labelled.name, number) + ", " + place_of("feature", feature.name, feature_number),
        "give points in px of the picture, from its upper left corner"};
  }
  return base::Done{};
}

struct Guess {
  std::vector<double> amounts;
  double left = 0;  ///< share of the patch that the components do not explain
};

Guess explain(const EigenFeature& feature, std::span<const double> patch, std::vector<double>& scratch) {
  const std::size_t samples = patch.size();
  const std::size_t length = feature.mean.size();
  const std::size_t m = feature.components;
  scratch.resize(samples);
  for (std::size_t i = 0; i < samples; ++i) scratch[i] = patch[i] - feature.mean[i];
  std::vector<double> seen(m);
  for (std::size_t a = 0; a < m; ++a)
    seen[a] = algebra::dot_in_order(&feature.basis[a * length], scratch.data(), samples);
  Guess guess;
  guess.amounts.assign(m, 0.0);
  for (std::size_t a = 0; a < m; ++a) {
    for (std::size_t b = 0; b < m; ++b) guess.amounts[a] += feature.solve[a * m + b] * seen[b];
  }
  for (std::size_t a = 0; a < m; ++a) {
    for (std::size_t i = 0; i < samples; ++i) scratch[i] -= guess.amounts[a] * feature.basis[a * length + i];
  }
  guess.left = algebra::dot_in_order(scratch.data(), scratch.data(), samples) / static_cast<double>(samples);
  return guess;
}

}  // namespace

base::Result<EigenPoints> learn_eigen_points(std::span<const LabelledImage> images,
                                             std::span<const LabelledFeature> features, const EigenOptions& options) {
  if (images.size() < 2) return wrong("at least two labelled pictures are needed", "", "label one more");
  // Learning takes a time that grows with the third power of the pictures.
  constexpr double k_most_steps = 2e8;
  const auto count = static_cast<double>(images.size());
  if (count * count * count * static_cast<double>(features.size()) > k_most_steps) {
    return base::Error{std::to_string(images.size()) + " labelled pictures are too many for " +
                           std::to_string(features.size()) + " features",
                       "", "label fewer pictures, those that differ most"};
  }
  for (std::size_t k = 0; k < images.size(); ++k) {
    const LabelledImage& one = images[k];
    const std::string place = place_of("picture", one.name, k);
    if (one.image.width < 2 || one.image.height < 2 || one.image.width != images[0].image.width ||
        one.image.height != images[0].image.height ||
        one.image.pixels.size() !=
            static_cast<std::size_t>(one.image.width) * static_cast<std::size_t>(one.image.height)) {
      return wrong("the pictures are not of one size", place);
    }
    if (one.points.size() != images[0].points.size()) return wrong("the pictures have other numbers of points", place);
    for (const PxPoint& p : one.points) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) return wrong("a point is no number", place);
    }
  }
  EigenPoints learned;
  learned.patch = std::clamp<std::size_t>(options.patch, 4, 128);
  learned.search_px = std::clamp(options.search_px, 0, 50);
  learned.point_count = images[0].points.size();
  EigenOptions usable = options;
  usable.patch = learned.patch;
  for (std::size_t i = 0; i < features.size(); ++i) {
    for (std::size_t k = 0; k < images.size(); ++k) {
      if (auto inside = check_inside(images[k], k, features[i], i); !inside) return inside.error();
    }
    auto feature = learn_feature(images, features[i].points, usable, place_of("feature", features[i].name, i));
    if (!feature) return feature.error();
    learned.features.push_back(std::move(feature).value());
  }
  if (learned.features.empty()) return wrong("there is no feature", "");
  return learned;
}

std::vector<PxPoint> shifts_for(const EigenPoints& learned, std::span<const PxPoint> points) {
  std::vector<PxPoint> shifts;
  const std::size_t samples = learned.patch * learned.patch;
  for (const EigenFeature& feature : learned.features) {
    PxPoint shift;
    const double share = 1.0 / static_cast<double>(feature.points.size());
    for (std::size_t i = 0; i < feature.points.size(); ++i) {
      const PxPoint usual{feature.mean[samples + 2 * i] / feature.point_weight,
                          feature.mean[samples + 2 * i + 1] / feature.point_weight};
      shift = shift + (points[feature.points[i]] - usual) * share;
    }
    shifts.push_back(shift);
  }
  return shifts;
}

base::Result<EigenFound> find_eigen_points(const EigenPoints& learned, const GreyImage& image,
                                           std::span<const PxPoint> shifts) {
  const auto pixels =
      static_cast<std::size_t>(std::max(0, image.width)) * static_cast<std::size_t>(std::max(0, image.height));
  if (image.width < 2 || image.height < 2 || image.pixels.size() != pixels) return wrong("the picture is empty", "");
  EigenFound found;
  found.points.resize(learned.point_count);
  constexpr double k_flat = 0.05;  // of the contrast that was learned
  const std::size_t samples = learned.patch * learned.patch;
  std::vector<double> patch(samples);
  std::vector<double> scratch;
  double left = 0;
  for (std::size_t f = 0; f < learned.features.size(); ++f) {
    const EigenFeature& feature = learned.features[f];
    const PxPoint start = f < shifts.size() ? shifts[f] : PxPoint{};
    PxPoint best_shift;
    Guess best;
    for (int dy = -learned.search_px; dy <= learned.search_px; ++dy) {
      for (int dx = -learned.search_px; dx <= learned.search_px; ++dx) {
        const PxPoint shift = start + PxPoint{static_cast<double>(dx), static_cast<double>(dy)};
        const double contrast = take_patch(image, feature.corner + shift, feature.size, learned.patch, patch);
        Guess guess = explain(feature, patch, scratch);
        // A black or flat patch shows nothing, however near it is to the mean.
        if (contrast <= k_flat * feature.contrast) guess.left = std::max(guess.left, 1.0);
        // A feature that stands still should not wander for a little better explanation.
        guess.left *= 1.0 + 0.01 * (dx * dx + dy * dy);
        if (best.amounts.empty() || guess.left < best.left) {
          best = std::move(guess);
          best_shift = shift;
        }
      }
    }
    const std::size_t length = feature.mean.size();
    for (std::size_t i = 0; i < feature.points.size(); ++i) {
      double x = feature.mean[samples + 2 * i];
      double y = feature.mean[samples + 2 * i + 1];
      for (std::size_t a = 0; a < feature.components; ++a) {
        x += best.amounts[a] * feature.basis[a * length + samples + 2 * i];
        y += best.amounts[a] * feature.basis[a * length + samples + 2 * i + 1];
      }
      found.points[feature.points[i]] = PxPoint{x, y} * (1.0 / feature.point_weight) + best_shift;
    }
    found.shifts.push_back(best_shift);
    left += best.left;
  }
  found.confidence = std::clamp(1.0 - left / static_cast<double>(learned.features.size()), 0.0, 1.0);
  return found;
}

}  // namespace penpose::animation
