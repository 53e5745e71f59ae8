#include "core/intent/line/sliding.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/math.h"
#include "core/curve/pairing.h"
#include "core/curve/polyline.h"

namespace penpose::intent {

using inference::Term;

namespace {

/// Lines that tell a shape lie beside where they were meant by this share of their length (root mean square).
constexpr double k_offset = 0.07;
/// Both ends of a line are places of the face, a corner of the mouth or of an eye: they say this much more than what
/// lies between, over a tenth of the length each.
constexpr double k_ends = 2.0;

PxPoint direction(PxPoint v) {
  const double length = geometry::distance(v, {});
  return length > 0.0 ? v * (1.0 / length) : PxPoint{1, 0};
}

/// `size`: px, root mean square.
Modes modes_at(double share, double size, bool closed) {
  if (closed) {
    const double a = 2.0 * base::k_pi * share;
    return {size * 0.7,
            size * base::sin(a),
            size * base::cos(a),
            size * 0.5 * base::sin(2.0 * a),
            size * 0.5 * base::cos(2.0 * a),
            0.0};
  }
  // Sines of the single to the fourfold angle.
  const double s1 = base::sin(base::k_pi * share);
  const double s2 = 2.0 * s1 * base::cos(base::k_pi * share);
  const double s3 = s1 * (3.0 - 4.0 * s1 * s1);
  const double s4 = 2.0 * s2 * (1.0 - 2.0 * s1 * s1);
  return {size * (1.0 - share), size * share, size * s1, size / 2.0 * s2, size / 3.0 * s3, size / 4.0 * s4};
}

/// The share of the reference's length that each point stands for: half of both segments that it ends.
std::vector<double> stretches(std::span<const double> along) {
  const std::size_t n = along.size();
  std::vector<double> share(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double before = i > 0 ? along[i] - along[i - 1] : 0.0;
    const double after = i + 1 < n ? along[i + 1] - along[i] : 0.0;
    share[i] = 0.5 * (before + after) / along.back();
  }
  return share;
}

}  // namespace

SlidingLine::SlidingLine(std::span<const PxPoint> line)
    : line_(line.begin(), line.end()), lengths_(curve::cumulative_length<PxPoint>(line_)) {}

PxPoint SlidingLine::point(double along) const {
  const auto at = curve::place_at(lengths_, std::clamp(along / length(), 0.0, 1.0));
  return line_[at.segment] * (1.0 - at.fraction) + line_[at.segment + 1] * at.fraction;
}

SlidingLine::Place SlidingLine::place(double along, const Alignment& alignment) const {
  const double whole = length();
  const double reach = 0.02 * whole;  // a hand's tangent, not one segment's
  if (alignment.closed) {
    const auto around = [&](double s) { return s - whole * std::floor(s / whole); };
    const PxPoint ahead = point(around(along + reach)) - point(around(along - reach));
    return {point(around(along)), direction(ahead)};
  }
  const double inside = std::clamp(along, 0.0, whole);
  const PxPoint ahead =
      point(std::clamp(along + reach, reach, whole)) - point(std::clamp(along - reach, 0.0, whole - reach));
  const PxPoint tangent = direction(ahead);
  return {point(inside) + tangent * (along - inside), tangent};
}

Matching SlidingLine::match(std::span<const PxPoint> seen, const Alignment& alignment, bool slide, double doubt) const {
  const std::size_t n = seen.size();
  const std::vector<double> along = curve::cumulative_length<PxPoint>(seen);
  const double reference = std::max(along.back(), 1e-9);
  Matching m;
  m.target.resize(n);
  m.tangent.resize(n);
  m.weight = along.back() > 0.0 ? stretches(along) : std::vector<double>(n, 1.0 / static_cast<double>(n));
  m.slid.assign(n, 0.0);
  m.along.resize(n);
  m.modes.resize(n);
  std::vector<double> equal(n);  // the place of equal arc length
  const double span = alignment.reference_to - alignment.reference_from;
  const bool offset = alignment.offset_px > 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    double share = along.back() > 0.0 ? along[i] / reference : static_cast<double>(i) / static_cast<double>(n - 1);
    // Points just outside belong to the drawn part's end as much as those just inside.
    if (share < alignment.reference_from - 0.01 || share > alignment.reference_to + 0.01) m.weight[i] = 0.0;
    share = (share - alignment.reference_from) / span;
    const double to = alignment.line_from + share * (alignment.line_to - alignment.line_from) + alignment.turned;
    equal[i] = length() * (alignment.reversed ? 1.0 - to : to);
    m.modes[i] =
        modes_at(share, alignment.slide * length() * (alignment.line_to - alignment.line_from), alignment.closed);
    if (!alignment.closed) {
      for (std::size_t end = 0; end < 2; ++end) m.modes[i][end] *= alignment.ends_slide[end];
    }
    if (offset) m.modes[i].back() = 0.0;
    if (alignment.ends > 0.0)
      m.weight[i] *= 1.0 + alignment.ends * std::max(0.0, (std::abs(2.0 * share - 1.0) - 0.8) / 0.2);
  }
  Modes at{};
  for (int round = 0; round < 3; ++round) {
    for (std::size_t i = 0; i < n; ++i) {
      m.slid[i] = times(m.modes[i], at);
      const Place p = place(equal[i] + m.slid[i], alignment);
      m.target[i] = p.at;
      m.tangent[i] = p.tangent;
      m.along[i] = equal[i] + m.slid[i];
    }
    if (!slide || round == 2) break;
    ModeMatrix matrix{};
    Modes right{};
    for (std::size_t i = 0; i < n; ++i) {
      const double w = m.weight[i] * k_looks / (doubt * doubt);
      const double left = dot(seen[i] - m.target[i], m.tangent[i]) + m.slid[i];
      for (std::size_t a = 0; a < k_modes; ++a) right[a] += w * m.modes[i][a] * left;
      grow(matrix, m.modes[i], w);
    }
    at = solve_modes(matrix, right);
    // The order along the line stays: no point slides past its neighbour.
    double scale = 1.0;
    for (std::size_t i = 0; i + 1 < n; ++i) {
      const double gap = std::abs(equal[i + 1] - equal[i]);
      const double closer = std::abs(times(m.modes[i + 1], at) - times(m.modes[i], at));
      if (closer > 0.9 * gap && closer > 0.0) scale = std::min(scale, 0.9 * gap / closer);
    }
    for (double& a : at) a *= scale;
  }
  if (offset) {
    const PxPoint chord = direction(line_.back() - line_.front());
    m.across.resize(n);
    for (std::size_t i = 0; i < n; ++i) m.across[i] = alignment.offset_px * dot(chord, m.tangent[i]);
  }
  return m;
}

std::vector<Alignment> alignments(std::span<const PxPoint> seen, std::span<const PxPoint> line, double near_px,
                                  const inference::Weights& weights) {
  const double reference = curve::arc_length<PxPoint>(seen);
  const double drawn = curve::arc_length<PxPoint>(line);
  std::vector<Alignment> list;
  constexpr std::size_t k_samples = 24;
  const auto a = curve::resample<PxPoint>(seen, k_samples);
  const auto b = curve::resample<PxPoint>(line, k_samples);
  if (!a || !b) return {Alignment{}};

  if (curve::is_closed(seen, near_px) && curve::is_closed(line, near_px)) {
    // No start to trust: every shift both ways round, the least sum of distances first (method, section 1).
    double least = std::numeric_limits<double>::infinity();
    Alignment best;
    best.closed = true;
    for (const bool reversed : {false, true}) {
      for (std::size_t shift = 0; shift + 1 < k_samples; ++shift) {
        double sum = 0;
        for (std::size_t i = 0; i + 1 < k_samples; ++i) {
          const std::size_t j = (i + shift) % (k_samples - 1);
          sum += geometry::distance((*a)[i], (*b)[reversed ? (k_samples - 1 - j) : j]);
        }
        if (sum >= least) continue;
        least = sum;
        best.reversed = reversed;
        best.turned = static_cast<double>(shift) / static_cast<double>(k_samples - 1);
      }
    }
    return {best};
  }

  // Both ends and the direction all along, in px.
  double with = 0;
  for (std::size_t i = 0; i + 1 < k_samples; ++i)
    with += dot(direction((*a)[i + 1] - (*a)[i]), direction((*b)[i + 1] - (*b)[i]));
  with /= static_cast<double>(k_samples - 1);
  double against = 0;
  for (std::size_t i = 0; i + 1 < k_samples; ++i)
    against += dot(direction((*a)[i + 1] - (*a)[i]), direction((*b)[k_samples - 2 - i] - (*b)[k_samples - 1 - i]));
  against /= static_cast<double>(k_samples - 1);
  const double turn = std::min(reference, drawn);
  const double forward =
      geometry::distance(line.front(), seen.front()) + geometry::distance(line.back(), seen.back()) - turn * with;
  const double backward =
      geometry::distance(line.front(), seen.back()) + geometry::distance(line.back(), seen.front()) - turn * against;
  const bool reversed = backward < forward;
  const auto add = [&](Alignment one) {
    one.reversed = reversed;
    list.push_back(one);
    if (std::abs(forward - backward) < 0.3 * turn) {
      one.reversed = !reversed;
      one.terms[Term::backwards] = 1.0;
      list.push_back(one);
    }
  };
  add({});
  const double ratio = drawn / std::max(reference, 1e-9);
  if (ratio < 0.85) {
    const double part = std::max(ratio, 0.1);
    for (const double from : {0.0, 0.5 * (1.0 - part), 1.0 - part}) {
      Alignment one;
      one.reference_from = from;
      one.reference_to = from + part;
      one.terms[Term::partial] = 1.0;
      one.terms[Term::left_out] = 1.0 - part;
      add(one);
    }
  } else if (ratio > 1.12) {
    const double part = std::max(1.0 / ratio, 0.1);
    for (const double from : {0.0, 0.5 * (1.0 - part), 1.0 - part}) {
      Alignment one;
      one.line_from = from;
      one.line_to = from + part;
      // Both ends overshot alike is how a wide line is drawn; all of it at one end is less likely the longer it is.
      const bool one_end = one.line_from == 0.0 || one.line_from == 1.0 - part;
      one.terms[Term::overshot] = 1.0;
      if (one_end) one.terms[Term::one_end] = std::max(0.0, ratio - 1.22);
      add(one);
    }
  }
  Alignment beside = list.front();
  beside.offset_px = k_offset * drawn;
  beside.terms[Term::backwards] += 1.0;  // what believing that costs
  beside.rough = 1.3;                    // such lines are drawn the more roughly
  list.push_back(beside);
  for (Alignment& one : list) {
    one.ends = k_ends;
    one.charge = weights.by.dot(one.terms);
  }
  return list;
}

}  // namespace penpose::intent
