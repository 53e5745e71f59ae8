#include "core/document/commands/list/face/feature_commands.h"

#include <algorithm>
#include <utility>

#include "core/document/commands/apply_parts.h"
#include "core/document/commands/list/posing_commands.h"
#include "core/document/features/feature_near.h"

namespace penpose::document {
namespace {

using geometry::ModelPoint;

FeatureCurves features_so_far(const Document& document, Parts& work) {
  const auto& features = work.face.features(document, work.whole_of(document));
  return features ? *features : FeatureCurves{};
}

/// The document with these corrections. A drawing of the face that is there is read by them; where nothing of the face
/// is left that lines could be, it goes.
Changed with_features(const Document& document, std::vector<NamedCurve> features, Parts& work) {
  Model model = *document.model;
  model.features = std::move(features);
  Document changed = document;
  changed.model = std::make_shared<const Model>(std::move(model));
  if (!changed.face || changed.face->time_s != changed.time_s) return changed;
  if (features_so_far(changed, work).curves.empty()) {
    changed.face = nullptr;
    return changed;
  }
  return with_face_read(changed, *changed.face, work);
}

Changed with_feature(const Document& document, NamedCurve feature, Parts& work) {
  if (feature.name.empty()) return base::Error{"a feature needs a name", "feature", "give one, such as brow_L"};
  std::vector<NamedCurve> features = document.model->features;
  const auto same =
      std::find_if(features.begin(), features.end(), [&](const NamedCurve& one) { return one.name == feature.name; });
  if (same != features.end()) {
    *same = std::move(feature);
  } else if (features.size() >= k_most_corrected) {
    return base::Error{"200 features are corrected, which is all that a model has", "feature",
                       "take one back as it was found"};
  } else {
    features.push_back(std::move(feature));
  }
  return with_features(document, std::move(features), work);
}

/// The points in the direction in which the feature runs.
std::vector<mesh::MeshPoint> in_its_direction(const Document& document, const FeatureCurves& features,
                                              const std::string& name, std::vector<mesh::MeshPoint> points) {
  if (runs_backwards(*document.model, document.pose, features, name, positions_of(document, points)))
    std::reverse(points.begin(), points.end());
  return points;
}

/// The pose as it was before a drawing of a face was read; what was set since stays.
rig::Pose pose_before(const Document& document, const FaceDrawing& drawing) {
  rig::Pose pose = document.pose;
  const bool known =
      drawing.rig == document.model->rig && drawing.base.size() == pose.size() && drawing.posed.size() == pose.size();
  for (std::size_t p = 0; known && p < pose.size(); ++p) {
    if (pose[p] == drawing.posed[p]) pose[p] = drawing.base[p];
  }
  return pose;
}

/// A line of the face as it should be, which lay over the face as it was.
Changed face_line_is_feature(const Document& document, const LineIsFeature& command, Parts& work) {
  const FaceLine line = *find_face_line(document, command.curve);
  Document before = document;
  before.pose = pose_before(document, *document.face);
  auto drawn = drawn_on_surface(before, before.face->view, line.line, work);
  if (!drawn) return drawn.error();
  const FeatureCurves features = features_so_far(document, work);
  NamedCurve feature{command.feature, in_its_direction(before, features, command.feature, std::move(drawn->points))};
  FaceDrawing drawing = *document.face;
  std::erase_if(drawing.lines, [&](const FaceLine& one) { return one.id == command.curve; });
  Document changed = drawing.lines.empty() ? std::move(before) : document;
  changed.face = drawing.lines.empty() ? nullptr : std::make_shared<const FaceDrawing>(std::move(drawing));
  return with_feature(changed, std::move(feature), work);
}

}  // namespace

Changed run(const Document& document, const DrawFeature& command, Parts& work) {
  auto drawn = drawn_on_surface(document, command.view, command.line, work);
  if (!drawn) return drawn.error();
  const FeatureCurves features = features_so_far(document, work);
  std::string name = command.feature;
  if (name.empty()) {
    auto near = feature_near(*document.model, document.pose, features, positions_of(document, drawn->points));
    if (!near)
      return base::Error{"no feature runs there, or several do", "feature", "say which feature the line runs along"};
    name = *std::move(near);
  }
  return with_feature(document, {name, in_its_direction(document, features, name, std::move(drawn->points))}, work);
}

Changed run(const Document& document, const LineIsFeature& command, Parts& work) {
  if (find_face_line(document, command.curve) != nullptr) return face_line_is_feature(document, command, work);
  const PoseCurve* curve = find_curve(document, command.curve);
  if (curve == nullptr) return no_such_curve(command.curve);
  if (curve->points.size() < 2) return base::Error{"a point is no feature", "curve", "name a line"};
  auto points = in_its_direction(document, features_so_far(document, work), command.feature, curve->points);
  Document changed = document;
  std::erase_if(changed.curves, [&](const auto& one) { return one->id == command.curve; });
  return with_feature(changed, {command.feature, std::move(points)}, work);
}

Changed run(const Document& document, const PlaceFeature& command, Parts& work) {
  if (command.points.size() == 1)
    return base::Error{"a feature has two points or more", "points", "give others, or none: there is no such feature"};
  if (auto error = check_on_mesh(command.points, *document.model->mesh)) return *error;
  return with_feature(document, {command.feature, command.points}, work);
}

Changed run(const Document& document, const FeatureAsFound& command, Parts& work) {
  std::vector<NamedCurve> features = document.model->features;
  const auto erased = std::erase_if(
      features, [&](const NamedCurve& one) { return command.feature.empty() || one.name == command.feature; });
  if (erased == 0) return base::Error{"the feature was not corrected", "feature", "it is as it was found"};
  return with_features(document, std::move(features), work);
}

}  // namespace penpose::document
