// A frame of the window's picture by each way to draw, with one sample a px and no darkening of creases, as the window
// draws it while something moves: milliseconds a frame (median), CPU time of all threads a frame, and the memory that
// drawing adds at its peak. The pose changes each frame. llvmpipe and softpipe are Mesa's software renderers.
//
//   draw_bench [MODEL...]                    all ways and sizes, a process each; builtin:demo where no model is named
//   draw_bench --one gl|es|cpu MODEL WxH all|part     one of them

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "ui/files/load_model.h"
#include "ui/render/appearance.h"
#include "ui/render/cpu/cpu_renderer.h"
#include "ui/render/framing.h"
#include "ui/render/renderer.h"

namespace penpose {
namespace {

/// softpipe takes a second a frame.
const int k_frames =
    std::getenv("GALLIUM_DRIVER") != nullptr && std::string(std::getenv("GALLIUM_DRIVER")) == "softpipe" ? 5 : 60;

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

double cpu_ms() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return 1000 * (seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime));
}

double resident_mb(const char* what) {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word) {
    double kb = 0;
    if (word == what && status >> kb) return kb / 1024;
  }
  return 0;
}

int measure(const std::string& way, const std::string& name, const std::string& size, const std::string& part) {
  geometry::Viewport viewport;
  if (std::sscanf(size.c_str(), "%dx%d", &viewport.width, &viewport.height) != 2) return 2;
  const auto model = files::load_model(name, files::NamedBy::user);
  if (!model) {
    std::fprintf(stderr, "%s\n", model.error().line(name).c_str());
    return 1;
  }
  render::PosedMesh posed = render::posed_mesh(*model);
  const render::Appearance appearance = render::make_appearance(*model, {});
  const auto camera = render::frame_points(posed.positions, viewport);
  const double before_mb = resident_mb("VmRSS:");
  const render::DrawWay wanted = way == "gl"   ? render::DrawWay::gl
                                 : way == "es" ? render::DrawWay::es
                                               : render::DrawWay::cpu;
  auto made = render::make_offscreen_renderer(wanted);
  if (!made) {
    std::fprintf(stderr, "%s\n", made.error().line(way).c_str());
    return 1;
  }
  render::Renderer& renderer = **made;
  renderer.set_occlusion(false);
  renderer.set_smoothing(true);
  render::Scene scene = render::scene_of(*model, posed, appearance);
  scene.shape_number = 1;
  document::Model moved = *model;
  std::vector<double> times;
  double cpu = 0;
  const float step = 1e-3F / static_cast<float>(k_frames);
  for (int frame = 0; frame < k_frames + 5; ++frame) {
    // All of it moves, as when it is turned; or a part of it, as when a line is drawn.
    if (part == "all") {
      for (glm::vec3& p : posed.positions) p *= 1.0F + step;
    } else {
      moved.pose[0] = 0.01 * frame;
      posed = render::posed_mesh(moved);
      scene.positions = posed.positions;
      scene.normals = posed.normals;
    }
    scene.pose_number = static_cast<std::uint64_t>(frame) + 1;
    const double cpu_before = cpu_ms();
    const auto began = std::chrono::steady_clock::now();
    const auto picture = renderer.render(scene, camera);
    if (!picture) {
      std::fprintf(stderr, "%s\n", picture.error().line(way).c_str());
      return 1;
    }
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - began;
    if (frame < 5) continue;
    times.push_back(took.count());
    cpu += cpu_ms() - cpu_before;
  }
  std::sort(times.begin(), times.end());
  std::printf("%8.2f %8.2f %8.1f\n", times[times.size() / 2], cpu / k_frames, resident_mb("VmHWM:") - before_mb);
  return 0;
}

int run_one(const char* program, const char* driver, const std::string& way, const std::string& model,
            const std::string& size, const std::string& part) {
  std::printf("  %-9s %-4s  %-3s %-9s", size.c_str(), part.c_str(), way.c_str(), driver == nullptr ? "" : driver);
  std::fflush(stdout);
  const pid_t child = ::fork();
  if (child == 0) {
    if (driver != nullptr) ::setenv("GALLIUM_DRIVER", driver, 1);
    if (driver != nullptr) ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    ::execl(program, program, "--one", way.c_str(), model.c_str(), size.c_str(), part.c_str(), nullptr);
    ::_exit(127);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

}  // namespace
}  // namespace penpose

int main(int argc, char** argv) {
  if (argc == 6 && std::strcmp(argv[1], "--one") == 0) return penpose::measure(argv[2], argv[3], argv[4], argv[5]);
  std::vector<std::string> models(argv + 1, argv + argc);
  if (models.empty()) models.emplace_back("builtin:demo");
  for (const std::string& model : models) {
    std::printf("%s\n  size      moves way            ms/frame  cpu ms  MB\n", model.c_str());
    for (const char* size : {"800x480", "1280x800", "1920x1080"}) {
      for (const char* part : {"all", "part"}) {
        penpose::run_one(argv[0], nullptr, "cpu", model, size, part);
        penpose::run_one(argv[0], "llvmpipe", "gl", model, size, part);
        penpose::run_one(argv[0], "llvmpipe", "es", model, size, part);
        penpose::run_one(argv[0], "softpipe", "gl", model, size, part);
      }
    }
  }
  return 0;
}
