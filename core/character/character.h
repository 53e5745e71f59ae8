#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/document/commands/apply.h"
#include "core/document/commands/command.h"
#include "core/document/document.h"
#include "core/document/document_hash.h"
#include "core/document/features/feature_curves.h"
#include "core/intent/model/whole_model.h"
#include "core/io/model/write_model.h"
#include "core/portrait/read_drawing.h"

namespace penpose::character {

using document::CurveId;
using document::View;
using geometry::ModelPoint;
using geometry::PxPoint;

/// What a solve minimises. `meant`: what the window does, the squares of distances in widths of doubt plus what the
/// controls that move cost; `exact`: the sum of distances, to its least; `paper`: the same, by the single simplex of
/// 2006.
using document::Preset;

/// What a character is made of, when no file holds it.
struct Pieces {
  mesh::MeshSource mesh;
  std::vector<rig::BlendShape> shapes;         ///< may be empty
  std::vector<rig::Joint> joints;              ///< may be empty; then no influences either
  std::vector<std::uint32_t> first_influence;  ///< rig::Skeleton::make
  std::vector<rig::Influence> influences;
};

/// What a drawing of a whole face was taken for.
struct DrawnFace {
  document::FeatureCurves features;  ///< of the face, whether drawn or not
  portrait::DrawingRead read;        ///< its lines say which of features.curves they are
};

/// A character that a program poses: a document, with all that solving it keeps in memory. What it is asked for becomes
/// a command of the document, so that the window, a session and a program come to the same bits. On an error nothing
/// has changed. One thread at a time; a copy of the document costs a few hundred bytes.
class Character {
 public:
  explicit Character(document::Document document);

  /// A glTF, OBJ, PLY, OFF or STL file in memory, or a project. Errors: those of io::read_document.
  [[nodiscard]] static base::Result<Character> read(base::Bytes bytes, std::string_view file_name_hint = {});
  /// "builtin:head", the program's own head, which has nothing to pose yet, or "builtin:demo", the same with sketched
  /// controls.
  [[nodiscard]] static base::Result<Character> built_in(std::string_view name = "builtin:head");
  /// Errors: those of the mesh, the blend shapes, the skeleton and the rig.
  [[nodiscard]] static base::Result<Character> make(Pieces pieces);

  [[nodiscard]] const document::Document& document() const { return document_; }
  [[nodiscard]] std::span<const rig::Parameter> parameters() const { return document_.model->rig->parameters(); }
  [[nodiscard]] const rig::Pose& pose() const { return document_.pose; }
  [[nodiscard]] std::size_t vertex_count() const { return document_.model->mesh->vertex_count(); }

  /// Any command there is. Errors: those of document::apply.
  base::Status perform(const document::Command& command);
  /// All of them or, where one is refused, none.
  base::Status perform(std::span<const document::Command> commands);

  /// A curve drawn on the surface as it is posed, px of a view.
  [[nodiscard]] base::Result<CurveId> draw_reference(const View& view, std::span<const PxPoint> line);
  [[nodiscard]] base::Result<CurveId> draw_constraint(const View& view, std::span<const PxPoint> line);
  /// A curve of known points.
  [[nodiscard]] base::Result<CurveId> place_reference(std::span<const mesh::MeshPoint> points);
  [[nodiscard]] base::Result<CurveId> place_constraint(std::span<const mesh::MeshPoint> points);
  /// The points of the mesh that vertices are. Errors (place "vertices/N"): no such vertex, one that no triangle has.
  [[nodiscard]] base::Result<std::vector<mesh::MeshPoint>> points_at(std::span<const std::uint32_t> vertices) const;
  /// The points of a curve that has a name in the model. Errors: there is none.
  [[nodiscard]] base::Result<std::vector<mesh::MeshPoint>> points_of(std::string_view named_curve) const;

  /// Draws where a reference should go, and solves at once as the window does when the pen lifts. `pressure`: one a
  /// point, or none.
  base::Status draw_target(CurveId curve, const View& view, std::span<const PxPoint> line,
                           std::span<const double> pressure = {});
  /// Says where each point of a reference should go; `solve` brings it there.
  base::Status place_target(CurveId curve, std::span<const ModelPoint> points);
  /// Solves for all curves, from the pose as it is.
  base::Status solve(Preset preset = Preset::meant);
  /// Poses the face as a drawing of it shows, whose lines have no labels and lie anywhere on their sheet: controls
  /// start at rest, joints and what is locked where they are. `view`: from where the drawing sees the face, whose
  /// picture may be of any size; none: from far in front. Errors: those of document::feature_curves_of, Camera::make
  /// and portrait::pose_from_drawing.
  [[nodiscard]] base::Result<DrawnFace> draw_face(const portrait::Drawing& drawing,
                                                  const std::optional<View>& view = {});
  /// Sketches a deformer: a new parameter, drawn in four strokes. `paper` of the sketch is not read.
  base::Status sketch(const articulation::Sketch& sketch);

  /// Sets all parameters. Errors: another number of values than parameters, a value out of range.
  base::Status set_pose(std::span<const double> values);
  /// World positions of all vertices at a pose. Precondition: one value a parameter, one place a vertex.
  void evaluate(std::span<const double> pose, std::span<ModelPoint> positions) const;
  /// The points of the mesh that a curve is glued to. Errors: no such curve.
  [[nodiscard]] base::Result<std::vector<mesh::MeshPoint>> points_of(CurveId curve) const;
  /// Where the points of a curve are now.
  [[nodiscard]] base::Result<std::vector<ModelPoint>> positions_of(CurveId curve) const;
  /// How far each point of a curve is from where it should be, model units: from its place where that is known or kept,
  /// across the drawn line where it was drawn. Errors: no such curve, one without a target.
  [[nodiscard]] base::Result<std::vector<double>> distances_of(CurveId curve) const;
  /// A view of the whole character at rest (geometry::frame_box).
  [[nodiscard]] View view_from(double yaw_degrees, double pitch_degrees = 0, geometry::Viewport viewport = {}) const;

  [[nodiscard]] document::DocumentState state() { return hasher_(document_); }
  /// A project as .glb, which reads back with the same state, or another format that is written (io::model_formats).
  [[nodiscard]] base::Result<std::vector<std::uint8_t>> write(std::string_view file_name_hint = ".glb") const;

  /// Called with the commands that a call means and the document after each, before they count: what it throws, or an
  /// error, leaves the character as it was.
  using Listener =
      std::function<base::Status(std::span<const document::Command>, std::span<const document::Document> after)>;
  void listen(Listener listener) { listener_ = std::move(listener); }

  /// What solving the document needs of its rig; kept until the rig changes.
  [[nodiscard]] const intent::WholeModel& whole_model();
  /// Forgets what is kept in memory for the next solve: after an exception has come out of a call.
  void forget_scratch();

 private:
  [[nodiscard]] base::Result<CurveId> add(const document::Command& command);

  document::Document document_;
  std::unique_ptr<document::ApplyWorkspace> work_;
  document::DocumentHasher hasher_;
  Listener listener_;
};

}  // namespace penpose::character
