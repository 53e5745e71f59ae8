// Learns the weights of core/inference from readings of generated cases, leaving rigs out in turn, and writes the
// table. docs/developing.md says how it is used.

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "tests/judges/rigs/random/random_rigs.h"
#include "tests/judges/rigs/rig.h"
#include "tests/learn/collect.h"
#include "tests/support/parallel.h"

namespace penpose::learn {
namespace {

using inference::k_term_count;
using inference::Term;
using inference::Terms;

Widths widths_of() {
  Widths widths;
  for (std::size_t k = 0; k < k_term_count; ++k) widths.values()[k] = 8.0;
  widths[Term::evidence] = 0;
  widths[Term::taught] = 0;
  widths[Term::leaning] = 0;
  widths[Term::one_end] = 0;
  return widths;
}

/// Rigs made by lot.
constexpr std::uint64_t k_random_rigs = 32;
/// Rigs made with care count more: each is like one that many people have.
constexpr double k_made_with_care = 4.0;

/// Rigs are left out in so many parts.
constexpr std::size_t k_parts = 8;

/// The cases of one part of the rigs, or of all others.
std::vector<LearnCase> part_of(const std::vector<std::vector<LearnCase>>& of_rigs, std::size_t part, bool others) {
  std::vector<LearnCase> out;
  for (std::size_t r = 0; r < of_rigs.size(); ++r) {
    if ((r % k_parts == part) != others) out.insert(out.end(), of_rigs[r].begin(), of_rigs[r].end());
  }
  return out;
}

void print(const char* what, const Score& score) {
  std::printf("  %-24s %6.3f loss  %5.1f %% of %zu\n", what, score.loss, 100 * score.right, score.of);
}

/// The table as C++.
bool write(const char* path, const inference::Weights& weights) {
  std::FILE* file = std::fopen(path, "w");
  if (file == nullptr) return false;
  std::fputs("// Written by tests/learn/learn; do not edit.\n#include \"core/inference/weights.h\"\n\n"
             "namespace penpose::inference {\nnamespace {\n\nWeights table() {\n  Weights w;\n", file);
  for (std::size_t k = 0; k < k_term_count; ++k)
    std::fprintf(file, "  w.by[Term::%s] = %.4g;\n", inference::name_of(static_cast<Term>(k)), weights.by.values()[k]);
  for (const inference::Scale& scale : inference::scales())
    std::fprintf(file, "  w.%s = %.4g;\n", scale.name, weights.*scale.value);
  std::fputs("  return w;\n}\n\n}  // namespace\n\nconst Weights& learned_weights() {\n"
             "  static const Weights weights = table();\n  return weights;\n}\n\n"
             "}  // namespace penpose::inference\n", file);
  return std::fclose(file) == 0;
}

int run(int rounds, const char* path) {
  std::vector<judges::Rig> rigs;
  for (const judges::RigMaker& maker : judges::own_rigs()) {
    if (maker.group != judges::Group::seen) continue;
    rigs.push_back(maker.make());
    if (rigs.back().lines.empty()) rigs.pop_back();
  }
  for (std::uint64_t seed = 1; seed <= k_random_rigs; ++seed) rigs.push_back(judges::random_rig(seed));
  std::vector<KnownReadings> known(rigs.size());
  inference::Weights weights = inference::learned_weights();
  weights.by[Term::taught] = 1.0;
  if (const char* set = std::getenv("LEARN_SET")) {
    const std::string text = set;
    for (const inference::Scale& scale : inference::scales()) {
      if (text.substr(0, text.find('=')) == scale.name) weights.*scale.value = std::stod(text.substr(text.find('=') + 1));
    }
  }
  for (int round = 0; round < rounds; ++round) {
    std::vector<std::vector<LearnCase>> of_rigs(rigs.size());
    tests::parallel_for(rigs.size(), 0, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) of_rigs[i] = collect(rigs[i], weights, known[i]);
    });
    for (std::vector<LearnCase>& cases : of_rigs) {
      for (LearnCase& one : cases) one.weight *= one.rig.starts_with("random") ? 1.0 : k_made_with_care;
    }
    std::vector<LearnCase> all;
    for (auto& some : of_rigs) all.insert(all.end(), some.begin(), some.end());
    std::size_t none = 0, only = 0;
    for (const LearnCase& one : all) {
      std::size_t right = 0;
      for (const Candidate& c : one.candidates) right += c.right ? 1 : 0;
      none += right == 0 ? 1 : 0;
      only += right == one.candidates.size() && right > 0 ? 1 : 0;
    }
    std::printf("round %d: %zu cases, %zu without a right reading, %zu with right ones alone\n", round, all.size(), none,
                only);
    print("as they are", score(all, weights.by));
    const Widths widths = widths_of();
    Score left;
    std::vector<Terms> of_parts(k_parts);
    tests::parallel_for(k_parts, 0, [&](std::size_t begin, std::size_t end) {
      for (std::size_t part = begin; part < end; ++part)
        of_parts[part] = fit(part_of(of_rigs, part, true), weights.by, widths);
    });
    for (std::size_t r = 0; r < rigs.size(); ++r) {
      const Score one = score(of_rigs[r], of_parts[r % k_parts]);
      left.loss += one.loss * static_cast<double>(one.of);
      left.right += one.right * static_cast<double>(one.of);
      left.of += one.of;
      print(rigs[r].name.c_str(), one);
    }
    left.loss /= static_cast<double>(left.of);
    left.right /= static_cast<double>(left.of);
    print("rigs left out", left);
    weights.by = fit(all, weights.by, widths);
    // The bound of the search may rest at 0 where it need not.
    Terms lifted = weights.by;
    for (std::size_t k = 0; k < k_term_count; ++k) {
      if (widths.values()[k] != 0.0) lifted.values()[k] = std::max(lifted.values()[k], 0.5);
    }
    const Terms again = fit(all, lifted, widths);
    std::printf("  lifted: %.5f, was %.5f\n", loss(all, again, widths), loss(all, weights.by, widths));
    if (loss(all, again, widths) < loss(all, weights.by, widths)) weights.by = again;
    print("learned", score(all, weights.by));
    for (std::size_t k = 0; k < k_term_count; ++k)
      std::printf("    %-12s %9.4f\n", inference::name_of(static_cast<Term>(k)), weights.by.values()[k]);
    std::fflush(stdout);
  }
  return path == nullptr || write(path, weights) ? 0 : 1;
}

}  // namespace
}  // namespace penpose::learn

int main(int count, char** words) { return penpose::learn::run(count > 1 ? std::stoi(words[1]) : 3, count > 2 ? words[2] : nullptr);
}
