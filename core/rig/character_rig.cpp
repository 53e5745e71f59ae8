#include "core/rig/character_rig.h"

#include <algorithm>
#include <optional>
#include <set>

namespace penpose::rig {
namespace {

class BoundCharacter final : public BoundVertices {
 public:
  BoundCharacter(const CharacterRig& rig, std::span<const std::uint32_t> vertices)
      : rig_(rig), vertices_(vertices.begin(), vertices.end()), displacements_(vertices.size()) {
    for (const std::uint32_t v : vertices_) rest_.push_back(rig.mesh().positions()[v]);
    for (const auto& layer : rig.layers()) layers_.push_back(layer->bind(vertices_));
    if (rig.skeleton() != nullptr) {
      mark_carrying_joints();
      joints_.emplace(*rig.skeleton(), carries_);
      vertex_matrices_.resize(vertices_.size());
    }
  }

  [[nodiscard]] std::size_t vertex_count() const override { return vertices_.size(); }

  void evaluate(std::span<const double> pose, std::span<ModelPoint> positions) override {
    std::fill(displacements_.begin(), displacements_.end(), ModelVector{0});
    for (std::size_t i = 0; i < layers_.size(); ++i) layers_[i]->add(layer_values(pose, i), displacements_);
    for (std::size_t k = 0; k < vertices_.size(); ++k) positions[k] = rest_[k] + displacements_[k];
    if (rig_.skeleton() == nullptr) return;
    turn_joints(layer_values(pose, layers_.size()));
    for (std::size_t k = 0; k < vertices_.size(); ++k) positions[k] = carried(vertex_matrices_[k], positions[k]);
  }

  [[nodiscard]] bool moves(std::size_t parameter) const override {
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      if (rig_.layers()[i]->driven() && layers_[i]->moves(parameter)) return true;
    }
    const std::size_t layer = layer_of(parameter);
    if (layer < layers_.size()) return layers_[layer]->moves(parameter - rig_.first_parameter(layer));
    return carries_[rig_.skeleton()->joint_of(parameter - rig_.first_parameter(layer))];
  }

  [[nodiscard]] std::optional<LinearForm> linearize(std::span<const double> pose,
                                                    std::span<const std::size_t> free) override {
    const std::size_t n = vertices_.size();
    LinearForm form;
    Pose fixed(pose.begin(), pose.end());
    form.columns.resize(free.size() * n);
    for (std::size_t i = 0; i < free.size(); ++i) {
      const std::size_t layer = layer_of(free[i]);
      const std::span column = std::span(form.columns).subspan(i * n, n);
      for (std::size_t k = 0; k < layers_.size(); ++k) {
        if (rig_.layers()[k]->driven() && layers_[k]->moves(free[i])) return std::nullopt;
      }
      if (layer == layers_.size()) {
        if (moves(free[i])) return std::nullopt;
        continue;
      }
      if (!layers_[layer]->column(free[i] - rig_.first_parameter(layer), column)) return std::nullopt;
      fixed[free[i]] = 0.0;
    }
    form.constant.resize(n);
    evaluate(fixed, form.constant);
    if (rig_.skeleton() != nullptr) {
      // evaluate() left the matrices at this pose: a displaced vertex is turned by the linear part of its matrix.
      for (std::size_t k = 0; k < n; ++k) {
        const glm::dmat3 turn(vertex_matrices_[k]);
        for (std::size_t i = 0; i < free.size(); ++i) form.columns[i * n + k] = turn * form.columns[i * n + k];
      }
    }
    return form;
  }

 private:
  [[nodiscard]] std::size_t layer_of(std::size_t parameter) const {
    std::size_t layer = 0;
    while (layer < layers_.size() && parameter >= rig_.first_parameter(layer + 1)) ++layer;
    return layer;
  }
  [[nodiscard]] std::span<const double> layer_values(std::span<const double> pose, std::size_t layer) const {
    if (layer < layers_.size() && rig_.layers()[layer]->driven()) return pose;
    return pose.subspan(rig_.first_parameter(layer), rig_.first_parameter(layer + 1) - rig_.first_parameter(layer));
  }
  /// Fills the matrices; those that no turn changed stay.
  void turn_joints(std::span<const double> values) {
    if (turned_ && std::equal(values.begin(), values.end(), values_.begin(), values_.end())) return;
    values_.assign(values.begin(), values.end());
    joints_->turn(values);
    const Skeleton& skeleton = *rig_.skeleton();
    for (std::size_t k = 0; k < vertices_.size(); ++k) {
      const auto influences = skeleton.influences_of(vertices_[k]);
      const auto changed = [&](const Influence& influence) { return joints_->changed(influence.joint); };
      if (!turned_ || std::any_of(influences.begin(), influences.end(), changed))
        vertex_matrices_[k] = skeleton.vertex_matrix(vertices_[k], joints_->matrices());
    }
    turned_ = true;
  }
  /// A joint carries the bound vertices when it or a joint below it has a share in one of them.
  void mark_carrying_joints() {
    const auto joints = rig_.skeleton()->joints();
    carries_.assign(joints.size(), false);
    for (const std::uint32_t v : vertices_) {
      for (const Influence& influence : rig_.skeleton()->influences_of(v)) {
        if (influence.weight > 0.0) carries_[influence.joint] = true;
      }
    }
    for (std::size_t i = joints.size(); i-- > 0;) {
      if (carries_[i] && joints[i].parent >= 0) carries_[static_cast<std::size_t>(joints[i].parent)] = true;
    }
  }

  const CharacterRig& rig_;
  std::vector<std::uint32_t> vertices_;
  std::vector<ModelPoint> rest_;
  std::vector<std::unique_ptr<BoundLayer>> layers_;
  std::vector<ModelVector> displacements_;
  std::vector<bool> carries_;
  std::optional<PosedJoints> joints_;  ///< those that carry
  bool turned_ = false;
  std::vector<double> values_;  ///< of the joints at the last turn
  std::vector<glm::dmat4> vertex_matrices_;
};

}  // namespace

base::Result<std::shared_ptr<const CharacterRig>> CharacterRig::make(
    std::shared_ptr<const mesh::TriangleMesh> mesh, std::vector<std::shared_ptr<const DisplacementLayer>> layers,
    std::shared_ptr<const Skeleton> skeleton) {
  if (skeleton && skeleton->vertex_count() != mesh->vertex_count()) {
    return base::Error{"the skeleton is for another number of vertices", "", "bind the skeleton to this mesh"};
  }
  auto made = std::make_shared<CharacterRig>();
  const auto append = [&](std::span<const Parameter> parameters) {
    made->first_parameter_.push_back(made->parameters_.size());
    made->parameters_.insert(made->parameters_.end(), parameters.begin(), parameters.end());
  };
  for (const auto& layer : layers) append(layer->parameters());
  append(skeleton ? skeleton->parameters() : std::span<const Parameter>{});
  made->first_parameter_.push_back(made->parameters_.size());
  std::set<std::string_view> names;
  for (const Parameter& parameter : made->parameters_) {
    if (!names.insert(parameter.name).second) {
      return base::Error{"two parameters have this name", "parameter " + parameter.name, "rename one of them"};
    }
  }
  made->mesh_ = std::move(mesh);
  made->layers_ = std::move(layers);
  made->skeleton_ = std::move(skeleton);
  return std::shared_ptr<const CharacterRig>(std::move(made));
}

void CharacterRig::displace(std::span<const double> pose, std::span<ModelPoint> positions) const {
  std::fill(positions.begin(), positions.end(), ModelVector{0});
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    const std::size_t own = first_parameter_[i + 1] - first_parameter_[i];
    layers_[i]->add(layers_[i]->driven() ? pose : pose.subspan(first_parameter_[i], own), positions);
  }
  const auto rest = mesh_->positions();
  for (std::size_t v = 0; v < positions.size(); ++v) positions[v] = rest[v] + positions[v];
}

void CharacterRig::evaluate(std::span<const double> pose, std::span<ModelPoint> positions) const {
  displace(pose, positions);
  if (!skeleton_) return;
  std::vector<glm::dmat4> matrices(skeleton_->joints().size());
  skeleton_->joint_matrices(pose.subspan(first_parameter_[layers_.size()]), matrices);
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    positions[v] = carried(skeleton_->vertex_matrix(v, matrices), positions[v]);
  }
}

std::unique_ptr<BoundVertices> CharacterRig::bind(std::span<const std::uint32_t> vertices) const {
  return std::make_unique<BoundCharacter>(*this, vertices);
}

}  // namespace penpose::rig
