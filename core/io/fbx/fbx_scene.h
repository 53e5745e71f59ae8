#pragma once

#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/io/fbx/fbx_tree.h"

namespace penpose::io {

/// Nodes hang no deeper than this below each other.
inline constexpr std::size_t k_deepest_fbx_node = 1000;

/// An object of an FBX file: a node, a mesh, a deformer, a curve ...
struct FbxObject {
  std::int64_t id = 0;
  std::string name;
  std::string kind;  ///< "Model", "Geometry", "Deformer", ...
  std::string use;   ///< "Mesh", "LimbNode", "Shape", "Skin", "Cluster", ...
  const FbxRecord* record = nullptr;
};

struct FbxConnection {
  std::int64_t object = 0;
  std::string property;  ///< empty: the whole object
};

/// Objects and what they are connected to. The tree must outlive it.
class FbxScene {
 public:
  /// Errors: no objects.
  static base::Result<FbxScene> make(const FbxTree& tree);

  [[nodiscard]] const std::vector<FbxObject>& objects() const { return objects_; }
  [[nodiscard]] const FbxObject* object(std::int64_t id) const;
  /// What is connected to an object, of this kind and use (empty: any), in the order of the file.
  [[nodiscard]] std::vector<const FbxObject*> parts_of(std::int64_t id, std::string_view kind,
                                                       std::string_view use = {}) const;
  /// What an object is connected to.
  [[nodiscard]] const std::vector<FbxConnection>& wholes_of(std::int64_t id) const;
  /// What is connected to one property of an object; null: nothing.
  [[nodiscard]] const FbxObject* part_at(std::int64_t id, std::string_view property) const;
  /// The node that a node hangs below; null: none.
  [[nodiscard]] const FbxObject* parent_of(const FbxObject& node) const;

  /// A property of the file's settings or of an object; `otherwise` where it is not said.
  [[nodiscard]] double setting(std::string_view name, double otherwise) const;
  [[nodiscard]] static double property(const FbxObject& object, std::string_view name, double otherwise);
  [[nodiscard]] static glm::dvec3 vector(const FbxObject& object, std::string_view name, glm::dvec3 otherwise);

  /// From the file's axes and unit to +y up, +z to the front, metres.
  [[nodiscard]] glm::dmat4 to_world() const;

 private:
  const FbxRecord* settings_ = nullptr;
  std::vector<FbxObject> objects_;
  std::map<std::int64_t, std::size_t> number_;
  std::map<std::int64_t, std::vector<FbxConnection>> parts_, wholes_;
};

/// Values of a node's transform: degrees and units of the file.
struct FbxTransform {
  glm::dvec3 translation{0}, rotation{0}, scaling{1};
};
[[nodiscard]] FbxTransform transform_of(const FbxObject& node);
/// T Roff Rp Rpre R Rpost^-1 Rp^-1 Soff Sp S Sp^-1, as Autodesk's SDK documents it ("Computing transformation
/// matrices").
[[nodiscard]] glm::dmat4 local_matrix(const FbxObject& node, const FbxTransform& values);
/// The parts of a matrix without shear: translation, rotation of length one, scale (a mirror image has -x).
struct FbxLocal {
  glm::dvec3 translation{0};
  glm::dquat rotation{1, 0, 0, 0};
  glm::dvec3 scale{1};
};
[[nodiscard]] FbxLocal parts_of(const glm::dmat4& local);
/// The transform of a node's own geometry, which its children do not take.
[[nodiscard]] glm::dmat4 geometric_matrix(const FbxObject& node);

}  // namespace penpose::io
