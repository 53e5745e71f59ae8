#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/mesh_point.h"
#include "core/rig/rig.h"

namespace penpose::posing {

using geometry::ModelPoint;

/// A point of a curve on the mesh: a weighted sum of up to three vertices (unused ones have weight 0).
struct CurvePoint {
  std::array<std::uint32_t, 3> vertex{0, 0, 0};
  std::array<double, 3> weight{1, 0, 0};
};

[[nodiscard]] CurvePoint at_vertex(std::uint32_t vertex);
/// Precondition: the point's triangle exists.
[[nodiscard]] CurvePoint at_mesh_point(const mesh::MeshPoint& point, std::span<const mesh::Triangle> triangles);

/// A reference curve and where each of its points should be.
struct CurvePair {
  std::vector<CurvePoint> reference;
  std::vector<ModelPoint> target;  ///< one a reference point
  std::vector<double> weights;     ///< w_i of the energy, >= 0; empty: all 1, which is the paper
};

/// A curve that should stay where it was when it was set.
struct Constraint {
  std::vector<CurvePoint> points;
  std::vector<ModelPoint> positions;  ///< one a point
};

/// What to solve (method, section 2): E(x) = sum w_i |r_i(x) - t_i| + sum |k_i(x) - k_i|, in model units.
struct PoseProblem {
  std::vector<CurvePair> pairs;
  std::vector<Constraint> constraints;
  std::vector<std::size_t> free;  ///< parameters that may move, ascending
  rig::Pose start;                ///< one value a parameter: where the search starts; other parameters keep it
};

/// Errors: nothing to match, another number of targets than of reference points, weights that are negative or all zero,
/// numbers that are not finite, vertices or parameters out of range, a start outside its ranges.
[[nodiscard]] base::Status check_problem(const rig::Rig& rig, const PoseProblem& problem);

/// Pen pressure (0..1, one a point) to weights of mean 1. All zero pressure gives all ones.
[[nodiscard]] std::vector<double> pressure_weights(std::span<const double> pressure);

}  // namespace penpose::posing
