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

/// The morph targets of a mesh below one node, before and after.
struct MeshTargets {
  std::size_t mesh = 0;            ///< in the file that was read
  std::size_t read_node = 0;       ///< in the file that was read
  std::size_t node = 0;            ///< in the file that is written (PatchJoints::write_carrier)
  std::vector<std::size_t> parts;  ///< of the model
  std::size_t old_count = 0;
  std::vector<TargetColumn> columns;
  /// In the file that is written: a copy where other nodes keep the mesh as it is (PatchColumns).
  std::size_t written = 0;

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
  void add_new(const GlbWeights& weights, const std::vector<bool>& used);
  /// Names of targets that take a part of the weight of others and stay.
  [[nodiscard]] std::vector<OneWayName> one_way_names(const GlbWeights& weights) const;

  /// In the order of the model's parts.
  [[nodiscard]] std::vector<MeshTargets>& meshes() { return meshes_; }

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
};

}  // namespace penpose::io
