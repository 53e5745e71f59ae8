#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>

#include "core/articulation/edit.h"
#include "core/articulation/measure/doubts.h"
#include "core/base/json/json.h"
#include "core/base/numbers.h"
#include "core/base/text/shown_text.h"
#include "core/document/document_hash.h"
#include "core/io/model/model_formats.h"
#include "core/io/project/sketch_file.h"
#include "ui/cli/orientation_option.h"
#include "ui/cli/pose/tolerance_option.h"
#include "ui/cli/progress.h"
#include "ui/cli/subcommand.h"
#include "ui/files/file_roles.h"
#include "ui/files/files.h"
#include "ui/files/load_model.h"
#include "ui/files/save_model.h"

namespace penpose::cli {
namespace {

using articulation::Deformer;
using articulation::SketchedDeformers;
using json::Json;

struct ArticulateArguments {
  io::WriteOptions glb;
  std::string model;
  io::Orientation orientation;
  std::string sketch;
  std::string out;
  bool json = false;
  bool paper = false;  ///< as the paper has it, whatever the file says
};

constexpr std::size_t k_longest_line = 4096;

struct Built {
  std::shared_ptr<const Deformer> deformer;
  double build_us = 0;
};

/// Builds all deformers of the file. Errors: their place is a JSON pointer in it.
base::Result<std::vector<Built>> build_all(const document::Document& document, const io::SketchFile& file) {
  const document::Model& model = *document.model;
  const auto canvas = document::make_canvas(model);
  if (!canvas) return canvas.error();
  std::vector<Built> all;
  Progress progress("articulating", file.sketches.size());
  for (std::size_t i = 0; i < file.sketches.size(); ++i) {
    const auto before = std::chrono::steady_clock::now();
    auto deformer = articulation::build_deformer(file.sketches[i], **canvas);
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - before;
    if (!deformer) {
      base::Error error = deformer.error();
      error.place = "/deformers/" + std::to_string(i) + "/" + error.place;
      return error;
    }
    if (rig::find_parameter(model.rig->parameters(), file.sketches[i].name)) {
      return base::Error{"the model has a control '" + file.sketches[i].name + "' already",
                         "/deformers/" + std::to_string(i) + "/name", "choose another name"};
    }
    if (document.pending && document.pending->sketch.name == file.sketches[i].name) {
      return base::Error{"a control '" + file.sketches[i].name + "' is being sketched in the model",
                         "/deformers/" + std::to_string(i) + "/name", "choose another name"};
    }
    all.push_back({std::move(deformer).value(), took.count()});
    progress.advance();
  }
  progress.finish();
  return all;
}

/// The deformers that the model has, then the new ones.
base::Result<document::Document> articulated(const document::Document& document, const std::vector<Built>& built) {
  const document::Model& model = *document.model;
  std::vector<std::shared_ptr<const Deformer>> deformers;
  if (model.deformers) deformers.assign(model.deformers->deformers().begin(), model.deformers->deformers().end());
  for (const Built& one : built) deformers.push_back(one.deformer);
  auto set = SketchedDeformers::make(std::move(deformers));
  if (!set) return set.error();
  auto changed = document::with_deformers(model, std::move(set).value());
  if (!changed) return changed.error();
  return document::with_model(document, std::move(changed).value());
}

/// The corrections that the model has, then those of the file. Errors: their place is a JSON pointer in it.
base::Result<document::Document> corrected(const document::Document& document, const io::SketchFile& file) {
  if (file.corrections.empty()) return document;
  auto sketches = document::correction_sketches(*document.model);
  const std::size_t before = sketches.size();
  sketches.insert(sketches.end(), file.corrections.begin(), file.corrections.end());
  auto changed = document::with_corrections(*document.model, sketches);
  if (changed) return document::with_model(document, std::move(changed).value());
  base::Error error = changed.error();
  const std::size_t end = std::min(error.place.find('/'), error.place.size());
  const auto number = base::parse_uint(std::string_view(error.place).substr(0, end));
  if (number && *number >= before) {
    error.place = "/corrections/" + std::to_string(*number - before) + error.place.substr(end);
  }
  return error;
}

const char* mode_name(const Deformer& deformer) {
  return deformer.mode() == articulation::Mode::translate ? "translate" : "rotate";
}

/// The last part of a path, without its ending: what a model is called wherever it lies.
std::string stem(const std::string& model) { return std::filesystem::path(model).stem().string(); }

/// What in the file will not do what its author may think, one line each.
std::vector<std::string> notes_on(const io::SketchFile& file, const std::string& model) {
  std::vector<std::string> notes;
  if (!file.model.empty() && stem(file.model) != stem(model)) {
    notes.push_back("the strokes were drawn on " + file.model + ": see that they lie right on this model");
  }
  for (const std::string& pointer : file.skipped) notes.push_back(pointer + " is not known and was skipped");
  return notes;
}

/// What a user may not have meant, one line each.
std::vector<std::string> notes_on(const Deformer& deformer) {
  auto doubts = articulation::doubts_of(deformer);
  if (!deformer.sketch().paper || !deformer.turned_round() || deformer.mode() != articulation::Mode::rotate)
    return doubts;
  return {
      "the target was turned round, because its end lies nearer to the start of the reference than its start does; "
      "if the control tears the model, draw the target so that its start is the nearer end, or use translate"};
}

int articulate(const ArticulateArguments& arguments) {
  files::FileRoles files;
  files.reads(arguments.model);
  files.reads(arguments.sketch);
  if (const auto fits = files.writes(arguments.out, "-o"); !fits) return files::report(fits.error(), arguments.out);
  if (!io::keeps_everything(arguments.out)) {
    return files::report(
        {"controls are not kept in such a file", "", "name the output " + io::extensions_that_keep_everything()},
        arguments.out);
  }
  const auto document = files::load_document(arguments.model, files::NamedBy::user, arguments.orientation);
  if (!document) return files::report(document.error(), arguments.model);
  const auto bytes = files::read_file(arguments.sketch, files::k_most_text_bytes);
  if (!bytes) return files::report(bytes.error(), arguments.sketch);
  auto file = io::read_sketch_file(*bytes);
  if (!file) return files::report(file.error(), arguments.sketch);
  if (arguments.paper) {
    for (articulation::Sketch& sketch : file->sketches) {
      sketch.paper = true;
      sketch.betweens.clear();
    }
  }
  if (file->sketches.empty() && file->corrections.empty()) {
    return files::report({"there is no deformer in the file", "/deformers", "draw one"}, arguments.sketch);
  }
  const std::vector<std::string> file_notes = notes_on(*file, arguments.model);
  const auto built = build_all(*document, *file);
  if (!built) return files::report(built.error(), arguments.sketch);
  const auto bare = articulated(*document, *built);
  if (!bare) return files::report(bare.error(), arguments.model);
  const auto result = corrected(*bare, *file);
  if (!result) return files::report(result.error(), arguments.sketch);
  if (auto saved = files::save_as_it_came(*result, arguments.out, files::SaveNotes::loud, arguments.glb); !saved)
    return files::report(saved.error(), arguments.out);

  if (!arguments.json) {
    for (const std::string& note : file_notes)
      std::cout << "warning: " << base::shown_line(arguments.sketch + ": " + note, k_longest_line) << '\n';
  }
  Json rows = Json::array();
  for (const Built& one : *built) {
    const Deformer& deformer = *one.deformer;
    const auto full = std::count(deformer.weights().begin(), deformer.weights().end(), 1.0);
    const auto notes = notes_on(deformer);
    rows.push_back({{"name", deformer.sketch().name},
                    {"mode", mode_name(deformer)},
                    {"reference", deformer.inferred() ? "inferred" : "drawn"},
                    {"vertices", deformer.vertices().size()},
                    {"vertices_at_full_weight", full},
                    {"minimum", deformer.parameter().minimum},
                    {"maximum", deformer.parameter().maximum},
                    {"target_turned_round", deformer.turned_round()},
                    {"stretch", deformer.strain().stretch},
                    {"turned_over", deformer.strain().turned_over},
                    {"targets", 1 + deformer.betweens().size()},
                    {"notes", notes},
                    {"build_us", one.build_us}});
    if (arguments.json) continue;
    const bool chosen = deformer.sketch().mode == articulation::Mode::automatic;
    std::cout << base::shown_name(deformer.sketch().name) << ": " << mode_name(deformer)
              << (chosen ? " (chosen), " : ", ") << deformer.vertices().size() << " vertices (" << full
              << " at full weight), " << (deformer.inferred() ? "reference inferred, " : "reference drawn, ")
              << base::format_fixed(one.build_us / 1000.0, 2) << " ms\n";
    for (const std::string& note : notes) std::cout << "  warning: " << note << '\n';
  }
  Json corrections = Json::array();
  const auto& all = result->model->corrections;
  for (std::size_t i = all ? all->size() - file->corrections.size() : 0; all && i < all->size(); ++i) {
    const articulation::Correction& one = *all->all()[i];
    const auto notes = notes_on(*one.deformer);
    Json drivers = Json::object();
    std::string names;
    for (const articulation::Driver& driver : one.drawn.drivers) {
      drivers[driver.control] = driver.value;
      names += (names.empty() ? "" : " and ") + base::shown_name(driver.control);
    }
    corrections.push_back({{"name", one.drawn.sketch.name},
                           {"drivers", std::move(drivers)},
                           {"vertices", one.vertices.size()},
                           {"notes", notes}});
    if (arguments.json) continue;
    std::cout << base::shown_name(one.drawn.sketch.name) << ": corrects " << names << ", " << one.vertices.size()
              << " vertices\n";
    for (const std::string& note : notes) std::cout << "  warning: " << note << '\n';
  }
  if (arguments.json) {
    const Json object = {{"model", arguments.model},
                         {"out", arguments.out},
                         {"notes", file_notes},
                         {"deformers", std::move(rows)},
                         {"corrections", std::move(corrections)},
                         {"state", document::DocumentHasher()(*result).whole.hex()}};
    std::cout << object.dump_as_made() << '\n';
  }
  return k_success;
}

void add_options(const Command& command, ArticulateArguments& arguments) {
  command.add_option("MODEL", arguments.model, "Model to articulate").required();
  command.add_option("--sketch", arguments.sketch, "JSON file of strokes").required();
  command.add_option("-o", arguments.out, "Write the articulated model, " + io::extensions_that_keep_everything())
      .required();
  command.add_flag("--json", arguments.json, "Print one JSON object");
  command
      .add_option(
          "--preset", [&arguments](const std::string& preset) { arguments.paper = preset == "paper"; },
          "default: weights that fall off over the surface, and of the ways of moving the one that distorts it least. "
          "paper: as published in 2006")
      .one_of({"default", "paper"});
  add_orientation_options(command, arguments.orientation);
  add_tolerance_option(command, arguments.glb);
}

}  // namespace

Subcommand articulate_subcommand() {
  return subcommand<ArticulateArguments>(
      "articulate", files::Rights::no_programs, "Gives a model controls from the strokes of a sketch file", add_options,
      articulate, {"penpose articulate elephant.glb --sketch trunk.json -o rigged.glb", "controls from strokes"},
      {"penpose articulate elephant.glb --sketch trunk.json -o paper.glb --preset paper", "as published in 2006"});
}

}  // namespace penpose::cli
