// temporary: prints lost cases of rigs
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <cstdio>
#include <string>
#include "tests/judges/rigs/random/random_rigs.h"
#include "tests/judges/shared/kinds.h"
#include "tests/judges/shared/shared_cases.h"
#include "tests/learn/collect.h"
#include "tests/support/parallel.h"
using namespace penpose;
int main(int, char** v) {
  const int from = std::stoi(v[1]), to = std::stoi(v[2]);
  std::vector<judges::Rig> rigs;
  if (from == 0)
    for (const judges::RigMaker& maker : judges::own_rigs())
      if (maker.group == judges::Group::seen) { rigs.push_back(maker.make()); if (rigs.back().lines.empty()) rigs.pop_back(); }
  for (int q = std::max(1, from); q <= to; ++q) rigs.push_back(judges::random_rig(q));
  if (from == -1) rigs.resize(8);
  const std::vector<std::string> kinds = judges::kind_names();
  std::vector<std::string> out(rigs.size());
  tests::parallel_for(rigs.size(), 0, [&](std::size_t b, std::size_t e) {
    for (std::size_t r = b; r < e; ++r) {
      learn::KnownReadings known;
      const auto w = inference::learned_weights().by;
      out[r] = "#### " + rigs[r].name + " " + rigs[r].kind + "\n";
      std::vector<learn::LearnCase> cases;
      if (from == -1) {
        if (r < 2) {
          const std::string n = r == 0 ? "ict_face" : "ict_avatar";
          const auto model = judges::read_shared_model(n + ".glb");
          learn::Asked asked{n, model, {}, judges::known_faces_of(model, judges::read_shared_cases(n + "_intent_cases.json"))};
          if (r == 1) asked.gestures = judges::gestures_of(model, judges::read_shared_cases("ict_avatar_gestures.json"));
          cases = learn::collect(asked, inference::learned_weights(), known);
        } else if (r - 2 < kinds.size()) {
          const auto kind = judges::make_kind(kinds[r - 2]);
          learn::Asked asked{kinds[r - 2], kind.model, kind.gestures, {}};
          cases = learn::collect(asked, inference::learned_weights(), known);
        }
        out[r] += cases.empty() ? "" : cases.front().rig + "\n";
      } else {
        cases = learn::collect(rigs[r], inference::learned_weights(), known);
      }
      for (auto& one : cases) {
        auto list = one.candidates;
        if (list.empty()) continue;
        std::stable_sort(list.begin(), list.end(), [&](auto& a, auto& d) { return w.dot(a.terms) < w.dot(d.terms); });
        if (list.front().right) continue;
        auto right = std::find_if(list.begin(), list.end(), [](auto& x) { return x.right; });
        out[r] += one.name + " | " + list.front().note.substr(0, 90) + " | ";
        if (right == list.end()) { out[r] += "NONE\n"; continue; }
        out[r] += right->note.substr(0, 90) + " |";
        char buf[99];
        std::snprintf(buf, 99, " %+.1f:", w.dot(right->terms) - w.dot(list.front().terms)); out[r] += buf;
        for (std::size_t k = 0; k < inference::k_term_count; ++k) {
          const double d = right->terms.values()[k] - list.front().terms.values()[k];
          const double wd = d * w.values()[k];
          if (std::abs(wd) < 0.5 && !(w.values()[k] == 0 && std::abs(d) > 0.3)) continue;
          std::snprintf(buf, 99, " %s %+.1f", inference::name_of(static_cast<inference::Term>(k)), w.values()[k] == 0 ? d : wd); out[r] += buf;
          if (w.values()[k] == 0) out[r] += "*";
        }
        out[r] += "\n";
      }
    }
  });
  for (auto& o : out) std::fputs(o.c_str(), stdout);
}
