// Learns the weights of core/inference from readings of generated cases, leaving rigs out in turn, and writes the
// table. docs/developing.md says how it is used.

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "core/base/edition.h"
#include "tests/judges/rigs/random/random_rigs.h"
#include "tests/learn/collect.h"
#include "tests/support/parallel.h"

namespace penpose::learn {
namespace {

using inference::k_term_count;
using inference::Term;
using inference::Terms;

/// Rigs made by lot: seeds from 1 on.
constexpr std::uint64_t k_random_rigs = 32;
/// Rigs made with care count more: each is like one that many people have.
constexpr double k_made_with_care = 4.0;
/// Rigs are left out in so many parts.
constexpr std::size_t k_parts = 8;
/// How strongly weights are held near 0.
constexpr double k_width = 8.0;
/// Weights before anything is learned.
constexpr double k_first = 4.0;

constexpr const char* k_usage =
    "usage: learn [--rounds N] [--set SCALE=VALUE]... [-o TABLE.cpp]\n"
    "  --rounds N    rounds of search and learning (4)\n"
    "  --set ...     another value of a scale of the table, such as reach=8\n"
    "  -o TABLE.cpp  writes the table, core/inference/learned_weights.cpp\n";

struct Arguments {
  int rounds = 4;
  std::string table;
  inference::Weights weights;
};

bool set_scale(const std::string& text, inference::Weights& weights) {
  const std::size_t at = text.find('=');
  for (const inference::Scale& scale : inference::scales()) {
    if (at == std::string::npos || text.substr(0, at) != scale.name) continue;
    weights.*scale.value = std::stod(text.substr(at + 1));
    return true;
  }
  return false;
}

bool parse(int count, char** words, Arguments& arguments) {
  for (int i = 1; i + 1 < count; i += 2) {
    const std::string word = words[i];
    if (word == "--rounds") {
      arguments.rounds = std::stoi(words[i + 1]);
    } else if (word == "-o") {
      arguments.table = words[i + 1];
    } else if (word != "--set" || !set_scale(words[i + 1], arguments.weights)) {
      return false;
    }
  }
  return count % 2 == 1 && arguments.rounds > 0;
}

/// Terms that are not learned have no width: joints that lean and lines that are read from their other end are not
/// cases of faces.
Widths widths_of() {
  Widths widths;
  for (double& width : widths.values()) width = k_width;
  for (const Term fixed : {Term::evidence, Term::taught, Term::leaning, Term::one_end, Term::backwards})
    widths[fixed] = 0;
  return widths;
}

Terms first_weights() {
  Terms by;
  for (double& weight : by.values()) weight = k_first;
  by[Term::evidence] = 1;
  by[Term::taught] = 1;
  by[Term::leaning] = 1;
  // A line that goes far beyond one end of its curve is not that curve's.
  by[Term::one_end] = 100;
  return by;
}

std::vector<judges::Rig> rigs_to_learn_from() {
  std::vector<judges::Rig> rigs;
  for (const judges::RigMaker& maker : judges::own_rigs()) {
    if (maker.group != judges::Group::seen) continue;
    rigs.push_back(maker.make());
    if (rigs.back().lines.empty()) rigs.pop_back();
  }
  for (std::uint64_t seed = 1; seed <= k_random_rigs; ++seed) rigs.push_back(judges::random_rig(seed));
  return rigs;
}

using CasesOfRigs = std::vector<std::vector<LearnCase>>;

/// The cases of one part of the rigs, or of all others.
std::vector<LearnCase> part_of(const CasesOfRigs& of_rigs, std::size_t part, bool others) {
  std::vector<LearnCase> out;
  for (std::size_t r = 0; r < of_rigs.size(); ++r) {
    if ((r % k_parts == part) != others) out.insert(out.end(), of_rigs[r].begin(), of_rigs[r].end());
  }
  return out;
}

CasesOfRigs collect_all(const std::vector<judges::Rig>& rigs, const inference::Weights& weights,
                        std::vector<KnownReadings>& known) {
  CasesOfRigs of_rigs(rigs.size());
  tests::parallel_for(rigs.size(), 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) of_rigs[i] = collect(rigs[i], weights, known[i]);
  });
  for (std::vector<LearnCase>& cases : of_rigs) {
    for (LearnCase& one : cases) one.weight *= one.rig.starts_with("random") ? 1.0 : k_made_with_care;
  }
  return of_rigs;
}

/// The score of each rig by weights that were learned without its part.
Score score_left_out(const CasesOfRigs& of_rigs, const Terms& from, const Widths& widths) {
  std::vector<Terms> of_parts(k_parts);
  tests::parallel_for(k_parts, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t part = begin; part < end; ++part) of_parts[part] = fit(part_of(of_rigs, part, true), from, widths);
  });
  Score sum;
  for (std::size_t r = 0; r < of_rigs.size(); ++r) {
    const Score one = score(of_rigs[r], of_parts[r % k_parts]);
    const auto of = static_cast<double>(one.of);
    sum.loss += one.loss * of;
    sum.right += one.right * of;
    sum.of += one.of;
  }
  sum.loss /= static_cast<double>(sum.of);
  sum.right /= static_cast<double>(sum.of);
  return sum;
}

std::string shown(const char* what, const Score& score) {
  char text[160];
  std::snprintf(text, sizeof text, "%-18s loss %.3f, likeliest reading right in %.1f %% of %zu cases", what, score.loss,
                100 * score.right, score.of);
  return text;
}

/// The table as C++.
bool write(const std::string& path, const inference::Weights& weights, const std::string& figures) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (file == nullptr) return false;
  std::fprintf(
      file,
      "// Written by tests/learn/learn for edition %u; do not edit.\n// Rigs: those of tests/judges/rigs/seen and "
      "random rigs of the seeds 1 to %u.\n%s#include \"core/inference/weights.h\"\n\n"
      "namespace penpose::inference {\nnamespace {\n\nWeights learned_table() {\n  Weights w;\n",
      static_cast<unsigned>(base::k_edition), static_cast<unsigned>(k_random_rigs), figures.c_str());
  for (std::size_t k = 0; k < k_term_count; ++k)
    std::fprintf(file, "  w.by[Term::%s] = %.4g;\n", inference::name_of(static_cast<Term>(k)), weights.by.values()[k]);
  for (const inference::Scale& scale : inference::scales())
    std::fprintf(file, "  w.%s = %.4g;\n", scale.name, weights.*scale.value);
  std::fputs(
      "  return w;\n}\n\n}  // namespace\n\nconst Weights& learned_weights() {\n"
      "  static const Weights weights = learned_table();\n  return weights;\n}\n\n}  // namespace penpose::inference\n",
      file);
  return std::fclose(file) == 0;
}

int run(Arguments& arguments) {
  const std::vector<judges::Rig> rigs = rigs_to_learn_from();
  const Widths widths = widths_of();
  std::vector<KnownReadings> known(rigs.size());
  inference::Weights& weights = arguments.weights;
  weights.by = first_weights();
  std::string figures;
  for (int round = 1; round <= arguments.rounds; ++round) {
    const CasesOfRigs of_rigs = collect_all(rigs, weights, known);
    const std::vector<LearnCase> all = part_of(of_rigs, k_parts, true);
    std::printf("round %d: %zu cases\n  %s\n", round, all.size(), shown("as they are", score(all, weights.by)).c_str());
    const Terms by = fit(all, weights.by, widths);
    const std::string learned = shown("learned", score(all, by));
    const std::string left_out = shown("rigs left out", score_left_out(of_rigs, weights.by, widths));
    std::printf("  %s\n  %s\n", left_out.c_str(), learned.c_str());
    std::fflush(stdout);
    figures = "// " + left_out + ",\n// " + learned + ".\n";
    weights.by = by;
  }
  for (std::size_t k = 0; k < k_term_count; ++k)
    std::printf("    %-12s %9.4f\n", inference::name_of(static_cast<Term>(k)), weights.by.values()[k]);
  if (arguments.table.empty() || write(arguments.table, weights, figures)) return 0;
  std::fprintf(stderr, "%s: cannot be written; choose another place\n", arguments.table.c_str());
  return 1;
}

}  // namespace
}  // namespace penpose::learn

int main(int count, char** words) {
  penpose::learn::Arguments arguments;
  if (!penpose::learn::parse(count, words, arguments)) {
    std::fputs(penpose::learn::k_usage, stderr);
    return 2;
  }
  return penpose::learn::run(arguments);
}
