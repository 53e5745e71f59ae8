#include "ui/cli/convert_command.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "ui/cli/commands.h"
#include "ui/cli/files.h"
#include "ui/cli/load_model.h"
#include "ui/cli/save_model.h"

namespace penpose::cli {
namespace {

struct ConvertArguments {
  std::string in;
  std::string out;
};

int run_convert(const ConvertArguments& arguments) {
  const auto model = load_model(arguments.in);
  if (!model) return report(model.error(), arguments.in);
  if (const auto saved = save_model(*model, arguments.out); !saved) return report(saved.error(), arguments.out);
  for (const std::string& note : model->notes) std::cerr << "penpose: " << arguments.in << ": " << note << '\n';
  return k_success;
}

}  // namespace

void add_convert_command(CLI::App& app, int& status) {
  auto arguments = std::make_shared<ConvertArguments>();
  CLI::App* command = app.add_subcommand("convert", "Converts a model to GLB, or to OBJ at its pose");
  command->add_option("IN", arguments->in, "glTF, GLB, OBJ, PLY, OFF or STL file")->required();
  command->add_option("OUT", arguments->out, ".glb or .obj file to write")->required();
  command->callback([arguments, &status] { status = run_convert(*arguments); });
}

}  // namespace penpose::cli
