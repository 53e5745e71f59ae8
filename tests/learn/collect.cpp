#include "tests/learn/collect.h"

#include <algorithm>

#include "core/intent/solve.h"
#include "core/tracking/case_problem.h"
#include "tests/judges/cases/gestures.h"
#include "tests/judges/cases/known_faces.h"
#include "tests/judges/cases/random_gestures.h"
#include "tests/judges/measures/gesture_judge.h"
#include "tests/judges/rigs/control_words.h"

namespace penpose::learn {
namespace {

using judges::Outcome;

/// Readings at most that a case keeps from earlier rounds.
constexpr std::size_t k_kept = 40;
/// Readings of a known face are right that are no farther off than the best by this, per cent of its movement.
constexpr double k_as_good = 10.0;
/// Known faces are more than gestures.
constexpr double k_weight_of_known = 0.4;
/// Lines that are drawn again where they are ask for nothing.
constexpr double k_weight_of_still = 2.0;
/// Lines that nothing is meant to follow: rarer here than among the faces that people have.
constexpr double k_weight_of_none = 8.0;
/// Gestures made by lot of a rig made by lot.
constexpr std::size_t k_random_gestures = 60;

/// Reads the cases of a rig.
class Reads {
 public:
  Reads(const document::Model& model, const io::CaseFile& file, const inference::Weights& weights)
      : model_(model), whole_(intent::measure_whole_model(*model.rig)), hand_(tracking::hand_doubt(model, file)) {
    options_.weights = &weights;
    options_.others = 2;
  }

  /// All readings that were found and those of earlier rounds. `allowed`: what may move in a reading that is right;
  /// empty: anything.
  std::vector<intent::ExplainedReading> read(const io::PoseCase& one, const std::vector<std::size_t>& allowed,
                                             std::vector<rig::Pose>& known) {
    auto problem = tracking::intent_of_case(model_, one, tracking::FreeSet::all, io::TargetForm::drawn, hand_);
    if (!problem) return {};
    std::vector<rig::Pose> also = known;
    if (!allowed.empty()) {
      intent::IntentProblem part = *problem;
      std::erase_if(part.free, [&](std::size_t p) { return !std::binary_search(allowed.begin(), allowed.end(), p); });
      if (auto solution = intent::solve(*model_.rig, whole_, part, options_, work_)) also.push_back(solution->pose);
    }
    auto readings = intent::explain(*model_.rig, whole_, *problem, options_, work_, also);
    if (!readings) return {};
    for (const intent::ExplainedReading& reading : *readings) {
      const auto same = [&](const rig::Pose& pose) { return same_controls(pose, reading.pose); };
      if (known.size() < k_kept && std::none_of(known.begin(), known.end(), same)) known.push_back(reading.pose);
    }
    return *readings;
  }

 private:
  [[nodiscard]] bool same_controls(const rig::Pose& a, const rig::Pose& b) const {
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double rest = model_.rig->parameters()[i].rest;
      if ((a[i] != rest) != (b[i] != rest)) return false;
    }
    return true;
  }

  const document::Model& model_;
  intent::WholeModel whole_;
  double hand_;
  intent::SolveOptions options_;
  intent::SolveWorkspace work_;
};

std::vector<std::size_t> parameters_of(const document::Model& model, const std::vector<std::string>& controls) {
  std::vector<std::size_t> out;
  const auto parameters = model.rig->parameters();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (judges::has(controls, judges::control_of(parameters[i].name))) out.push_back(i);
  }
  return out;
}

void collect_gestures(const Asked& asked, const inference::Weights& weights, KnownReadings& known,
                      std::vector<LearnCase>& out) {
  const auto& cases = asked.gestures;
  const io::CaseFile file = judges::file_of(cases);
  Reads reads(asked.model, file, weights);
  const judges::WholeFace face(asked.model, file);
  judges::GestureJudge judge(face);
  for (const judges::Gesture& gesture : cases) {
    std::vector<std::string> allowed = gesture.accepted;
    for (const auto& group : gesture.needed) allowed.insert(allowed.end(), group.begin(), group.end());
    LearnCase one;
    one.rig = asked.name;
    one.name = "gesture " + gesture.asked.name;
    if (gesture.still_is_right) one.weight = k_weight_of_none;
    for (const auto& reading : reads.read(gesture.asked, parameters_of(asked.model, allowed), known[one.name])) {
      Outcome outcome;
      judge.judge(gesture, reading.pose, outcome);
      one.candidates.push_back({reading.terms, outcome.right == 1.0, outcome.note});
    }
    out.push_back(std::move(one));
  }
}

void collect_known_faces(const Asked& asked, const inference::Weights& weights, KnownReadings& known,
                         std::vector<LearnCase>& out) {
  const auto& cases = asked.faces;
  const io::CaseFile file = judges::file_of(cases);
  Reads reads(asked.model, file, weights);
  const judges::WholeFace face(asked.model, file);
  for (const judges::KnownFace& one : cases) {
    // What nobody would show says nothing of what is meant.
    if (one.asked.name.starts_with("random")) continue;
    std::vector<std::size_t> allowed;
    for (std::size_t i = 0; i < one.truth.size(); ++i) {
      if (one.truth[i] != asked.model.rig->parameters()[i].rest) allowed.push_back(i);
    }
    LearnCase made;
    made.rig = asked.name;
    made.name = "known " + one.asked.name;
    made.weight = allowed.empty() ? k_weight_of_still : k_weight_of_known;
    const auto truth = face.moved(one.truth);
    std::vector<double> errors;
    for (const auto& reading : reads.read(one.asked, allowed, known[made.name])) {
      Outcome outcome;
      face.judge(truth, face.moved(reading.pose), outcome);
      const double error = outcome.error ? *outcome.error : 100.0 * outcome.still.value_or(0.0);
      errors.push_back(error);
      face.count_controls(reading.pose, outcome);
      made.candidates.push_back({reading.terms, false, outcome.note});
    }
    if (errors.empty()) continue;
    const double least = *std::min_element(errors.begin(), errors.end());
    // Where even the best is far off, nothing of it says what is right.
    if (least > 50.0) continue;
    for (std::size_t i = 0; i < errors.size(); ++i) made.candidates[i].right = errors[i] <= least + k_as_good;
    out.push_back(std::move(made));
  }
}

}  // namespace

std::vector<LearnCase> collect(const Asked& asked, const inference::Weights& weights, KnownReadings& known) {
  std::vector<LearnCase> out;
  collect_gestures(asked, weights, known, out);
  collect_known_faces(asked, weights, known, out);
  return out;
}

std::vector<LearnCase> collect(const judges::Rig& rig, const inference::Weights& weights, KnownReadings& known) {
  if (rig.lines.empty()) return {};
  const bool by_lot = rig.name.starts_with("random");
  return collect(
      {rig.name, rig.model,
       by_lot ? judges::random_gestures(rig, 1, k_random_gestures) : judges::gestures(rig, judges::Extent::whole),
       judges::known_faces(rig, judges::Extent::whole)},
      weights, known);
}

}  // namespace penpose::learn
