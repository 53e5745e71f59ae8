#include "core/tracking/feature_curves.h"

#include "core/io/tracks/known_heads.h"
#include "core/portrait/features/find_features.h"

namespace penpose::tracking {
namespace {

base::Result<FeatureCurves> at_vertices(const document::Model& model, const std::vector<io::VertexCurve>& named) {
  FeatureCurves out;
  for (const io::VertexCurve& curve : named) {
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

base::Result<FeatureCurves> feature_curves_of(const document::Model& model, const intent::WholeModel& whole,
                                              const std::vector<io::VertexCurve>& named) {
  if (!named.empty()) return at_vertices(model, named);
  FeatureCurves out;
  for (const document::NamedCurve& curve : model.curves) {
    portrait::FeatureCurve one{curve.name, {}};
    for (const mesh::MeshPoint& point : curve.points)
      one.points.push_back(posing::at_mesh_point(point, model.mesh->triangles()));
    if (one.points.size() > 1) out.curves.push_back(std::move(one));
  }
  if (!out.curves.empty()) return out;
  if (const auto known = io::known_head_curves(model); !known.empty()) return at_vertices(model, known);
  out.found = true;
  for (portrait::FoundCurve& one : portrait::find_features(*model.rig, *model.mesh, whole, 0.0)) {
    if (one.sureness >= portrait::k_sure) {
      out.curves.push_back(std::move(one.curve));
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

}  // namespace penpose::tracking
