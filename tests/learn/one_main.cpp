// temporary: prints readings of one case of a rig
#include <cstdio>
#include <string>
#include "core/intent/solve.h"
#include "core/tracking/case_problem.h"
#include "tests/judges/cases/gestures.h"
#include "tests/judges/cases/known_faces.h"
#include "tests/judges/measures/gesture_judge.h"
#include "tests/judges/rigs/control_words.h"
#include "tests/learn/collect.h"
using namespace penpose;
int main(int c, char** v) {
  for (const judges::RigMaker& maker : judges::own_rigs()) {
    if (maker.group != judges::Group::seen || std::string(v[1]) != maker.name) continue;
    auto rig = maker.make();
    learn::KnownReadings known;
    std::string want = v[2];
    for (auto& one : learn::collect(rig, inference::learned_weights(), known)) {
      if (one.name.find(want) == std::string::npos) continue;
      std::printf("== %s\n", one.name.c_str());
      int n = 0;
      auto w = inference::learned_weights().by;
      auto list = one.candidates;
      std::stable_sort(list.begin(), list.end(), [&](auto& a, auto& b) { return w.dot(a.terms) < w.dot(b.terms); });
      for (auto& cand : list) {
        if (n++ > (c > 3 ? std::stoi(v[3]) : 8)) break;
        std::printf("%s %7.2f |", cand.right ? "RIGHT" : "wrong", w.dot(cand.terms));
        for (std::size_t k = 0; k < inference::k_term_count; ++k)
          if (cand.terms.values()[k] != 0) std::printf(" %s %.2f", inference::name_of(static_cast<inference::Term>(k)), w.values()[k]*cand.terms.values()[k]);
        std::printf(" raw astray %.2f determined %.2f limit %.2f share %.2f || %s\n", cand.terms[inference::Term::astray], cand.terms[inference::Term::determined], cand.terms[inference::Term::limit], cand.terms[inference::Term::share], cand.note.c_str());
      }
    }
  }
}
