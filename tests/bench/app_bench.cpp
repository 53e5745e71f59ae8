// From a pen's report to the solved pose, in the app without its window: every report of a trace of 300 a second that
// draws targets on a model, one by one.
//
//   app_bench [MODEL]      (the shared ict_face.glb by default)

#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "core/document/commands/command.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/view/posed_surface.h"
#include "ui/app/window/timings.h"
#include "ui/files/load_model.h"
#include "ui/render/framing.h"

namespace penpose::app {
namespace {

using Clock = std::chrono::steady_clock;

std::int64_t since_us(Clock::time_point start) {
  return std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - start).count();
}

int measure(const std::string& path) {
  auto document = files::load_document(path);
  if (!document) {
    std::fprintf(stderr, "%s\n", document.error().line(path).c_str());
    return 1;
  }
  std::int64_t now_us = 0;
  EditingSession editing([&] { return now_us; }, [](const std::string&, bool) {});
  editing.open(std::move(*document), nullptr, path);
  PosedSurface surface;
  surface.update(editing.shown().model(), editing.shown().pose());
  const geometry::Viewport window{1280, 800};
  const auto camera = render::frame_points(surface.positions(), window, {0, 0});
  editing.set_view({camera.pose(), window});
  const auto report = [&](geometry::PxPoint at, bool tip) {
    now_us += 3333;
    editing.input().pen({at, 0.6, true, tip, false, false});
  };
  // The mouth lies about three quarters down a face; where there is no surface the reference is refused and drawn
  // lower.
  std::vector<std::int64_t> times;
  std::vector<std::int64_t> cpu;
  std::size_t strokes = 0;
  std::vector<std::int64_t> surfaces;
  for (int stroke = 0; stroke < 24; ++stroke) {
    const double y = 400 + 12.0 * (stroke % 12);
    const auto at = [&](int i, double rise) {
      const double x = i / 150.0;
      return geometry::PxPoint{560 + 160 * x, y - rise * 4 * (x - 0.5) * (x - 0.5)};
    };
    for (int i = 0; i <= 150; ++i) report(at(i, 0), true);
    report(at(150, 0), false);
    for (int i = 0; i <= 150; ++i) {
      const auto start = Clock::now();
      const std::int64_t cpu_before = thread_cpu_us();
      report(at(i, 24), true);
      editing.shown().follow_pen();
      // A line that misses the model is no reference, and the next stroke draws none of its target.
      if (!editing.shown().live().active()) continue;
      times.push_back(since_us(start));
      cpu.push_back(thread_cpu_us() - cpu_before);
      if (i == 150) ++strokes;
      const auto posed = Clock::now();
      surface.update(editing.shown().model(), editing.shown().pose());
      surfaces.push_back(since_us(posed));
    }
    report(at(150, 24), false);
    editing.perform(document::ClearCurves{});
    editing.perform(document::ResetParameters{});
  }
  std::printf("%s: %zu reports of %zu strokes while a target is drawn\n", path.c_str(), times.size(), strokes);
  std::printf("report to pose    median %lld us, p99 %lld us, worst %lld us\n",
              static_cast<long long>(percentile(times, 0.5)), static_cast<long long>(percentile(times, 0.99)),
              static_cast<long long>(percentile(times, 1)));
  std::printf("  its CPU time    median %lld us, p99 %lld us, worst %lld us\n",
              static_cast<long long>(percentile(cpu, 0.5)), static_cast<long long>(percentile(cpu, 0.99)),
              static_cast<long long>(percentile(cpu, 1)));
  std::printf("pose to surface   median %lld us, p99 %lld us\n", static_cast<long long>(percentile(surfaces, 0.5)),
              static_cast<long long>(percentile(surfaces, 0.99)));
  return 0;
}

}  // namespace
}  // namespace penpose::app

int main(int argc, char** argv) {
  const std::string path = argc > 1 ? argv[1] : std::string(PENPOSE_SHARED_DIR) + "/meshes/ict_face.glb";
  return penpose::app::measure(path);
}
