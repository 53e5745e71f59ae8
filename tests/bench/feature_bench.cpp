// feature_bench: feature curves found without names, on the built-in head and the shared ones: the mean distance to the
// curves of the files, both ways, in percent of the eyes' distance, how sure they are, and the time.

#include <algorithm>
#include <cstdio>
#include <ctime>

#include "core/portrait/features/find_features.h"
#include "tests/core/portrait/shared_heads.h"

int main() {
  using namespace penpose;
  for (const tests::KnownHead& head : tests::known_heads()) {
    const auto whole = intent::measure_whole_model(*head.model.rig);
    std::vector<portrait::FoundCurve> found;
    double best_ms = 1e300;
    for (int run = 0; run < 5; ++run) {
      const std::clock_t start = std::clock();
      found = portrait::find_features(*head.model.rig, *head.model.mesh, whole, head.model.front_yaw_degrees);
      best_ms = std::min(best_ms, 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    std::printf("%s: %zu vertices, %.1f ms\n", head.name.c_str(), head.model.mesh->vertex_count(), best_ms);
    const double eyes = tests::eye_distance(head.curves);
    for (const portrait::FoundCurve& curve : found) {
      std::printf("  %-16s sure %.2f%s", curve.curve.name.c_str(), curve.sureness,
                  curve.sureness < portrait::k_sure ? " (unsure)" : "");
      const auto known = head.curves.find(curve.curve.name);
      if (known != head.curves.end()) {
        const double off = tests::mean_distance(tests::places_of(curve.curve, *whole.rest), known->second);
        std::printf("  off %.2f %%", 100.0 * off / eyes);
      }
      std::puts("");
    }
  }
}
