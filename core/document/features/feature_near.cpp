#include "core/document/features/feature_near.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/base/math.h"
#include "core/curve/polyline.h"

namespace penpose::document {
namespace {

using geometry::ModelPoint;
using geometry::ModelVector;
using Line = std::vector<ModelPoint>;

/// Those that find_features looks for, from the top of the face to its foot.
constexpr std::array<const char*, 14> k_looked_for{
    "brow_R",      "brow_L",    "eyelid_upper_R",  "eyelid_upper_L",  "eyelid_lower_R",  "eyelid_lower_L",
    "nose_bridge", "nose_base", "lip_upper_outer", "lip_upper_inner", "lip_lower_inner", "lip_lower_outer",
    "jaw",         "chin"};

/// How far the points of a line are from another, in the mean.
double mean_distance(const Line& from, const Line& to) {
  double sum = 0;
  for (const ModelPoint& p : from) {
    double least = std::numeric_limits<double>::infinity();
    for (const ModelPoint& q : to) least = std::min(least, geometry::distance(p, q));
    sum += least;
  }
  return sum / static_cast<double>(from.size());
}

/// How badly a line fits a feature, in shares of the length of the longer; infinite: they run in other directions.
double misfit(const Line& line, const Line& feature) {
  constexpr std::size_t k_places = 24;
  constexpr double k_most_turned = 0.6;  // cosine of the angle between the two
  const auto one = curve::resample<ModelPoint>(line, k_places), other = curve::resample<ModelPoint>(feature, k_places);
  if (!one || !other) return std::numeric_limits<double>::infinity();
  const ModelVector along = one->back() - one->front(), feature_along = other->back() - other->front();
  const double lengths = geometry::length(along) * geometry::length(feature_along);
  if (lengths > 0 && std::abs(glm::dot(along, feature_along)) < k_most_turned * lengths)
    return std::numeric_limits<double>::infinity();
  const double longer = std::max(curve::arc_length<ModelPoint>(*one), curve::arc_length<ModelPoint>(*other));
  return 0.5 * (mean_distance(*one, *other) + mean_distance(*other, *one)) / longer;
}

const portrait::FeatureCurve* find_curve(const FeatureCurves& features, const std::string& name) {
  for (const auto* list : {&features.curves, &features.unsure}) {
    for (const portrait::FeatureCurve& curve : *list) {
      if (curve.name == name) return &curve;
    }
  }
  return nullptr;
}

}  // namespace

std::vector<ModelPoint> positions_of(const Model& model, const rig::Pose& pose, const portrait::FeatureCurve& curve) {
  std::vector<std::uint32_t> vertices;
  for (const posing::CurvePoint& point : curve.points)
    vertices.insert(vertices.end(), point.vertex.begin(), point.vertex.end());
  Line corners(vertices.size());
  model.rig->bind(vertices)->evaluate(pose, corners);
  Line out;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    ModelPoint sum(0);
    for (std::size_t k = 0; k < 3; ++k) sum += corners[3 * i + k] * curve.points[i].weight[k];
    out.push_back(sum);
  }
  return out;
}

namespace {

/// A line is near a feature whose misfit is below this.
constexpr double k_near = 0.3;

struct Fitting {
  std::string name;
  double misfit = 0;
};

/// How badly a line fits each feature, in their order.
std::vector<Fitting> fittings_of(const Model& model, const rig::Pose& pose,
                                 std::span<const portrait::FeatureCurve> features, const Line& line) {
  std::vector<Fitting> out;
  for (const portrait::FeatureCurve& curve : features)
    out.push_back({curve.name, misfit(line, positions_of(model, pose, curve))});
  return out;
}

void sort_by_misfit(std::vector<Fitting>& all) {
  std::stable_sort(all.begin(), all.end(), [](const Fitting& a, const Fitting& b) { return a.misfit < b.misfit; });
}

}  // namespace

std::optional<std::string> feature_near(const Model& model, const rig::Pose& pose, const FeatureCurves& features,
                                        const Line& line) {
  constexpr double k_clearly = 1.3;  // so much worse is the next one
  std::vector<Fitting> all = fittings_of(model, pose, features.curves, line);
  for (Fitting& one : fittings_of(model, pose, features.unsure, line)) all.push_back(std::move(one));
  sort_by_misfit(all);
  if (all.empty() || !(all.front().misfit < k_near)) return std::nullopt;
  if (all.size() > 1 && all[1].misfit < k_clearly * all.front().misfit) return std::nullopt;
  return all.front().name;
}

std::vector<std::string> features_near(const Model& model, const rig::Pose& pose,
                                       std::span<const portrait::FeatureCurve> features, const Line& line) {
  std::vector<Fitting> all = fittings_of(model, pose, features, line);
  sort_by_misfit(all);
  std::vector<std::string> out;
  for (Fitting& one : all) {
    if (one.misfit < k_near) out.push_back(std::move(one.name));
  }
  return out;
}

bool runs_backwards(const Model& model, const rig::Pose& pose, const FeatureCurves& features, const std::string& name,
                    const Line& line) {
  if (const portrait::FeatureCurve* own = find_curve(features, name); own != nullptr) {
    const Line there = positions_of(model, pose, *own);
    return geometry::distance(line.front(), there.front()) + geometry::distance(line.back(), there.back()) >
           geometry::distance(line.front(), there.back()) + geometry::distance(line.back(), there.front());
  }
  const double yaw = base::radians(model.front_yaw_degrees);
  const ModelVector left{base::cos(yaw), 0, -base::sin(yaw)};
  const ModelVector along = line.back() - line.front();
  const double to_left = glm::dot(along, left);
  return std::abs(along.y) > std::abs(to_left) ? along.y < 0 : to_left < 0;
}

std::vector<std::string> nameable_features(const Model& model, const FeatureCurves& features) {
  std::vector<std::string> out = portrait::names_of(features.curves);
  const auto add = [&](const std::string& name) {
    const bool there = std::any_of(out.begin(), out.end(),
                                   [&](const std::string& one) { return one == name || one + "_outer" == name; });
    if (!there) out.push_back(name);
  };
  for (const portrait::FeatureCurve& curve : features.unsure) add(curve.name);
  for (const NamedCurve& curve : model.features) add(curve.name);
  for (const char* name : k_looked_for) add(name);
  return out;
}

}  // namespace penpose::document
