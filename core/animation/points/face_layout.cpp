#include "core/animation/points/face_layout.h"

#include <algorithm>
#include <cmath>

#include "core/algebra/symmetric_eigen.h"
#include "core/animation/signal/statistics.h"

namespace penpose::animation {
namespace {

using Row = std::vector<double>;

Row row_of(std::span<const PxPoint> points) {
  Row row;
  for (const PxPoint& p : points) {
    row.push_back(p.x);
    row.push_back(p.y);
  }
  return row;
}

/// factor * p + shift, with points as complex numbers.
struct Similarity {
  double real = 1, imaginary = 0, x = 0, y = 0;

  [[nodiscard]] Row of(const Row& row) const {
    Row out(row.size());
    for (std::size_t i = 0; i + 1 < row.size(); i += 2) {
      out[i] = real * row[i] - imaginary * row[i + 1] + x;
      out[i + 1] = imaginary * row[i] + real * row[i + 1] + y;
    }
    return out;
  }
};

/// The similarity that best carries one row of points to another.
Similarity between(const Row& from, const Row& to) {
  const double n = static_cast<double>(from.size()) / 2;
  double fx = 0, fy = 0, tx = 0, ty = 0;
  for (std::size_t i = 0; i + 1 < from.size(); i += 2) {
    fx += from[i] / n;
    fy += from[i + 1] / n;
    tx += to[i] / n;
    ty += to[i + 1] / n;
  }
  double real = 0, imaginary = 0, square = 0;
  for (std::size_t i = 0; i + 1 < from.size(); i += 2) {
    const double ax = from[i] - fx, ay = from[i + 1] - fy, bx = to[i] - tx, by = to[i + 1] - ty;
    real += ax * bx + ay * by;
    imaginary += ax * by - ay * bx;
    square += ax * ax + ay * ay;
  }
  Similarity s;
  if (square > 0) s = {real / square, imaginary / square, 0, 0};
  s.x = tx - (s.real * fx - s.imaginary * fy);
  s.y = ty - (s.imaginary * fx + s.real * fy);
  return s;
}

double rms(const Row& row) {
  double sum = 0;
  for (const double one : row) sum += one * one;
  return std::sqrt(2 * sum / static_cast<double>(row.size()));
}

Row centred(Row row) {
  double x = 0, y = 0;
  const double n = static_cast<double>(row.size()) / 2;
  for (std::size_t i = 0; i + 1 < row.size(); i += 2) {
    x += row[i] / n;
    y += row[i + 1] / n;
  }
  for (std::size_t i = 0; i + 1 < row.size(); i += 2) {
    row[i] -= x;
    row[i + 1] -= y;
  }
  const double extent = rms(row);
  for (double& one : row) one /= extent > 0 ? extent : 1.0;
  return row;
}

FaceLayout learn_rows(const std::vector<Row>& rows) {
  constexpr double k_kept = 0.98;
  FaceLayout layout;
  layout.mean = centred(rows[0]);
  std::vector<Row> aligned(rows.size());
  for (int round = 0; round < 3; ++round) {
    Row mean(rows[0].size(), 0.0);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      aligned[k] = between(rows[k], layout.mean).of(rows[k]);
      for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += aligned[k][i] / static_cast<double>(rows.size());
    }
    layout.mean = centred(std::move(mean));
  }
  for (Row& row : aligned) {
    for (std::size_t i = 0; i < row.size(); ++i) row[i] -= layout.mean[i];
  }
  // There are fewer pictures than numbers: by their products with one another.
  const std::size_t n = rows.size();
  std::vector<double> products(n * n, 0.0);
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      for (std::size_t i = 0; i < aligned[a].size(); ++i) products[a * n + b] += aligned[a][i] * aligned[b][i];
    }
  }
  const algebra::SymmetricEigen eigen = algebra::symmetric_eigen(std::move(products), n);
  double all = 0;
  for (const double value : eigen.values) all += std::max(value, 0.0);
  double kept = 0;
  for (std::size_t e = 0; e + 1 < n && kept < k_kept * all && eigen.values[e] > 1e-9 * all; ++e) {
    Row axis(layout.mean.size(), 0.0);
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t i = 0; i < axis.size(); ++i) {
        axis[i] += eigen.vectors[e * n + k] * aligned[k][i] / std::sqrt(eigen.values[e]);
      }
    }
    layout.basis.insert(layout.basis.end(), axis.begin(), axis.end());
    ++layout.components;
    kept += eigen.values[e];
  }
  return layout;
}

/// The points as the layout would have them, in its own frame; and what is left.
struct Projected {
  Row fitted;
  double left = 0;
};
Projected project(const FaceLayout& layout, const Row& row, const Similarity& similarity) {
  Row away = similarity.of(row);
  for (std::size_t i = 0; i < away.size(); ++i) away[i] -= layout.mean[i];
  Projected result{layout.mean, 0};
  for (std::size_t e = 0; e < layout.components; ++e) {
    const double* axis = &layout.basis[e * away.size()];
    double along = 0;
    for (std::size_t i = 0; i < away.size(); ++i) along += axis[i] * away[i];
    for (std::size_t i = 0; i < away.size(); ++i) {
      result.fitted[i] += along * axis[i];
      away[i] -= along * axis[i];
    }
  }
  result.left = rms(away);
  return result;
}

}  // namespace

FaceLayout learn_layout(std::span<const LabelledImage> images) {
  constexpr std::size_t k_least = 4;
  constexpr std::size_t k_most = 200;  // pictures; more say little more, and every one is left out once
  std::vector<Row> rows;
  for (std::size_t k = 0; k < images.size() && rows.size() < k_most; k += images.size() / k_most + 1) {
    rows.push_back(row_of(images[k].points));
  }
  if (rows.size() < k_least || rows[0].size() < 2 * k_least) return {};
  std::vector<double> left;
  const std::size_t stride = rows.size() / 32 + 1;
  for (std::size_t out = 0; out < rows.size(); out += stride) {
    std::vector<Row> others;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      if (k != out) others.push_back(rows[k]);
    }
    const FaceLayout without = learn_rows(others);
    left.push_back(project(without, rows[out], between(rows[out], without.mean)).left);
  }
  FaceLayout layout = learn_rows(rows);
  constexpr double k_least_left = 0.005;  // of the extent: nobody labels finer
  layout.usual = std::max(quantile(left, 0.75), k_least_left);
  return layout;
}

Laid lay(const FaceLayout& layout, std::span<const PxPoint> points) {
  Laid laid{{points.begin(), points.end()}, 0};
  if (!(layout.usual > 0) || layout.mean.size() != 2 * points.size()) return laid;
  const Row row = row_of(points);
  const Projected projected = project(layout, row, between(row, layout.mean));
  const Row fitted = between(layout.mean, row).of(projected.fitted);
  for (std::size_t i = 0; i < points.size(); ++i) laid.points[i] = {fitted[2 * i], fitted[2 * i + 1]};
  laid.apart = projected.left / layout.usual;
  return laid;
}

base::Result<EigenFound> find_face(const EigenPoints& learned, const FaceLayout& layout, const GreyImage& image,
                                   std::span<const PxPoint> shifts) {
  constexpr double k_poor = 2;
  auto found = find_eigen_points(learned, image, shifts);
  if (!found) return found;
  Laid laid = lay(layout, found->points);
  for (int again = 0; again < 2 && laid.apart > 1; ++again) {
    const std::vector<PxPoint> from = shifts_for(learned, laid.points);
    auto other = find_eigen_points(learned, image, from);
    if (!other) return other;
    Laid laid_other = lay(layout, other->points);
    if (!(laid_other.apart < laid.apart)) break;
    found = std::move(other);
    laid = std::move(laid_other);
  }
  if (laid.apart > k_poor) found->shifts = shifts_for(learned, laid.points);
  const double beyond = std::max(0.0, laid.apart - 1);
  found->confidence /= 1 + 4.5 * beyond * beyond;
  return found;
}

}  // namespace penpose::animation
