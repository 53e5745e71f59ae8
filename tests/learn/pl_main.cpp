#include <cstdio>
#include <nlohmann/json.hpp>
#include "core/intent/solve.h"
#include "tests/judges/shared/kinds.h"
#include "tests/judges/shared/shared_cases.h"
using namespace penpose;
int main() {
  const auto kind = judges::make_kind("kiss_or_ooh");
  const auto whole = intent::measure_whole_model(*kind.model.rig);
  const auto ps = kind.model.rig->parameters();
  std::printf("samples %zu\n", whole.fields->samples().size());
  for (std::size_t p = 0; p < ps.size(); ++p) {
    if (whole.joint[p] != intent::k_no_partner) continue;
    std::printf("%s usual %.4f:", ps[p].name.c_str(), whole.fields->usual_way(p));
    for (auto& place : whole.places[p]) { auto at = whole.fields->places()[place.samples[0]]; std::printf(" [%.4f n%zu at %.3f %.3f %.3f]", place.way, place.samples.size(), at.x, at.y, at.z); }
    std::printf("\n");
  }
}
