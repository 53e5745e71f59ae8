#pragma once

#include <string>
#include <vector>

#include "core/intent/solve.h"
#include "core/io/project/case_file.h"
#include "core/posing/solve.h"

namespace penpose::judges {

/// What the program made of a case.
struct Answer {
  rig::Pose pose;
  double ms = 0;
  std::string refused;  ///< why there is no pose
};

/// Solves cases as `penpose pose` does, all parameters free but those that the case locks.
class Solver {
 public:
  /// `file`: all cases of the set, whose curves say how large a picture the hand drew. Both outlive this.
  Solver(const document::Model& model, const io::CaseFile& file);
  /// What was meant (the default preset).
  [[nodiscard]] Answer meant(const io::PoseCase& one, io::TargetForm form);
  /// Other readings that are offered beside what was meant, the likeliest first.
  [[nodiscard]] std::vector<rig::Pose> others(const io::PoseCase& one, io::TargetForm form);
  /// The least sum of distances, vertex i to target i (the preset `exact`).
  [[nodiscard]] Answer exact(const io::PoseCase& one);

 private:
  const document::Model& model_;
  intent::WholeModel whole_;
  double hand_;
  intent::SolveWorkspace meant_work_;
  posing::SolveWorkspace exact_work_;
};

}  // namespace penpose::judges
