#include "core/portrait/proportions.h"

#include <algorithm>
#include <array>
#include <functional>

#include "core/portrait/companions.h"

namespace penpose::portrait {
namespace {

using geometry::PxPoint;
using Line = std::vector<PxPoint>;
PxPoint mean_of(std::span<const PxPoint> points) {
  PxPoint sum{0, 0};
  for (const PxPoint& p : points) sum = sum + p;
  return sum * (1.0 / static_cast<double>(std::max<std::size_t>(points.size(), 1)));
}

/// The mean of the middles of the curves that are taken.
struct Middle {
  PxPoint at{0, 0};
  std::size_t count = 0;
};

Middle middle_of(std::span<const Line> curves, const std::function<bool(std::size_t)>& taken) {
  Middle middle;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (!taken(c)) continue;
    middle.at = middle.at + mean_of(curves[c]);
    ++middle.count;
  }
  if (middle.count > 0) middle.at = middle.at * (1.0 / static_cast<double>(middle.count));
  return middle;
}

}  // namespace

Part part_named(const std::string& name) {
  std::string lower;
  for (const char c : name) lower += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  const auto has = [&](const char* word) { return lower.find(word) != std::string::npos; };
  if (has("brow")) return Part::brow;
  if (has("eye") || has("lid")) return Part::eye;
  if (has("lip") || has("mouth")) return Part::mouth;
  if (has("nose") || has("nostril")) return Part::nose;
  if (has("jaw") || has("chin") || has("cheek") || has("face")) return Part::jaw;
  return Part::other;
}

std::vector<Proportion> proportions_of(std::span<const Line> curves, std::span<const Part> parts) {
  const auto is = [&](Part part) { return [parts, part](std::size_t c) { return parts[c] == part; }; };
  const bool lids = std::find(parts.begin(), parts.end(), Part::eye) != parts.end();
  const Part see = lids ? Part::eye : Part::brow;
  const Middle eyes = middle_of(curves, is(see));
  std::vector<Proportion> all;
  if (eyes.count == 0) return all;
  // Sides of the face, in the picture: about the middle of what sees.
  const auto left = [&](std::size_t c) { return mean_of(curves[c]).x < eyes.at.x; };
  std::array<Middle, 2> eye, brow;
  for (const bool side : {false, true}) {
    eye[side] = middle_of(curves, [&](std::size_t c) { return parts[c] == see && left(c) == side; });
    brow[side] = middle_of(curves, [&](std::size_t c) { return parts[c] == Part::brow && left(c) == side; });
  }
  PxPoint low{1e30, 1e30}, high{-1e30, -1e30};
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (parts[c] != Part::mouth) continue;
    for (const PxPoint& p : curves[c]) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  const bool mouths = low.x <= high.x;
  const PxPoint mouth = mouths ? (low + high) * 0.5 : eyes.at;
  const Middle noses = middle_of(curves, is(Part::nose));
  const double nose = noses.count > 0 ? noses.at.y : eyes.at.y + 0.6 * (mouth.y - eyes.at.y);

  const auto add = [&](const std::function<PxPoint(std::size_t, const PxPoint&)>& way) {
    std::vector<Line> field;
    bool moves = false;
    for (std::size_t c = 0; c < curves.size(); ++c) {
      Line line;
      for (const PxPoint& p : curves[c]) {
        line.push_back(way(c, p));
        moves = moves || line.back().x != 0.0 || line.back().y != 0.0;
      }
      field.push_back(std::move(line));
    }
    if (moves) all.push_back({std::move(field)});
  };
  const auto sees = [&](std::size_t c) { return parts[c] == Part::eye || parts[c] == Part::brow; };
  const auto below = [&](const PxPoint& p) { return std::max(0.0, p.y - eyes.at.y); };
  add([&](std::size_t c, const PxPoint&) {
    const Middle& side = eye[left(c)];
    return sees(c) && side.count > 0 ? PxPoint{side.at.x - eyes.at.x, 0} : PxPoint{0, 0};
  });
  add([&](std::size_t c, const PxPoint& p) {
    return parts[c] == Part::mouth ? PxPoint{p.x - mouth.x, 0} : PxPoint{0, 0};
  });
  if (lids) {
    add([&](std::size_t c, const PxPoint&) {
      return parts[c] == Part::brow ? PxPoint{0, brow[left(c)].at.y - eyes.at.y} : PxPoint{0, 0};
    });
  }
  add([&](std::size_t c, const PxPoint& p) {
    if (parts[c] == Part::mouth) return PxPoint{0, (nose - eyes.at.y) / 2.0};
    return parts[c] == Part::nose ? PxPoint{0, below(p)} : PxPoint{0, 0};
  });
  add([&](std::size_t c, const PxPoint& p) {
    if (sees(c)) return PxPoint{0, 0};
    return parts[c] == Part::mouth ? PxPoint{0, mouth.y - eyes.at.y} : PxPoint{0, below(p)};
  });
  return all;
}

}  // namespace penpose::portrait
