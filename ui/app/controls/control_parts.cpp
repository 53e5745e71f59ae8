#include "ui/app/controls/control_parts.h"

#include <algorithm>
#include <array>

#include "core/geometry/space.h"

namespace penpose::app {
namespace {

/// Model units, over all points of a part: a control that moves less of the features says nothing.
constexpr double k_least_move = 1e-6;
/// A control is of a part that it moves so many times as far as any other.
constexpr double k_distinctly = 1.5;

/// The vertices below the points of features, and the part of each.
struct FeatureVertices {
  std::vector<std::uint32_t> vertices;
  std::vector<FacePart> parts;
};

FeatureVertices vertices_of(std::span<const portrait::FeatureCurve> features) {
  FeatureVertices all;
  for (const portrait::FeatureCurve& curve : features) {
    const auto part = poses::part_of_feature(curve.name);
    if (!part) continue;
    for (const posing::CurvePoint& point : curve.points) {
      all.vertices.push_back(portrait::nearest_vertex(point));
      all.parts.push_back(*part);
    }
  }
  return all;
}

/// The part whose points move distinctly farther than those of the others, in the mean; `all`: none does, such as where
/// the whole head is turned.
FacePart part_of_moves(const FeatureVertices& features, std::span<const geometry::ModelPoint> rest,
                       std::span<const geometry::ModelPoint> moved) {
  struct Moves {
    double sum = 0;
    int count = 0;
    [[nodiscard]] double mean() const { return count > 0 ? sum / count : 0; }
  };
  std::array<Moves, 4> parts{};
  for (std::size_t v = 0; v < rest.size(); ++v) {
    Moves& part = parts[static_cast<std::size_t>(features.parts[v])];
    part.sum += geometry::distance(rest[v], moved[v]);
    ++part.count;
  }
  const auto less = [](const Moves& a, const Moves& b) { return a.mean() < b.mean(); };
  const auto most = std::max_element(parts.begin(), parts.end(), less);
  for (auto other = parts.begin(); other != parts.end(); ++other) {
    if (other != most && other->mean() * k_distinctly > most->mean()) return FacePart::all;
  }
  return most->sum > k_least_move ? static_cast<FacePart>(most - parts.begin()) : FacePart::all;
}

}  // namespace

std::vector<FacePart> parts_by_effect(const document::Document& document,
                                      std::span<const portrait::FeatureCurve> features) {
  const rig::Rig& rig = *document.model->rig;
  const auto parameters = rig.parameters();
  std::vector<FacePart> parts;
  for (const rig::Parameter& parameter : parameters) parts.push_back(part_of(parameter.name));
  const FeatureVertices moved_by = vertices_of(features);
  if (moved_by.vertices.empty()) return parts;
  const auto bound = rig.bind(moved_by.vertices);
  const rig::Pose rest = rig::rest_pose(rig);
  std::vector<geometry::ModelPoint> at_rest(moved_by.vertices.size());
  std::vector<geometry::ModelPoint> moved(moved_by.vertices.size());
  bound->evaluate(rest, at_rest);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!bound->moves(i)) continue;
    rig::Pose pose = rest;
    pose[i] = parameters[i].maximum != parameters[i].rest ? parameters[i].maximum : parameters[i].minimum;
    bound->evaluate(pose, moved);
    if (const FacePart part = part_of_moves(moved_by, at_rest, moved); part != FacePart::all) parts[i] = part;
  }
  return parts;
}

const std::vector<FacePart>& ControlParts::of(const document::Document& document,
                                              std::span<const portrait::FeatureCurve> features) {
  if (rig_ != document.model->rig || features_ != features.size() || parts_.size() != document.pose.size()) {
    rig_ = document.model->rig;
    features_ = features.size();
    parts_ = parts_by_effect(document, features);
  }
  return parts_;
}

}  // namespace penpose::app
