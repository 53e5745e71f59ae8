#include "core/portrait/features/mouth_seam.h"

#include <algorithm>
#include <cmath>

#include "core/portrait/surface/parting.h"

namespace penpose::portrait {
namespace {

/// A gap between lips is no higher than this share of the picture.
constexpr double k_gap = 0.12;
/// Beyond an open gap the other lip lies no deeper than this share of the picture's height.
constexpr double k_level = 0.02;
/// Columns without a break that a seam may bridge, px.
constexpr int k_bridge = 3;
/// How far a seam may rise or fall from one column to the next, px.
constexpr int k_climb = 3;
/// The shorter side of a mouth as a share of the longer one, and its width as one of the picture's height, at least.
constexpr double k_lopsided_seam = 0.4, k_narrowest = 0.03;
/// How sure a seam is for being an opening of the mesh.
constexpr double k_of_opening = 0.5;
/// Lips roll in this far before they end, as a share of the width.
constexpr double k_rolled = 0.35;
/// Points of a lip's line.
constexpr std::size_t k_seam_points = 33;

struct Break {
  int upper = 0, lower = 0;
};

/// The breaks of a column from above: places where what a px shows is not next to what the next px of skin below it
/// shows.
std::vector<Break> breaks_of(const FaceSurface& surface, int x, int top) {
  std::vector<Break> breaks;
  const int gap = static_cast<int>(k_gap * surface.image().height());
  int last = -1;
  for (int y = top; y >= 0; --y) {
    if (!surface.shows_skin(x, y)) continue;
    if (last >= 0 && last - y <= gap && surface.parted(x, last, x, y)) breaks.push_back({last, y});
    last = y;
  }
  return breaks;
}

/// The same with those joined that are both rims of a gap in which the inside is seen.
std::vector<Break> gaps_of(const FaceSurface& surface, int x, int top) {
  const FaceImage& image = surface.image();
  const std::vector<Break> breaks = breaks_of(surface, x, top);
  const double level = k_level * image.height() * image.px();
  std::vector<Break> gaps;
  for (std::size_t i = 0; i < breaks.size(); ++i) {
    Break gap = breaks[i];
    const double depth = image.depth(x, gap.upper) - level;
    for (std::size_t j = i + 1; image.depth(x, gap.lower) < depth && j < breaks.size(); ++j) {
      if (2 * (gap.upper - breaks[j].lower) > k_gap * image.height()) break;
      if (image.depth(x, breaks[j].lower) < depth) continue;
      gap.lower = breaks[j].lower;
      i = j;
    }
    gaps.push_back(gap);
  }
  return gaps;
}

class Tracker {
 public:
  Tracker(const FaceSurface& surface, int top) {
    for (int x = 0; x < surface.image().width(); ++x) breaks_.push_back(gaps_of(surface, x, top));
  }
  [[nodiscard]] const std::vector<Break>& of(int x) const { return breaks_[x]; }

  /// Follows a break to both sides.
  [[nodiscard]] std::vector<MouthSeam::Column> follow(int x, const Break& start) const {
    std::vector<MouthSeam::Column> right = side(x, start, -1);
    const std::vector<MouthSeam::Column> left = side(x, start, 1);
    std::reverse(right.begin(), right.end());
    right.push_back({x, start.upper, start.lower});
    right.insert(right.end(), left.begin(), left.end());
    return right;
  }

 private:
  [[nodiscard]] std::vector<MouthSeam::Column> side(int x, Break at, int step) const {
    std::vector<MouthSeam::Column> found;
    int missed = 0;
    for (x += step; x >= 0 && x < static_cast<int>(breaks_.size()) && missed <= k_bridge; x += step) {
      const Break* best = nullptr;
      int least = k_climb * (missed + 1) * 2 + 1;
      for (const Break& b : breaks_[x]) {
        // The gap narrows to the corners; what its middle does counts.
        const int away = std::abs(b.upper + b.lower - at.upper - at.lower);
        if (away < least) {
          least = away;
          best = &b;
        }
      }
      if (best == nullptr) {
        ++missed;
        continue;
      }
      missed = 0;
      at = *best;
      found.push_back({x, at.upper, at.lower});
    }
    return found;
  }

  std::vector<std::vector<Break>> breaks_;
};

/// How far the best push parts two places of a column, model units: the upper one goes up or the lower one down.
double most_parting(const FaceSurface& surface, PushField& field, const std::vector<Push>& pushes, int x,
                    const std::vector<Break>& breaks, std::vector<double>& parting) {
  parting.assign(breaks.size(), 0.0);
  double most = 0;
  for (const Push& push : pushes) {
    field.set(push);
    for (std::size_t i = 0; i < breaks.size(); ++i) {
      const double apart = field.of(surface.at(x, breaks[i].upper)).y - field.of(surface.at(x, breaks[i].lower)).y;
      parting[i] = std::max(parting[i], apart);
      most = std::max(most, apart);
    }
  }
  return most;
}

}  // namespace

std::optional<MouthSeam> find_mouth_seam(const rig::Rig& rig, const intent::WholeModel& whole,
                                         const FaceSurface& surface, double below) {
  const FaceImage& image = surface.image();
  const int middle = static_cast<int>(std::lround(image.column(0.0)));
  if (!image.inside(middle, 0)) return std::nullopt;
  const int top = std::min(image.height() - 1, static_cast<int>(image.row(below)));
  const Tracker tracker(surface, top);
  const double height = image.height() * image.px();

  std::optional<MouthSeam> best;
  double best_score = 0;
  geometry::Box box;
  box.add({-0.1 * height, image.place(0, 0).y, 0});
  box.add({0.1 * height, below, 0});
  const std::vector<Push> pushes = pushes_within(rig, whole, surface, box);
  PushField field(rig, surface, vertices_seen(surface, middle, 0, middle, top));
  std::vector<double> parting;
  const double most = most_parting(surface, field, pushes, middle, tracker.of(middle), parting);
  for (std::size_t i = 0; i < tracker.of(middle).size(); ++i) {
    const Break& b = tracker.of(middle)[i];
    MouthSeam seam;
    seam.columns = tracker.follow(middle, b);
    const double right = middle - seam.columns.front().x;
    const double left = seam.columns.back().x - middle;
    const double width = (right + left) * image.px();
    if (!(std::min(right, left) > k_lopsided_seam * std::max(right, left)) || width < k_narrowest * height) continue;
    const double step = std::abs(image.depth(middle, b.upper) - image.depth(middle, b.lower));
    seam.parting = parting[i] / width;
    // Lips lie in one depth; a chin in front of a neck and a nose do not.
    const double even = 1.0 / (1.0 + (step / (0.12 * width)) * (step / (0.12 * width)));
    double open = 0;
    for (const MouthSeam::Column& c : seam.columns) {
      if (surface.near_border(c.x, c.upper, k_rolled * width) && surface.near_border(c.x, c.lower, k_rolled * width))
        open += 1.0;
    }
    open /= static_cast<double>(seam.columns.size());
    seam.sureness = even * std::min(1.0, 0.35 + 2.0 * seam.parting + k_of_opening * open) *
                    (std::min(right, left) / std::max(right, left));
    const double opens = most > 1e-3 * height ? parting[i] / most : 0.3 + 0.7 * open;
    const double score = even * opens;

    if (score > best_score) {
      best_score = score;
      best = seam;
    }
  }
  return best;
}

std::array<FoundLine, 2> inner_lips(const FaceSurface& surface, const MouthSeam& seam) {
  std::array<FoundLine, 2> lines;
  const std::size_t last = seam.columns.size() - 1;
  for (std::size_t i = 0; i < k_seam_points; ++i) {
    const MouthSeam::Column& c = seam.columns[i * last / (k_seam_points - 1)];
    lines[0].points.push_back(surface.at(c.x, c.upper));
    lines[1].points.push_back(surface.at(c.x, c.lower));
  }
  lines[0].sureness = lines[1].sureness = seam.sureness;
  return lines;
}

}  // namespace penpose::portrait
