#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/model.h"
#include "core/geometry/bvh.h"
#include "core/posing/solve.h"
#include "ui/demo/expression_file.h"

namespace penpose::demo {

/// Points of each curve.
inline constexpr std::size_t k_expression_points = 32;

/// The surface of a model at rest, which strokes are projected onto.
[[nodiscard]] geometry::TriangleBvh rest_surface(const document::Model& model);

/// The problem that an expression states: each reference stroke is projected onto the surface at rest, each target
/// ordered, spaced and lifted as a pen's stroke is (method, section 1). All parameters are free and start at rest.
/// Errors (place "NAME, curve N"): a line that does not touch the model; those of pairing and of the camera.
[[nodiscard]] base::Result<posing::PoseProblem> problem_of_expression(const document::Model& model,
                                                                      const geometry::TriangleBvh& surface,
                                                                      const Expression& expression,
                                                                      geometry::Viewport viewport);

struct PosedExpression {
  std::string name;
  std::size_t curves = 0;
  posing::Solution solution;
  double solve_us = 0;  ///< the solve alone
};

/// Poses one expression from rest. Errors: those of problem_of_expression and of the solver.
[[nodiscard]] base::Result<PosedExpression> pose_expression(const document::Model& model,
                                                            const geometry::TriangleBvh& surface,
                                                            const Expression& expression, geometry::Viewport viewport,
                                                            posing::SolveWorkspace& work);

}  // namespace penpose::demo
