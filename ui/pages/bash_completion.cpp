#include <string_view>

#include "core/base/text/joined.h"
#include "ui/pages/completions.h"

namespace penpose::pages {
namespace {

using cli::CommandRow;
using cli::Completes;
using cli::OptionRow;

/// What to call for a value.
std::string offer(const OptionRow& row) {
  switch (row.completes) {
    case Completes::choices:
      return "_penpose_words '" + base::joined(row.choices, " ") + "'";
    case Completes::folders:
      return "_penpose_folders";
    case Completes::files:
      return row.extensions.empty() ? "_penpose_files" : "_penpose_files " + base::joined(row.extensions, " ");
    default:
      return ":";
  }
}

std::string case_of_options(const CommandRow& command) {
  std::string out;
  for (const OptionRow& row : command.options) {
    if (row.positional || row.value.empty()) continue;
    std::string pattern;
    for (const std::string& name : row.names) pattern += (pattern.empty() ? "" : "|") + command.name + ":" + name;
    out += "    " + pattern + ") " + offer(row) + "; return ;;\n";
  }
  return out;
}

/// Files of any positional fit: which one is being typed is for the program to say.
std::string case_of_positionals(const CommandRow& command) {
  std::string extensions;
  bool any = false;
  for (const OptionRow& row : command.options) {
    if (!row.positional) continue;
    any = true;
    for (const std::string& extension : row.extensions) {
      if ((extensions + " ").find(" " + extension + " ") == std::string::npos) extensions += " " + extension;
    }
  }
  return any ? "    " + (command.name.empty() ? "''" : command.name) + ") _penpose_files" + extensions + " ;;\n" : "";
}

constexpr std::string_view k_head = R"(# bash completion for penpose

_penpose_words() { COMPREPLY+=($(compgen -W "$1" -- "$cur")); }

_penpose_folders() {
  compopt -o filenames 2>/dev/null
  local name
  while IFS= read -r name; do COMPREPLY+=("$name"); done < <(compgen -d -- "$cur")
}

# Files with one of the endings, and folders; every file where none has one.
_penpose_files() {
  compopt -o filenames 2>/dev/null
  local name ending found=0 all=()
  while IFS= read -r name; do
    all+=("$name")
    if [ -d "$name" ]; then
      COMPREPLY+=("$name")
      continue
    fi
    for ending; do
      case "$name" in *"$ending") COMPREPLY+=("$name"); found=1 ;; esac
    done
  done < <(compgen -f -- "$cur")
  if [ $found = 0 ]; then COMPREPLY+=("${all[@]}"); fi
}

_penpose() {
  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} command='' options='' i
  COMPREPLY=()
  # --view=front comes as three words.
  if [ "$cur" = = ]; then
    cur=''
  elif [ "$prev" = = ]; then
    prev=${COMP_WORDS[COMP_CWORD-2]}
  fi
  for ((i = 1; i < COMP_CWORD; i++)); do
    case " $_penpose_commands " in *" ${COMP_WORDS[i]} "*) command=${COMP_WORDS[i]}; break ;; esac
  done
  case "$command:$prev" in
)";

}  // namespace

std::string bash_completion(std::span<const CommandRow> table) {
  std::string commands;
  std::string values;
  std::string options;
  std::string files;
  for (const CommandRow& command : table) {
    if (!command.name.empty()) commands += (commands.empty() ? "" : " ") + command.name;
    values += case_of_options(command);
    std::string names;
    for (const OptionRow& row : command.options) {
      if (!row.positional) names += (names.empty() ? "" : " ") + base::joined(row.names, " ");
    }
    options += "    " + (command.name.empty() ? "''" : command.name) + ") options='" + names + "' ;;\n";
    files += case_of_positionals(command);
  }
  std::string out(k_head);
  out += values + "  esac\n  case \"$command\" in\n" + options + "  esac\n";
  out += "  if [ \"${cur:0:1}\" = - ]; then _penpose_words \"$options\"; return; fi\n";
  out += "  if [ -z \"$command\" ]; then _penpose_words \"$_penpose_commands\"; fi\n";
  out += "  case \"$command\" in\n" + files + "  esac\n}\n\n";
  out += "_penpose_commands='" + commands + "'\ncomplete -F _penpose penpose\n";
  return out;
}

}  // namespace penpose::pages
