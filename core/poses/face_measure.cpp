#include "core/poses/face_measure.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"
#include "core/curve/polyline.h"

namespace penpose::poses {
namespace {

/// An eye that is open by less than this share of its width is closed at rest.
constexpr double k_open = 0.1;
/// A control may turn the head where the part that it moves least moves by this share of the one that it moves most.
constexpr double k_alike = 0.3;
/// A control is of a part whose places it moves by more than this share of those of the part that it moves most.
constexpr double k_belongs = 0.5;
/// Share of the face's size that counts as no move.
constexpr double k_still = 1e-4;

std::string plain_name(const std::string& name) {
  constexpr std::string_view k_outer = "_outer";
  return name.ends_with(k_outer) ? name.substr(0, name.size() - k_outer.size()) : name;
}

ModelPoint middle_of(std::span<const ModelPoint> points) {
  ModelPoint sum(0);
  for (const ModelPoint& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

/// Where a curve's points are, given three vertices each.
std::vector<ModelPoint> curve_places(std::span<const posing::CurvePoint> points, const ModelPoint* vertices) {
  std::vector<ModelPoint> places;
  for (std::size_t i = 0; i < points.size(); ++i) {
    ModelPoint sum(0);
    for (std::size_t k = 0; k < 3; ++k) sum += vertices[3 * i + k] * points[i].weight[k];
    places.push_back(sum);
  }
  return places;
}

/// A value at a share of the length, between those of points at shares.
ModelPoint between(std::span<const ModelPoint> values, std::span<const double> shares, double share) {
  std::size_t k = 0;
  while (k + 2 < shares.size() && shares[k + 1] < share) ++k;
  const double length = shares[k + 1] - shares[k];
  const double t = length > 0 ? std::clamp((share - shares[k]) / length, 0.0, 1.0) : 0.0;
  return values[k] * (1 - t) + values[k + 1] * t;
}

/// Whether places keep their distances from each other, measured between some of them far apart.
bool is_rigid(std::span<const ModelPoint> before, std::span<const ModelPoint> after) {
  constexpr double k_stretch = 0.15;
  double stretched = 0;
  double moved = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const std::size_t k = (i + before.size() / 2 + 1) % before.size();
    stretched += std::abs(geometry::distance(before[i], before[k]) - geometry::distance(after[i], after[k]));
    moved += geometry::distance(before[i], after[i]);
  }
  return stretched < k_stretch * moved;
}

double share_of_place(std::size_t i) { return static_cast<double>(i) / static_cast<double>(k_places - 1); }

}  // namespace

std::optional<FaceMeasure> FaceMeasure::of(const document::Model& model,
                                           std::span<const portrait::FeatureCurve> features) {
  FaceMeasure face;
  face.rig_ = model.rig;
  const double yaw = base::radians(model.front_yaw_degrees);
  face.frame_.front = {base::sin(yaw), 0, base::cos(yaw)};
  face.frame_.left = {base::cos(yaw), 0, -base::sin(yaw)};
  face.find_points(features);
  if (face.features_.empty()) return std::nullopt;
  face.place_features();
  face.measure_units();
  face.measure_controls();
  return face;
}

void FaceMeasure::find_points(std::span<const portrait::FeatureCurve> features) {
  for (const portrait::FeatureCurve& curve : features) {
    const auto part = part_of_feature(curve.name);
    const std::string name = plain_name(curve.name);
    if (!part || curve.points.size() < 2 || find(name)) continue;
    features_.push_back({name, *part, ModelVector(1)});
    points_.push_back({curve.points, {}, {}});
  }
}

void FaceMeasure::place_features() {
  std::vector<std::uint32_t> vertices;
  for (const Points& one : points_) {
    for (const posing::CurvePoint& point : one.points)
      vertices.insert(vertices.end(), point.vertex.begin(), point.vertex.end());
  }
  std::vector<ModelPoint> at_rest(vertices.size());
  rig_->bind(vertices)->evaluate(rig::rest_pose(*rig_), at_rest);
  std::size_t first = 0;
  for (std::size_t f = 0; f < points_.size(); ++f) {
    Points& one = points_[f];
    one.rest = curve_places(one.points, at_rest.data() + first);
    first += 3 * one.points.size();
    for (ModelPoint& p : one.rest) p = frame_.local(p);
    const ModelVector along = one.rest.back() - one.rest.front();
    const bool back = std::abs(along.x) >= std::abs(along.y) ? along.x < 0 : along.y < 0;
    if (back) {
      std::reverse(one.points.begin(), one.points.end());
      std::reverse(one.rest.begin(), one.rest.end());
    }
    const auto shares = curve::shares_of<ModelPoint>(one.rest);
    if (!shares) {
      // A curve without length says nothing.
      features_.erase(features_.begin() + static_cast<std::ptrdiff_t>(f));
      points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(f--));
      continue;
    }
    one.shares = *shares;
  }
  vertices.clear();
  for (const Points& one : points_) {
    for (const posing::CurvePoint& point : one.points)
      vertices.insert(vertices.end(), point.vertex.begin(), point.vertex.end());
  }
  bound_ = rig_->bind(vertices);
  rest_ = places(rig::rest_pose(*rig_));
}

std::optional<std::size_t> FaceMeasure::find(const std::string& name) const {
  for (std::size_t f = 0; f < features_.size(); ++f) {
    if (features_[f].name == name) return f;
  }
  return std::nullopt;
}

std::vector<ModelPoint> FaceMeasure::places(const rig::Pose& pose) const {
  std::vector<ModelPoint> vertices(bound_->vertex_count());
  bound_->evaluate(pose, vertices);
  std::vector<ModelPoint> out;
  const ModelPoint* from = vertices.data();
  for (const Points& one : points_) {
    const auto curve = curve_places(one.points, from);
    from += 3 * one.points.size();
    for (std::size_t i = 0; i < k_places; ++i)
      out.push_back(frame_.local(between(curve, one.shares, share_of_place(i))));
  }
  return out;
}

void FaceMeasure::measure_units() {
  const auto of_feature = [&](std::size_t f) { return std::span(rest_).subspan(f * k_places, k_places); };
  const auto middle_of_part = [&](FacePart part, int side) {
    std::vector<ModelPoint> all;
    for (std::size_t f = 0; f < features_.size(); ++f) {
      const ModelPoint middle = middle_of(of_feature(f));
      if (features_[f].part != part || features_[f].name.find("jaw") != std::string::npos) continue;
      if (side == 0 || (side > 0) == features_[f].name.ends_with("_L")) all.push_back(middle);
    }
    return all.empty() ? std::optional<ModelPoint>() : middle_of(all);
  };
  geometry::Box box;
  for (const ModelPoint& p : rest_) box.add(p);
  const auto left = middle_of_part(FacePart::eyes, 1);
  const auto right = middle_of_part(FacePart::eyes, -1);
  const auto mouth = middle_of_part(FacePart::mouth, 0);
  size_ = 0.5 * box.diagonal();
  if (left && right && mouth)
    size_ = 0.5 * (geometry::distance(*left, *right) + geometry::distance(0.5 * (*left + *right), *mouth));
  for (std::size_t f = 0; f < features_.size(); ++f) {
    MeasuredFeature& one = features_[f];
    one.unit = ModelVector(size_);
    const std::string& name = one.name;
    const double width = std::abs(of_feature(f).back().x - of_feature(f).front().x);
    if (one.part == FacePart::mouth && name.find("lip") != std::string::npos && width > 0.1 * size_) one.unit.x = width;
    const std::size_t at = name.find("upper");
    if (one.part != FacePart::eyes || at == std::string::npos) continue;
    std::string other = name;
    const auto lower = find(other.replace(at, 5, "lower"));
    if (!lower || !(width > 0.02 * size_)) continue;
    const double open = middle_of(of_feature(f)).y - middle_of(of_feature(*lower)).y;
    if (!(open > k_open * width)) continue;
    one.unit = {width, open, size_};
    features_[*lower].unit = one.unit;
  }
}

void FaceMeasure::measure_controls() {
  const auto parameters = rig_->parameters();
  turns_head_.assign(parameters.size(), false);
  moves_.assign(parameters.size(), {});
  const rig::Pose rest = rig::rest_pose(*rig_);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!bound_->moves(i)) continue;
    rig::Pose pose = rest;
    const rig::Parameter& one = parameters[i];
    pose[i] = one.maximum - one.rest >= one.rest - one.minimum ? one.maximum : one.minimum;
    const auto moved = places(pose);
    std::array<double, 4> far{};
    std::array<double, 4> count{};
    for (std::size_t k = 0; k < moved.size(); ++k) {
      const auto part = static_cast<std::size_t>(features_[k / k_places].part);
      const double by = geometry::distance(moved[k], rest_[k]);
      far[part] += by;
      count[part] += 1;
      if (by > k_still * size_) moves_[i][0] = true;
    }
    double least = 1e300;
    double most = 0;
    int parts = 0;
    for (std::size_t part = 1; part < far.size(); ++part) {
      if (count[part] == 0.0) continue;
      ++parts;
      least = std::min(least, far[part] / count[part]);
      most = std::max(most, far[part] / count[part]);
    }
    for (std::size_t part = 1; part < far.size(); ++part)
      moves_[i][part] = moves_[i][0] && count[part] > 0 && far[part] / count[part] > k_belongs * most;
    turns_head_[i] = parts > 1 && most > 0 && least > k_alike * most && is_rigid(rest_, moved);
  }
}

bool FaceMeasure::moves(std::size_t parameter, FacePart part) const {
  return !turns_head_[parameter] && moves_[parameter][static_cast<std::size_t>(part)];
}

std::vector<FeatureMoves> FaceMeasure::moves_of(const rig::Pose& pose) const {
  rig::Pose still = pose;
  const auto parameters = rig_->parameters();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (turns_head_[i]) still[i] = parameters[i].rest;
  }
  const auto moved = places(still);
  std::vector<FeatureMoves> out;
  for (std::size_t f = 0; f < features_.size(); ++f) {
    FeatureMoves one{features_[f].name, {}};
    for (std::size_t k = f * k_places; k < (f + 1) * k_places; ++k)
      one.moves.push_back((moved[k] - rest_[k]) / features_[f].unit);
    out.push_back(std::move(one));
  }
  return out;
}

geometry::ModelPoint in_model(const portrait::FaceFrame& frame, const geometry::ModelPoint& p) {
  return frame.left * p.x + frame.up * p.y + frame.front * p.z;
}

}  // namespace penpose::poses
