#pragma once

#include <cstddef>
#include <map>

#include "core/base/json/json.h"
#include "core/io/gltf/write/patch/patch_state.h"

namespace penpose::io {

/// Gives the meshes of a file the morph targets that PatchTargets has found, and what goes with them: names where the
/// file has them, weights of meshes and nodes, columns of keys.
class PatchColumns {
 public:
  explicit PatchColumns(PatchState& state) : state_(state) {}

  void write();

 private:
  void give_own_mesh(MeshTargets& mesh);
  [[nodiscard]] bool is_made(std::size_t target, std::size_t shapes) const;
  json::Json still_target(const json::Json& primitive);
  void name_targets(const MeshTargets& mesh, json::Json& object);
  void fit_weights(const MeshTargets& mesh, json::Json& object);
  void fit_samplers(const MeshTargets& mesh);
  void fit_sampler(const MeshTargets& mesh, json::Json& sampler, std::map<std::size_t, std::size_t>& outputs);

  PatchState& state_;
};

}  // namespace penpose::io
