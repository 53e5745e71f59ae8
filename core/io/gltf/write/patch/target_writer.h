#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <vector>

#include "core/base/json/json.h"
#include "core/document/model.h"
#include "core/io/gltf/read/internal/gltf_document.h"
#include "core/io/gltf/write/internal/gltf_builder.h"

namespace penpose::io {

/// Writes displacements of positions, normals and tangents.
class TargetWriter {
 public:
  TargetWriter(const document::Model& model, GltfDocument& document, GltfBuilder& builder)
      : model_(model), document_(document), builder_(builder) {}

  /// The object of a target for the primitives of a part. `made`: for a sketched control, whose normals follow from its
  /// positions.
  [[nodiscard]] json::Json write(const rig::BlendShape& shape, bool made, std::size_t part);

 private:
  struct Turned {
    std::vector<std::uint32_t> vertices;
    std::vector<glm::dmat3> turns;
  };
  const Turned& turned_by(const rig::BlendShape& shape);

  const document::Model& model_;
  GltfDocument& document_;
  GltfBuilder& builder_;
  std::vector<glm::vec3> at_rest_;
  const rig::BlendShape* shape_ = nullptr;
  Turned turned_;  ///< by shape_
};

}  // namespace penpose::io
