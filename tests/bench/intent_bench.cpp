// Posing for what was meant: the time of a solve and of a live step with 53 and with 530 controls, on an avatar of
// shapes and joints (also with a line on each of its curves at once) and on a skeleton, beside NLopt's Subplex on the
// same energy (matching as penpose's own answer leaves it). One core.

#include <algorithm>
#include <array>
#include <benchmark/benchmark.h>
#include <chrono>
#include <cstdio>
#include <map>
#include <nlopt.hpp>

#include "core/intent/live.h"
#include "core/intent/reading/reader.h"
#include "core/intent/solve.h"
#include "core/io/model/read_model.h"
#include "core/io/project/case_file.h"
#include "core/tracking/case_problem.h"
#include "tests/support/shared_data.h"

namespace {

using namespace penpose;

struct Subject {
  document::Model model;
  io::CaseFile cases;
  intent::WholeModel whole;
  double hand = 0;

  Subject(const char* file, const char* case_file) {
    const auto meshes = tests::shared_dir() / "meshes";
    model = io::read_model(tests::read_file(meshes / file), file).value();
    cases = io::read_cases(tests::read_file(meshes / case_file)).value();
    finish();
  }
  void finish() {
    whole = intent::measure_whole_model(*model.rig);
    hand = tracking::hand_doubt(model, cases);
  }
  [[nodiscard]] intent::IntentProblem problem(std::size_t index) const {
    return tracking::intent_of_case(model, cases.cases[index], tracking::FreeSet::all, io::TargetForm::drawn, hand)
        .value();
  }
};

/// The face's controls ten times over, each time smaller.
Subject tenfold(Subject face) {
  const auto* shapes = dynamic_cast<const rig::BlendShapes*>(face.model.rig->layers().front().get());
  std::vector<rig::BlendShape> all;
  for (int copy = 0; copy < 10; ++copy) {
    for (rig::BlendShape shape : shapes->shapes()) {
      const float scale = 1.0F - 0.07F * static_cast<float>(copy);
      shape.parameter.name.append("#").append(std::to_string(copy));
      for (auto& delta : shape.deltas) delta *= scale;
      all.push_back(std::move(shape));
    }
  }
  auto layer = rig::BlendShapes::make(std::move(all), face.model.mesh->vertex_count()).value();
  face.model.rig = rig::CharacterRig::make(face.model.mesh, {layer}, nullptr).value();
  face.finish();
  return face;
}

/// One more case: a line on every curve of the others at once.
Subject with_all_lines(Subject subject) {
  io::PoseCase all = subject.cases.cases.front();
  all.name = "all lines";
  all.references.clear();
  for (const io::PoseCase& one : subject.cases.cases) {
    if (one.view_yaw_degrees != all.view_yaw_degrees) continue;
    for (const io::CaseReference& reference : one.references) {
      const bool known = std::any_of(all.references.begin(), all.references.end(), [&](const io::CaseReference& other) {
        return other.vertices == reference.vertices;
      });
      if (!known) all.references.push_back(reference);
    }
  }
  subject.cases.cases.push_back(std::move(all));
  return subject;
}

const Subject& subject(int number) {
  static const Subject face("ict_face.glb", "ict_face_intent_cases.json");
  static const Subject avatar = with_all_lines({"ict_avatar.glb", "ict_avatar_intent_cases.json"});
  static const Subject many = tenfold(face);
  static const Subject body("cesium_man.glb", "cesium_body_cases.json");
  const std::array<const Subject*, 4> all{&face, &many, &body, &avatar};
  return *all[static_cast<std::size_t>(number)];
}

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

double since_us(std::chrono::steady_clock::time_point before) {
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - before).count();
}

std::map<std::string, std::vector<double>>& table() {
  static std::map<std::string, std::vector<double>> rows;
  return rows;
}

void solve(benchmark::State& state, int number, std::size_t index, const std::string& row) {
  const auto problem = subject(number).problem(index);
  intent::SolveWorkspace work;
  std::vector<double> times;
  for (auto _ : state) {
    const auto before = std::chrono::steady_clock::now();
    benchmark::DoNotOptimize(intent::solve(*subject(number).model.rig, subject(number).whole, problem, {}, work));
    times.push_back(since_us(before));
  }
  table()[row].push_back(percentile(times, 0.5) / 1000.0);
}

/// The energy of all controls, each alone, in u = 0..1 of its range.
void subplex(benchmark::State& state, std::size_t index) {
  const Subject& face = subject(0);
  const auto problem = face.problem(index);
  intent::SolveWorkspace work;
  const auto found = intent::solve(*face.model.rig, face.whole, problem, {}, work).value();
  intent::Reader reader = intent::Reader::of(*face.model.rig, face.whole, problem);
  intent::Quadratic quadratic;
  intent::Choice at;
  intent::Choice all;
  for (std::size_t v = 0; v < reader.parameters().size(); ++v) {
    all.units.push_back(v);  // the first units are the single parameters
    all.variables.push_back(v);
    all.values.push_back(0);
    if (found.pose[reader.parameters()[v]] == problem.start[reader.parameters()[v]]) continue;
    at.units.push_back(v);
    at.variables.push_back(v);
    at.values.push_back(found.pose[reader.parameters()[v]]);
  }
  reader.look(at, true, quadratic);
  const intent::ReadingCosts costs = reader.reading_costs();
  const auto energy = [&](const double* u) {
    intent::Choice some;
    for (std::size_t v = 0; v < all.variables.size(); ++v) {
      if (u[v] < 1e-3) continue;
      some.units.push_back(v);
      some.variables.push_back(v);
      some.values.push_back(u[v]);
    }
    return reader.energy(some, costs.costs_of(some));
  };
  double best = 0;
  std::vector<double> times;
  for (auto _ : state) {
    nlopt::opt opt(nlopt::LN_SBPLX, static_cast<unsigned>(all.variables.size()));
    opt.set_lower_bounds(0.0);
    opt.set_upper_bounds(1.0);
    const auto call = [](unsigned, const double* u, double*, void* f) {
      return (*static_cast<decltype(&energy)>(f))(u);
    };
    opt.set_min_objective(call, const_cast<void*>(static_cast<const void*>(&energy)));
    opt.set_ftol_rel(1e-6);
    opt.set_xtol_rel(1e-4);
    opt.set_initial_step(0.25);
    opt.set_maxeval(50000);
    std::vector<double> u(all.variables.size(), 0.0);
    const auto before = std::chrono::steady_clock::now();
    opt.optimize(u, best);
    times.push_back(since_us(before));
  }
  table()["53 controls, NLopt Subplex"].push_back(percentile(times, 0.5) / 1000.0);
  state.counters["energy"] = best;
  state.counters["energy_penpose"] = found.doubt_energy;
}

/// The first target of a case, drawn report by report.
void live(benchmark::State& state, int number, std::size_t index, const std::string& row) {
  const auto problem = subject(number).problem(index);
  const auto& drawn = problem.drawn.front().target;
  std::vector<geometry::PxPoint> line;
  constexpr int k_reports_a_segment = 6;
  for (std::size_t i = 0; i + 1 < drawn.size(); ++i) {
    for (int k = 0; k < k_reports_a_segment; ++k) {
      const double t = static_cast<double>(k) / k_reports_a_segment;
      line.push_back(drawn[i] * (1 - t) + drawn[i + 1] * t);
    }
  }
  std::vector<double> times;
  for (auto _ : state) {
    auto alone = problem;
    alone.drawn.resize(1, alone.drawn.front());
    auto poser = intent::LivePoser::start(*subject(number).model.rig, subject(number).whole, alone).value();
    for (std::size_t n = 2; n <= line.size(); ++n) {
      const auto before = std::chrono::steady_clock::now();
      benchmark::DoNotOptimize(poser.follow(std::span(line).first(n)));
      times.push_back(since_us(before));
    }
  }
  state.counters["step_us_median"] = percentile(times, 0.5);
  state.counters["step_us_p99"] = percentile(times, 0.99);
  table()[row].push_back(percentile(times, 0.99) / 1000.0);
}

}  // namespace

int main(int argc, char** argv) {
  if (!tests::has_shared()) {
    std::puts("the shared models are not here: nothing to measure");
    return 0;
  }
  const std::pair<int, std::string> subjects[] = {
      {0, "53 controls"}, {1, "530 controls"}, {2, "57 angles"}, {3, "avatar"}};
  for (const auto& [number, name] : subjects) {
    for (std::size_t i = 0; i < subject(number).cases.cases.size(); ++i) {
      const std::string label = std::string(name).append("/") + subject(number).cases.cases[i].name;
      benchmark::RegisterBenchmark(std::string("solve/").append(label).c_str(), solve, number, i,
                                   std::string(name).append(", penpose"))
          ->Unit(benchmark::kMillisecond);
      benchmark::RegisterBenchmark(std::string("live/").append(label).c_str(), live, number, i,
                                   std::string(name).append(", live step p99"))
          ->Unit(benchmark::kMillisecond);
      if (number != 0) continue;
      benchmark::RegisterBenchmark(std::string("subplex/").append(label).c_str(), subplex, i)
          ->Unit(benchmark::kMillisecond)
          ->Iterations(3);
    }
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  std::printf("\n%-32s %12s %12s\n", "", "median ms", "worst ms");
  for (const auto& [name, times] : table())
    std::printf("%-32s %12.3f %12.3f\n", name.c_str(), percentile(times, 0.5), percentile(times, 1.0));
}
