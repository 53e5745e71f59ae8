#include "core/character/character.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/character/demo_head.h"
#include "core/curve/distance.h"
#include "core/document/commands/apply_parts.h"
#include "core/document/commands/command_check.h"
#include "core/document/features/drawing_start.h"
#include "core/drawing/tool.h"
#include "core/head/head.h"
#include "core/io/project/read_document.h"
#include "core/io/project/write_document.h"
#include "core/portrait/pose_from_drawing.h"

namespace penpose::character {
namespace {

using document::Command;

template <typename T>
std::vector<T> copied(std::span<const T> values) {
  return {values.begin(), values.end()};
}

base::Error no_curve(CurveId id) {
  return {"there is no curve " + std::to_string(id.value), "curve", "it may have been deleted or drawn anew"};
}

}  // namespace

Character::Character(document::Document document)
    : document_(std::move(document)), work_(std::make_unique<document::ApplyWorkspace>()) {}

base::Result<Character> Character::read(base::Bytes bytes, std::string_view file_name_hint) {
  auto document = io::read_document(bytes, file_name_hint);
  if (!document) return document.error();
  return Character(std::move(document).value());
}

base::Result<Character> Character::built_in(std::string_view name) {
  if (name == "builtin:head") return Character(document::make_document(head::make_head()));
  if (name != "builtin:demo") {
    return base::Error{"there is no built-in character of that name", "", "use builtin:head or builtin:demo"};
  }
  auto head = make_demo_head();
  if (!head) return head.error();
  return Character(document::make_document(std::move(head).value()));
}

base::Result<Character> Character::make(Pieces pieces) {
  auto mesh = mesh::TriangleMesh::build(std::move(pieces.mesh));
  if (!mesh) return mesh.error();
  std::shared_ptr<const rig::BlendShapes> shapes;
  if (!pieces.shapes.empty()) {
    auto made = rig::BlendShapes::make(std::move(pieces.shapes), (*mesh)->vertex_count());
    if (!made) return made.error();
    shapes = std::move(made).value();
  }
  std::shared_ptr<const rig::Skeleton> skeleton;
  if (!pieces.joints.empty()) {
    auto made =
        rig::Skeleton::make(std::move(pieces.joints), std::move(pieces.first_influence), std::move(pieces.influences));
    if (!made) return made.error();
    skeleton = std::move(made).value();
  }
  auto model = document::make_model(std::move(mesh).value(), std::move(shapes), std::move(skeleton));
  if (!model) return model.error();
  return Character(document::make_document(std::move(model).value()));
}

base::Status Character::perform(const Command& command) { return perform(std::span(&command, 1)); }

base::Status Character::perform(std::span<const Command> commands) {
  if (!work_) work_ = std::make_unique<document::ApplyWorkspace>();
  std::vector<document::Document> after;
  after.reserve(commands.size());
  for (const Command& command : commands) {
    if (auto fits = document::check_command(command); !fits) return fits;
    auto changed = document::apply(after.empty() ? document_ : after.back(), command, *work_);
    if (!changed) return changed.error();
    after.push_back(std::move(changed).value());
  }
  if (listener_) {
    if (auto heard = listener_(commands, after); !heard) return heard;
  }
  if (!after.empty()) document_ = std::move(after.back());
  return base::Done{};
}

base::Result<CurveId> Character::add(const Command& command) {
  if (auto done = perform(command); !done) return done.error();
  return CurveId{document_.last_curve};
}

base::Result<CurveId> Character::draw_reference(const View& view, std::span<const PxPoint> line) {
  return add(document::DrawReference{view, copied(line)});
}

base::Result<CurveId> Character::draw_constraint(const View& view, std::span<const PxPoint> line) {
  return add(document::DrawConstraint{view, copied(line)});
}

base::Result<CurveId> Character::place_reference(std::span<const mesh::MeshPoint> points) {
  return add(document::PlaceCurve{copied(points), false});
}

base::Result<CurveId> Character::place_constraint(std::span<const mesh::MeshPoint> points) {
  return add(document::PlaceCurve{copied(points), true});
}

base::Result<std::vector<mesh::MeshPoint>> Character::points_at(std::span<const std::uint32_t> vertices) const {
  const auto triangles = document_.model->mesh->triangles();
  std::vector<mesh::MeshPoint> points;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    std::size_t corner = 3;
    const auto found = std::find_if(triangles.begin(), triangles.end(), [&](const mesh::Triangle& one) {
      corner = static_cast<std::size_t>(std::find(one.begin(), one.end(), vertices[i]) - one.begin());
      return corner < 3;
    });
    if (found == triangles.end()) {
      return base::Error{"no triangle has vertex " + std::to_string(vertices[i]), "vertices/" + std::to_string(i),
                         "give a vertex of the surface; there are " + std::to_string(vertex_count())};
    }
    mesh::MeshPoint point{static_cast<std::uint32_t>(found - triangles.begin()), {0, 0, 0}};
    point.barycentric.at(corner) = 1.0;
    points.push_back(point);
  }
  return points;
}

base::Result<std::vector<mesh::MeshPoint>> Character::points_of(std::string_view named_curve) const {
  for (const document::NamedCurve& one : document_.model->curves) {
    if (one.name == named_curve) return one.points;
  }
  return base::Error{"the model has no curve \"" + std::string(named_curve) + "\"", "name",
                     "`penpose info` lists those that there are"};
}

base::Status Character::draw_target(CurveId curve, const View& view, std::span<const PxPoint> line,
                                    std::span<const double> pressure) {
  return perform(document::DrawTarget{curve, view, copied(line), copied(pressure)});
}

base::Status Character::place_target(CurveId curve, std::span<const ModelPoint> points) {
  return perform(document::PlaceTarget{curve, copied(points)});
}

base::Status Character::solve(Preset preset) { return perform(document::SolvePose{preset}); }

base::Result<DrawnFace> Character::draw_face(const portrait::Drawing& drawing, const std::optional<View>& view) {
  const intent::WholeModel& whole = whole_model();
  const rig::Rig& rig = *document_.model->rig;
  auto features = document::feature_curves_of(*document_.model, whole, {});
  if (!features) return features.error();
  const auto start = document::drawing_start(document_, whole, features->curves);
  const auto camera =
      view ? geometry::Camera::make(view->camera, view->viewport)
           : portrait::camera_of_drawing(rig, features->curves, start.pose, document_.model->front_yaw_degrees);
  if (!camera) return camera.error();
  auto posed = portrait::pose_from_drawing(rig, whole, features->curves, drawing, *camera, start.pose, start.free);
  if (!posed) return posed.error();
  if (auto done = set_pose(posed->pose); !done) return done.error();
  return DrawnFace{std::move(*features), std::move(posed->read)};
}

base::Status Character::sketch(const articulation::Sketch& sketch) {
  using articulation::CurveRole;
  const View view{sketch.camera, sketch.viewport};
  const auto seen_by = [&](const std::optional<geometry::CameraPose>& own) {
    return View{own.value_or(sketch.camera), sketch.viewport};
  };
  std::vector<Command> commands;
  commands.emplace_back(
      document::BeginDeformer{sketch.name, sketch.mode, sketch.surface, sketch.minimum, sketch.maximum});
  if (sketch.reach != articulation::Reach::through) commands.emplace_back(document::TakeRegion{sketch.reach, {}});
  commands.emplace_back(document::SketchCurve{CurveRole::general, view, sketch.general});
  if (sketch.piece != 0) commands.emplace_back(document::TakeRegion{{}, sketch.piece});
  commands.emplace_back(document::SketchCurve{CurveRole::specific, view, sketch.specific});
  if (!sketch.reference.empty()) {
    commands.emplace_back(
        document::SketchCurve{CurveRole::reference, seen_by(sketch.reference_camera), sketch.reference});
  }
  commands.emplace_back(document::SketchCurve{CurveRole::target, seen_by(sketch.target_camera), sketch.target});
  return perform(commands);
}

base::Status Character::set_pose(std::span<const double> values) {
  const auto known = parameters();
  if (values.size() != known.size()) {
    return base::Error{"the pose has " + std::to_string(values.size()) + " values, the character has " +
                           std::to_string(known.size()) + " parameters",
                       "values", "give one value a parameter"};
  }
  document::SetParameters set;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] != document_.pose[i]) set.values.push_back({known[i].name, values[i]});
  }
  if (set.values.empty()) return base::Done{};
  return perform(set);
}

void Character::evaluate(std::span<const double> pose, std::span<ModelPoint> positions) const {
  document_.model->rig->evaluate(pose, positions);
}

base::Result<std::vector<mesh::MeshPoint>> Character::points_of(CurveId curve) const {
  const document::PoseCurve* found = document::find_curve(document_, curve);
  if (found == nullptr) return no_curve(curve);
  return found->points;
}

base::Result<std::vector<ModelPoint>> Character::positions_of(CurveId curve) const {
  const document::PoseCurve* found = document::find_curve(document_, curve);
  if (found == nullptr) return no_curve(curve);
  return document::positions_of(document_, found->points);
}

base::Result<std::vector<double>> Character::distances_of(CurveId curve) const {
  const document::PoseCurve* found = document::find_curve(document_, curve);
  if (found == nullptr) return no_curve(curve);
  const bool constraint = found->role == document::PoseCurveRole::constraint;
  if (!constraint && !found->target) {
    return base::Error{"curve " + std::to_string(curve.value) + " has no target yet", "curve", "give it one first"};
  }
  const auto positions = document::positions_of(document_, found->points);
  std::vector<double> distances;
  if (constraint || found->target->line.empty()) {
    const auto& places = constraint ? found->kept : found->target->points;
    for (std::size_t i = 0; i < positions.size(); ++i) distances.push_back(geometry::distance(positions[i], places[i]));
    return distances;
  }
  const auto camera = geometry::Camera::make(found->target->view.camera, found->target->view.viewport);
  if (!camera) return camera.error();
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const ModelPoint drawn = found->aside.empty() ? positions[i] : positions[i] + found->aside[i];
    const auto px = camera->project(drawn);
    if (!px) return base::Error{"the curve lies behind the view of its target", "curve", "draw the target again"};
    distances.push_back(curve::distance_to(found->target->line, *px) * camera->units_per_px(camera->depth(drawn)));
  }
  return distances;
}

View Character::view_from(double yaw_degrees, double pitch_degrees, geometry::Viewport viewport) const {
  const auto camera = geometry::frame_box(rest_world_box(*document_.model), viewport, yaw_degrees, pitch_degrees);
  return {camera.pose(), camera.viewport()};
}

base::Result<std::vector<std::uint8_t>> Character::write(std::string_view file_name_hint) const {
  return io::write_document(document_, file_name_hint);
}

const intent::WholeModel& Character::whole_model() {
  if (!work_) work_ = std::make_unique<document::ApplyWorkspace>();
  return work_->parts().whole_of(document_);
}

void Character::forget_scratch() {
  work_.reset();
  hasher_ = {};
}

}  // namespace penpose::character
