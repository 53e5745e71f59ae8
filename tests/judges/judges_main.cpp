// Judges how well the program reads what was drawn, on rigs that are made by code and, where they are, on the shared ones.
// Prints a table and writes it as JSON. docs/developing.md says how it is used.

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/edition.h"
#include "tests/judges/measures/measure.h"
#include "tests/judges/table/table.h"
#include "tests/support/parallel.h"

namespace penpose::judges {
namespace {

constexpr const char* k_usage =
    "usage: judges [--short] [--only MEASURE] [--rig NAME] [--json OUT] [--details FOLDER] [--about NAME=TEXT]\n"
    "  --short           a part of the cases, for the ordinary tests\n"
    "  --only, --rig     one measure, one rig (each may be given several times)\n"
    "  --json OUT        writes the table\n"
    "  --details FOLDER  writes every case into FOLDER/seen and FOLDER/held_out\n"
    "  --about NAME=TEXT a fact that the table is to hold, such as commit=... or machine=...\n";

struct Arguments {
  Extent extent = Extent::whole;
  std::vector<std::string> measures, rigs;
  std::string json, details;
  std::vector<std::pair<std::string, std::string>> about;
};

bool parse(int count, char** words, Arguments& arguments) {
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (word == "--short") {
      arguments.extent = Extent::brief;
      continue;
    }
    if (i + 1 == count) return false;
    const std::string value = words[++i];
    if (word == "--only") {
      arguments.measures.push_back(value);
    } else if (word == "--rig") {
      arguments.rigs.push_back(value);
    } else if (word == "--json") {
      arguments.json = value;
    } else if (word == "--details") {
      arguments.details = value;
    } else if (word == "--about" && value.find('=') != std::string::npos) {
      arguments.about.emplace_back(value.substr(0, value.find('=')), value.substr(value.find('=') + 1));
    } else {
      return false;
    }
  }
  return true;
}

bool wanted(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

/// What all measures say of all rigs, in the order of measures.
std::vector<Judged> judge_all(const Arguments& arguments) {
  std::vector<RigMaker> makers;
  for (const RigMaker& maker : own_rigs()) {
    if (wanted(arguments.rigs, maker.name)) makers.push_back(maker);
  }
  std::vector<Measure> measures;
  for (const Measure& measure : all_measures()) {
    if (wanted(arguments.measures, measure.name)) measures.push_back(measure);
  }
  std::vector<std::vector<Judged>> of_rigs(makers.size());
  // Rigs next to each other are of a kind and take alike; every second one makes two pieces of the same work.
  std::vector<std::size_t> order;
  for (std::size_t first : {0U, 1U}) {
    for (std::size_t r = first; r < makers.size(); r += 2) order.push_back(r);
  }
  tests::parallel_for(makers.size(), 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t r = order[i];
      const Rig rig = makers[r].make();
      for (const Measure& measure : measures) {
        if (measure.applies(rig))
          of_rigs[r].push_back({measure.name, rig.name, group_name(rig.group), measure.judge(rig, arguments.extent)});
      }
    }
  });
  std::vector<Judged> all;
  for (const Measure& measure : measures) {
    for (const auto& of_rig : of_rigs) {
      for (const Judged& one : of_rig) {
        if (one.measure == measure.name) all.push_back(one);
      }
    }
  }
  return all;
}

nlohmann::json details_of(const Judged& judged) {
  nlohmann::json cases = nlohmann::json::array();
  for (const Outcome& one : judged.outcomes) {
    nlohmann::json json{{"name", one.name}, {"hand", one.hand}, {"ms", one.ms}, {"note", one.note}};
    if (one.of > 0) json.update({{"right", one.right}, {"nothing", one.nothing}, {"of", one.of}});
    if (one.error) json["error"] = *one.error;
    if (one.stray) json["stray"] = *one.stray;
    if (one.still) json["still"] = *one.still;
    if (one.left) json["left"] = *one.left;
    cases.push_back(std::move(json));
  }
  return cases;
}

bool write(const std::filesystem::path& path, const nlohmann::json& json) {
  std::error_code error;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  std::ofstream file(path);
  file << json.dump(1) << '\n';
  file.close();
  if (!file) std::cerr << path.string() << ": cannot be written; choose another place\n";
  return !file.fail();
}

int run(const Arguments& arguments) {
  const auto judged = judge_all(arguments);
  if (judged.empty()) {
    std::cerr << "no rig and no measure of these names; leave out --rig and --only to see all\n";
    return 2;
  }
  const auto rows = table_of(judged);
  std::cout << printed(rows);
  if (!arguments.json.empty()) {
    nlohmann::json table{{"edition", base::k_edition}, {"short", arguments.extent == Extent::brief}};
    for (const auto& [name, text] : arguments.about) table[name] = text;
    table["rows"] = nlohmann::json::array();
    for (const Row& row : rows) table["rows"].push_back(row_to_json(row));
    if (!write(arguments.json, table)) return 1;
  }
  if (!arguments.details.empty()) {
    for (const Judged& one : judged) {
      const auto path = std::filesystem::path(arguments.details) / one.group / (one.measure + "_" + one.rig + ".json");
      if (!write(path, details_of(one))) return 1;
    }
  }
  return 0;
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
