#include "core/document/commands/list/placed_commands.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/document/commands/apply_parts.h"
#include "core/document/commands/text_form.h"

// Curves and targets of points that are known and not drawn.

namespace penpose::document {
namespace {

/// Barycentric coordinates may miss what they should be by so much.
constexpr double k_rounding = 1e-6;

bool is_on(const mesh::MeshPoint& point, const mesh::TriangleMesh& mesh) {
  if (point.triangle >= mesh.triangle_count()) return false;
  double sum = 0;
  for (const double share : point.barycentric) {
    if (!(share >= -k_rounding && share <= 1.0 + k_rounding)) return false;
    sum += share;
  }
  return std::abs(sum - 1.0) <= k_rounding;
}

base::Error wrong_point(std::size_t number, std::string what, std::string remedy) {
  return {std::move(what), "points/" + std::to_string(number), std::move(remedy)};
}

}  // namespace

std::optional<base::Error> check_on_mesh(std::span<const mesh::MeshPoint> points, const mesh::TriangleMesh& mesh) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_on(points[i], mesh)) continue;
    return wrong_point(
        i, "the point is not on the mesh",
        "give a triangle below " + std::to_string(mesh.triangle_count()) + " and three shares of 0 to 1 that sum to 1");
  }
  return std::nullopt;
}

Changed run(const Document& document, const PlaceCurve& command, Parts&) {
  if (command.points.empty() || command.points.size() > articulation::k_most_points)
    return base::Error{"a curve has at least one point and at most 100000", "points", "give others"};
  if (auto error = check_on_mesh(command.points, *document.model->mesh)) return *error;
  PoseCurve curve;
  curve.points = command.points;
  if (command.constraint) {
    curve.role = PoseCurveRole::constraint;
    curve.kept = positions_of(document, curve.points);
  }
  return with_curve(document, std::move(curve));
}

Changed run(const Document& document, const PlaceTarget& command, Parts&) {
  const auto curve = reference_named(document, command.curve, false);
  if (!curve) return curve.error();
  const std::size_t count = (*curve)->points.size();
  if (command.points.size() != count) {
    return base::Error{"the target has " + std::to_string(command.points.size()) + " points, the reference has " +
                           std::to_string(count),
                       "points", "give one point for each of the reference"};
  }
  for (std::size_t i = 0; i < count; ++i) {
    const geometry::ModelPoint& p = command.points[i];
    const double farthest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    if (std::isfinite(p.x + p.y + p.z) && farthest <= k_largest_number) continue;
    return wrong_point(i, "the point is nowhere", "give numbers that are finite and at most 1e15");
  }
  PoseCurve changed = **curve;
  changed.target.emplace();
  changed.target->points = command.points;
  changed.target->weights.assign(count, 1.0);
  return with_replaced(document, std::move(changed));
}

}  // namespace penpose::document
