#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/geometry/space.h"
#include "core/intent/model/whole_model.h"
#include "core/mesh/triangle_mesh.h"

namespace penpose::portrait {

using geometry::ModelPoint;
using geometry::ModelVector;

/// Directions of a face: x to its own left, y up, z where it looks; x = 0 is its plane of symmetry.
struct FaceFrame {
  ModelPoint origin{0};
  ModelVector left{1, 0, 0}, up{0, 1, 0}, front{0, 0, 1};

  [[nodiscard]] ModelPoint local(const ModelPoint& p) const;
  [[nodiscard]] ModelVector turned(const ModelVector& v) const;  ///< a direction into the frame
};

/// Where a face is, model units in its frame.
struct FacePlace {
  FaceFrame frame;
  geometry::Box box;    ///< of what shapes move, or of the whole model where none move anything
  double mirrored = 0;  ///< how sure the plane of symmetry is, 0..1
  bool of_shapes = false;
};

/// How far shapes move each sample of the model (ControlFields::samples), all together.
[[nodiscard]] std::vector<double> moved_by_shapes(const intent::WholeModel& whole);

/// Finds the plane of symmetry near the one that `front_yaw_degrees` (about +y, 0: +z) means: between controls that do
/// the same on both sides, or where there are none, the one that mirrors the surface best. Nothing for a model without
/// extent.
[[nodiscard]] std::optional<FacePlace> place_face(const mesh::TriangleMesh& mesh, const intent::WholeModel& whole,
                                                  double front_yaw_degrees);

}  // namespace penpose::portrait
