// Animation from tracked curves on the shared face: frames a second with the ten curves of the bundled map, and with
// eight of them. `--benchmark_counters_tabular=true` shows frames_per_second.

#include <benchmark/benchmark.h>

#include "core/animation/animate_track.h"
#include "core/tracking/track_setup.h"
#include "tests/support/shared_data.h"
#include "ui/cli/track/track_input.h"
#include "ui/files/load_model.h"

namespace {

using namespace penpose;

void animate_face(benchmark::State& state) {
  const auto model = files::load_model((tests::shared_dir() / "meshes" / "ict_face.glb").string()).value();
  const auto input =
      cli::read_track((tests::shared_dir() / "tracks" / "openface_head_test.csv").string(), {}, {}).value();
  const auto& track = std::get<animation::PointTrack>(input.track);
  auto map = io::read_bundled_map(*input.format).value();
  map.curves.resize(static_cast<std::size_t>(state.range(0)));
  if (state.range(1) != 0) map.free.clear();
  std::vector<std::string> notes;
  const auto setup = tracking::make_setup(model, track, map, {}, notes).value();
  const auto camera = geometry::frame_box(document::rest_world_box(model), {1000, 1000}, 0);
  for (auto _ : state) benchmark::DoNotOptimize(animation::animate_track(*model.rig, track, setup, camera));
  state.counters["frames_per_second"] =
      benchmark::Counter(static_cast<double>(track.frames.size()), benchmark::Counter::kIsIterationInvariantRate);
}

}  // namespace

// Curves; the map's own 23 controls or all 53.
BENCHMARK(animate_face)->Args({8, 0})->Args({10, 0})->Args({10, 1})->Unit(benchmark::kMillisecond);

int main(int argc, char** argv) {
  if (!penpose::tests::has_shared()) return 0;
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
