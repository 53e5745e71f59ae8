#include "core/document/commands/apply.h"

#include <algorithm>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include "core/base/text/utf8.h"
#include "core/document/commands/apply_parts.h"
#include "core/document/commands/command_visit.h"

namespace penpose::document {

ApplyWorkspace::ApplyWorkspace() : parts_(std::make_unique<ApplyParts>()) {}
ApplyWorkspace::~ApplyWorkspace() = default;
ApplyWorkspace::ApplyWorkspace(ApplyWorkspace&&) noexcept = default;
ApplyWorkspace& ApplyWorkspace::operator=(ApplyWorkspace&&) noexcept = default;

const geometry::TriangleBvh& ApplyParts::surface_of(const Document& document) {
  const Model& model = *document.model;
  if (tree_ && tree_mesh_ == model.mesh && tree_rig_ == model.rig && tree_pose_ == document.pose) return *tree_;
  std::vector<geometry::ModelPoint> posed(model.mesh->vertex_count());
  model.rig->evaluate(document.pose, posed);
  tree_positions_.assign(posed.begin(), posed.end());
  if (!tree_ || tree_mesh_ != model.mesh) {
    tree_ = std::make_unique<geometry::TriangleBvh>(tree_positions_, model.mesh->triangles());
  } else {
    tree_->refit(tree_positions_);
  }
  tree_mesh_ = model.mesh;
  tree_rig_ = model.rig;
  tree_pose_ = document.pose;
  return *tree_;
}

curve::Sheets& ApplyParts::sheets_of(const Document& document) {
  if (!sheets_ || sheets_mesh_ != document.model->mesh) {
    sheets_.emplace(*document.model->mesh);
    sheets_mesh_ = document.model->mesh;
  }
  return *sheets_;
}

const intent::WholeModel& ApplyParts::whole_of(const Document& document) {
  if (whole_rig_ != document.model->rig) {
    whole_ = intent::measure_whole_model(*document.model->rig);
    whole_rig_ = document.model->rig;
  }
  return whole_;
}

base::Result<std::shared_ptr<const articulation::Canvas>> ApplyParts::canvas_of(const Document& document) {
  const Model& model = *document.model;
  if (canvas_ && canvas_mesh_ == model.mesh && canvas_skeleton_ == model.skeleton) return canvas_;
  auto canvas = make_canvas(model);
  if (!canvas) return canvas;
  canvas_ = *canvas;
  canvas_mesh_ = model.mesh;
  canvas_skeleton_ = model.skeleton;
  return canvas;
}

namespace {

/// Names go into files that hold UTF-8 only, where two names that differ must not become one.
template <typename One>
std::optional<base::Error> check_texts(const One& command) {
  std::optional<base::Error> error;
  base::each_member(command, [&](std::string_view member, const auto& value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::string>) {
      if (base::valid_utf8(value) == value) return;
      error = base::Error{"the text is not valid UTF-8", std::string(member), "write it as UTF-8"};
    }
  });
  return error;
}

/// A curve is of the moment at which it, or its target, was drawn: over another pose it says nothing. A pose that is
/// keyed elsewhere than where it was drawn takes its curves along.
void keep_moments(const Document& before, bool keyed, Document& after) {
  const bool carried = keyed && after.time_s != before.time_s;
  if (!carried && after.curves == before.curves) return;
  for (auto& curve : after.curves) {
    const auto known =
        std::find_if(before.curves.begin(), before.curves.end(), [&](const auto& one) { return one->id == curve->id; });
    const bool drawn =
        known == before.curves.end() || (*known)->role != curve->role || (*known)->target != curve->target;
    const double time_s = drawn || (carried && curve->time_s == before.time_s) ? after.time_s : curve->time_s;
    if (time_s == curve->time_s) continue;
    PoseCurve moved = *curve;
    moved.time_s = time_s;
    curve = std::make_shared<const PoseCurve>(std::move(moved));
  }
}

}  // namespace

base::Error at(const char* member, base::Error error) {
  error.place = error.place.empty() ? member : std::string(member) + "/" + error.place;
  return error;
}

base::Result<Document> apply(const Document& document, const Command& command, ApplyWorkspace& work) {
  if (auto error = visit([](const auto& one) { return check_texts(one); }, command)) return *error;
  auto changed = visit([&](const auto& one) { return run(document, one, work.parts()); }, command);
  if (changed) keep_moments(document, command.holds<SetKey>(), *changed);
  return changed;
}

}  // namespace penpose::document
