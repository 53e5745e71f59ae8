#include "ui/render/ghosts/ghost_faces.h"

#include <algorithm>
#include <utility>

namespace penpose::render {
namespace {

using geometry::ModelPoint;

/// Contours that are shorter say nothing, as a share of the view's height.
constexpr double k_least_contour = 0.02;

portrait::SurfaceLine surface_line(const document::Model& model, const std::vector<mesh::MeshPoint>& points) {
  portrait::SurfaceLine line;
  for (const mesh::MeshPoint& point : points) line.push_back(posing::at_mesh_point(point, model.mesh->triangles()));
  return line;
}

}  // namespace

void GhostFaces::forget() {
  if (!ghosts_.empty()) ++number_;
  ghosts_ = {};
  source_ = {};
  curves_ = {};
  tree_.reset();
  settled_ = true;
}

void GhostFaces::pose_all(const GhostSight& sight, const GhostLook& look) {
  const document::Document& document = sight.document;
  std::vector<Ghost> before = std::exchange(ghosts_, {});
  std::vector<ModelPoint> posed;
  for (const GhostMoment& moment : ghost_moments(*document.timeline, sight.time_s, sight.rate, look)) {
    rig::Pose pose = document::pose_at(document, moment.time_s);
    const auto same = std::find_if(before.begin(), before.end(),
                                   [&](const Ghost& one) { return !one.pose.empty() && one.pose == pose; });
    if (same != before.end()) {
      ghosts_.push_back(std::move(*same));
      same->pose.clear();
      ghosts_.back().moment = moment;
      continue;
    }
    posed.resize(document.model->rig->vertex_count());
    document.model->rig->evaluate(pose, posed);
    ++posed_;
    ghosts_.push_back({moment, std::move(pose), {posed.begin(), posed.end()}, {}});
  }
}

void GhostFaces::trace(Ghost& ghost, const GhostSight& sight, const geometry::Camera& camera) {
  ++traced_;
  ghost.lines.clear();
  const mesh::TriangleMesh& mesh = *sight.document.model->mesh;
  if (!tree_) {
    tree_.emplace(ghost.positions, mesh.triangles(), geometry::TriangleBvh::Build::quick);
  } else {
    tree_->refit(ghost.positions);
  }
  const std::vector<ModelPoint> positions(ghost.positions.begin(), ghost.positions.end());
  const auto add = [&](const portrait::SurfaceLine& line, const std::string& feature,
                       std::optional<document::CurveId> curve) {
    GhostLine made{feature, curve, {}, {}};
    for (const posing::CurvePoint& point : line) {
      const auto px = camera.project(portrait::place_of(point, positions));
      if (!px) continue;
      made.on.push_back(point);
      made.places.push_back(*px);
    }
    if (made.on.size() >= 2) ghost.lines.push_back(std::move(made));
  };
  const auto add_seen = [&](const portrait::SurfaceLine& line, const std::string& feature,
                            std::optional<document::CurveId> curve) {
    for (const auto& part : portrait::seen_parts(camera, line, positions, *tree_)) add(part, feature, curve);
  };
  for (const auto& line :
       portrait::silhouette(camera, mesh, positions, *tree_, k_least_contour * camera.viewport().height))
    add(line, {}, std::nullopt);
  for (const portrait::FeatureCurve& feature : sight.features) add_seen(feature.points, feature.name, std::nullopt);
  for (const auto& curve : sight.document.curves) {
    if (curve->role == document::PoseCurveRole::reference && curve->points.size() >= 2)
      add_seen(surface_line(*sight.document.model, curve->points), {}, curve->id);
  }
}

void GhostFaces::follow_view(const geometry::Camera& camera) {
  for (Ghost& ghost : ghosts_) {
    const std::vector<ModelPoint> positions(ghost.positions.begin(), ghost.positions.end());
    for (GhostLine& line : ghost.lines) {
      for (std::size_t i = 0; i < line.on.size(); ++i) {
        if (const auto px = camera.project(portrait::place_of(line.on[i], positions))) line.places[i] = *px;
      }
    }
  }
}

void GhostFaces::look_at(const GhostSight& sight, const GhostLook& look) {
  const document::Document& document = sight.document;
  Source now{document.model, document.timeline, document.pose, sight.time_s, sight.rate, look};
  if (now.model != source_.model) forget();
  const bool same_view = sight.view == view_;
  const bool same_lines = curves_ == document.curves && feature_count_ == sight.features.size();
  if (now == source_ && same_lines && same_view && settled_) return;
  ++number_;
  if (!(now == source_)) pose_all(sight, look);
  source_ = std::move(now);
  view_ = sight.view;
  curves_ = document.curves;
  feature_count_ = sight.features.size();
  const auto camera = geometry::Camera::make(sight.view.camera, sight.view.viewport);
  const bool anew = !same_lines || (same_view && !settled_);
  settled_ = same_view || anew;
  if (!camera) return;
  if (!same_view && !anew) follow_view(*camera);
  for (Ghost& ghost : ghosts_) {
    if (anew || ghost.lines.empty()) trace(ghost, sight, *camera);
  }
}

}  // namespace penpose::render
