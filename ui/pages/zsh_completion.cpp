#include <string_view>

#include "core/base/text/joined.h"
#include "ui/pages/completions.h"

namespace penpose::pages {
namespace {

using cli::CommandRow;
using cli::Completes;
using cli::OptionRow;

/// For between single quotes, with the signs of _arguments' own language named.
std::string quoted(std::string_view text, std::string_view special = "[]:\\") {
  std::string out;
  for (const char c : text) {
    if (special.find(c) != std::string_view::npos) out += '\\';
    out += c == '\'' ? "'\\''" : std::string(1, c);
  }
  return out;
}

std::string action(const OptionRow& row) {
  if (row.completes == Completes::choices) return "(" + base::joined(row.choices, " ") + ")";
  if (row.completes == Completes::folders) return "_files -/";
  if (row.completes == Completes::nothing) return " ";
  if (row.extensions.empty()) return "_files";
  // One ending in brackets would be read as qualifiers.
  if (row.extensions.size() == 1) return "_files -g \"*" + row.extensions.front() + "\"";
  std::string endings;
  for (const std::string& extension : row.extensions) endings += (endings.empty() ? "" : "|") + extension.substr(1);
  return "_files -g \"*.(" + endings + ")\"";
}

std::string spec(const OptionRow& row, std::size_t place) {
  if (row.positional) {
    return "'" + (row.many ? "*" : std::to_string(place)) + ":" + quoted(row.names.front()) + ":" + action(row) + "'";
  }
  const std::string rest =
      "[" + quoted(row.help) + "]" + (row.value.empty() ? "" : ":" + quoted(row.value) + ":" + action(row));
  std::string out = "'";
  if (row.many) {
    out += "*";
  } else {
    std::vector<std::string> others = row.names;
    others.insert(others.end(), row.excludes.begin(), row.excludes.end());
    out += "(" + base::joined(others, " ") + ")";
  }
  if (row.names.size() == 1) return out + row.names.front() + rest + "'";
  const std::string names = base::joined(row.names, ",");
  return out + "'{" + names + "}'" + rest + "'";
}

std::string specs(const CommandRow& command, std::string_view indent) {
  std::string out;
  std::size_t place = 0;
  for (const OptionRow& row : command.options) {
    if (row.positional) ++place;
    out += " \\\n" + std::string(indent) + spec(row, place);
  }
  return out;
}

}  // namespace

std::string zsh_completion(std::span<const CommandRow> table) {
  std::string out = "#compdef penpose\n\n_penpose_commands() {\n  local -a commands=(\n";
  for (const CommandRow& command : table) {
    if (!command.name.empty()) out += "    '" + command.name + ":" + quoted(command.help, ":\\") + "'\n";
  }
  out +=
      "  )\n  _describe -t commands 'penpose command' commands\n}\n\n_penpose() {\n"
      "  local curcontext=\"$curcontext\" state line\n  typeset -A opt_args\n";
  const CommandRow& program = table.front();
  std::string files = "_files";
  std::string options;
  for (const OptionRow& row : program.options) {
    if (row.positional) {
      files = action(row);
    } else {
      options += " \\\n    " + spec(row, 0);
    }
  }
  out += "  _arguments -C" + options + " \\\n    '1: :->first' \\\n    '*:: :->rest'\n";
  out += "  case $state in\n    first) _alternative 'commands:command:_penpose_commands' 'files:model:" +
         quoted(files, "\\") + "' ;;\n    rest)\n      case $line[1] in\n";
  for (const CommandRow& command : table) {
    if (command.name.empty()) continue;
    out += "        " + command.name + ")\n          _arguments" + specs(command, "            ") + "\n          ;;\n";
  }
  out +=
      "      esac ;;\n  esac\n}\n\n"
      "# Read as a function of that name it completes; sourced it makes itself known.\n"
      "if [ \"$funcstack[1]\" = _penpose ]; then _penpose \"$@\"; else compdef _penpose penpose; fi\n";
  return out;
}

}  // namespace penpose::pages
