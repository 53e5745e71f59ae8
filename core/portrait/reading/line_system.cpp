#include "core/portrait/reading/line_system.h"

#include <algorithm>
#include <cmath>

#include "core/algebra/cholesky.h"
#include "core/algebra/vectors.h"

namespace penpose::portrait {
namespace {

/// The width of doubt of a point of a line, px of the face: neighbours stray alike, so it is more than a hand's.
constexpr double k_width = 2.7;
constexpr std::size_t k_place = 4;  ///< numbers of a placement
constexpr double k_unit_px = 100.0;
/// How far a placement is from its first guess: scale and turn, and shift in px.
constexpr double k_scale_doubt = 0.12;
constexpr double k_shift_doubt = 40.0;
/// What is drawn over a face leaves what is not drawn within so many px.
constexpr double k_hold = 12.0;

/// What a placement does to a curve: larger, turned, shifted.
std::array<Trace, k_place> placement_columns(const Trace& curve) {
  std::array<Trace, k_place> out{};
  for (std::size_t i = 0; i < k_points; ++i) {
    const double x = curve[2 * i] / k_unit_px, y = curve[2 * i + 1] / k_unit_px;
    out[0][2 * i] = x;
    out[0][2 * i + 1] = y;
    out[1][2 * i] = -y;
    out[1][2 * i + 1] = x;
    out[2][2 * i] = 1.0;
    out[3][2 * i + 1] = 1.0;
  }
  return out;
}

}  // namespace

LineSystem::LineSystem(const FaceView& face, const Stretches& stretches, std::span<const Trace> lines, const Hand& hand)
    : face_(face),
      stretches_(stretches),
      lines_(lines),
      hand_(hand),
      controls_(face.controls().size()),
      proportions_(face.proportion_count()),
      size_(controls_ + proportions_ + k_place),
      blocks_(stretches.size()) {}

double LineSystem::width() const { return k_width * hand_.width; }

void LineSystem::bend(std::span<const double> shares, std::span<const double> proportions) {
  std::vector<double> bent(shares.begin(), shares.end());
  bent.insert(bent.end(), proportions.begin(), proportions.end());
  if (bent == bent_) return;
  bent_ = std::move(bent);
  for (Block& one : blocks_) one.bent = false;
}

void LineSystem::slide(const Block& block, const double* column, double* out) const {
  for (std::size_t s = 0; s < slides_; ++s)
    out[s] = algebra::dot(block.slides.data() + s * k_numbers, column, k_numbers);
  algebra::solve_forward(block.factor.data(), slides_, out);
}

std::vector<double> LineSystem::slid_of(const Block& block, const double* column) const {
  std::vector<double> out(slides_);
  slide(block, column, out.data());
  return out;
}

const LineSystem::Block& LineSystem::block(std::size_t number) {
  if (blocks_.size() < stretches_.size()) blocks_.resize(stretches_.size());
  Block& b = blocks_[number];
  if (b.bent) return b;
  b.bent = true;
  b.nuisances.clear();
  const Stretch& stretch = stretches_[number];
  const double wide = width();
  Trace mean = stretch.rest;
  for (std::size_t k = 0; k < bent_.size(); ++k) {
    if (bent_[k] == 0.0) continue;
    const Trace& way = k < controls_ ? stretch.ways[k] : stretch.proportions[k - controls_];
    algebra::add_scaled(bent_[k], way.data(), mean.data(), k_numbers);
  }
  const auto slides = slides_of(mean, stretch);
  slides_ = slides.size();
  b.slides.clear();
  for (const Trace& slide : slides) {
    for (const double v : slide) b.slides.push_back(v / wide);
  }
  b.factor.assign(slides_ * slides_, 0.0);
  for (std::size_t i = 0; i < slides_; ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      b.factor[i * slides_ + k] =
          algebra::dot(b.slides.data() + i * k_numbers, b.slides.data() + k * k_numbers, k_numbers) +
          (i == k ? 1.0 : 0.0);
    }
  }
  (void)algebra::factor(b.factor.data(), slides_);  // its diagonal is 1 and more
  const auto add = [&](const Trace& column) {
    for (const double v : column) b.columns.push_back(v / wide);
  };
  if (b.columns.empty()) {
    for (const Trace& way : stretch.ways) add(way);
    for (std::size_t p = 0; p < proportions_; ++p) add(stretch.proportions[p]);
  }
  b.columns.resize((controls_ + proportions_) * k_numbers);
  for (const Trace& way : placement_columns(mean)) add(way);
  b.slid.resize(size_ * slides_);
  for (std::size_t c = 0; c < size_; ++c) slide(b, b.columns.data() + c * k_numbers, b.slid.data() + c * slides_);
  return b;
}

const LineSystem::Block& LineSystem::block_of_line(std::size_t number) {
  static_cast<void>(block(number));
  Block& b = blocks_[number];
  if (!b.nuisances.empty()) return b;
  const std::size_t n = proportions_ + k_place;
  b.nuisances.resize(n * size_);
  for (std::size_t i = 0; i < n; ++i) {
    const double* const column = b.columns.data() + (controls_ + i) * k_numbers;
    const double* const slid = b.slid.data() + (controls_ + i) * slides_;
    for (std::size_t k = 0; k < size_; ++k) {
      b.nuisances[i * size_ + k] = algebra::dot(column, b.columns.data() + k * k_numbers, k_numbers) -
                                   algebra::dot_in_order(slid, b.slid.data() + k * slides_, slides_);
    }
  }
  return b;
}

Trace LineSystem::off(std::size_t line, std::size_t stretch, bool reversed) const {
  const Trace there = guess_(lines_[line]);
  const Trace& rest = stretches_[stretch].rest;
  const double wide = width();
  Trace out{};
  for (std::size_t i = 0; i < k_points; ++i) {
    const std::size_t k = reversed ? k_points - 1 - i : i;
    out[2 * i] = (rest[2 * i] - there[2 * k]) / wide;
    out[2 * i + 1] = (rest[2 * i + 1] - there[2 * k + 1]) / wide;
  }
  return out;
}

void LineSystem::hold_undrawn(std::span<const Label> labels, SquaresOfDoubt& squares) {
  // A mouth takes the jaw along, and one line of a part the others.
  std::vector<Part> goes;
  for (const Label& label : labels) {
    if (label.stretch != k_nothing) goes.push_back(face_.part(stretches_[label.stretch].curve));
  }
  const auto is_drawn = [&](Part part) { return std::find(goes.begin(), goes.end(), part) != goes.end(); };
  if (is_drawn(Part::mouth)) goes.push_back(Part::jaw);
  for (std::size_t c = 0; c < face_.curve_count(); ++c) {
    if (is_drawn(face_.part(c))) continue;
    const std::size_t whole = c * FaceView::stretches_per_curve();
    const Block& b = block(whole);
    squares.parts.push_back({b.columns.data(), b.slid.data(), width() * width() / (k_hold * k_hold)});
  }
}

SquaresOfDoubt LineSystem::squares(std::span<const Label> labels, std::span<const double> weights) {
  // Nuisances: proportions, then the placement.
  const std::size_t n = proportions_ + k_place;
  std::vector<double> nuisances(n * size_, 0.0), rest(size_, 0.0);
  SquaresOfDoubt out;
  const auto add = [&](std::size_t line, std::size_t stretch, bool reversed, double weight) {
    const Block& b = block_of_line(stretch);
    out.parts.push_back({b.columns.data(), b.slid.data(), weight});
    algebra::add_scaled(weight, b.nuisances.data(), nuisances.data(), nuisances.size());
    const Trace off = this->off(line, stretch, reversed);
    const auto slid = slid_of(b, off.data());
    for (std::size_t c = 0; c < size_; ++c) {
      rest[c] += weight * (algebra::dot(off.data(), b.columns.data() + c * k_numbers, k_numbers) -
                           algebra::dot_in_order(slid.data(), b.slid.data() + c * slides_, slides_));
    }
    out.constant += weight * (algebra::dot(off.data(), off.data(), k_numbers) -
                              algebra::dot_in_order(slid.data(), slid.data(), slides_));
  };
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Label& label = labels[i];
    if (label.stretch == k_nothing) continue;
    const double weight = weights.empty() ? 1.0 : weights[i];
    const bool twice = label.also != k_nothing;
    add(i, label.stretch, label.reversed, twice ? 0.5 * weight : weight);
    if (twice) add(i, label.also, label.reversed, 0.5 * weight);
  }
  if (hand_.over) hold_undrawn(labels, out);
  out.slides = slides_;
  factor_.assign(n * n, 0.0);
  cross_.assign(n * (controls_ + 1), 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const double* row = nuisances.data() + i * size_;
    std::copy_n(row + controls_, i + 1, factor_.data() + i * n);
    const double usual = i < proportions_       ? hand_.proportion
                         : i < proportions_ + 2 ? k_scale_doubt * k_unit_px
                                                : k_shift_doubt;
    factor_[i * n + i] += 1.0 / (usual * usual * doubt_ * doubt_);
    std::copy_n(row, controls_, cross_.data() + i * (controls_ + 1));
    cross_[i * (controls_ + 1) + controls_] = rest[controls_ + i];
  }
  if (!algebra::factor(factor_.data(), n)) factor_.assign(n * n, 0.0);
  // L^-1 of the rows, for all columns at once.
  const std::size_t width = controls_ + 1;
  for (std::size_t i = 0; i < n; ++i) {
    double* const row = cross_.data() + i * width;
    for (std::size_t k = 0; k < i; ++k) algebra::add_scaled(-factor_[i * n + k], cross_.data() + k * width, row, width);
    const double scale = factor_[i * n + i] > 0.0 ? 1.0 / factor_[i * n + i] : 0.0;
    for (std::size_t j = 0; j < width; ++j) row[j] *= scale;
  }
  out.pull.assign(controls_, 0.0);
  for (std::size_t j = 0; j < controls_; ++j) out.pull[j] = -rest[j];
  for (std::size_t i = 0; i < n; ++i) {
    const double* const row = cross_.data() + i * width;
    for (std::size_t j = 0; j < controls_; ++j) out.pull[j] += row[j] * row[controls_];
    out.constant -= row[controls_] * row[controls_];
  }
  out.nuisances = cross_;
  out.width = width;
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
  std::copy_n(u.begin() + static_cast<std::ptrdiff_t>(proportions_), k_place, out.change.begin());
  // The curves became larger, turned and shifted to meet the lines; the lines, then, the other way.
  const double along = 1.0 + out.change[0] / k_unit_px, across = out.change[1] / k_unit_px;
  const double square = along * along + across * across;
  const auto back = [&](double x, double y) {
    return PxPoint{(x * along + y * across) / square, (y * along - x * across) / square};
  };
  const PxPoint turned = back(guess_.along, guess_.across);
  out.placement = {turned.x, turned.y, back(guess_.shift.x - out.change[2], guess_.shift.y - out.change[3])};
  return out;
}

std::vector<double> LineSystem::left(std::span<const Label> labels, std::span<const double> shares,
                                     const Fitted& fitted) {
  std::vector<double> factors(shares.begin(), shares.end());
  factors.insert(factors.end(), fitted.proportions.begin(), fitted.proportions.end());
  factors.insert(factors.end(), fitted.change.begin(), fitted.change.end());
  const auto squares_at = [&](std::size_t line, std::size_t stretch, bool reversed) {
    const Block& b = block(stretch);
    Trace off = this->off(line, stretch, reversed);
    for (std::size_t c = 0; c < size_; ++c) {
      if (factors[c] != 0.0) algebra::add_scaled(factors[c], b.columns.data() + c * k_numbers, off.data(), k_numbers);
    }
    const auto slid = slid_of(b, off.data());
    return algebra::dot(off.data(), off.data(), k_numbers) - algebra::dot_in_order(slid.data(), slid.data(), slides_);
  };
  std::vector<double> out(labels.size(), 0.0);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Label& label = labels[i];
    if (label.stretch == k_nothing) continue;
    out[i] = squares_at(i, label.stretch, label.reversed);
    if (label.also != k_nothing) out[i] = 0.5 * (out[i] + squares_at(i, label.also, label.reversed));
  }
  return out;
}

}  // namespace penpose::portrait
