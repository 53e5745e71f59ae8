#include "core/document/features/feature_curves.h"

#include <algorithm>
#include <limits>

#include "core/curve/polyline.h"
#include "core/document/features/known_heads.h"
#include "core/document/features/model_paint.h"
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

/// How far a curve lies from another one, of its own length, in the mean.
double share_apart(const Places& one, const Places& other) {
  const auto some = curve::resample<geometry::ModelPoint>(one, 12),
             many = curve::resample<geometry::ModelPoint>(other, 60);
  if (!some || !many) return std::numeric_limits<double>::infinity();
  double sum = 0;
  for (const geometry::ModelPoint& p : *some) {
    double least = std::numeric_limits<double>::infinity();
    for (const geometry::ModelPoint& q : *many) least = std::min(least, geometry::distance(p, q));
    sum += least;
  }
  return sum / (static_cast<double>(some->size()) * curve::arc_length<geometry::ModelPoint>(one));
}

/// A curve that is looked for.
struct Sought {
  portrait::FeatureCurve curve;
  double sureness = 1;
};

/// Takes away those whose place named curves take: of the same name, else the one that lies upon a named one and is
/// nearest to it.
void take_named(std::vector<Sought>& sought, const std::vector<portrait::FeatureCurve>& named, const Places& rest) {
  constexpr double k_near = 0.08;
  for (const portrait::FeatureCurve& own : named) {
    auto taken = std::find_if(sought.begin(), sought.end(), [&](const Sought& one) {
      return one.curve.name == own.name || own.name + "_outer" == one.curve.name;
    });
    double least = k_near;
    for (auto one = sought.begin(); taken == sought.end() && one != sought.end(); ++one)
      least = std::min(least, share_apart(places_of(one->curve, rest), places_of(own, rest)));
    for (auto one = sought.begin(); taken == sought.end() && least < k_near && one != sought.end(); ++one) {
      if (share_apart(places_of(one->curve, rest), places_of(own, rest)) == least) taken = one;
    }
    if (taken != sought.end()) sought.erase(taken);
  }
}

/// Curves of the eyes, brows and lips are used even if they are unsure: every face has them.
bool is_of_every_face(const std::string& name) {
  return name.starts_with("eyelid_") || name.starts_with("brow_") || name.starts_with("lip_");
}
constexpr double k_least_sure = 0.1;

portrait::FeatureCurve feature_curve(const Model& model, const NamedCurve& curve) {
  portrait::FeatureCurve out{curve.name, {}};
  for (const mesh::MeshPoint& point : curve.points)
    out.points.push_back(posing::at_mesh_point(point, model.mesh->triangles()));
  return out;
}

/// Those that a model names, each as it was corrected, and those that somebody drew.
std::vector<portrait::FeatureCurve> named_curves(const Model& model) {
  std::vector<portrait::FeatureCurve> out;
  for (const NamedCurve& curve : model.curves) {
    const NamedCurve* corrected = find_correction(model, curve.name);
    portrait::FeatureCurve one = feature_curve(model, corrected != nullptr ? *corrected : curve);
    if (one.points.size() > 1) out.push_back(std::move(one));
  }
  for (const NamedCurve& curve : model.features) {
    const bool there = std::any_of(out.begin(), out.end(), [&](const auto& one) { return one.name == curve.name; });
    if (!there && curve.points.size() > 1) out.push_back(feature_curve(model, curve));
  }
  return out;
}

/// Whether somebody said that the face has no such feature.
bool is_none(const Model& model, const std::string& name) {
  const NamedCurve* corrected = find_correction(model, name);
  return corrected != nullptr && corrected->points.empty();
}

}  // namespace

const NamedCurve* find_correction(const Model& model, const std::string& name) {
  const auto found = std::find_if(model.features.begin(), model.features.end(),
                                  [&](const NamedCurve& one) { return one.name == name; });
  return found == model.features.end() ? nullptr : &*found;
}

base::Result<FeatureCurves> feature_curves_of(const Model& model, const intent::WholeModel& whole,
                                              const std::vector<VertexCurve>& named) {
  if (!named.empty()) return at_vertices(model, named);
  FeatureCurves out;
  out.curves = named_curves(model);
  Places rest(model.rig->vertex_count());
  model.rig->evaluate(rig::rest_pose(*model.rig), rest);
  const auto known = at_vertices(model, known_head_curves(model));
  if (!known) return known;
  std::vector<Sought> sought;
  for (const portrait::FeatureCurve& one : known->curves) sought.push_back({one});
  for (portrait::FoundCurve& one :
       portrait::find_features(*model.rig, *model.mesh, whole, model.front_yaw_degrees, paint_of(model))) {
    // Lists of known heads call the border of the lips plainly by its lip.
    const bool listed = std::any_of(known->curves.begin(), known->curves.end(), [&](const auto& other) {
      return other.name == one.curve.name || other.name + "_outer" == one.curve.name;
    });
    if (!listed) sought.push_back({std::move(one.curve), one.sureness});
  }
  take_named(sought, out.curves, rest);
  std::erase_if(sought, [&](const Sought& one) { return is_none(model, one.curve.name); });
  for (Sought& one : sought) {
    if (one.sureness < portrait::k_sure) {
      if (one.sureness < k_least_sure || !is_of_every_face(one.curve.name)) {
        out.unsure.push_back(std::move(one.curve));
        continue;
      }
      out.doubtful.push_back(one.curve.name);
    }
    const bool listed = std::any_of(known->curves.begin(), known->curves.end(),
                                    [&](const auto& other) { return other.name == one.curve.name; });
    out.found = out.found || !listed;
    out.curves.push_back(std::move(one.curve));
  }
  if (out.curves.empty()) {
    return base::Error{
        "no features of a face were found", "",
        "name them in a JSON file, {\"curves\": {NAME: {\"vertices\": [...]}}}, and pass it by --curves"};
  }
  return out;
}

}  // namespace penpose::document
