#pragma once

#include <memory>
#include <numeric>
#include <span>
#include <vector>

#include "core/posing/problem.h"
#include "tests/support/models/test_rigs.h"

namespace penpose::tests {

/// A sheet of 30 x 30 cells over 0..1 x 0..1 with random shapes, and joints along x if asked for.
struct Sheet {
  std::shared_ptr<const mesh::TriangleMesh> mesh = grid_mesh(30, 30);
  std::shared_ptr<const rig::CharacterRig> rig;

  explicit Sheet(std::size_t shapes, std::uint64_t seed = 3, std::size_t joints = 0) {
    rig = rig::CharacterRig::make(
              mesh, {random_shapes(*mesh, shapes, seed)},
              joints == 0 ? nullptr : chain_skeleton(*mesh, joints, 1.0 / static_cast<double>(joints)))
              .value();
  }

  /// Vertices from..to of one row of the sheet, left to right.
  [[nodiscard]] static std::vector<posing::CurvePoint> row(std::uint32_t row, std::uint32_t from = 0,
                                                           std::uint32_t to = 30) {
    std::vector<posing::CurvePoint> points;
    for (std::uint32_t c = from; c <= to; ++c) points.push_back(posing::at_vertex(row * 31 + c));
    return points;
  }

  [[nodiscard]] std::vector<geometry::ModelPoint> at(std::span<const posing::CurvePoint> points,
                                                     const rig::Pose& pose) const {
    const auto all = all_positions(*rig, pose);
    std::vector<geometry::ModelPoint> places;
    for (const auto& p : points) {
      places.push_back(all[p.vertex[0]] * p.weight[0] + all[p.vertex[1]] * p.weight[1] +
                       all[p.vertex[2]] * p.weight[2]);
    }
    return places;
  }

  /// Five rows whose targets are where they lie at `answer`; everything may move, from rest.
  [[nodiscard]] posing::PoseProblem problem(const rig::Pose& answer) const {
    posing::PoseProblem problem;
    for (const std::uint32_t r : {3U, 9U, 15U, 21U, 27U}) problem.pairs.push_back({row(r), at(row(r), answer), {}});
    problem.start = rig::rest_pose(*rig);
    problem.free.resize(problem.start.size());
    std::iota(problem.free.begin(), problem.free.end(), std::size_t{0});
    return problem;
  }
};

}  // namespace penpose::tests
