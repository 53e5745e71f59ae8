#include "ui/cli/parser/command_table.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <span>

#include "core/base/version.h"
#include "core/io/model/model_formats.h"
#include "ui/cli/parser/program_options.h"

namespace penpose::cli {
namespace {

/// Options that are alike wherever they come. Without a row any file is offered.
std::span<const ValueRow> common_values() {
  const std::vector<std::string> models = io::extensions_read();
  const std::vector<std::string> sessions{".session", ".hid"};
  const std::vector<std::string> json{".json"};
  static const ValueRow rows[] = {
      {"--set", Completes::nothing},
      {"--case", Completes::nothing},
      {"--size", Completes::nothing},
      {"MODEL", Completes::files, models},
      {"--model", Completes::files, models},
      {"IN", Completes::files, models},
      {"SESSION", Completes::files, sessions},
      {"trace", Completes::files, sessions},
      {"--session", Completes::files, sessions},
      {"--cases", Completes::files, json},
      {"--sketch", Completes::files, json},
      {"--labels", Completes::files, json},
      {"--curves", Completes::files, json},
      {"--camera", Completes::files, json},
      {"--png", Completes::files, {".png"}},
  };
  return rows;
}

/// "{front,side}" of a type's text, as the parser prints it; empty where it lists none.
std::vector<std::string> choices_in(const std::string& type) {
  const std::size_t open = type.find('{');
  const std::size_t close = type.find('}');
  std::vector<std::string> out;
  if (open == std::string::npos || close == std::string::npos) return out;
  std::size_t begin = open + 1;
  while (begin <= close) {
    const std::size_t end = std::min(type.find(',', begin), close);
    out.push_back(type.substr(begin, end - begin));
    begin = end + 1;
  }
  return out;
}

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  if (option.get_positional()) return {option.get_name(true, false)};
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

std::vector<std::string> names_of(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options) names.push_back(names_of(*option).back());
  std::sort(names.begin(), names.end());
  return names;
}

void add_completion(OptionRow& row, const std::string& command) {
  row.completes = Completes::files;
  const auto take = [&](std::span<const ValueRow> rows) {
    for (const ValueRow& known : rows) {
      if (std::find(row.names.begin(), row.names.end(), known.name) == row.names.end()) continue;
      row.completes = known.completes;
      row.extensions = known.extensions;
      // What opens in the window, too.
      if (command.empty() && known.name == "MODEL") row.extensions.emplace_back(".session");
      return true;
    }
    return false;
  };
  const Subcommand* own = subcommand_named(command);
  if (own == nullptr || !take(own->values)) take(common_values());
}

/// Types are written as the parser prints them: `FLOAT:0 to 60`, `TEXT:{drop,apply}`, `TEXT:WxH`, `TEXT`.
void add_value(OptionRow& row, const CLI::Option& option, const std::string& command) {
  const std::string type = option.get_type_name();
  const std::size_t colon = type.find(':');
  const std::string kind = type.substr(0, colon);
  const std::string rest = colon == std::string::npos ? "" : type.substr(colon + 1);
  row.fallback = option.get_default_str();
  row.choices = choices_in(type);
  if (!row.choices.empty()) {
    row.completes = Completes::choices;
    row.value = "WORD";
    return;
  }
  if (kind != "TEXT" && !kind.empty()) {
    row.value = "N";
    row.range = rest;
    return;
  }
  add_completion(row, command);
  row.value = !rest.empty()                         ? rest
              : row.completes == Completes::folders ? "FOLDER"
              : row.completes == Completes::nothing ? "TEXT"
                                                    : "FILE";
}

OptionRow row_of(const CLI::Option& option, const std::string& command) {
  OptionRow row;
  row.names = names_of(option);
  row.help = option.get_description();
  row.positional = option.get_positional();
  row.required = option.get_required();
  row.many = option.get_items_expected_max() > 1;
  row.excludes = names_of(option.get_excludes());
  row.needs = names_of(option.get_needs());
  if (option.get_items_expected_max() > 0) add_value(row, option, command);
  return row;
}

CommandRow row_of(const CLI::App& app, const std::string& name) {
  CommandRow row{name, app.get_description(), {}, {}};
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_group().empty()) row.options.push_back(row_of(*option, name));
  }
  const auto examples = examples_of(name);
  row.examples.assign(examples.begin(), examples.end());
  return row;
}

}  // namespace

std::vector<CommandRow> command_table(bool has_window) {
  CLI::App app{"", "penpose"};
  int status = 0;
  files::WindowRequest request;
  add_program_options(app, status, request, has_window);
  std::vector<CommandRow> table{row_of(app, "")};
  for (const CLI::App* command : app.get_subcommands({})) table.push_back(row_of(*command, command->get_name()));
  return table;
}

std::string program_version() { return "penpose " + std::string(base::k_version); }

}  // namespace penpose::cli
