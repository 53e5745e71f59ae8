#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/document/model.h"
#include "core/geometry/bvh.h"
#include "core/geometry/camera.h"
#include "core/rig/surface_poser.h"
#include "ui/render/appearance.h"
#include "ui/render/framing.h"

namespace penpose::app {

/// The surface as it is shown: positions for drawing and for picking, kept up to date with what changes alone.
class PosedSurface {
 public:
  /// Takes another pose, and another model where it is one. True when anything changed.
  bool update(const std::shared_ptr<const document::Model>& model, std::span<const double> pose);

  [[nodiscard]] std::span<const glm::vec3> positions() const { return poser_->positions(); }
  [[nodiscard]] std::span<const glm::vec3> normals() const { return poser_->normals(); }
  [[nodiscard]] const document::Model& model() const { return *model_; }
  [[nodiscard]] const std::shared_ptr<const document::Model>& shared_model() const { return model_; }
  [[nodiscard]] const render::Appearance& appearance() const { return appearance_; }
  /// Soft shadows of this model from now on; null: none.
  void set_light(std::shared_ptr<const render::BakedLight> light);
  /// Where the vertices of a whole figure's face are now; empty: all of the model is the face (render::face_vertices).
  [[nodiscard]] std::vector<glm::vec3> face_positions() const;
  /// Numbers that change with the triangles and with the pose; never 0.
  [[nodiscard]] std::uint64_t shape_number() const { return shape_number_; }
  [[nodiscard]] std::uint64_t pose_number() const { return pose_number_; }
  /// Diagonal of the model at rest.
  [[nodiscard]] double size() const { return size_; }

  [[nodiscard]] glm::vec3 at(const mesh::MeshPoint& point) const;
  /// What is seen under a px position.
  [[nodiscard]] std::optional<geometry::RayHit> pick(const geometry::Camera& camera, geometry::PxPoint at);

 private:
  std::shared_ptr<const document::Model> model_;
  std::optional<rig::SurfacePoser> poser_;
  render::Appearance appearance_;
  std::vector<std::uint32_t> face_;
  std::optional<geometry::TriangleBvh> tree_;
  std::uint64_t tree_pose_ = 0;
  std::uint64_t shape_number_ = 0;
  std::uint64_t pose_number_ = 0;
  double size_ = 1;
};

}  // namespace penpose::app
