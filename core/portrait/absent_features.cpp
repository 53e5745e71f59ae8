#include "core/portrait/absent_features.h"

#include <algorithm>
#include <array>

#include "core/base/math.h"

namespace penpose::portrait {
namespace {

using geometry::PxPoint;
using Line = std::vector<PxPoint>;

/// The box of the lines of a part, of one side of a middle or of both.
struct PartBox {
  PxPoint low{1e300, 1e300}, high{-1e300, -1e300};
  std::optional<std::size_t> first;  ///< of its curves
  void add(const Line& line, std::size_t number) {
    for (const PxPoint& p : line) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    if (!first) first = number;
  }
  [[nodiscard]] PxPoint middle() const { return (low + high) * 0.5; }
};

/// Points along a parabola through three.
Line bow_through(PxPoint from, PxPoint middle, PxPoint to, std::size_t count) {
  Line out;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(count - 1);
    out.push_back(from * ((1.0 - t) * (1.0 - 2.0 * t)) + middle * (4.0 * t * (1.0 - t)) + to * (t * (2.0 * t - 1.0)));
  }
  return out;
}

}  // namespace

std::vector<AbsentFeature> absent_features(std::span<const Line> lines, std::span<const Part> parts) {
  PartBox eyes, mouth, nose, jaw;
  std::array<PartBox, 2> eye, brow;
  for (std::size_t c = 0; c < lines.size(); ++c) {
    if (parts[c] == Part::eye) eyes.add(lines[c], c);
    if (parts[c] == Part::mouth) mouth.add(lines[c], c);
    if (parts[c] == Part::nose) nose.add(lines[c], c);
    if (parts[c] == Part::jaw) jaw.add(lines[c], c);
  }
  std::vector<AbsentFeature> out;
  if (!eyes.first || !mouth.first) return out;
  for (std::size_t c = 0; c < lines.size(); ++c) {
    const std::size_t side = (lines[c].front().x + lines[c].back().x) / 2.0 < eyes.middle().x ? 0 : 1;
    if (parts[c] == Part::eye) eye[side].add(lines[c], c);
    if (parts[c] == Part::brow) brow[side].add(lines[c], c);
  }
  if (!eye[0].first || !eye[1].first) return out;
  const double apart = eye[1].middle().x - eye[0].middle().x, down = mouth.middle().y - eyes.middle().y;
  if (!(apart > 0.0 && down > 0.0)) return out;
  const std::size_t count = lines.front().size();
  // In units of the distance between the eyes, as faces usually are.
  for (const std::size_t side : {0, 1}) {
    if (brow[side].first) continue;
    const double out_of = side == 0 ? -apart : apart;
    const PxPoint at = eye[side].middle();
    out.push_back({Part::brow, std::nullopt,
                   bow_through(at + PxPoint{-0.31 * out_of, -0.39 * apart}, at + PxPoint{0.06 * out_of, -0.45 * apart},
                               at + PxPoint{0.43 * out_of, -0.29 * apart}, count)});
  }
  const double middle = eyes.middle().x;
  if (nose.first && nose.high.x - nose.low.x < 0.15 * apart) {
    const double y = nose.high.y + 0.16 * (nose.high.y - nose.low.y);
    out.push_back(
        {Part::nose, nose.first,
         bow_through({middle - 0.2 * apart, y}, {middle, y + 0.05 * apart}, {middle + 0.2 * apart, y}, count)});
  }
  if (!jaw.first || jaw.low.y > eyes.high.y) {
    Line line;
    const double top = eyes.middle().y, chin = jaw.first ? jaw.high.y : top + 1.6 * down;
    for (std::size_t i = 0; i < count; ++i) {
      const double angle = base::k_pi * static_cast<double>(i) / static_cast<double>(count - 1);
      line.push_back({middle - 1.2 * apart * base::cos(angle), top + (chin - top) * base::sin(angle)});
    }
    out.push_back({Part::jaw, jaw.first, std::move(line)});
  }
  Line crown;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = base::k_pi * static_cast<double>(i) / static_cast<double>(count - 1);
    crown.push_back({middle - 1.2 * apart * base::cos(angle), eyes.middle().y - 1.2 * apart * base::sin(angle)});
  }
  out.push_back({Part::crown, std::nullopt, std::move(crown)});
  return out;
}

}  // namespace penpose::portrait
