#include <algorithm>
#include <chrono>
#include <iomanip>
#include <iostream>
#include <optional>

#include "core/base/json/json.h"
#include "core/base/numbers.h"
#include "core/base/text/shown_text.h"
#include "core/document/document_hash.h"
#include "core/intent/solve.h"
#include "core/io/project/case_file.h"
#include "core/posing/solve.h"
#include "core/tracking/case_problem.h"
#include "ui/cli/orientation_option.h"
#include "ui/cli/pose/explained.h"
#include "ui/cli/pose/tolerance_option.h"
#include "ui/cli/progress.h"
#include "ui/cli/subcommand.h"
#include "ui/files/file_roles.h"
#include "ui/files/files.h"
#include "ui/files/load_model.h"
#include "ui/files/save_model.h"

namespace penpose::cli {
namespace {

using json::Json;

/// Other readings that are printed.
constexpr std::size_t k_others = 4;

/// Which energy is minimised.
enum class Preset : std::uint8_t { meant, exact, paper };

struct PoseArguments {
  io::WriteOptions glb;
  std::string model;
  io::Orientation orientation;
  std::string cases;
  std::string name;
  std::string out;
  tracking::FreeSet free = tracking::FreeSet::all;
  io::TargetForm form = io::TargetForm::points;
  Preset preset = Preset::meant;
  bool json = false;
  bool explain = false;
};

struct SolvedCase {
  std::string name;
  posing::Solution solution;
  double solve_us = 0;
  std::optional<intent::Solution> meant;           ///< what the default preset says beyond it
  const inference::Weights* weights = nullptr;     ///< of them
  std::vector<intent::ExplainedReading> readings;  ///< where they are asked for
};

/// What solving needs of a model, made once.
struct Solvers {
  posing::SolveWorkspace plain;
  intent::SolveWorkspace meant;
  intent::WholeModel whole;
  double hand = 0;  ///< doubt of the hand, model units
};

/// The median of eleven solves alone, no loading.
template <typename Solve>
auto timed(const io::PoseCase& pose_case, double& median_us, const Solve& solve) -> decltype(solve()) {
  std::vector<double> times;
  constexpr int k_solves = 11;
  for (int i = 0; i + 1 < k_solves; ++i) {
    const auto before = std::chrono::steady_clock::now();
    auto solution = solve();
    times.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - before).count());
    if (solution) continue;
    base::Error error = solution.error();
    error.place = "case " + pose_case.name + (error.place.empty() ? "" : ", " + error.place);
    return error;
  }
  const auto before = std::chrono::steady_clock::now();
  auto solution = solve();
  times.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - before).count());
  std::sort(times.begin(), times.end());
  median_us = times[times.size() / 2];
  return solution;
}

base::Result<SolvedCase> solve_case(const document::Model& model, const io::PoseCase& pose_case,
                                    const PoseArguments& arguments, Solvers& solvers) {
  SolvedCase solved{pose_case.name, {}, 0, std::nullopt, &inference::learned_weights(), {}};
  if (arguments.preset == Preset::meant) {
    const auto problem = tracking::intent_of_case(model, pose_case, arguments.free, arguments.form, solvers.hand);
    if (!problem) return problem.error();
    intent::SolveOptions options;
    const auto solve = [&] { return intent::solve(*model.rig, solvers.whole, *problem, options, solvers.meant); };
    auto solution = timed(pose_case, solved.solve_us, solve);
    if (!solution) return solution.error();
    options.others = k_others;
    if (auto with_others = solve()) {
      solution->others = std::move(with_others->others);
      solution->probability = with_others->probability;
    }
    if (arguments.explain) {
      auto readings = intent::explain(*model.rig, solvers.whole, *problem, options, solvers.meant);
      if (!readings) return readings.error();
      solved.readings = std::move(readings).value();
      solved.weights = options.weights;
    }
    solved.solution.pose = solution->pose;
    solved.solution.energy_start = solution->energy_start;
    solved.solution.energy = solution->energy;
    solved.solution.max_distance = solution->max_distance;
    solved.solution.variables = solution->variables;
    solved.solution.evaluations = solution->evaluations;
    solved.meant = std::move(solution).value();
    return solved;
  }
  auto problem = tracking::problem_of_case(model, pose_case, arguments.free, arguments.form);
  if (!problem) return problem.error();
  posing::SolveOptions options;
  options.paper = arguments.preset == Preset::paper;
  auto solution =
      timed(pose_case, solved.solve_us, [&] { return posing::solve(*model.rig, *problem, options, solvers.plain); });
  if (!solution) return solution.error();
  solved.solution = std::move(solution).value();
  return solved;
}

/// What each of the other readings has away from the rest pose, and how far its energy is above that of the one taken.
Json others_json(const intent::Solution& solution, const rig::Rig& rig) {
  Json others = Json::array();
  for (const intent::OtherReading& one : solution.others) {
    Json parameters = Json::object();
    for (std::size_t i = 0; i < one.pose.size(); ++i) {
      const rig::Parameter& parameter = rig.parameters()[i];
      if (one.pose[i] != parameter.rest) parameters[parameter.name] = one.pose[i];
    }
    others.push_back({{"above", one.above}, {"probability", one.probability}, {"parameters", std::move(parameters)}});
  }
  return others;
}

Json to_json(const SolvedCase& solved, document::Document& document, document::DocumentHasher& hasher) {
  const posing::Solution& s = solved.solution;
  document.pose = s.pose;
  Json parameters = Json::object();
  for (std::size_t i = 0; i < s.pose.size(); ++i) parameters[document.model->rig->parameters()[i].name] = s.pose[i];
  const Json others = solved.meant ? others_json(*solved.meant, *document.model->rig) : Json::array();
  Json out = {{"name", solved.name},
              {"variables", s.variables},
              {"energy_start", s.energy_start},
              {"energy", s.energy},
              {"max_distance", s.max_distance},
              {"parameters", std::move(parameters)},
              {"others", others},
              {"evaluations", s.evaluations},
              {"put_back", s.put_back},
              {"solve_us", solved.solve_us},
              {"state", hasher(document).whole.hex()}};
  if (!solved.readings.empty())
    out["readings"] = explained_json(solved.readings, *document.model->rig, *solved.weights);
  return out;
}

void print_row(const SolvedCase& solved, const document::Model& model, bool explain) {
  const posing::Solution& s = solved.solution;
  std::cout << std::left << std::setw(28) << base::shown_name(solved.name) << std::right << "  energy " << std::setw(10)
            << base::format_fixed(s.energy_start, 4) << " -> " << std::setw(10) << base::format_fixed(s.energy, 4)
            << "  farthest " << base::format_fixed(s.max_distance, 4) << "  " << s.variables << " variables, "
            << s.evaluations << " evaluations, " << base::format_fixed(solved.solve_us / 1000.0, 2) << " ms\n";
  const auto parameters = model.rig->parameters();
  for (std::size_t i = 0; i < s.pose.size(); ++i) {
    if (s.pose[i] != parameters[i].rest)
      std::cout << "    " << base::shown_name(parameters[i].name) << " = " << base::format_fixed(s.pose[i], 4) << '\n';
  }
  if (explain) std::cout << explained_table(solved.readings, *model.rig, *solved.weights);
}

int pose(const PoseArguments& arguments) {
  files::FileRoles files;
  files.reads(arguments.model);
  files.reads(arguments.cases);
  if (const auto fits = arguments.out.empty() ? base::Done{} : files.writes(arguments.out, "-o"); !fits)
    return files::report(fits.error(), arguments.out);
  auto document = files::load_document(arguments.model, files::NamedBy::user, arguments.orientation);
  if (!document) return files::report(document.error(), arguments.model);
  const document::Model& model = *document->model;
  const auto bytes = files::read_file(arguments.cases, files::k_most_text_bytes);
  if (!bytes) return files::report(bytes.error(), arguments.cases);
  const auto file = io::read_cases(*bytes);
  if (!file) return files::report(file.error(), arguments.cases);
  if (auto fits = io::check_cases(*file, model, arguments.form); !fits)
    return files::report(fits.error(), arguments.cases);

  std::vector<const io::PoseCase*> chosen;
  for (const auto& pose_case : file->cases) {
    if (arguments.name.empty() || pose_case.name == arguments.name) chosen.push_back(&pose_case);
  }
  if (chosen.empty()) {
    const std::string what =
        arguments.name.empty() ? "there is no case" : "there is no case of the name " + arguments.name;
    return files::report({what, "/cases", "choose one of the file's cases"}, arguments.cases);
  }
  if (!arguments.out.empty() && chosen.size() > 1) {
    return files::report({"one file holds one pose", "", "choose the case with --case NAME"}, arguments.out);
  }

  Solvers solvers;
  if (arguments.preset == Preset::meant) {
    solvers.whole = intent::measure_whole_model(*model.rig);
    solvers.hand = tracking::hand_doubt(model, *file);
  }
  std::vector<SolvedCase> solved;
  Progress progress("posing", chosen.size());
  for (const io::PoseCase* pose_case : chosen) {
    auto result = solve_case(model, *pose_case, arguments, solvers);
    if (!result) return files::report(result.error(), arguments.cases);
    solved.push_back(std::move(result).value());
    progress.advance();
  }
  progress.finish();

  if (arguments.json) {
    Json cases = Json::array();
    document::DocumentHasher hasher;
    for (const SolvedCase& one : solved) cases.push_back(to_json(one, *document, hasher));
    document->pose = solved.back().solution.pose;
    const Json result = {
        {"model", arguments.model}, {"cases", std::move(cases)}, {"state", hasher(*document).whole.hex()}};
    std::cout << result.dump_as_made() << '\n';
  } else {
    for (const SolvedCase& one : solved) print_row(one, model, arguments.explain);
  }
  if (!arguments.out.empty()) {
    document->pose = solved.back().solution.pose;
    if (auto saved = files::save_as_it_came(*document, arguments.out, files::SaveNotes::loud, arguments.glb); !saved)
      return files::report(saved.error(), arguments.out);
  }
  return k_success;
}

void add_options(const Command& command, PoseArguments& arguments) {
  command.add_option("MODEL", arguments.model, "Model with blend shapes or joints").required();
  add_orientation_options(command, arguments.orientation);
  command.add_option("--cases", arguments.cases, "JSON file of posing cases").required();
  command.add_option("--case", arguments.name, "Only the case of this name");
  command
      .add_option(
          "--free",
          [&arguments](const std::string& set) {
            arguments.free = set == "all" ? tracking::FreeSet::all : tracking::FreeSet::of_case;
          },
          "Parameters that may move: those of the case, or all (default)")
      .one_of({"all", "case"});
  command
      .add_option(
          "--form",
          [&arguments](const std::string& form) {
            arguments.form = form == "points" ? io::TargetForm::points : io::TargetForm::drawn;
          },
          "Targets as points, one a vertex (default), or as a drawn line")
      .one_of({"points", "drawn"});
  command
      .add_option(
          "--preset",
          [&arguments](const std::string& preset) {
            arguments.preset = preset == "paper" ? Preset::paper : preset == "exact" ? Preset::exact : Preset::meant;
          },
          "What is minimised. default: what the strokes mean, squares of distances in widths of doubt plus what "
          "the controls that move cost. "
          "exact: the sum of distances, to its least. paper: the same, by the "
          "single simplex of 2006")
      .one_of({"default", "exact", "paper"});
  command.add_option("-o", arguments.out, "Write the posed model, .glb or .obj (with one case)");
  command.add_flag("--explain", arguments.explain,
                   "Print how the lines can be read and why the first reading wins (preset default, lines on faces)");
  command.add_flag("--json", arguments.json, "Print one JSON object");
  add_tolerance_option(command, arguments.glb);
}

}  // namespace

Subcommand pose_subcommand() {
  return subcommand<PoseArguments>(
      "pose", files::Rights::no_programs, "Solves posing cases: brings curves of a model to where they should be",
      add_options, pose,
      {"penpose pose face.glb --cases cases.json --case smile -o smile.glb", "one case, and the posed model"},
      {"penpose pose face.glb --cases cases.json --json", "all cases, for scripts"});
}

}  // namespace penpose::cli
