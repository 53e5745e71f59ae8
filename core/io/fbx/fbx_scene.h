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
#include "core/io/fbx/tree/fbx_tree.h"

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
  const FbxRecord* usual = nullptr;  ///< the file's template of such objects; null: none
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

  /// A property of the file's settings or of an object, or of the file's template of such objects; `otherwise` where it
  /// is not said.
  [[nodiscard]] double setting(std::string_view name, double otherwise) const;
  [[nodiscard]] static double property(const FbxObject& object, std::string_view name, double otherwise);
  [[nodiscard]] static glm::dvec3 vector(const FbxObject& object, std::string_view name, glm::dvec3 otherwise);
  [[nodiscard]] double frames_per_second() const;
  [[nodiscard]] bool of_blender() const { return of_blender_; }

  /// From the file's axes and unit to +y up, +z to the front, metres.
  [[nodiscard]] glm::dmat4 to_world() const;

 private:
  const FbxRecord* settings_ = nullptr;
  std::vector<FbxObject> objects_;
  std::map<std::int64_t, std::size_t> number_;
  std::map<std::int64_t, std::vector<FbxConnection>> parts_, wholes_;
  bool of_blender_ = false;
};

/// Values of a node's transform: degrees and units of the file.
struct FbxTransform {
  glm::dvec3 translation{0}, rotation{0}, scaling{1};
};
/// A transform in parts that hold no shear.
struct FbxLocal {
  glm::dvec3 translation{0};
  glm::dmat3 rotation{1};
  glm::dvec3 scale{1};
  [[nodiscard]] glm::dmat4 matrix() const;
};
/// A node's order of rotations, 0 to 5: XYZ, XZY, YZX, YXZ, ZXY, ZYX; what is named first is turned first.
[[nodiscard]] int fbx_rotation_order(const FbxObject& node);
/// Between angles in degrees and the rotation that they are.
[[nodiscard]] glm::dmat3 fbx_rotation(const glm::dvec3& angles, int order);
[[nodiscard]] glm::dvec3 fbx_angles(const glm::dmat3& rotation, int order);

[[nodiscard]] glm::dquat fbx_turn(const glm::dmat3& rotation);

/// A node's T Roff Rp Rpre R Rpost^-1 Rp^-1 Soff Sp S Sp^-1, as Autodesk's SDK documents it ("Computing transformation
/// matrices").
class FbxNodeTransform {
 public:
  explicit FbxNodeTransform(const FbxObject& node);
  [[nodiscard]] const FbxTransform& still() const { return still_; }
  /// Returns true if a turn or a scale also moves the node.
  [[nodiscard]] bool has_pivots() const;
  [[nodiscard]] FbxLocal at(const FbxTransform& values) const;
  [[nodiscard]] FbxLocal local() const { return at(still_); }

 private:
  FbxTransform still_;
  int order_ = 0;
  glm::dmat3 before_{1}, after_{1};
  glm::dvec3 turn_offset_{0}, turn_pivot_{0}, scale_offset_{0}, scale_pivot_{0};
};
/// The transform of a node's own geometry, which its children do not take.
[[nodiscard]] glm::dmat4 geometric_matrix(const FbxObject& node);

}  // namespace penpose::io
