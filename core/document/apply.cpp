#include "core/document/apply.h"

#include <glm/vec3.hpp>
#include <utility>

#include "core/document/apply_parts.h"

namespace penpose::document {

ApplyWorkspace::ApplyWorkspace() : parts_(std::make_unique<Parts>()) {}
ApplyWorkspace::~ApplyWorkspace() = default;
ApplyWorkspace::ApplyWorkspace(ApplyWorkspace&&) noexcept = default;
ApplyWorkspace& ApplyWorkspace::operator=(ApplyWorkspace&&) noexcept = default;

const geometry::TriangleBvh& ApplyWorkspace::Parts::surface_of(const Document& document) {
  const Model& model = *document.model;
  if (tree_ && tree_mesh_ == model.mesh && tree_rig_ == model.rig && tree_pose_ == document.pose) return *tree_;
  std::vector<geometry::ModelPoint> posed(model.mesh->vertex_count());
  model.rig->evaluate(document.pose, posed);
  const std::vector<glm::vec3> positions(posed.begin(), posed.end());
  if (!tree_ || tree_mesh_ != model.mesh) {
    tree_ = std::make_unique<geometry::TriangleBvh>(positions, model.mesh->triangles());
  } else {
    tree_->refit(positions);
  }
  tree_mesh_ = model.mesh;
  tree_rig_ = model.rig;
  tree_pose_ = document.pose;
  return *tree_;
}

base::Result<std::shared_ptr<const articulation::Canvas>> ApplyWorkspace::Parts::canvas_of(const Document& document) {
  const Model& model = *document.model;
  if (canvas_ && canvas_mesh_ == model.mesh && canvas_skeleton_ == model.skeleton) return canvas_;
  auto canvas = make_canvas(model);
  if (!canvas) return canvas;
  canvas_ = *canvas;
  canvas_mesh_ = model.mesh;
  canvas_skeleton_ = model.skeleton;
  return canvas;
}

base::Error at(const char* member, base::Error error) {
  error.place = error.place.empty() ? member : std::string(member) + "/" + error.place;
  return error;
}

base::Result<Document> apply(const Document& document, const Command& command, ApplyWorkspace& work) {
  return std::visit([&](const auto& one) { return run(document, one, work.parts()); }, command);
}

}  // namespace penpose::document
