#include "core/document/features/feature_curves.h"

#include <algorithm>

#include "core/document/features/known_heads.h"
#include "core/portrait/features/find_features.h"

namespace penpose::document {
namespace {

base::Result<FeatureCurves> at_vertices(const Model& model, const std::vector<VertexCurve>& named) {
  FeatureCurves out;
  for (const VertexCurve& curve : named) {
    portrait::FeatureCurve one{curve.name, {}};
    for (const std::uint32_t v : curve.vertices) {
      if (v >= model.mesh->vertex_count()) {
        return base::Error{"the model has no vertex " + std::to_string(v), "/curves/" + curve.name,
                           "name vertices below " + std::to_string(model.mesh->vertex_count())};
      }
      one.points.push_back(posing::at_vertex(v));
    }
    out.curves.push_back(std::move(one));
  }
  return out;
}

}  // namespace

base::Result<FeatureCurves> feature_curves_of(const Model& model, const intent::WholeModel& whole,
                                              const std::vector<VertexCurve>& named) {
  if (!named.empty()) return at_vertices(model, named);
  FeatureCurves out;
  for (const NamedCurve& curve : model.curves) {
    portrait::FeatureCurve one{curve.name, {}};
    for (const mesh::MeshPoint& point : curve.points)
      one.points.push_back(posing::at_mesh_point(point, model.mesh->triangles()));
    if (one.points.size() > 1) out.curves.push_back(std::move(one));
  }
  if (!out.curves.empty()) return out;
  auto known = at_vertices(model, known_head_curves(model));
  if (!known) return known;
  out = std::move(*known);
  // Lists of known heads call the border of the lips plainly by its lip.
  const auto has = [&](const std::string& name) {
    return std::any_of(out.curves.begin(), out.curves.end(), [&](const portrait::FeatureCurve& one) {
      return one.name == name || one.name + "_outer" == name;
    });
  };
  for (portrait::FoundCurve& one : portrait::find_features(*model.rig, *model.mesh, whole, model.front_yaw_degrees)) {
    if (has(one.curve.name)) continue;
    if (one.sureness >= portrait::k_sure) {
      out.curves.push_back(std::move(one.curve));
      out.found = true;
    } else {
      out.unsure.push_back(std::move(one.curve.name));
    }
  }
  if (out.curves.empty()) {
    return base::Error{
        "no features of a face were found", "",
        "name them in a JSON file, {\"curves\": {NAME: {\"vertices\": [...]}}}, and pass it by --curves"};
  }
  return out;
}

}  // namespace penpose::document
