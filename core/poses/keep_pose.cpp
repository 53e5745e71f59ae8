#include "core/poses/keep_pose.h"

#include <algorithm>
#include <cmath>

#include "core/curve/polyline.h"
#include "core/document/commands/apply.h"

namespace penpose::poses {
namespace {

/// Share of its range from which on a control is away from rest.
constexpr double k_moved = 1e-6;
/// In the mean a feature goes so far, in its units, for it to count that a control does it.
constexpr double k_does = 1e-3;
/// A reference lies on a feature that it is no farther from in the mean, as a share of the face's size.
constexpr double k_on_feature = 0.12;

std::vector<std::pair<std::string, ModelVector>> deeds_of(const FaceMeasure& face, const rig::Rig& rig,
                                                          std::size_t control, double value) {
  rig::Pose alone = rig::rest_pose(rig);
  alone[control] = value;
  std::vector<std::pair<std::string, ModelVector>> does;
  for (const FeatureMoves& one : face.moves_of(alone)) {
    ModelVector mean(0);
    double far = 0;
    for (const ModelVector& move : one.moves) {
      mean += move / static_cast<double>(k_places);
      far += geometry::length(move) / static_cast<double>(k_places);
    }
    if (far > k_does) does.emplace_back(one.feature, mean);
  }
  return does;
}

/// Where a line asks places of a feature to go, in the picture in which it was drawn: none of the depth.
std::optional<KeptLine> line_over(const FaceMeasure& face, std::size_t feature, const std::vector<double>& shares,
                                  const std::vector<ModelPoint>& rest, const document::View& view,
                                  const std::vector<curve::PxPoint>& drawn) {
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  auto line = curve::resample_at<curve::PxPoint>(drawn, shares);
  if (!camera || !line) return std::nullopt;
  std::vector<curve::PxPoint> seen;
  for (const ModelPoint& p : rest) {
    const auto px = camera->project(p);
    if (!px) return std::nullopt;
    seen.push_back(*px);
  }
  const auto apart = [&](const std::vector<curve::PxPoint>& other) {
    return geometry::distance(other.front(), seen.front()) + geometry::distance(other.back(), seen.back());
  };
  std::vector<double> back;
  for (const double share : shares) back.push_back(1 - share);
  auto reversed = curve::resample_at<curve::PxPoint>(drawn, back);
  if (reversed && apart(*reversed) < apart(*line)) line = std::move(reversed);
  KeptLine kept;
  kept.feature = face.features()[feature].name;
  ModelPoint middle(0);
  for (const ModelPoint& p : rest) middle += p / static_cast<double>(rest.size());
  kept.from = geometry::normalized(face.frame().turned(camera->eye() - middle));
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const curve::PxPoint by = (*line)[i] - seen[i];
    const double units = camera->units_per_px(camera->depth(rest[i]));
    const ModelVector way = (camera->right() * by.x - camera->up() * by.y) * units;
    kept.moves.push_back(face.frame().turned(way) / face.features()[feature].unit);
  }
  kept.at = shares;
  return kept;
}

std::optional<KeptLine> line_of_face(const FaceMeasure& face, const document::FaceDrawing& drawing,
                                     const document::FaceLine& line) {
  std::string name = line.feature;
  if (name.ends_with("_outer")) name.resize(name.size() - 6);
  const auto feature = face.find(name);
  if (!feature) return std::nullopt;
  std::vector<ModelPoint> rest;
  std::vector<double> shares;
  for (std::size_t i = 0; i < k_places; ++i) {
    rest.push_back(in_model(face.frame(), face.rest()[*feature * k_places + i]));
    shares.push_back(static_cast<double>(i) / static_cast<double>(k_places - 1));
  }
  return line_over(face, *feature, shares, rest, drawing.view, line.line);
}

/// Places of a reference on a feature: the nearest share of its length for each.
struct OnFeature {
  std::size_t feature = 0;
  double apart = 1e300;
  std::vector<double> shares;
};

OnFeature nearest_on(const FaceMeasure& face, std::size_t feature, const std::vector<ModelPoint>& reference) {
  constexpr int k_steps = 64;
  OnFeature out{feature, 0, {}};
  const auto& points = face.points(feature);
  const auto fine = curve::resample<ModelPoint>(points.rest, k_steps + 1);
  if (!fine) return {};
  for (const ModelPoint& p : reference) {
    const ModelPoint own = face.frame().local(p);
    std::size_t best = 0;
    for (std::size_t k = 1; k < fine->size(); ++k) {
      if (geometry::distance((*fine)[k], own) < geometry::distance((*fine)[best], own)) best = k;
    }
    out.apart += geometry::distance((*fine)[best], own) / static_cast<double>(reference.size());
    out.shares.push_back(static_cast<double>(best) / k_steps);
  }
  return out;
}

std::optional<KeptLine> line_of_curve(const document::Document& at_rest, const FaceMeasure& face,
                                      const document::PoseCurve& curve) {
  const auto all = document::positions_of(at_rest, curve.points);
  // As many places as a feature has.
  auto reference = curve::resample<ModelPoint>(all, k_places);
  if (!reference) return std::nullopt;
  OnFeature best;
  for (std::size_t f = 0; f < face.features().size(); ++f) {
    OnFeature one = nearest_on(face, f, *reference);
    if (one.apart < best.apart) best = std::move(one);
  }
  if (!(best.apart < k_on_feature * face.size()) || best.shares.front() == best.shares.back()) return std::nullopt;
  std::vector<double> shares;
  for (std::size_t i = 0; i < k_places; ++i)
    shares.push_back(static_cast<double>(i) / static_cast<double>(k_places - 1));
  auto kept = line_over(face, best.feature, shares, *reference, curve.target->view, curve.target->line);
  if (!kept) return std::nullopt;
  if (best.shares.front() > best.shares.back()) {
    std::reverse(best.shares.begin(), best.shares.end());
    std::reverse(kept->moves.begin(), kept->moves.end());
  }
  // Nearest places may step back where a feature bends.
  for (std::size_t i = 1; i < best.shares.size(); ++i) best.shares[i] = std::max(best.shares[i], best.shares[i - 1]);
  kept->at = std::move(best.shares);
  return kept;
}

}  // namespace

KeptPose keep_pose(const document::Document& document, const rig::Pose& pose, const std::string& name,
                   const std::string& model, const FaceMeasure* face, std::vector<KeptLine> lines) {
  const rig::Rig& rig = *document.model->rig;
  const auto parameters = rig.parameters();
  KeptPose kept;
  kept.name = name;
  kept.model = model;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const rig::Parameter& one = parameters[i];
    kept.controls.push_back(one.name);
    if (!(std::abs(pose[i] - one.rest) > k_moved * (one.maximum - one.minimum))) continue;
    KeptValue value{one.name, pose[i], {}};
    if (face != nullptr) value.does = deeds_of(*face, rig, i, pose[i]);
    kept.values.push_back(std::move(value));
  }
  if (face != nullptr) kept.moves = face->moves_of(pose);
  kept.lines = std::move(lines);
  return kept;
}

std::vector<KeptLine> lines_of(const document::Document& document, const FaceMeasure& face,
                               const std::function<bool(document::CurveId)>& shown) {
  std::vector<KeptLine> lines;
  const auto add = [&](std::optional<KeptLine> line) {
    if (!line) return;
    // A line that was drawn again counts in place of the first.
    std::erase_if(lines, [&](const KeptLine& one) { return one.feature == line->feature && one.at == line->at; });
    lines.push_back(std::move(*line));
  };
  if (document.face != nullptr) {
    for (const document::FaceLine& line : document.face->lines) {
      if (shown(line.id)) add(line_of_face(face, *document.face, line));
    }
  }
  document::Document at_rest = document;
  at_rest.pose = rig::rest_pose(*document.model->rig);
  for (const auto& curve : document.curves) {
    const bool drawn = curve->role == document::PoseCurveRole::reference && curve->target && curve->points.size() > 1 &&
                       curve->target->line.size() > 1;
    if (drawn && shown(curve->id)) add(line_of_curve(at_rest, face, *curve));
  }
  return lines;
}

}  // namespace penpose::poses
