#include "core/portrait/sketch/model_face.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/portrait/proportions.h"
#include "core/portrait/sketch/habits.h"

namespace penpose::portrait {
namespace {

PxPoint middle_of(const std::vector<PxPoint>& points) {
  PxPoint sum{0, 0};
  for (const PxPoint& p : points) sum = sum + p;
  return sum * (1.0 / static_cast<double>(points.size()));
}

struct Ends {
  double low = 1e300, high = -1e300;
  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  [[nodiscard]] double width() const { return high - low; }
  [[nodiscard]] double middle() const { return 0.5 * (low + high); }
};
Ends ends_of(const std::vector<PxPoint>& points) {
  Ends ends;
  for (const PxPoint& p : points) ends.add(p.x);
  return ends;
}

/// Returns the height of a line at x; beyond the line, that of its nearer end.
double height_at(const std::vector<PxPoint>& line, double x) {
  const PxPoint* best = &line.front();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const PxPoint& a = line[i];
    const PxPoint& b = line[i + 1];
    if ((a.x <= x) != (b.x <= x)) return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
  }
  for (const PxPoint& p : line) {
    if (std::abs(p.x - x) < std::abs(best->x - x)) best = &p;
  }
  return best->y;
}

void make_mean_one(std::vector<double>& weights) {
  double sum = 0;
  for (const double w : weights) sum += w;
  for (double& w : weights) w *= static_cast<double>(weights.size()) / sum;
}

bool has_word(const std::string& name, const char* word) {
  std::string lower;
  for (const char c : name) lower += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower.find(word) != std::string::npos;
}

}  // namespace

std::optional<ModelFace> ModelFace::see(const rig::Rig& rig, std::span<const FeatureCurve> curves,
                                        const rig::Pose& start, const geometry::Camera& camera) {
  ModelFace face(curves, camera);
  std::vector<geometry::ModelPoint> places(rig.vertex_count());
  rig.evaluate(start, places);
  std::array<std::vector<PxPoint>, 2> eyes;
  std::vector<PxPoint> mouth, brows;
  for (const FeatureCurve& curve : curves) {
    Seen one;
    for (const posing::CurvePoint& point : curve.points) {
      geometry::ModelPoint p(0);
      for (std::size_t k = 0; k < point.vertex.size(); ++k) p += places[point.vertex[k]] * point.weight[k];
      const auto px = camera.project(p);
      if (!px) return {};
      one.px.push_back(*px);
    }
    const Part part = part_named(curve.name);
    if (part == Part::eye) one.feature = has_word(curve.name, "lower") ? Feature::lower_lid : Feature::upper_lid;
    if (part == Part::mouth) one.feature = has_word(curve.name, "lower") ? Feature::lower_lip : Feature::upper_lip;
    if (part == Part::brow) one.feature = Feature::brow;
    if (part == Part::nose) one.feature = Feature::nose;
    if (part == Part::mouth) mouth.insert(mouth.end(), one.px.begin(), one.px.end());
    face.seen_.push_back(std::move(one));
  }
  // Sides by the middle of all that has two.
  Ends all;
  for (const Seen& one : face.seen_) {
    if (one.feature != Feature::other && one.feature != Feature::nose) all.add(middle_of(one.px).x);
  }
  for (Seen& one : face.seen_) {
    one.right = middle_of(one.px).x > all.middle();
    const bool eye = one.feature == Feature::upper_lid || one.feature == Feature::lower_lid;
    if (eye) eyes[one.right ? 1 : 0].insert(eyes[one.right ? 1 : 0].end(), one.px.begin(), one.px.end());
  }
  if (eyes[0].empty() || eyes[1].empty() || mouth.empty()) return {};
  const auto center = [](const std::vector<PxPoint>& points) {
    PxPoint low{1e300, 1e300}, high{-1e300, -1e300};
    for (const PxPoint& p : points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return (low + high) * 0.5;
  };
  const PxPoint left = center(eyes[0]);
  const PxPoint right = center(eyes[1]);
  if (!(right.x > left.x)) return {};
  face.layout_.middle = (left + right) * 0.5;
  face.layout_.along = right - left;
  for (Seen& one : face.seen_) {
    for (const PxPoint& p : one.px) one.points.push_back(face.layout_.in_frame(p));
  }
  face.measure_features();
  return face;
}

const ModelFace::Seen* ModelFace::seen(Feature feature, bool right) const {
  const bool sides = feature == Feature::brow || feature == Feature::upper_lid || feature == Feature::lower_lid;
  const Seen* best = nullptr;
  for (std::size_t c = 0; c < seen_.size(); ++c) {
    const Seen& one = seen_[c];
    if (one.feature != feature || (sides && one.right != right)) continue;
    // Of lips, the border of the opening.
    if (best == nullptr || has_word(curves_[c].name, "inner")) best = &one;
  }
  return best;
}

void ModelFace::measure_features() {
  FaceLayout drawn = layout_;
  const auto add = [&](const Seen* one, FacePart part) {
    if (one == nullptr) return;
    FaceMark mark;
    mark.points = one->points;
    mark.low = {1e300, 1e300};
    mark.high = {-1e300, -1e300};
    for (const PxPoint& p : mark.points) {
      mark.low = {std::min(mark.low.x, p.x), std::min(mark.low.y, p.y)};
      mark.high = {std::max(mark.high.x, p.x), std::max(mark.high.y, p.y)};
    }
    mark.part = part;
    mark.right = one->right;
    drawn.marks.push_back(std::move(mark));
  };
  for (const bool right : {false, true}) {
    add(seen(Feature::brow, right), FacePart::brow);
    add(seen(Feature::upper_lid, right), FacePart::eye);
    add(seen(Feature::lower_lid, right), FacePart::eye);
  }
  add(seen(Feature::upper_lip, false), FacePart::mouth);
  add(seen(Feature::lower_lip, false), FacePart::mouth);
  measures_ = measure(drawn);
}

std::vector<intent::DrawnCurve> ModelFace::lines_of(const Expression& expression) const {
  std::vector<intent::DrawnCurve> out;
  Ends mouth;
  for (const Seen& one : seen_) {
    if (one.feature != Feature::upper_lip && one.feature != Feature::lower_lip) continue;
    for (const PxPoint& p : one.points) mouth.add(p.x);
  }
  for (std::size_t c = 0; c < seen_.size(); ++c) {
    const Seen& one = seen_[c];
    const std::size_t side = one.right ? 1 : 0;
    std::vector<PxPoint> target = one.points;
    std::vector<double> weights;
    const Ends ends = ends_of(one.points);
    switch (one.feature) {
      case Feature::brow: {
        if (!expression.brows[side]) continue;
        const Expression::Brow& brow = *expression.brows[side];
        for (PxPoint& p : target) {
          // From 0 at the inner end to 1 at the outer one, which hardly moves with the tilt.
          const double s = ends.width() > 0 ? (one.right ? p.x - ends.low : ends.high - p.x) / ends.width() : 0;
          p.y -= brow.raised + brow.tilted * (s - k_tilt_pivot) * ends.width();
        }
        break;
      }
      case Feature::upper_lid: {
        const Seen* lower = seen(Feature::lower_lid, one.right);
        if (!expression.closed[side] || lower == nullptr) continue;
        for (PxPoint& p : target) p.y += *expression.closed[side] * (height_at(lower->points, p.x) - p.y);
        break;
      }
      case Feature::upper_lip:
      case Feature::lower_lip: {
        if (!expression.mouth) continue;
        const bool opens_alone = expression.mouth->opened > 0 && expression.mouth->widened == 0 &&
                                 expression.mouth->corners == std::array<double, 2>{0, 0};
        const double w = mouth.width();
        const double share = one.feature == Feature::upper_lip ? -k_upper_of_gap : 1 - k_upper_of_gap;
        for (PxPoint& p : target) {
          const double t = w > 0 ? std::clamp((p.x - mouth.middle()) / (0.5 * w), -1.0, 1.0) : 0;
          const double corner = expression.mouth->corners[t > 0 ? 1 : 0];
          const double opened = expression.mouth->opened;
          p.y += (share * opened * (1 - t * t) + k_corners_drop * opened * t * t - corner * t * t) * w;
          if (one.feature == Feature::upper_lip) p.y -= expression.mouth->sneered * (1 - t * t) * w;
          p.x += 0.5 * w * t * (expression.mouth->widened - k_open_narrows * opened);
          // Where a jaw takes the corners is its own affair.
          if (opens_alone) weights.push_back(k_least_weight + (1 - t * t));
        }
        break;
      }
      case Feature::lower_lid:
      case Feature::nose:
      case Feature::other:
        continue;
    }
    make_mean_one(weights);
    intent::DrawnCurve line{curves_[c].points, camera_, {}, 0, std::move(weights)};
    for (const PxPoint& p : target) line.target.push_back(layout_.on_sheet(p));
    double doubt = k_sketch_doubt;
    // People draw mouths of usual size: on a small mouth the line and its doubt shrink alike.
    if (one.feature == Feature::upper_lip || one.feature == Feature::lower_lip)
      doubt *= std::min(1.0, mouth.width() / k_mouth_width.mean);
    line.doubt_px = std::max(0.1, doubt * std::sqrt(geometry::dot(layout_.along, layout_.along)));
    out.push_back(std::move(line));
  }
  return out;
}

std::optional<std::size_t> ModelFace::curve_of(FacePart part, bool right, bool lower) const {
  const Seen* one = nullptr;
  if (part == FacePart::brow) one = seen(Feature::brow, right);
  if (part == FacePart::nose) one = seen(Feature::nose, false);
  if (part == FacePart::eye) one = seen(lower ? Feature::lower_lid : Feature::upper_lid, right);
  if (part == FacePart::mouth) one = seen(lower ? Feature::lower_lip : Feature::upper_lip, false);
  if (one == nullptr) return {};
  return static_cast<std::size_t>(one - seen_.data());
}

std::optional<std::size_t> ModelFace::other_border(std::size_t curve) const {
  const Feature feature = seen_[curve].feature;
  if (feature != Feature::upper_lip && feature != Feature::lower_lip) return {};
  for (std::size_t c = 0; c < seen_.size(); ++c) {
    if (c != curve && seen_[c].feature == feature) return c;
  }
  return {};
}

bool ModelFace::below_mouth(const PxPoint& p) const {
  const Seen* lower = seen(Feature::lower_lip, false);
  const Seen* upper = seen(Feature::upper_lip, false);
  if (lower == nullptr || upper == nullptr) return false;
  return p.y > 0.5 * (middle_of(lower->points).y + middle_of(upper->points).y);
}

}  // namespace penpose::portrait
