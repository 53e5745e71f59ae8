// Posing end to end: a file of cases, from bytes to a pose, on a small model. Nothing in it may crash, hang or give a
// pose that is no pose.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/io/project/case_file.h"
#include "core/posing/solve.h"
#include "core/tracking/case_problem.h"
#include "tests/support/models/sheet_model.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace penpose;
  const auto file = io::read_cases({data, size});
  if (!file) return 0;
  static const document::Model k_model = tests::sheet_model();
  for (const auto form : {io::TargetForm::points, io::TargetForm::drawn}) {
    if (!io::check_cases(*file, k_model, form)) continue;
    for (const io::PoseCase& one : file->cases) {
      const auto problem = tracking::problem_of_case(k_model, one, tracking::FreeSet::of_case, form);
      if (!problem) continue;
      posing::SolveWorkspace work;
      const auto solution = posing::solve(*k_model.rig, *problem, {}, work);
      if (!solution) continue;
      for (std::size_t i = 0; i < solution->pose.size(); ++i) {
        const rig::Parameter& parameter = k_model.rig->parameters()[i];
        const double value = solution->pose[i];
        if (!(value >= parameter.minimum && value <= parameter.maximum)) std::abort();
      }
    }
  }
  return 0;
}
