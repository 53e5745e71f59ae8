#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/portrait/surface/face_surface.h"
#include "core/rig/rig.h"

namespace penpose::portrait {

/// One control at one end of its range.
struct Push {
  std::size_t control = 0;
  double value = 0;
};

/// How far a push moves each vertex, model units in the frame; vertices that were not asked for stay at 0.
class PushField {
 public:
  /// `vertices`: ascending, those that are asked for.
  PushField(const rig::Rig& rig, const FaceSurface& surface, std::span<const std::uint32_t> vertices);
  /// Moves to a push. Fields of one object replace each other.
  void set(const Push& push);
  [[nodiscard]] ModelVector of(std::uint32_t vertex) const { return ways_[vertex]; }
  [[nodiscard]] ModelVector of(const mesh::MeshPoint& point) const;

 private:
  const FaceSurface& surface_;
  rig::Pose rest_;
  std::vector<std::uint32_t> vertices_;
  std::unique_ptr<rig::BoundVertices> bound_;
  std::vector<ModelPoint> at_rest_, at_push_;
  std::vector<ModelVector> ways_;
};

/// Both ends of the range of the controls that move something within a box of the face's frame; ends at which a control
/// rests are left out.
[[nodiscard]] std::vector<Push> pushes_within(const rig::Rig& rig, const intent::WholeModel& whole,
                                              const FaceSurface& surface, const geometry::Box& box);

/// The vertices of the triangles that a picture's px show, ascending. From x0, y0 to x1, y1, every step-th px.
[[nodiscard]] std::vector<std::uint32_t> vertices_seen(const FaceSurface& surface, int x0, int y0, int x1, int y1);

}  // namespace penpose::portrait
