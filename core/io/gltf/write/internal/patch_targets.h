#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/document/model.h"
#include "core/document/source_file.h"
#include "core/io/gltf/internal/gltf_extras.h"
#include "core/io/gltf/read/internal/gltf_document.h"
#include "core/io/gltf/write/glb_targets.h"
#include "core/io/gltf/write/internal/glb_weights.h"
#include "core/io/gltf/write/internal/gltf_builder.h"

namespace penpose::io {

/// A morph target of a mesh as the patched file has it.
struct TargetColumn {
  std::string name;
  std::optional<std::size_t> old;    ///< its number in the file that was read; none: new
  std::size_t target = k_no_target;  ///< of GlbWeights::targets
  bool fresh = false;                ///< its displacements are written
};

/// The morph targets of one mesh, before and after.
struct MeshTargets {
  std::size_t mesh = 0;
  std::vector<std::size_t> parts;  ///< of the model
  std::vector<std::size_t> nodes;  ///< of the scene, each once
  std::size_t old_count = 0;
  std::vector<TargetColumn> columns;

  /// Whether keys and weights of the file still fit.
  [[nodiscard]] bool same_columns() const;
  [[nodiscard]] bool same() const;
};

/// Finds what has to become of the morph targets of a file. All that is given outlives it.
class PatchTargets {
 public:
  PatchTargets(const document::Model& model, const GlbTargets& morphs, GltfDocument& document, const RootExtras& root);

  /// One a weight of the model: whether targets that were there for it go or move otherwise, so that keys that move it
  /// have to be found again.
  [[nodiscard]] const std::vector<bool>& reshaped() const { return reshaped_; }
  /// Whether the pose gives a control, by its number among the model's weights, another value than the file.
  [[nodiscard]] bool is_posed(std::size_t weight) const;
  /// Whether a shape of the model is as it was read.
  [[nodiscard]] bool is_same_shape(const rig::BlendShape& shape) const;
  /// Adds what the file does not have. `used`: one a target of morphs, whether its weight is written anywhere.
  /// Errors: nothing; `cannot` says why the file has no place for them.
  void add_new(const GlbWeights& weights, const std::vector<bool>& used);
  /// Names of targets that take a part of the weight of others and stay.
  [[nodiscard]] std::vector<OneWayName> one_way_names(const GlbWeights& weights) const;

  [[nodiscard]] std::vector<MeshTargets>& meshes() { return meshes_; }
  [[nodiscard]] const std::string& cannot() const { return cannot_; }

 private:
  void find_meshes();
  void match(MeshTargets& mesh);
  [[nodiscard]] bool says_the_same(const MeshTargets& mesh, std::size_t column, const rig::BlendShape& shape);
  void mark_reshaped(const std::string& target);
  [[nodiscard]] bool moves(const MeshTargets& mesh, const rig::BlendShape& shape) const;

  const document::Model& model_;
  const document::SourceFile& source_;
  const GlbTargets& morphs_;
  GltfDocument& document_;
  const RootExtras& root_;
  std::vector<MeshTargets> meshes_;
  std::map<std::string, std::size_t> wanted_;         ///< targets of morphs by name
  std::map<std::string, std::size_t> source_shapes_;  ///< blend shapes as they were read, by name
  std::map<std::string, const OneWayName*> helpers_;  ///< of the file, by their own names
  std::map<std::string, std::string> owners_;         ///< controls of targets that baking made, by their names
  std::vector<bool> reshaped_;
  std::string cannot_;
};

/// The entries of a shape that lie in a part, as first and one past the last.
[[nodiscard]] std::pair<std::size_t, std::size_t> entries_in(const rig::BlendShape& shape, const mesh::Part& part);

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
