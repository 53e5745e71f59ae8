#include "ui/pages/man_page.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>

namespace penpose::pages {
namespace {

using cli::CommandRow;
using cli::OptionRow;

/// Text that roff prints as it is: signs with a meaning of their own are named, hyphens are the ones one types.
std::string plain(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool line_starts = out.empty() || out.back() == '\n';
    switch (c) {
      case '\\':
        out += "\\e";
        break;
      case '-':
        out += "\\-";
        break;
      case '\'':
        out += "\\(aq";
        break;
      case '`':
        out += "\\(ga";
        break;
      case '^':
        out += "\\(ha";
        break;
      case '~':
        out += "\\(ti";
        break;
      case '.':
        out += line_starts ? "\\&." : ".";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string in_font(char font, std::string_view text) {
  std::string out = "\\f";
  out += font;
  out += plain(text);
  out += "\\fR";
  return out;
}
std::string bold(std::string_view text) { return in_font('B', text); }
std::string italic(std::string_view text) { return in_font('I', text); }

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

/// A help text as a sentence. A name keeps its letters.
std::string sentence(std::string text) {
  const std::string_view word = std::string_view(text).substr(0, text.find_first_of(" ,:"));
  const bool is_name = std::any_of(word.begin(), word.end(), [](char c) { return c < 'a' || c > 'z'; });
  if (!is_name && !text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  if (!text.empty() && text.back() != '.') text += '.';
  return text;
}

/// The same in lines of at most 72 signs, each ready for roff.
std::string filled(const std::string& text) {
  constexpr std::size_t k_widest = 72;
  std::string out;
  std::string line;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > k_widest) {
      out += plain(line) + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return out + plain(line) + "\n";
}

std::string listed(const std::vector<std::string>& names) {
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) out += i + 1 < names.size() ? ", " : " or ";
    out += bold(names[i]);
  }
  return out;
}

std::string full_name(const CommandRow& command, char between) {
  return command.name.empty() ? "penpose" : std::string("penpose") + between + command.name;
}

std::string synopsis(const CommandRow& command) {
  std::string out = bold(full_name(command, ' ')) + " [" + italic("OPTIONS") + "]";
  for (const OptionRow& row : command.options) {
    if (!row.positional) continue;
    std::string name = italic(upper(row.names.front())) + (row.many ? "..." : "");
    out += row.required ? " " + name : " [" + name + "]";
  }
  return out;
}

std::string head_of(const OptionRow& row) {
  if (row.positional) return italic(upper(row.names.front())) + (row.many ? "..." : "");
  std::string out;
  for (const std::string& name : row.names) {
    out += (out.empty() ? "" : ", ") + bold(name);
  }
  if (!row.value.empty()) out += " " + italic(row.value);
  return out;
}

std::string describe(const OptionRow& row) {
  std::string out = ".TP\n" + head_of(row) + "\n" + filled(sentence(row.help));
  if (!row.choices.empty()) out += "One of " + listed(row.choices) + ".\n";
  if (!row.range.empty()) out += "From " + plain(row.range) + ".\n";
  if (!row.fallback.empty()) out += "Without it " + bold(row.fallback) + ".\n";
  if (row.required && !row.positional) out += "Has to be given.\n";
  if (row.many && !row.positional && row.help.find("many times") == std::string::npos)
    out += "May be given many times.\n";
  if (!row.excludes.empty()) out += "Not with " + listed(row.excludes) + ".\n";
  if (!row.needs.empty()) out += "Only with " + listed(row.needs) + ".\n";
  return out;
}

std::string options(const CommandRow& command) {
  std::string positionals;
  std::string others;
  for (const OptionRow& row : command.options) (row.positional ? positionals : others) += describe(row);
  std::string out;
  if (!positionals.empty()) out += ".SH ARGUMENTS\n" + positionals;
  if (!others.empty()) out += ".SH OPTIONS\n" + others;
  return out;
}

std::string subcommands(std::span<const CommandRow> table) {
  std::string out = ".SH COMMANDS\nEach has a page of its own, such as\n.BR penpose\\-render (1).\n";
  for (const CommandRow& command : table) {
    if (!command.name.empty()) out += ".TP\n" + bold(command.name) + "\n" + filled(sentence(command.help));
  }
  return out;
}

std::string examples(const CommandRow& command) {
  if (command.examples.empty()) return "";
  std::string out = ".SH EXAMPLES\n";
  for (const cli::Example& example : command.examples) {
    out += ".TP\n" + bold(example.call) + "\n" + filled(sentence(std::string(example.does)));
  }
  return out;
}

constexpr std::string_view k_end = R"(.SH EXIT STATUS
.TP
.B 0
It was done.
.TP
.B 1
The work failed; one line on standard error names the file, the place in
it and the remedy.
.TP
.B 2
It was called in a wrong way.
)";

std::string see_also(std::span<const CommandRow> table, const CommandRow& command) {
  std::string out = ".SH SEE ALSO\n";
  if (!command.name.empty()) return out + ".BR penpose (1)\n";
  for (const CommandRow& other : table) {
    if (other.name.empty()) continue;
    out += ".BR " + plain(full_name(other, '-')) + " (1)" + (&other == &table.back() ? "\n" : ",\n");
  }
  return out;
}

}  // namespace

std::string man_page_name(const CommandRow& command) { return full_name(command, '-') + ".1"; }

std::string man_page(std::span<const CommandRow> table, const CommandRow& command, const std::string& version,
                     const std::string& date) {
  std::string out = ".TH " + plain(upper(full_name(command, '-'))) + " 1 " + date + " \"" + plain(version) + "\"\n";
  // Long words as they are: nobody types a hyphen that was put in.
  out += ".nh\n.ad l\n";
  std::string summary = command.help.substr(0, command.help.find(". "));
  while (!summary.empty() && summary.back() == '.') summary.pop_back();
  summary[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(summary[0])));
  out += ".SH NAME\n" + plain(full_name(command, '-')) + " \\- " + plain(summary) + "\n";
  out += ".SH SYNOPSIS\n" + synopsis(command) + "\n";
  if (command.name.empty()) out += ".br\n" + bold("penpose") + " " + italic("COMMAND") + " ...\n";
  out += ".SH DESCRIPTION\n" + filled(sentence(command.help));
  if (command.name.empty()) out += subcommands(table);
  return out + options(command) + examples(command) + std::string(k_end) + see_also(table, command);
}

}  // namespace penpose::pages
