#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/json/json.h"
#include "core/document/model.h"
#include "core/io/gltf/write/internal/gltf_builder.h"

namespace penpose::io {

/// The nodes of a file while it is written.
struct GlbNodes {
  std::vector<json::Json> nodes;
  json::Json scene = json::Json::array();  ///< numbers of those at the root
};

/// How the vertices of a part are bound to joints: to none, all to one, or by weights.
enum class Binding : std::uint8_t { free, rigid, skinned };

/// What a file says of a model's joints: their nodes, the skin, which of them carry each vertex. The model outlives it.
class GlbSkin {
 public:
  explicit GlbSkin(const document::Model& model);

  [[nodiscard]] Binding binding(std::size_t part) const { return bindings_[part]; }
  /// Joints are the first nodes, in their order, so that they come back in it.
  void write_joints(GlbNodes& out) const;
  /// One skin serves all parts. Its joints need a common root (glTF 2.0, section 5.28), so roots are gathered below a
  /// node that is no joint where there are several.
  void write_skin(GltfBuilder& builder, GlbNodes& out);
  /// Call it after write_skin, for a part that is skinned.
  void write_weights(const mesh::Part& part, GltfBuilder& builder, json::Json& attributes) const;

 private:
  [[nodiscard]] std::span<const rig::Joint> joints() const {
    return model_.skeleton ? model_.skeleton->joints() : std::span<const rig::Joint>();
  }
  [[nodiscard]] Binding binding_of(const mesh::Part& part) const;

  const document::Model& model_;
  std::vector<Binding> bindings_;
  std::vector<bool> in_skin_;
  std::vector<std::size_t> skin_place_;
  std::size_t still_place_ = 0;
  bool has_still_ = false;
};

}  // namespace penpose::io
