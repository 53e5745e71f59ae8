#include <chrono>
#include <filesystem>
#include <iostream>
#include <system_error>

#include "core/base/json/json.h"
#include "core/base/numbers.h"
#include "core/document/document_hash.h"
#include "ui/cli/subcommand.h"
#include "ui/demo/contact_sheet.h"
#include "ui/demo/run_demo.h"
#include "ui/files/files.h"
#include "ui/files/save_model.h"

namespace penpose::cli {
namespace {

/// Strokes that one control took: two regions, the target, and the reference where it was drawn.
std::size_t stroke_count(const articulation::Sketch& sketch) { return sketch.reference.empty() ? 3 : 4; }

using json::Json;
using Clock = std::chrono::steady_clock;

struct DemoArguments {
  std::string folder = ".";
  bool json = false;
};

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

std::vector<demo::SheetCell> sheet_cells(const demo::Demo& made) {
  const document::Model& model = *made.document.model;
  const rig::Pose rest = rig::rest_pose(*model.rig);
  std::vector<demo::SheetCell> cells{{"neutral", rest, {}}};
  for (demo::RegionCell& regions : demo::region_cells(model)) cells.push_back({"regions", rest, std::move(regions)});
  for (const demo::NamedPose& one : made.poses) cells.push_back({one.name, one.pose, {}});
  return cells;
}

Json to_json(const articulation::Deformer& deformer) {
  return {{"name", deformer.sketch().name},
          {"mode", deformer.mode() == articulation::Mode::translate ? "translate" : "rotate"},
          {"strokes", stroke_count(deformer.sketch())},
          {"vertices", deformer.vertices().size()}};
}

Json to_json(const demo::NamedPose& one, const document::Model& model) {
  Json parameters = Json::object();
  const auto known = model.rig->parameters();
  for (std::size_t i = 0; i < known.size(); ++i) parameters[known[i].name] = one.pose[i];
  return {{"name", one.name},
          {"curves", one.curves},
          {"energy_start", one.distance_at_rest},
          {"energy", one.distance},
          {"parameters", std::move(parameters)}};
}

struct Written {
  std::string glb;
  std::string png;
  std::vector<demo::SheetCell> cells;
  double replay_ms = 0;
  double picture_ms = 0;
  double total_ms = 0;
};

void print(const demo::Demo& made, const Written& written) {
  const document::Model& model = *made.document.model;
  std::cout << "replayed the bundled session on the built-in head (" << model.mesh->vertex_count()
            << " vertices): " << made.reports << " pen reports, " << made.strokes << " strokes, " << made.states_checked
            << " states equal to the recording, in " << base::format_fixed(written.replay_ms, 0) << " ms\n"
            << "deformers, by sketching\n";
  std::size_t strokes = 0;
  const auto deformers = model.deformers->deformers();
  for (const auto& deformer : deformers) {
    const std::size_t own = stroke_count(deformer->sketch());
    strokes += own;
    std::cout << "  " << deformer->sketch().name << ": "
              << (deformer->mode() == articulation::Mode::translate ? "translate, " : "rotate, ") << own << " strokes, "
              << deformer->vertices().size() << " vertices\n";
  }
  std::cout << "  " << deformers.size() << " deformers from " << strokes << " strokes\n"
            << "expressions, by drawing where curves should go\n";
  for (const demo::NamedPose& one : made.poses) {
    std::cout << "  " << one.name << ": " << one.curves << " curves, distance left "
              << base::format_fixed(one.distance_at_rest, 4) << " -> " << base::format_fixed(one.distance, 4) << "\n";
  }
  std::cout << "pictures, row by row: ";
  for (std::size_t i = 0; i < written.cells.size(); ++i) std::cout << (i > 0 ? ", " : "") << written.cells[i].title;
  std::cout << "\nwrote " << written.glb << " and " << written.png << " in "
            << base::format_fixed(written.total_ms / 1000, 2) << " s\n";
}

Json to_json(const demo::Demo& made, const Written& written) {
  Json deformers = Json::array();
  const document::Model& model = *made.document.model;
  for (const auto& deformer : model.deformers->deformers()) deformers.push_back(to_json(*deformer));
  Json expressions = Json::array();
  for (const demo::NamedPose& one : made.poses) expressions.push_back(to_json(one, model));
  Json pictures = Json::array();
  for (const demo::SheetCell& cell : written.cells) pictures.push_back(cell.title);
  return {{"model", "builtin:head"},
          {"vertices", model.mesh->vertex_count()},
          {"reports", made.reports},
          {"strokes", made.strokes},
          {"states_checked", made.states_checked},
          {"deformers", std::move(deformers)},
          {"expressions", std::move(expressions)},
          {"pictures", std::move(pictures)},
          {"glb", written.glb},
          {"png", written.png},
          {"replay_ms", written.replay_ms},
          {"picture_ms", written.picture_ms},
          {"total_ms", written.total_ms},
          {"state", document::DocumentHasher()(made.document).whole.hex()}};
}

int run_demo_command(const DemoArguments& arguments) {
  const Clock::time_point start = Clock::now();
  std::error_code failed;
  std::filesystem::create_directories(arguments.folder, failed);
  if (failed)
    return files::report({"the folder cannot be made: " + failed.message(), "", "choose another"}, arguments.folder);
  const auto made = demo::run_demo();
  if (!made) return files::report(made.error());

  const std::filesystem::path folder(arguments.folder);
  Written written{(folder / "demo.glb").string(), (folder / "demo.png").string(), sheet_cells(*made)};
  written.replay_ms = ms_since(start);
  if (auto saved = files::save_document(made->document, written.glb, files::SaveNotes::quiet); !saved) {
    return files::report(saved.error(), written.glb);
  }
  const Clock::time_point before_pictures = Clock::now();
  const auto sheet = demo::draw_contact_sheet(*made->document.model, written.cells);
  if (!sheet) return files::report(sheet.error(), written.png);
  const auto png = render::encode_png(*sheet);
  if (!png) return files::report(png.error(), written.png);
  if (auto saved = files::write_file(written.png, *png); !saved) return files::report(saved.error(), written.png);
  written.picture_ms = ms_since(before_pictures);
  written.total_ms = ms_since(start);
  if (arguments.json) {
    std::cout << to_json(*made, written).dump_as_made() << '\n';
  } else {
    print(*made, written);
  }
  return k_success;
}

void add_options(const Command& command, DemoArguments& arguments) {
  command.add_option("-o", arguments.folder, "Folder to write to").show_default();
  command.add_flag("--json", arguments.json, "Print one JSON object");
}

}  // namespace

Subcommand demo_subcommand() {
  return subcommand<DemoArguments>(
      "demo", files::Rights::all, "Replays the bundled pen session on the built-in head, writes demo.glb and demo.png",
      add_options, run_demo_command, {"penpose demo -o out", "writes out/demo.glb and out/demo.png"},
      {"penpose demo -o out --json", "what it did, for scripts"}, {{"-o", Completes::folders}});
}

}  // namespace penpose::cli
