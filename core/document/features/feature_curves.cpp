#include "core/document/features/feature_curves.h"

#include <algorithm>
#include <limits>

#include "core/curve/polyline.h"
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

using Places = std::vector<geometry::ModelPoint>;

/// The points of a curve at rest.
Places places_of(const portrait::FeatureCurve& curve, const Places& rest) {
  Places out;
  for (const posing::CurvePoint& point : curve.points) {
    geometry::ModelPoint sum(0);
    for (std::size_t k = 0; k < point.vertex.size(); ++k) {
      if (point.weight[k] != 0.0) sum += rest[point.vertex[k]] * point.weight[k];
    }
    out.push_back(sum);
  }
  return out;
}

/// Whether a curve lies upon another one all along: the same feature under another name.
bool lies_upon(const Places& one, const Places& other) {
  constexpr double k_near = 0.08;  // of its length
  const auto finer = curve::resample<geometry::ModelPoint>(one, 12),
             along = curve::resample<geometry::ModelPoint>(other, 60);
  if (!finer || !along) return false;
  double sum = 0;
  for (const geometry::ModelPoint& p : *finer) {
    double least = std::numeric_limits<double>::infinity();
    for (const geometry::ModelPoint& q : *along) least = std::min(least, geometry::distance(p, q));
    sum += least;
  }
  return sum / static_cast<double>(finer->size()) < k_near * curve::arc_length<geometry::ModelPoint>(one);
}

/// Those that a model names.
std::vector<portrait::FeatureCurve> named_curves(const Model& model) {
  std::vector<portrait::FeatureCurve> out;
  for (const NamedCurve& curve : model.curves) {
    portrait::FeatureCurve one{curve.name, {}};
    for (const mesh::MeshPoint& point : curve.points)
      one.points.push_back(posing::at_mesh_point(point, model.mesh->triangles()));
    if (one.points.size() > 1) out.push_back(std::move(one));
  }
  return out;
}

}  // namespace

base::Result<FeatureCurves> feature_curves_of(const Model& model, const intent::WholeModel& whole,
                                              const std::vector<VertexCurve>& named) {
  if (!named.empty()) return at_vertices(model, named);
  FeatureCurves out;
  out.curves = named_curves(model);
  Places rest(model.rig->vertex_count());
  model.rig->evaluate(rig::rest_pose(*model.rig), rest);
  // Lists of known heads call the border of the lips plainly by its lip.
  const auto has = [&](const portrait::FeatureCurve& curve) {
    const Places there = places_of(curve, rest);
    return std::any_of(out.curves.begin(), out.curves.end(), [&](const portrait::FeatureCurve& one) {
      return one.name == curve.name || one.name + "_outer" == curve.name || lies_upon(there, places_of(one, rest));
    });
  };
  auto known = at_vertices(model, known_head_curves(model));
  if (!known) return known;
  for (portrait::FeatureCurve& one : known->curves) {
    if (!has(one)) out.curves.push_back(std::move(one));
  }
  for (portrait::FoundCurve& one : portrait::find_features(*model.rig, *model.mesh, whole, model.front_yaw_degrees)) {
    if (has(one.curve)) continue;
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
