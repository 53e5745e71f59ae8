#include "ui/demo/pose_expression.h"

#include <chrono>
#include <numeric>
#include <string>
#include <utility>

#include "core/curve/pairing.h"
#include "core/curve/projection.h"

namespace penpose::demo {
namespace {

base::Result<posing::CurvePair> pair_of(const document::Model& model, const geometry::TriangleBvh& surface,
                                        const DrawnPair& drawn, const geometry::CameraPose& seen_from,
                                        geometry::Viewport viewport) {
  const auto camera = geometry::Camera::make(seen_from, viewport);
  if (!camera) return camera.error();
  const auto reference = curve::surface_curve(drawn.reference, k_expression_points, *camera, surface);
  if (!reference) return reference.error();
  auto target = curve::pair_target(reference->positions, drawn.target, *camera);
  if (!target) return target.error();
  posing::CurvePair pair;
  for (const mesh::MeshPoint& point : reference->points) {
    pair.reference.push_back(posing::at_mesh_point(point, model.mesh->triangles()));
  }
  pair.target = std::move(target->points);
  return pair;
}

}  // namespace

geometry::TriangleBvh rest_surface(const document::Model& model) {
  std::vector<geometry::ModelPoint> rest(model.mesh->vertex_count());
  model.rig->evaluate(rig::rest_pose(*model.rig), rest);
  const std::vector<glm::vec3> positions(rest.begin(), rest.end());
  return {positions, model.mesh->triangles()};
}

base::Result<posing::PoseProblem> problem_of_expression(const document::Model& model,
                                                        const geometry::TriangleBvh& surface,
                                                        const Expression& expression, geometry::Viewport viewport) {
  posing::PoseProblem problem;
  problem.start = rig::rest_pose(*model.rig);
  problem.free.resize(problem.start.size());
  std::iota(problem.free.begin(), problem.free.end(), std::size_t{0});
  for (std::size_t i = 0; i < expression.curves.size(); ++i) {
    const DrawnPair& drawn = expression.curves[i];
    auto pair = pair_of(model, surface, drawn, drawn.camera.value_or(expression.camera), viewport);
    if (!pair) {
      base::Error error = pair.error();
      error.place = expression.name + ", curve " + std::to_string(i);
      return error;
    }
    problem.pairs.push_back(std::move(pair).value());
  }
  return problem;
}

base::Result<PosedExpression> pose_expression(const document::Model& model, const geometry::TriangleBvh& surface,
                                              const Expression& expression, geometry::Viewport viewport,
                                              posing::SolveWorkspace& work) {
  const auto problem = problem_of_expression(model, surface, expression, viewport);
  if (!problem) return problem.error();
  const auto before = std::chrono::steady_clock::now();
  auto solution = posing::solve(*model.rig, *problem, {}, work);
  const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - before;
  if (!solution) {
    base::Error error = solution.error();
    error.place = expression.name;
    return error;
  }
  return PosedExpression{expression.name, expression.curves.size(), std::move(solution).value(), took.count()};
}

}  // namespace penpose::demo
