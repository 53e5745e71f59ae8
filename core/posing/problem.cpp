#include "core/posing/problem.h"

#include <cmath>

namespace penpose::posing {
namespace {

bool finite(const ModelPoint& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

base::Error at_curve(const char* what, const char* kind, std::size_t index, const char* remedy) {
  return {what, std::string(kind) + " " + std::to_string(index), remedy};
}

std::optional<base::Error> check_curve(const rig::Rig& rig, std::span<const CurvePoint> points,
                                       std::span<const ModelPoint> positions, const char* kind, std::size_t index) {
  if (points.size() != positions.size()) {
    return at_curve("has another number of positions than of points", kind, index, "give one position a point");
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!finite(positions[i])) return at_curve("has a position that is not finite", kind, index, "give plain numbers");
    for (std::size_t k = 0; k < 3; ++k) {
      if (points[i].vertex[k] >= rig.vertex_count())
        return at_curve("uses a vertex that does not exist", kind, index, "use vertices of this model");
      if (!std::isfinite(points[i].weight[k]))
        return at_curve("has a weight that is not finite", kind, index, "give plain numbers");
    }
  }
  return std::nullopt;
}

}  // namespace

CurvePoint at_vertex(std::uint32_t vertex) { return {{vertex, vertex, vertex}, {1, 0, 0}}; }

CurvePoint at_mesh_point(const mesh::MeshPoint& point, std::span<const mesh::Triangle> triangles) {
  return {triangles[point.triangle], point.barycentric};
}

base::Status check_problem(const rig::Rig& rig, const PoseProblem& problem) {
  std::size_t points = 0;
  for (std::size_t p = 0; p < problem.pairs.size(); ++p) {
    const CurvePair& pair = problem.pairs[p];
    if (auto error = check_curve(rig, pair.reference, pair.target, "reference", p)) return *error;
    points += pair.reference.size();
    if (pair.weights.empty()) continue;
    if (pair.weights.size() != pair.reference.size())
      return at_curve("has another number of weights than of points", "reference", p, "give one weight a point");
    double sum = 0;
    for (const double weight : pair.weights) {
      if (!(weight >= 0.0) || !std::isfinite(weight))
        return at_curve("has a weight that is negative or not finite", "reference", p, "give weights of 0 or more");
      sum += weight;
    }
    if (!(sum > 0.0)) return at_curve("has only weights of zero", "reference", p, "give at least one weight above 0");
  }
  if (points == 0)
    return base::Error{"there is no reference curve to match", "", "draw a reference and a target curve"};
  for (std::size_t c = 0; c < problem.constraints.size(); ++c) {
    if (auto error = check_curve(rig, problem.constraints[c].points, problem.constraints[c].positions, "constraint", c))
      return *error;
  }
  const auto parameters = rig.parameters();
  if (problem.start.size() != parameters.size())
    return base::Error{"the start has another number of values than the rig has parameters", "start",
                       "give one value a parameter"};
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!(problem.start[i] >= parameters[i].minimum && problem.start[i] <= parameters[i].maximum)) {
      return base::Error{"the start is outside its range", "parameter " + parameters[i].name, "start inside the range"};
    }
  }
  for (std::size_t i = 0; i < problem.free.size(); ++i) {
    if (problem.free[i] >= parameters.size())
      return base::Error{"a free parameter does not exist", "free " + std::to_string(i),
                         "use parameters of this model"};
    if (i > 0 && problem.free[i] <= problem.free[i - 1])
      return base::Error{"the free parameters are not ascending", "free " + std::to_string(i),
                         "sort them and name each once"};
  }
  return base::Done{};
}

std::vector<double> pressure_weights(std::span<const double> pressure) {
  double sum = 0;
  for (const double p : pressure) sum += p;
  std::vector<double> weights(pressure.begin(), pressure.end());
  for (double& w : weights) w = sum > 0.0 ? w * static_cast<double>(pressure.size()) / sum : 1.0;
  return weights;
}

}  // namespace penpose::posing
