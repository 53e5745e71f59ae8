#include "tests/judges/measures/solver.h"

#include <chrono>

#include "core/tracking/case_problem.h"

namespace penpose::judges {
namespace {

/// As many as the window offers.
constexpr std::size_t k_offered_at_most = 4;

Answer refused(const base::Error& error) {
  Answer answer;
  answer.refused = error.line();
  return answer;
}

template <typename Solve>
Answer timed(const Solve& solve) {
  Answer answer;
  const auto before = std::chrono::steady_clock::now();
  const auto solution = solve();
  answer.ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - before).count();
  if (!solution) return refused(solution.error());
  answer.pose = solution->pose;
  return answer;
}

}  // namespace

Solver::Solver(const document::Model& model, const io::CaseFile& file)
    : model_(model), whole_(intent::measure_whole_model(*model.rig)), hand_(tracking::hand_doubt(model, file)) {}

Answer Solver::meant(const io::PoseCase& one, io::TargetForm form) {
  const auto problem = tracking::intent_of_case(model_, one, tracking::FreeSet::all, form, hand_);
  if (!problem) return refused(problem.error());
  intent::SolveOptions options;
  return timed([&] { return intent::solve(*model_.rig, whole_, *problem, options, meant_work_); });
}

std::vector<rig::Pose> Solver::others(const io::PoseCase& one, io::TargetForm form) {
  const auto problem = tracking::intent_of_case(model_, one, tracking::FreeSet::all, form, hand_);
  std::vector<rig::Pose> poses;
  if (!problem) return poses;
  intent::SolveOptions options;
  options.others = k_offered_at_most;
  const auto solution = intent::solve(*model_.rig, whole_, *problem, options, meant_work_);
  if (!solution) return poses;
  for (const intent::OtherReading& other : solution->others) poses.push_back(other.pose);
  return poses;
}

Answer Solver::exact(const io::PoseCase& one) {
  const auto problem = tracking::problem_of_case(model_, one, tracking::FreeSet::all, io::TargetForm::points);
  if (!problem) return refused(problem.error());
  return timed([&] { return posing::solve(*model_.rig, *problem, {}, exact_work_); });
}

}  // namespace penpose::judges
