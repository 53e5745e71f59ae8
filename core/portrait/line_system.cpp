#include "core/portrait/line_system.h"

#include <algorithm>
#include <cmath>

#include "core/algebra/cholesky.h"
#include "core/algebra/vectors.h"

namespace penpose::portrait {
namespace {

/// The width of doubt of a point of a line, px of the face: neighbours stray alike, so it is more than a hand's.
constexpr double k_width = 2.85;
constexpr std::size_t k_place = 4;  ///< numbers of a placement
constexpr double k_unit_px = 100.0;

/// A line's columns of a placement: along, across, shift; reversed where it was drawn so.
std::array<Trace, k_place> placement_columns(const Trace& line, bool reversed) {
  std::array<Trace, k_place> out{};
  for (std::size_t i = 0; i < k_points; ++i) {
    const std::size_t k = reversed ? k_points - 1 - i : i;
    const double x = line[2 * k] / (k_unit_px * k_width), y = line[2 * k + 1] / (k_unit_px * k_width);
    out[0][2 * i] = -x;
    out[0][2 * i + 1] = -y;
    out[1][2 * i] = y;
    out[1][2 * i + 1] = -x;
    out[2][2 * i] = -1.0 / k_width;
    out[3][2 * i + 1] = -1.0 / k_width;
  }
  return out;
}

}  // namespace

LineSystem::LineSystem(const FaceView& face, std::span<const Trace> lines, double usual_proportion)
    : face_(face),
      lines_(lines),
      usual_proportion_(usual_proportion),
      controls_(face.controls().size()),
      proportions_(face.proportion_count()),
      size_(controls_ + proportions_ + 1),
      shares_(controls_, 0.0),
      blocks_(face.stretches().size()) {}

void LineSystem::bend(std::span<const double> shares) {
  if (std::equal(shares.begin(), shares.end(), shares_.begin(), shares_.end())) return;
  shares_.assign(shares.begin(), shares.end());
  blocks_.assign(blocks_.size(), std::nullopt);
}

std::vector<double> LineSystem::slid_of(const Block& block, const double* column) const {
  std::vector<double> out(k_slides);
  for (std::size_t s = 0; s < k_slides; ++s)
    out[s] = algebra::dot(block.slides.data() + s * k_numbers, column, k_numbers);
  algebra::solve_forward(block.factor.data(), k_slides, out.data());
  return out;
}

const LineSystem::Block& LineSystem::block(std::size_t number) {
  auto& kept = blocks_[number];
  if (kept) return *kept;
  kept.emplace();
  Block& b = *kept;
  const Stretch& stretch = face_.stretches()[number];
  Trace mean = stretch.rest;
  for (std::size_t j = 0; j < controls_; ++j) {
    if (shares_[j] == 0.0) continue;
    for (std::size_t i = 0; i < k_numbers; ++i) mean[i] += shares_[j] * stretch.ways[j][i];
  }
  for (const Trace& slide : slides_of(mean, stretch.whole(), stretch.to - stretch.from)) {
    for (const double v : slide) b.slides.push_back(v / k_width);
  }
  b.factor.assign(k_slides * k_slides, 0.0);
  for (std::size_t i = 0; i < k_slides; ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      b.factor[i * k_slides + k] =
          algebra::dot(b.slides.data() + i * k_numbers, b.slides.data() + k * k_numbers, k_numbers) +
          (i == k ? 1.0 : 0.0);
    }
  }
  (void)algebra::factor(b.factor.data(), k_slides);  // its diagonal is 1 and more
  const auto add = [&](const Trace& column) {
    for (const double v : column) b.columns.push_back(v / k_width);
  };
  for (const Trace& way : stretch.ways) add(way);
  for (const Trace& way : stretch.proportions) add(way);
  Trace rest = stretch.rest;
  if (stretch.curve < own_rest_.size() && own_rest_[stretch.curve]) {
    const auto& own = *own_rest_[stretch.curve];
    for (std::size_t i = 0; i < k_points; ++i) {
      const double share =
          stretch.from + (stretch.to - stretch.from) * static_cast<double>(i) / static_cast<double>(k_points - 1);
      const double x = share * static_cast<double>(own.size() - 1);
      const std::size_t k = std::min(static_cast<std::size_t>(x), own.size() - 2);
      const double f = x - static_cast<double>(k);
      const PxPoint p = own[k] * (1.0 - f) + own[k + 1] * f;
      rest[2 * i] = p.x;
      rest[2 * i + 1] = p.y;
    }
  }
  add(rest);
  for (std::size_t c = 0; c < size_; ++c) {
    const auto slid = slid_of(b, b.columns.data() + c * k_numbers);
    b.slid.insert(b.slid.end(), slid.begin(), slid.end());
  }
  b.gram.assign(size_ * size_, 0.0);
  for (std::size_t i = 0; i < size_; ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      b.gram[i * size_ + k] = b.gram[k * size_ + i] =
          algebra::dot(b.columns.data() + i * k_numbers, b.columns.data() + k * k_numbers, k_numbers) -
          algebra::dot_in_order(b.slid.data() + i * k_slides, b.slid.data() + k * k_slides, k_slides);
    }
  }
  return b;
}

SquaresOfDoubt LineSystem::squares(std::span<const Label> labels) {
  std::vector<double> gram(size_ * size_, 0.0);
  std::vector<double> places(k_place * size_, 0.0);  // of placement columns with all others
  std::array<double, k_place * k_place> own{};
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Block& b = block(labels[i].stretch);
    algebra::add_scaled(1.0, b.gram.data(), gram.data(), gram.size());
    const auto columns = placement_columns(lines_[i], labels[i].reversed);
    std::array<std::vector<double>, k_place> slid;
    for (std::size_t p = 0; p < k_place; ++p) {
      slid[p] = slid_of(b, columns[p].data());
      for (std::size_t c = 0; c < size_; ++c) {
        places[p * size_ + c] += algebra::dot(columns[p].data(), b.columns.data() + c * k_numbers, k_numbers) -
                                 algebra::dot_in_order(slid[p].data(), b.slid.data() + c * k_slides, k_slides);
      }
      for (std::size_t q = 0; q <= p; ++q) {
        own[p * k_place + q] += algebra::dot(columns[p].data(), columns[q].data(), k_numbers) -
                                algebra::dot_in_order(slid[p].data(), slid[q].data(), k_slides);
      }
    }
  }
  // Nuisances: proportions, then the placement.
  const std::size_t n = proportions_ + k_place;
  factor_.assign(n * n, 0.0);
  cross_.assign(n * (controls_ + 1), 0.0);
  const std::size_t rest = controls_ + proportions_;
  for (std::size_t i = 0; i < n; ++i) {
    const bool place = i >= proportions_;
    const double* row = place ? places.data() + (i - proportions_) * size_ : gram.data() + (controls_ + i) * size_;
    for (std::size_t k = 0; k <= i; ++k) {
      double v = 0;
      if (k < proportions_) {
        v = row[controls_ + k];
      } else {
        v = own[(i - proportions_) * k_place + (k - proportions_)];
      }
      factor_[i * n + k] = v;
    }
    factor_[i * n + i] += place ? 1e-9 : 1.0 / (usual_proportion_ * usual_proportion_);
    for (std::size_t j = 0; j < controls_; ++j) cross_[i * (controls_ + 1) + j] = row[j];
    cross_[i * (controls_ + 1) + controls_] = row[rest];
  }
  SquaresOfDoubt out;
  if (!algebra::factor(factor_.data(), n)) factor_.assign(n * n, 0.0);
  // L^-1 of the rows, for all columns at once.
  const std::size_t width = controls_ + 1;
  for (std::size_t i = 0; i < n; ++i) {
    double* const row = cross_.data() + i * width;
    for (std::size_t k = 0; k < i; ++k) algebra::add_scaled(-factor_[i * n + k], cross_.data() + k * width, row, width);
    const double scale = factor_[i * n + i] > 0.0 ? 1.0 / factor_[i * n + i] : 0.0;
    for (std::size_t j = 0; j < width; ++j) row[j] *= scale;
  }
  out.curvature.assign(controls_ * controls_, 0.0);
  out.pull.assign(controls_, 0.0);
  out.constant = gram[rest * size_ + rest];
  for (std::size_t j = 0; j < controls_; ++j) {
    std::copy_n(gram.data() + j * size_, controls_, out.curvature.data() + j * controls_);
    out.pull[j] = -gram[j * size_ + rest];
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double* const row = cross_.data() + i * width;
    for (std::size_t j = 0; j < controls_; ++j) {
      if (row[j] == 0.0) continue;
      algebra::add_scaled(-row[j], row, out.curvature.data() + j * controls_, controls_);
      out.pull[j] += row[j] * row[controls_];
    }
    out.constant -= row[controls_] * row[controls_];
  }
  return out;
}

LineSystem::Fitted LineSystem::fitted(std::span<const double> shares) const {
  const std::size_t n = proportions_ + k_place, width = controls_ + 1;
  std::vector<double> u(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double* const row = cross_.data() + i * width;
    u[i] = -row[controls_];
    for (std::size_t j = 0; j < controls_; ++j) u[i] -= row[j] * shares[j];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) u[i] -= factor_[k * n + i] * u[k];
    u[i] = factor_[i * n + i] > 0.0 ? u[i] / factor_[i * n + i] : 0.0;
  }
  Fitted out;
  out.proportions.assign(u.begin(), u.begin() + static_cast<std::ptrdiff_t>(proportions_));
  out.placement = {u[proportions_] / k_unit_px, u[proportions_ + 1] / k_unit_px,
                   PxPoint{u[proportions_ + 2], u[proportions_ + 3]}};
  return out;
}

}  // namespace penpose::portrait
