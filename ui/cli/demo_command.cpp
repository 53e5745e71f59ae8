#include "ui/cli/demo_command.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <system_error>

#include "core/base/numbers.h"
#include "ui/cli/commands.h"
#include "ui/cli/files.h"
#include "ui/cli/save_model.h"
#include "ui/demo/contact_sheet.h"
#include "ui/demo/demo_head.h"
#include "ui/demo/run_demo.h"

namespace penpose::cli {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

struct DemoArguments {
  std::string folder = ".";
  bool json = false;
};

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

std::vector<demo::SheetCell> sheet_cells(const demo::Demo& made) {
  const rig::Pose rest = rig::rest_pose(*made.model.rig);
  std::vector<demo::SheetCell> cells{{"neutral", rest, {}}};
  for (demo::RegionCell& regions : demo::region_cells(made.model))
    cells.push_back({"regions", rest, std::move(regions)});
  for (const demo::PosedExpression& one : made.expressions) cells.push_back({one.name, one.solution.pose, {}});
  return cells;
}

Json to_json(const articulation::Deformer& deformer) {
  return {{"name", deformer.sketch().name},
          {"mode", deformer.mode() == articulation::Mode::translate ? "translate" : "rotate"},
          {"strokes", demo::stroke_count(deformer.sketch())},
          {"vertices", deformer.vertices().size()}};
}

Json to_json(const demo::PosedExpression& one, const document::Model& model) {
  Json parameters = Json::object();
  const auto known = model.rig->parameters();
  for (std::size_t i = 0; i < known.size(); ++i) parameters[known[i].name] = one.solution.pose[i];
  return {{"name", one.name},
          {"curves", one.curves},
          {"variables", one.solution.variables},
          {"energy_start", one.solution.energy_start},
          {"energy", one.solution.energy},
          {"max_distance", one.solution.max_distance},
          {"evaluations", one.solution.evaluations},
          {"solve_us", one.solve_us},
          {"parameters", std::move(parameters)}};
}

struct Written {
  std::string glb;
  std::string png;
  std::vector<demo::SheetCell> cells;
  double picture_ms = 0;
  double total_ms = 0;
};

void print(const demo::Demo& made, const Written& written) {
  std::size_t strokes = 0;
  const auto deformers = made.model.deformers->deformers();
  std::cout << "deformers of the built-in head (" << made.model.mesh->vertex_count() << " vertices), by sketching\n";
  for (const auto& deformer : deformers) {
    const std::size_t own = demo::stroke_count(deformer->sketch());
    strokes += own;
    std::cout << "  " << deformer->sketch().name << ": "
              << (deformer->mode() == articulation::Mode::translate ? "translate, " : "rotate, ") << own << " strokes, "
              << deformer->vertices().size() << " vertices\n";
  }
  std::cout << "  " << deformers.size() << " deformers from " << strokes << " strokes in "
            << base::format_fixed(made.build_us / 1000, 0) << " ms, the head included\n"
            << "expressions, by drawing where curves should go\n";
  for (const demo::PosedExpression& one : made.expressions) {
    std::cout << "  " << one.name << ": " << one.curves << " curves, energy "
              << base::format_fixed(one.solution.energy_start, 4) << " -> "
              << base::format_fixed(one.solution.energy, 4) << ", " << one.solution.evaluations << " evaluations, "
              << base::format_fixed(one.solve_us / 1000, 1) << " ms\n";
  }
  std::cout << "pictures, row by row: ";
  for (std::size_t i = 0; i < written.cells.size(); ++i) std::cout << (i > 0 ? ", " : "") << written.cells[i].title;
  std::cout << "\nwrote " << written.glb << " and " << written.png << " in "
            << base::format_fixed(written.total_ms / 1000, 2) << " s\n";
}

Json to_json(const demo::Demo& made, const Written& written) {
  Json deformers = Json::array();
  for (const auto& deformer : made.model.deformers->deformers()) deformers.push_back(to_json(*deformer));
  Json expressions = Json::array();
  for (const demo::PosedExpression& one : made.expressions) expressions.push_back(to_json(one, made.model));
  Json pictures = Json::array();
  for (const demo::SheetCell& cell : written.cells) pictures.push_back(cell.title);
  return {{"model", "builtin:head"},
          {"vertices", made.model.mesh->vertex_count()},
          {"deformers", std::move(deformers)},
          {"expressions", std::move(expressions)},
          {"pictures", std::move(pictures)},
          {"glb", written.glb},
          {"png", written.png},
          {"build_ms", made.build_us / 1000},
          {"picture_ms", written.picture_ms},
          {"total_ms", written.total_ms},
          {"state", document::state_hash(made.model).hex()}};
}

int run_demo_command(const DemoArguments& arguments) {
  const Clock::time_point start = Clock::now();
  std::error_code failed;
  std::filesystem::create_directories(arguments.folder, failed);
  if (failed) return report({"the folder cannot be made: " + failed.message(), "", "choose another"}, arguments.folder);
  const auto made = demo::run_demo();
  if (!made) return report(made.error());

  const std::filesystem::path folder(arguments.folder);
  Written written{(folder / "demo.glb").string(), (folder / "demo.png").string(), sheet_cells(*made)};
  if (auto saved = save_model(made->model, written.glb, SaveNotes::quiet); !saved)
    return report(saved.error(), written.glb);
  const Clock::time_point before_pictures = Clock::now();
  const auto sheet = demo::draw_contact_sheet(made->model, written.cells);
  if (!sheet) return report(sheet.error(), written.png);
  const auto png = render::encode_png(*sheet);
  if (!png) return report(png.error(), written.png);
  if (auto saved = write_file(written.png, *png); !saved) return report(saved.error(), written.png);
  written.picture_ms = ms_since(before_pictures);
  written.total_ms = ms_since(start);
  if (arguments.json) {
    std::cout << to_json(*made, written).dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
  } else {
    print(*made, written);
  }
  return k_success;
}

}  // namespace

void add_demo_command(CLI::App& app, int& status) {
  auto arguments = std::make_shared<DemoArguments>();
  CLI::App* command = app.add_subcommand(
      "demo", "Articulates the built-in head from strokes, poses expressions, writes demo.glb and .png");
  command->add_option("-o", arguments->folder, "Folder to write to")->capture_default_str();
  command->add_flag("--json", arguments->json, "Print one JSON object");
  command->callback([arguments, &status] { status = run_demo_command(*arguments); });
}

}  // namespace penpose::cli
