#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/interface.h"
#include "core/rig/joint_followers.h"

namespace penpose::intent {

using geometry::ModelPoint;

/// Where one control takes the vertices that it may move; all others stay where they are, bit for bit.
struct ControlEffect {
  std::span<const std::uint32_t> vertices;  ///< ascending
  std::span<const ModelPoint> rest, moved;  ///< one a vertex
};

/// Evaluates single controls of a rig, all others at rest. A joint costs only the vertices that follow it. The object
/// holds scratch memory; the rig must outlive it.
class ControlEffects : public base::Fixed {
 public:
  explicit ControlEffects(const rig::Rig& rig);

  /// Returns the rest positions of all vertices.
  [[nodiscard]] std::span<const ModelPoint> rest() const { return rest_; }
  /// Returns the effect of a parameter at `value`. Its spans stay valid until the next call.
  [[nodiscard]] ControlEffect of(std::size_t parameter, double value);

 private:
  const rig::Rig& rig_;
  rig::Pose pose_;  ///< at rest between calls
  std::vector<std::uint32_t> all_;
  std::vector<ModelPoint> rest_, moved_;
  const rig::Skeleton* skeleton_ = nullptr;
  std::size_t first_angle_ = 0;  ///< the first parameter of the skeleton
  std::optional<rig::JointFollowers> followers_;
  std::optional<std::uint32_t> joint_;  ///< the one last asked for, and what follows it
  std::span<const std::uint32_t> following_;
  std::vector<ModelPoint> following_rest_;
};

}  // namespace penpose::intent
