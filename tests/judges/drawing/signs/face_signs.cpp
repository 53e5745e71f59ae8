#include "tests/judges/drawing/signs/face_signs.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "core/base/math.h"

namespace penpose::judges::drawn {
namespace {

using geometry::PxPoint;
using portrait::FeatureCurve;

/// What a jaw that drops leaves the corners of the mouth behind by, which nobody takes for a smile.
constexpr double k_left_behind = 0.15;
/// Of an eye without a lower lid: how far it is open, in its widths.
constexpr double k_open = 0.35;
constexpr std::array<const char*, 2> k_sides{"_L", "_R"};

std::optional<std::size_t> named(std::span<const FeatureCurve> curves, const std::string& name) {
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (curves[c].name == name) return c;
  }
  return std::nullopt;
}
/// Maps call the outer border of a lip plainly by the lip, or say that it is the outer one.
std::optional<std::size_t> outer_lip(std::span<const FeatureCurve> curves, const std::string& lip) {
  const auto outer = named(curves, lip + "_outer");
  return outer ? outer : named(curves, lip);
}

struct Reach {
  double low = 1e300, high = -1e300;
  void add(double v) { low = std::min(low, v), high = std::max(high, v); }
  [[nodiscard]] double size() const { return high - low; }
  [[nodiscard]] double middle() const { return (low + high) / 2; }
};
Reach extent_x(std::span<const PxPoint> line) {
  Reach all;
  for (const PxPoint& p : line) all.add(p.x);
  return all;
}

std::vector<std::size_t> three_nearest(std::span<const PxPoint> line, double x) {
  std::vector<std::size_t> order(line.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return std::abs(line[a].x - x) < std::abs(line[b].x - x); });
  order.resize(std::min<std::size_t>(order.size(), 3));
  return order;
}
/// The points of a lid's middle.
std::vector<std::size_t> middle_of(std::span<const PxPoint> line) {
  const Reach all = extent_x(line);
  std::vector<std::size_t> inside;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (std::abs(line[i].x - all.middle()) < 0.27 * all.size()) inside.push_back(i);
  }
  return inside.empty() ? three_nearest(line, all.middle()) : inside;
}

PxPoint mean(std::span<const PxPoint> line, std::span<const std::size_t> points) {
  PxPoint sum;
  for (const std::size_t i : points) sum = sum + line[i];
  return sum * (1.0 / static_cast<double>(std::max<std::size_t>(points.size(), 1)));
}
double mean_y(std::span<const PxPoint> line) {
  double sum = 0;
  for (const PxPoint& p : line) sum += p.y;
  return sum / static_cast<double>(std::max<std::size_t>(line.size(), 1));
}

}  // namespace

base::Result<FaceSigns> FaceSigns::make(std::span<const FeatureCurve> curves, const CurvePlaces& rest,
                                        double front_yaw_degrees) {
  for (const char* lip : {"lip_upper", "lip_lower"}) {
    if (!outer_lip(curves, lip)) return base::Error{"the face has no such curve", lip, "name the borders of its lips"};
  }
  FaceSigns signs;
  const double yaw = base::radians(front_yaw_degrees);
  signs.right_ = {base::cos(yaw), -base::sin(yaw)};
  const Flat lines = signs.flat(rest);
  signs.find_lips(curves, lines);
  signs.find_lids(curves, lines);
  signs.find_brows(curves, lines);
  signs.find_fixed(curves, lines);
  signs.rest_ = signs.numbers(lines);
  for (std::size_t s = 0; s < 2; ++s) {
    if (!signs.lid_upper_[s].any()) continue;
    signs.open_[s] =
        signs.lid_lower_[s].any() ? signs.rest_.lid[s] : k_open * extent_x(lines[signs.lid_upper_[s].curve]).size();
  }
  return signs;
}

void FaceSigns::find_lips(std::span<const FeatureCurve> curves, const Flat& rest) {
  const std::size_t upper = *outer_lip(curves, "lip_upper"), lower = *outer_lip(curves, "lip_lower");
  Reach all;
  for (const std::size_t c : {upper, lower}) {
    for (std::size_t i = 0; i < rest[c].size(); ++i) {
      // The face's right is at the left of the picture.
      if (rest[c][i].x < all.low) corners_[1] = {c, i};
      if (rest[c][i].x > all.high) corners_[0] = {c, i};
      all.add(rest[c][i].x);
    }
  }
  mouth_ = std::max(all.size(), 1e-12);
  const auto some = [&](std::size_t c) { return Some{c, three_nearest(rest[c], all.middle())}; };
  upper_ = some(upper);
  lower_ = some(lower);
  const auto upper_inner = named(curves, "lip_upper_inner"), lower_inner = named(curves, "lip_lower_inner");
  if (upper_inner && lower_inner) upper_inner_ = some(*upper_inner), lower_inner_ = some(*lower_inner);
}

void FaceSigns::find_lids(std::span<const FeatureCurve> curves, const Flat& rest) {
  for (std::size_t s = 0; s < 2; ++s) {
    const auto upper = named(curves, std::string("eyelid_upper") + k_sides[s]);
    const auto lower = named(curves, std::string("eyelid_lower") + k_sides[s]);
    if (upper) lid_upper_[s] = {*upper, middle_of(rest[*upper])};
    if (upper && lower) lid_lower_[s] = {*lower, middle_of(rest[*lower])};
  }
}

void FaceSigns::find_brows(std::span<const FeatureCurve> curves, const Flat& rest) {
  constexpr double k_third = 0.36;
  const auto left = named(curves, "brow_L"), right = named(curves, "brow_R");
  const double lips = mean_y(rest[lower_.curve]);
  double brows = 0;
  if (left && right) {
    brows = (mean_y(rest[*left]) + mean_y(rest[*right])) / 2;
    const auto mean_x = [&](std::size_t c) {
      double sum = 0;
      for (const PxPoint& p : rest[c]) sum += p.x;
      return sum / static_cast<double>(rest[c].size());
    };
    const double centre = (mean_x(*left) + mean_x(*right)) / 2;
    const std::array<std::size_t, 2> both{*left, *right};
    for (std::size_t s = 0; s < 2; ++s) {
      const auto& line = rest[both[s]];
      Reach far;
      for (const PxPoint& p : line) far.add(std::abs(p.x - centre));
      brow_in_[s].curve = brow_out_[s].curve = both[s];
      for (std::size_t i = 0; i < line.size(); ++i) {
        const double x = std::abs(line[i].x - centre);
        if (x <= far.low + k_third * far.size()) brow_in_[s].points.push_back(i);
        if (x >= far.high - k_third * far.size()) brow_out_[s].points.push_back(i);
      }
    }
  } else {
    // Where faces have them: a quarter as far above the eyes as the lips are below.
    double eyes = lips + mouth_;
    if (lid_upper_[0].any() && lid_upper_[1].any())
      eyes = (mean_y(rest[lid_upper_[0].curve]) + mean_y(rest[lid_upper_[1].curve])) / 2;
    brows = eyes + (eyes - lips) / 4;
  }
  const auto chin = named(curves, "chin");
  const double low = chin ? mean_y(rest[*chin]) : lips - (brows - lips) * 0.4;
  height_ = std::max(1.5 * (brows - low), 1e-12);
  if (const auto wings = named(curves, "nose_base")) {
    wings_.curve = *wings;
    wings_.points.resize(rest[*wings].size());
    std::iota(wings_.points.begin(), wings_.points.end(), std::size_t{0});
  }
}

void FaceSigns::find_fixed(std::span<const FeatureCurve> curves, const Flat& rest) {
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (curves[c].name.starts_with("eyelid_upper")) {
      fixed_.push_back({c, 0});
      fixed_.push_back({c, rest[c].size() - 1});
    } else if (curves[c].name == "nose_bridge" || curves[c].name == "nose_base") {
      for (std::size_t i = 0; i < rest[c].size(); ++i) fixed_.push_back({c, i});
    }
  }
}

FaceSigns::Flat FaceSigns::flat(const CurvePlaces& places) const {
  Flat lines;
  for (const auto& curve : places) {
    std::vector<PxPoint> line;
    for (const geometry::ModelPoint& p : curve) line.push_back({right_.x * p.x + right_.y * p.z, p.y});
    lines.push_back(std::move(line));
  }
  return lines;
}

FaceSigns::Numbers FaceSigns::numbers(const Flat& lines) const {
  Numbers out;
  const auto at = [&](const Some& some) { return mean(lines[some.curve], some.points); };
  const PxPoint upper = at(upper_), lower = at(lower_);
  std::array<PxPoint, 2> corner;
  for (std::size_t s = 0; s < 2; ++s) {
    corner[s] = lines[corners_[s].curve][corners_[s].index];
    out.corner[s] = corner[s].y - (upper.y + lower.y) / 2;
    out.brow_in[s] = brow_in_[s].any() ? at(brow_in_[s]).y : 0;
    out.brow_out[s] = brow_out_[s].any() ? at(brow_out_[s]).y : 0;
    if (lid_upper_[s].any()) out.lid[s] = at(lid_upper_[s]).y - (lid_lower_[s].any() ? at(lid_lower_[s]).y : 0);
  }
  out.gap = upper_inner_.any() ? at(upper_inner_).y - at(lower_inner_).y : upper.y - lower.y;
  out.width = geometry::distance(corner[0], corner[1]);
  out.lip = upper.y;
  for (const std::size_t i : wings_.points) out.wings.push_back(lines[wings_.curve][i].y);
  return out;
}

Signs FaceSigns::of(const CurvePlaces& places, std::optional<Side> meant) const {
  const Numbers now = numbers(flat(places));
  Signs out;
  out[Sign::gap] = (now.gap - rest_.gap) / mouth_;
  out[Sign::width] = (now.width - rest_.width) / mouth_;
  std::array<double, 2> corner, brow_in, brow_out, lid;
  for (std::size_t s = 0; s < 2; ++s) {
    corner[s] = (now.corner[s] - rest_.corner[s]) / mouth_ - k_left_behind * std::max(out[Sign::gap], 0.0);
    brow_in[s] = (now.brow_in[s] - rest_.brow_in[s]) / height_;
    brow_out[s] = (now.brow_out[s] - rest_.brow_out[s]) / height_;
    lid[s] = 1 + (now.lid[s] - rest_.lid[s]) / std::max(open_[s], 1e-9);
  }
  out[Sign::corner_left] = corner[0];
  out[Sign::corner_right] = corner[1];
  out[Sign::corner] = (corner[0] + corner[1]) / 2;
  const double skew = corner[0] - corner[1];
  out[Sign::corner_skew] = !meant ? std::abs(skew) : *meant == Side::left ? skew : -skew;
  out[Sign::brow_in_left] = brow_in[0];
  out[Sign::brow_in_right] = brow_in[1];
  out[Sign::brow_in] = (brow_in[0] + brow_in[1]) / 2;
  out[Sign::brow_out] = (brow_out[0] + brow_out[1]) / 2;
  out[Sign::brow_tilt] = out[Sign::brow_in] - out[Sign::brow_out];
  out[Sign::lid_left] = lid[0];
  out[Sign::lid_right] = lid[1];
  out[Sign::lid] = (lid[0] + lid[1]) / 2;
  out[Sign::lid_least] = std::min(lid[0], lid[1]);
  out[Sign::lid_skew] = std::abs(lid[0] - lid[1]);
  const bool right = meant ? *meant == Side::right : lid[1] < lid[0];
  out[Sign::lid_this] = lid[right ? 1 : 0];
  out[Sign::lid_other] = lid[right ? 0 : 1];
  double wings = wings_.any() ? -1e300 : 0;
  for (std::size_t i = 0; i < now.wings.size(); ++i) wings = std::max(wings, now.wings[i] - rest_.wings[i]);
  out[Sign::sneer] = std::max(wings, now.lip - rest_.lip) / height_;
  return out;
}

double FaceSigns::crossing(const CurvePlaces& places) const {
  const Numbers now = numbers(flat(places));
  // Lips of some models overlap at rest.
  double deep = std::max(0.0, std::min(rest_.gap, 0.0) - now.gap);
  for (std::size_t s = 0; s < 2; ++s) {
    if (lid_upper_[s].any() && lid_lower_[s].any()) deep = std::max(deep, -now.lid[s]);
  }
  return deep;
}

}  // namespace penpose::judges::drawn
