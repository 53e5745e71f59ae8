#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/state_hash.h"
#include "core/document/model.h"

namespace penpose::document {

/// The glTF file that a model was read from, and where in it each thing came from: whoever saves the model changes this
/// file instead of writing another. Shared by all copies of the model and no part of its state hash.
struct SourceFile {
  /// A part of the mesh: primitives of one mesh that share their vertices, below one node.
  struct Part {
    std::size_t node = 0;
    std::size_t mesh = 0;
    std::vector<std::size_t> primitives;
    std::vector<std::string> targets;  ///< names of its morph targets as they were read, in the order of the file
  };
  /// An animation that became one of the model.
  struct AnimationFrom {
    std::size_t index = 0;  ///< in the file
    std::string name;
    base::Hash128 hash;  ///< of its channels
  };

  std::shared_ptr<const std::vector<std::uint8_t>> bytes;  ///< as they were read: .glb or .gltf
  std::map<std::string, std::vector<std::uint8_t>> files;  ///< that lie beside it, by their relative paths
  std::vector<Part> parts;                                 ///< one a part of the mesh
  std::vector<std::optional<std::size_t>> nodes;           ///< one a joint of the skeleton; none: a joint of no node
  std::vector<AnimationFrom> animations;                   ///< in the order of the model
  std::vector<std::string> weights;                        ///< names of blend shapes and sketched deformers
  std::map<std::string, double> pose;                      ///< values of all parameters by name, as they were read

  // What the model had when it was read; the same pointer means that it was not changed.
  std::shared_ptr<const mesh::TriangleMesh> mesh;
  std::shared_ptr<const rig::BlendShapes> shapes;
  std::shared_ptr<const rig::Skeleton> skeleton;
  std::shared_ptr<const articulation::SketchedDeformers> deformers;
  std::shared_ptr<const articulation::Corrections> corrections;
};

}  // namespace penpose::document
