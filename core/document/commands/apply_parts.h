#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/articulation/region/canvas.h"
#include "core/curve/projection.h"
#include "core/curve/sheets.h"
#include "core/document/commands/apply.h"
#include "core/document/commands/command.h"
#include "core/document/document.h"
#include "core/document/drawing/face_reader.h"
#include "core/geometry/bvh.h"
#include "core/intent/solve.h"
#include "core/posing/solve.h"

// What the application of single commands has in common.

namespace penpose::document {

struct ApplyParts {
  posing::SolveWorkspace solve;
  intent::SolveWorkspace meant;
  FaceReader face;

  /// What the controls of the document's rig do to the whole model.
  const intent::WholeModel& whole_of(const Document& document);

  /// The search tree over the surface as the document is posed.
  const geometry::TriangleBvh& surface_of(const Document& document);
  /// All vertices as the last surface_of posed them.
  [[nodiscard]] std::span<const glm::vec3> surface_positions() const { return tree_positions_; }
  /// Which triangles of the document's mesh lie beside each other.
  curve::Sheets& sheets_of(const Document& document);
  /// What strokes of deformers are drawn on.
  base::Result<std::shared_ptr<const articulation::Canvas>> canvas_of(const Document& document);

 private:
  std::shared_ptr<const rig::CharacterRig> whole_rig_;
  intent::WholeModel whole_;
  std::shared_ptr<const mesh::TriangleMesh> tree_mesh_;
  std::shared_ptr<const rig::CharacterRig> tree_rig_;
  rig::Pose tree_pose_;
  std::vector<glm::vec3> tree_positions_;
  std::unique_ptr<geometry::TriangleBvh> tree_;
  std::shared_ptr<const mesh::TriangleMesh> sheets_mesh_;
  std::optional<curve::Sheets> sheets_;
  std::shared_ptr<const mesh::TriangleMesh> canvas_mesh_;
  std::shared_ptr<const rig::Skeleton> canvas_skeleton_;
  std::shared_ptr<const articulation::Canvas> canvas_;
};

using Parts = ApplyParts;

/// The error with a member of the command as its place.
[[nodiscard]] base::Error at(const char* member, base::Error error);

/// The numbers of parameters, by name. Errors (place: the member, "names"): the model has none of that name.
[[nodiscard]] base::Result<std::size_t> number_of(const Document& document, const std::string& name,
                                                  const char* member);
[[nodiscard]] base::Result<std::vector<std::size_t>> numbers_of(const Document& document,
                                                                const std::vector<std::string>& names);

/// Takes the first that is called so out of a list; false where none is.
[[nodiscard]] bool erase_named(auto& list, const std::string& name) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const auto& one) { return one->name == name; });
  if (found == list.end()) return false;
  list.erase(found);
  return true;
}

/// Errors: the value is none of the parameter's.
[[nodiscard]] std::optional<base::Error> out_of_range(const rig::Parameter& parameter, double value);

/// The document with other sketched deformers; poses are kept by the names of parameters, and what is locked by names
/// that are still there.
[[nodiscard]] Changed with_deformers(const Document& document,
                                     std::shared_ptr<const articulation::SketchedDeformers> deformers);

/// Projects a line onto the surface as the document is posed. Errors (place: the member): the view is not valid; the
/// line does not lie on the surface.
[[nodiscard]] base::Result<curve::ProjectedStroke> drawn_on_surface(const Document& document, const View& view,
                                                                    const std::vector<PxPoint>& line, Parts& work);
/// The error that there is no curve of that number.
[[nodiscard]] base::Error no_such_curve(CurveId id);
/// Errors (place: "points/N"): a point that is not on the mesh.
[[nodiscard]] std::optional<base::Error> check_on_mesh(std::span<const mesh::MeshPoint> points,
                                                       const mesh::TriangleMesh& mesh);

/// The document with one curve more, which gets the next number. Errors: all numbers are used up.
[[nodiscard]] Changed with_curve(const Document& document, PoseCurve curve);
/// The document with this drawing of the face read, and the pose that it asks for; without lines there is none, and the
/// pose stays.
[[nodiscard]] Changed with_face_read(const Document& document, FaceDrawing drawing, Parts& work);
/// The document with a curve in place of the one of the same number.
[[nodiscard]] Document with_replaced(const Document& document, PoseCurve curve);
/// Errors: no such curve, a constraint; with `with_line` one that has no drawn target.
[[nodiscard]] base::Result<const PoseCurve*> reference_named(const Document& document, CurveId id, bool with_line);

}  // namespace penpose::document
