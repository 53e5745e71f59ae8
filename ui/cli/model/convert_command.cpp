#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "core/io/model/model_formats.h"
#include "core/io/surface/shape_list.h"
#include "ui/cli/number_range.h"
#include "ui/cli/orientation_option.h"
#include "ui/cli/pose/tolerance_option.h"
#include "ui/cli/subcommand.h"
#include "ui/files/file_roles.h"
#include "ui/files/files.h"
#include "ui/files/folder_files.h"
#include "ui/files/load_model.h"
#include "ui/files/save_model.h"

namespace penpose::cli {
namespace {

struct ConvertArguments {
  io::WriteOptions write;
  std::string in;
  std::string out;
  std::vector<std::string> shapes;
  std::vector<std::string> assignments;
  io::Orientation orientation;
};

/// The files that --shapes names: each as it is, a folder's models in the order of their names, numbers as numbers. An
/// error is that of the file `blamed`.
base::Result<std::vector<std::string>> shape_files(const std::vector<std::string>& named, std::string& blamed) {
  std::vector<std::string> files;
  for (const std::string& path : named) {
    blamed = path;
    auto inside = files::folder_files(path, [](const std::filesystem::path& file) {
      // What file managers leave beside a file is none.
      return !file.filename().string().starts_with('.') && io::format_to_read({}, file.string()) != nullptr;
    });
    if (!inside) return inside.error();
    if (!*inside) {
      files.push_back(path);
      continue;
    }
    if ((*inside)->empty()) return base::Error{"has no model", "", "name a folder of .obj files"};
    files.insert(files.end(), (*inside)->begin(), (*inside)->end());
  }
  return files;
}

/// An error is that of the file `blamed`.
base::Result<document::Document> load_with_shapes(const ConvertArguments& arguments, std::string& blamed) {
  auto document = files::load_document(arguments.in, files::NamedBy::user, arguments.orientation);
  if (!document || arguments.shapes.empty()) return document;
  const auto files = shape_files(arguments.shapes, blamed);
  if (!files) return files.error();
  std::vector<io::ShownShape> shapes;
  for (const std::string& file : *files) {
    // The model itself may lie in the folder.
    std::error_code code;
    if (std::filesystem::equivalent(file, arguments.in, code)) continue;
    auto shape = files::load_model(file, files::NamedBy::user, arguments.orientation);
    blamed = file;
    if (!shape) return shape.error();
    shapes.push_back({io::control_name_of(file), std::move(shape).value()});
  }
  blamed = arguments.in;
  auto model = io::with_shapes(*document->model, shapes);
  if (!model) return model.error();
  return document::with_model(*document, std::move(model).value());
}

/// Poses the document as --set asks for.
base::Status set_all(const ConvertArguments& arguments, document::Document& document) {
  if (arguments.assignments.empty()) return base::Done{};
  document::Model model = document::model_of(document);
  for (const std::string& assignment : arguments.assignments) {
    if (auto set = files::set_parameter(model, assignment); !set) return set;
  }
  document.pose = model.pose;
  return base::Done{};
}

int run_convert(const ConvertArguments& arguments) {
  files::FileRoles files(files::FileRoles::Output::silent);
  for (const std::string& shape : arguments.shapes) files.reads(shape);
  if (const auto fits = files.writes(arguments.out, "OUT"); !fits) return files::report(fits.error(), arguments.out);
  std::string blamed = arguments.in;
  auto document = load_with_shapes(arguments, blamed);
  if (!document) return files::report(document.error(), blamed);
  if (const auto set = set_all(arguments, *document); !set) return files::report(set.error(), arguments.in);
  if (const auto saved = files::save_as_it_came(*document, arguments.out, files::SaveNotes::loud, arguments.write);
      !saved)
    return files::report(saved.error(), arguments.out);
  for (const std::string& note : document->model->notes) files::warn(note, arguments.in);
  return k_success;
}

void add_options(const Command& command, ConvertArguments& arguments) {
  command.add_option("IN", arguments.in, io::names_read() + " file").required();
  command
      .add_option("OUT", arguments.out,
                  io::extensions_to_write() + " file to write; .csv: the blend shapes as Live Link Face writes them")
      .required();
  command.add_option("--shapes", arguments.shapes,
                     "Files, or folders of files, that each show one blend shape; their names become its name");
  command.add_option("--set", arguments.assignments,
                     "NAME=VALUE: a parameter of the pose, or an expression; may be given many times");
  command.add_option("--fps", arguments.write.fps, "Frames a second of a .csv file, or of turns in an .fbx file")
      .check(number_range(0.1, 1000.0), "0.1 to 1000")
      .show_default();
  command.add_flag("--plain-textures", arguments.write.plain_textures,
                   "Write WebP textures as PNG, for programs that read no WebP (Blender before 4.0)");
  add_orientation_options(command, arguments.orientation);
  add_tolerance_option(command, arguments.write);
}

}  // namespace

Subcommand convert_subcommand() {
  return subcommand<ConvertArguments>(
      "convert", files::Rights::no_programs,
      "Converts a model to GLB or FBX, to OBJ at its pose, or its animation to ARKit CSV", add_options, run_convert,
      {"penpose convert scan.obj scan.glb --shapes shapes", "OBJ files as blend shapes"},
      {"penpose convert posed.glb posed.obj", "the pose as it stands"},
      {{"OUT", Completes::files, io::extensions_written()}});
}

}  // namespace penpose::cli
