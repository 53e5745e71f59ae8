#include "ui/render/renderer.h"

#include <utility>

#include "ui/render/cpu/cpu_renderer.h"
#include "ui/render/offscreen_ways.h"

namespace penpose::render {

std::string_view name_of(DrawWay way) { return way == DrawWay::gl ? "gl" : way == DrawWay::es ? "es" : "cpu"; }

std::optional<DrawWay> way_of(std::string_view name) {
  for (const DrawWay way : {DrawWay::gl, DrawWay::es, DrawWay::cpu}) {
    if (name == name_of(way)) return way;
  }
  return std::nullopt;
}

std::vector<DrawWay> built_in_ways() {
  std::vector<DrawWay> ways;
  for (const OffscreenWay& one : card_ways()) ways.push_back(one.way);
  ways.push_back(DrawWay::cpu);
  return ways;
}

std::vector<WayHere> ways_here() {
  std::vector<WayHere> ways;
  for (const DrawWay way : built_in_ways()) {
    const auto made = make_offscreen_renderer(way);
    ways.push_back(
        {way, made ? base::Result<std::string>((*made)->driver()) : base::Result<std::string>(made.error())});
  }
  return ways;
}

base::Result<std::unique_ptr<Renderer>> make_offscreen_renderer(std::optional<DrawWay> way) {
  for (const OffscreenWay& one : card_ways()) {
    if (way && *way != one.way) continue;
    auto made = one.make();
    if (made || way) return made;
  }
  if (way && *way != DrawWay::cpu) {
    return base::Error{"this penpose was built without OpenGL", std::string(name_of(*way)), "draw with cpu"};
  }
  return std::unique_ptr<Renderer>(std::make_unique<CpuRenderer>());
}

}  // namespace penpose::render
