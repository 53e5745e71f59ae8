#pragma once

#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/json/json.h"
#include "core/base/result.h"
#include "core/document/model.h"

namespace penpose::io {

/// What glTF has no place for is kept in members "extras": {"penpose": {...}} (glTF 2.0, section 3.3.3): at the root of
/// the document with the edition, and at nodes.
inline constexpr const char* k_extras_key = "penpose";

/// Root: {"edition": base::k_edition, "shapes": [{"name", "rest", "minimum", "maximum"}], "curves": [{"name", "points":
/// [[triangle, b0, b1, b2], ...]}], "features": [the same, without points: there is none], "deformers": [a deformer as
/// sketch files have it, with its own "viewport", ...]}. Deformers are also morph targets of their names, sampled at
/// amount 1, after those of the shapes, and "baked":
/// [[NAME, ...], ...] names the targets with the remaining motion of each (baked_deformer.h). "corrections": [a
/// deformer with its "drivers", ...]. "expressions": [{"name", "values": {TARGET: VALUE}}], "front_yaw_degrees" and
/// "humanoid": {BONE: number of the joint} keep what a VRM avatar said where the file is none any more. A target that
/// takes a part of the weight of another.
struct OneWayName {
  std::string name;
  std::string target;
  double factor = 1;
};

struct RootExtras {
  bool present = false;
  /// Drawn under a newer edition, or none: what was sketched is not read, and stays the morph targets that it was baked
  /// to.
  bool of_another_edition = false;
  /// The older edition that it was drawn under: each control is read that today is built alike; 0: it is none.
  std::uint32_t older_edition = 0;
  std::vector<rig::Parameter> shapes;  ///< in the order of the rig
  std::vector<document::NamedCurve> curves;
  std::vector<document::NamedCurve> features;  ///< as they were corrected: members as those of "curves"
  std::vector<articulation::Sketch> deformers;
  std::vector<OneWayName> one_way;
  std::vector<articulation::CorrectionSketch> corrections;  ///< also morph targets of their names, behind "baked"
  /// "animation_order": numbers of animations of the file, in the order in which the model has them.
  std::vector<std::size_t> animation_order;
  std::vector<std::vector<std::string>> baked;  ///< one list a deformer: targets that only show it to other programs
};

/// "one_way": [[NAME, TARGET, 1 or -1], ...] names targets that take what goes above 1 or below 0 of the weight of
/// another (one_way_targets.h): the weight is the sum of theirs, turned round for -1. Animation: {"fps": F}, whose
/// frames its keys are.
///
/// Sampler of weights: {"added": [key, ...]}, keys that are there for other programs alone (dense_keys.h).
///
/// Node: {"joint": true, "posable": true, "rest_rotation": [x, y, z, w], "minimum": [x, y, z], "maximum": [x, y, z],
/// "values": [rx, ry, rz]} or {"carried_by_parent": true} or {"still": true} or
/// {"group": true}. A joint whose inverse bind matrix needs doubles also has "inverse_bind": 16 numbers by columns.
///
/// Mesh: {"copy_of": M}, a copy of mesh M with other targets for one of the nodes that shared it; its parts stand in
/// the place of M's.
struct NodeExtras {
  bool joint = false;              ///< the node is a joint, whether it moves anything or not
  bool carried_by_parent = false;  ///< the node is no joint: its mesh belongs to the node above
  bool still = false;              ///< vertices that follow this joint follow nothing
  bool group = false;              ///< the node only gathers joints below one root
  std::optional<bool> posable;
  std::optional<glm::dquat> rest_rotation;  ///< the node's own rotation holds the pose
  std::optional<glm::dvec3> minimum;        ///< radians
  std::optional<glm::dvec3> maximum;
  std::optional<glm::dmat4> inverse_bind;
  glm::dvec3 values{0};
};

/// Errors (place: JSON pointer): a member of another type, a range without room.
[[nodiscard]] base::Result<RootExtras> read_root_extras(const json::Json& document);
/// One entry a node; all empty when `root` is not present.
[[nodiscard]] base::Result<std::vector<NodeExtras>> read_node_extras(const json::Json& document,
                                                                     const RootExtras& root);
/// Errors: a curve point on a triangle that does not exist, or with coordinates that do not sum to one.
[[nodiscard]] base::Status check_curves(const RootExtras& root, std::size_t triangle_count);

/// `baked`: names of the targets that were made for each deformer beside its own. `project`: the member "project"
/// (core/io/project/internal/project_json.h), or null for a model alone.
[[nodiscard]] json::Json write_root_extras(const document::Model& model,
                                           const std::vector<std::vector<std::string>>& baked,
                                           const std::vector<OneWayName>& one_way, const json::Json& project);

}  // namespace penpose::io
