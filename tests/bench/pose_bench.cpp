// Posing against its peers on the shared face: the gap that each solver leaves to the known optimum, and its time, in
// one run. Peers minimise the plain energy through the same linear form of the curve points, so that only the search
// differs.

#include <algorithm>
#include <benchmark/benchmark.h>
#include <cstdio>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multimin.h>
#include <map>
#include <nlopt.hpp>

#include "core/io/model/read_model.h"
#include "core/io/project/case_file.h"
#include "core/posing/curve_system.h"
#include "core/posing/finish.h"
#include "core/posing/pose_objective.h"
#include "core/posing/relevance.h"
#include "core/posing/solve.h"
#include "core/tracking/case_problem.h"
#include "tests/support/shared_data.h"

namespace {

using namespace penpose;

struct Face {
  document::Model model;
  io::CaseFile cases;
};

const Face& face() {
  static const Face loaded = [] {
    const auto meshes = tests::shared_dir() / "meshes";
    Face f{io::read_model(tests::read_file(meshes / "ict_face.glb"), "ict_face.glb").value(),
           io::read_cases(tests::read_file(meshes / "ict_face_sketch_cases.json")).value()};
    return f;
  }();
  return loaded;
}

posing::PoseProblem problem_of(std::size_t index, tracking::FreeSet free) {
  return tracking::problem_of_case(face().model, face().cases.cases[index], free, io::TargetForm::points).value();
}

/// The plain energy of a case as a function of all free parameters, 0..1.
struct PlainEnergy {
  explicit PlainEnergy(const posing::PoseProblem& problem) : system(*face().model.rig, problem) {
    auto columns = system.columns(problem.start, problem.free).value();
    model = posing::make_linear_model(system, problem.start,
                                      posing::make_variables(*face().model.rig, problem.free, problem.start),
                                      std::move(columns), 0.0);
    image.resize(model.at_zero.size());
  }
  double operator()(std::span<const double> u) {
    model.residuals(u, image);
    return posing::weighted_lengths(image.data(), model.weights);
  }
  posing::CurveSystem system;
  posing::LinearModel model;
  posing::Residuals image;
};

/// The optimum of the free parameters of a case, by a finishing run to the end from several starts: the energy is
/// convex.
double own_optimum(const posing::PoseProblem& problem) {
  PlainEnergy energy(problem);
  double best = 1e300;
  for (const double start : {0.0, 0.3, 0.7}) {
    std::vector<double> u(problem.free.size(), start);
    posing::FinishWorkspace work;
    best = std::min(best, posing::finish_linear(energy.model, {3000, 1e-12}, u, work).value);
  }
  return best;
}

struct Outcome {
  double energy = 0;
  double start = 0;
};
using Solver = Outcome (*)(const posing::PoseProblem&);

Outcome run_penpose(const posing::PoseProblem& problem, bool finish, bool paper) {
  static posing::SolveWorkspace work;
  posing::SolveOptions options;
  options.finish = finish;
  options.paper = paper;
  const auto solution = posing::solve(*face().model.rig, problem, options, work).value();
  return {solution.energy, solution.energy_start};
}
Outcome penpose_default(const posing::PoseProblem& problem) { return run_penpose(problem, true, false); }
Outcome penpose_simplex(const posing::PoseProblem& problem) { return run_penpose(problem, false, false); }
Outcome penpose_paper(const posing::PoseProblem& problem) { return run_penpose(problem, false, true); }

Outcome run_nlopt(const posing::PoseProblem& problem, nlopt::algorithm algorithm) {
  PlainEnergy energy(problem);
  nlopt::opt opt(algorithm, static_cast<unsigned>(problem.free.size()));
  opt.set_lower_bounds(0.0);
  opt.set_upper_bounds(1.0);
  opt.set_min_objective([](unsigned n, const double* x, double*,
                           void* data) { return (*static_cast<PlainEnergy*>(data))(std::span(x, n)); },
                        &energy);
  opt.set_ftol_rel(1e-6);
  opt.set_xtol_rel(1e-5);
  opt.set_initial_step(0.25);
  opt.set_maxeval(100000);
  std::vector<double> u(problem.free.size(), 0.0);
  const double start = energy(u);
  double value = start;
  try {
    opt.optimize(u, value);
  } catch (const std::exception&) {
    value = energy(u);
  }
  return {value, start};
}
Outcome nlopt_nelder_mead(const posing::PoseProblem& problem) { return run_nlopt(problem, nlopt::LN_NELDERMEAD); }
Outcome nlopt_subplex(const posing::PoseProblem& problem) { return run_nlopt(problem, nlopt::LN_SBPLX); }

/// GSL knows no bounds: the energy is taken at the clamped point.
Outcome gsl_nmsimplex2(const posing::PoseProblem& problem) {
  PlainEnergy energy(problem);
  const std::size_t d = problem.free.size();
  std::vector<double> clamped(d);
  struct Context {
    PlainEnergy& energy;
    std::vector<double>& clamped;
  } context{energy, clamped};
  gsl_multimin_function function{[](const gsl_vector* x, void* data) {
                                   auto& c = *static_cast<Context*>(data);
                                   for (std::size_t i = 0; i < c.clamped.size(); ++i)
                                     c.clamped[i] = std::clamp(gsl_vector_get(x, i), 0.0, 1.0);
                                   return c.energy(c.clamped);
                                 },
                                 d, &context};
  gsl_vector* x = gsl_vector_calloc(d);
  gsl_vector* step = gsl_vector_alloc(d);
  gsl_vector_set_all(step, 0.25);
  gsl_multimin_fminimizer* minimizer = gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, d);
  gsl_multimin_fminimizer_set(minimizer, &function, x, step);
  const double start = energy(std::vector<double>(d, 0.0));
  for (int i = 0; i < 50000; ++i) {
    if (gsl_multimin_fminimizer_iterate(minimizer) != GSL_SUCCESS) break;
    if (gsl_multimin_test_size(gsl_multimin_fminimizer_size(minimizer), 1e-4) == GSL_SUCCESS) break;
  }
  const double value = minimizer->fval;
  gsl_multimin_fminimizer_free(minimizer);
  gsl_vector_free(step);
  gsl_vector_free(x);
  return {value, start};
}

void solve_case(benchmark::State& state, Solver solver, std::size_t index, tracking::FreeSet free) {
  const auto problem = problem_of(index, free);
  const double optimum =
      free == tracking::FreeSet::all ? face().cases.cases[index].optimum_energy.value() : own_optimum(problem);
  Outcome outcome;
  for (auto _ : state) outcome = solver(problem);
  state.counters["gap_percent"] = 100.0 * (outcome.energy - optimum) / (outcome.start - optimum);
}

double percentile(std::vector<double>& values, double share) {
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

/// Prints as usual and gathers what the summary needs.
class Summary final : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      const auto gap = run.counters.find("gap_percent");
      if (gap == run.counters.end()) continue;
      const std::string name = run.benchmark_name();
      // free/solver/case and the benchmark's own options: the first two name the row.
      auto& rows = table_[name.substr(0, name.find('/', name.find('/') + 1))];
      rows.first.push_back(gap->second.value);
      rows.second.push_back(run.GetAdjustedRealTime());
    }
  }
  void print() {
    std::printf("\n%-28s %12s %12s %14s %14s\n", "", "median gap %", "worst gap %", "median time ms", "worst time ms");
    for (auto& [name, rows] : table_) {
      std::printf("%-28s %12.4f %12.4f %14.3f %14.3f\n", name.c_str(), percentile(rows.first, 0.5),
                  percentile(rows.first, 1.0), percentile(rows.second, 0.5), percentile(rows.second, 1.0));
    }
    if (table_.contains("all/nlopt_subplex") && table_.contains("all/penpose")) {
      std::printf("penpose is %.0f times as fast as Subplex\n",
                  percentile(table_["all/nlopt_subplex"].second, 0.5) / percentile(table_["all/penpose"].second, 0.5));
    }
  }

 private:
  std::map<std::string, std::pair<std::vector<double>, std::vector<double>>> table_;
};

}  // namespace

int main(int argc, char** argv) {
  if (!tests::has_shared()) {
    std::puts("the shared models are not here: nothing to measure");
    return 0;
  }
  const std::pair<const char*, Solver> solvers[] = {{"penpose", penpose_default},
                                                    {"penpose_simplex_alone", penpose_simplex},
                                                    {"penpose_paper_preset", penpose_paper},
                                                    {"nlopt_nelder_mead", nlopt_nelder_mead},
                                                    {"nlopt_subplex", nlopt_subplex},
                                                    {"gsl_nmsimplex2", gsl_nmsimplex2}};
  for (const auto free : {tracking::FreeSet::all, tracking::FreeSet::of_case}) {
    for (const auto& [name, solver] : solvers) {
      if (free == tracking::FreeSet::of_case && solver != penpose_default) continue;
      for (std::size_t i = 0; i < face().cases.cases.size(); ++i) {
        const std::string label =
            std::string(free == tracking::FreeSet::all ? "all/" : "case/") + name + "/" + face().cases.cases[i].name;
        benchmark::RegisterBenchmark(label.c_str(), solve_case, solver, i, free)
            ->Unit(benchmark::kMillisecond)
            ->MinTime(0.1);
      }
    }
  }
  benchmark::Initialize(&argc, argv);
  Summary summary;
  benchmark::RunSpecifiedBenchmarks(&summary);
  summary.print();
}
