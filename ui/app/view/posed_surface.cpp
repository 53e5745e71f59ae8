#include "ui/app/view/posed_surface.h"

namespace penpose::app {

bool PosedSurface::update(const std::shared_ptr<const document::Model>& model, std::span<const double> pose) {
  bool changed = false;
  if (model != model_) {
    const bool same_mesh = model_ && model_->mesh == model->mesh;
    const bool same_rig = model_ && model_->rig == model->rig;
    model_ = model;
    if (!same_rig) poser_.emplace(model->rig);
    if (!same_mesh) {
      appearance_ = render::make_appearance(*model);
      face_ = render::face_vertices(*model);
      size_ = document::rest_world_box(*model).diagonal();
      if (!(size_ > 0)) size_ = 1;
      tree_.reset();
      ++shape_number_;
    }
    changed = true;
  }
  if (poser_->update(pose)) changed = true;
  if (changed) ++pose_number_;
  return changed;
}

void PosedSurface::set_light(std::shared_ptr<const render::BakedLight> light) {
  if (light == appearance_.light) return;
  appearance_.light = std::move(light);
  ++shape_number_;
}

std::vector<glm::vec3> PosedSurface::face_positions() const {
  std::vector<glm::vec3> at;
  at.reserve(face_.size());
  for (const std::uint32_t v : face_) at.push_back(positions()[v]);
  return at;
}

glm::vec3 PosedSurface::at(const mesh::MeshPoint& point) const {
  const mesh::Triangle& corners = model_->mesh->triangles()[point.triangle];
  const auto p = positions();
  return p[corners[0]] * static_cast<float>(point.barycentric[0]) +
         p[corners[1]] * static_cast<float>(point.barycentric[1]) +
         p[corners[2]] * static_cast<float>(point.barycentric[2]);
}

std::optional<geometry::RayHit> PosedSurface::pick(const geometry::Camera& camera, geometry::PxPoint at) {
  if (!tree_) {
    tree_.emplace(positions(), model_->mesh->triangles());
  } else if (tree_pose_ != pose_number_) {
    tree_->refit(positions());
  }
  tree_pose_ = pose_number_;
  return tree_->nearest_hit(camera.ray(at));
}

}  // namespace penpose::app
