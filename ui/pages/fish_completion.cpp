#include <string_view>

#include "core/base/text/joined.h"
#include "ui/pages/completions.h"

namespace penpose::pages {
namespace {

using cli::CommandRow;
using cli::Completes;
using cli::OptionRow;

std::string quoted(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') out += '\\';
    out += c;
  }
  return out + "'";
}

std::string offer(const OptionRow& row) {
  if (row.completes == Completes::choices) return " -x -a " + quoted(base::joined(row.choices, " "));
  if (row.completes == Completes::folders) return " -x -a '(__fish_complete_directories)'";
  if (row.completes == Completes::nothing) return " -x";
  if (row.extensions.empty()) return " -r -F";
  return " -k -x -a '(__penpose_files " + base::joined(row.extensions, " ") + ")'";
}

std::string line(const CommandRow& command, const OptionRow& row) {
  std::string out = "complete -c penpose -n ";
  out += command.name.empty() ? "__fish_use_subcommand" : quoted("__fish_seen_subcommand_from " + command.name);
  for (const std::string& name : row.names) {
    if (row.positional) continue;
    out += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  if (row.positional || !row.value.empty()) out += offer(row);
  if (!row.positional) out += " -d " + quoted(row.help);
  return out + "\n";
}

constexpr std::string_view k_head = R"(# fish completion for penpose

# Files with one of the endings, and folders; every file where none has one.
function __penpose_files
    set -l files (complete -C "__fish_command_without_completions "(commandline -ct))
    set -l fitting
    for ending in $argv
        set -a fitting (string match -- "*$ending" $files)
    end
    if set -q fitting[1]
        printf '%s\n' $fitting
        string match -- '*/' $files
    else
        printf '%s\n' $files
    end
end

complete -c penpose -f
)";

}  // namespace

std::string fish_completion(std::span<const CommandRow> table) {
  std::string out(k_head);
  for (const CommandRow& command : table) {
    if (!command.name.empty()) {
      out += "complete -c penpose -n __fish_use_subcommand -a " + command.name + " -d " + quoted(command.help) + "\n";
    }
  }
  for (const CommandRow& command : table) {
    for (const OptionRow& row : command.options) out += line(command, row);
  }
  return out;
}

}  // namespace penpose::pages
