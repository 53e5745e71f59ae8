// Judges how well the program reads what was drawn, on rigs that are made by code and, where they are, on the shared
// ones. Prints a table and writes it as JSON. docs/developing.md says how it is used.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/edition.h"
#include "tests/judges/jobs.h"
#include "tests/judges/measures/solver.h"
#include "tests/judges/table/bounds.h"
#include "tests/judges/table/table.h"

namespace penpose::judges {
namespace {

using nlohmann::json;

constexpr const char* k_usage =
    "usage: judges [--short] [--own] [--only MEASURE]... [--rig NAME]... [--json OUT] [--details FOLDER]\n"
    "              [--about NAME=TEXT]... [--bounds FILE | --tighten FILE]\n"
    "  --short           a part of the cases of the project's own rigs, for the ordinary tests; implies --own\n"
    "  --own             without the shared models\n"
    "  --json OUT        writes the table\n"
    "  --details FOLDER  writes every case into FOLDER/seen, FOLDER/held_out and FOLDER/shared\n"
    "  --about NAME=TEXT a fact that the table is to hold, such as commit=... or machine=...\n"
    "  --bounds FILE     fails where a figure is worse than its bound\n"
    "  --tighten FILE    writes better figures into the bounds and never a worse one\n"
    "  --list            says which rigs and measures there are\n";

struct Arguments {
  Wanted wanted;
  std::string json, details, bounds;
  bool tighten = false;
  bool list = false;
  std::vector<std::pair<std::string, std::string>> about;
};

bool parse(int count, char** words, Arguments& arguments) {
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (word == "--short" || word == "--own") {
      arguments.wanted.shared = false;
      if (word == "--short") arguments.wanted.extent = Extent::brief;
      continue;
    }
    if (word == "--list") {
      arguments.list = true;
      continue;
    }
    if (i + 1 == count) return false;
    const std::string value = words[++i];
    if (word == "--only") {
      arguments.wanted.measures.push_back(value);
    } else if (word == "--rig") {
      arguments.wanted.rigs.push_back(value);
    } else if (word == "--json") {
      arguments.json = value;
    } else if (word == "--details") {
      arguments.details = value;
    } else if (word == "--bounds" || word == "--tighten") {
      arguments.bounds = value;
      arguments.tighten = word == "--tighten";
    } else if (word == "--about" && value.find('=') != std::string::npos) {
      arguments.about.emplace_back(value.substr(0, value.find('=')), value.substr(value.find('=') + 1));
    } else {
      return false;
    }
  }
  return true;
}

bool write(const std::filesystem::path& path, const json& value) {
  std::error_code error;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  std::ofstream file(path);
  file << lined(value) << '\n';
  file.close();
  if (file.fail()) std::cerr << path.string() << ": cannot be written; choose another place\n";
  return !file.fail();
}

std::optional<json> read(const std::string& path) {
  std::ifstream file(path);
  json value = json::parse(file, nullptr, false);
  if (!file.is_open() || value.is_discarded() || !value.is_object()) {
    std::cerr << path << ": not a JSON object; give the file of bounds\n";
    return {};
  }
  return value;
}

json details_of(const Judged& judged) {
  json cases = json::array();
  for (const Outcome& one : judged.outcomes) {
    json about{{"name", one.name}, {"hand", one.hand}, {"ms", one.ms}, {"note", one.note}};
    if (one.of > 0) about.update({{"right", one.right}, {"nothing", one.nothing}, {"of", one.of}});
    for (const auto& [name, value] :
         {std::pair{"error", one.error}, {"stray", one.stray}, {"still", one.still}, {"left", one.left}}) {
      if (value) about[name] = *value;
    }
    cases.push_back(std::move(about));
  }
  return cases;
}

json table_json(const Arguments& arguments, const std::vector<Row>& rows) {
  json table{{"edition", base::k_edition}, {"short", arguments.wanted.extent == Extent::brief}};
  for (const auto& [name, text] : arguments.about) table[name] = text;
  table["rows"] = json::array();
  for (const Row& row : rows) table["rows"].push_back(row_to_json(row));
  return table;
}

/// Whether the figures keep to their bounds, or could be written into them.
bool bounded(const Arguments& arguments, const std::vector<Row>& rows) {
  const auto bounds = read(arguments.bounds);
  if (!bounds) return false;
  if (arguments.tighten) return write(arguments.bounds, tightened(*bounds, rows));
  const auto lines = broken(*bounds, rows);
  for (const std::string& line : lines) std::cerr << "worse: " << line << '\n';
  return lines.empty();
}

int list() {
  for (const Measure& measure : all_measures()) std::cout << "measure " << measure.name << '\n';
  for (const RigMaker& maker : own_rigs())
    std::cout << maker.name << " (" << group_name(maker.group) << "): " << maker.make().kind << '\n';
  return 0;
}

int run(const Arguments& arguments) {
  if (arguments.list) return list();
  const Wanted& wanted = arguments.wanted;
  if (!arguments.bounds.empty() &&
      (wanted.extent != Extent::brief || !wanted.measures.empty() || !wanted.rigs.empty())) {
    std::cerr << arguments.bounds << ": bounds are those of all of --short; leave out --only and --rig, add --short\n";
    return 2;
  }
  const auto judged = judge_all(arguments.wanted);
  if (judged.empty()) {
    std::cerr << "no rig and no measure of these names; leave out --rig and --only to see all\n";
    return 2;
  }
  const auto rows = table_of(judged);
  std::cout << printed(rows);
  if (!arguments.json.empty() && !write(arguments.json, table_json(arguments, rows))) return 1;
  if (!arguments.details.empty()) {
    for (const Judged& one : judged) {
      const auto path = std::filesystem::path(arguments.details) / one.group / (one.measure + "_" + one.rig + ".json");
      if (!write(path, details_of(one))) return 1;
    }
  }
  return arguments.bounds.empty() || bounded(arguments, rows) ? 0 : 1;
}

}  // namespace
}  // namespace penpose::judges

int main(int count, char** words) {
  penpose::judges::Arguments arguments;
  if (!penpose::judges::parse(count, words, arguments)) {
    std::fputs(penpose::judges::k_usage, stderr);
    return 2;
  }
  return penpose::judges::run(arguments);
}
