// A frame of the window that the processor draws, whole: what the app prepares, the panels, the model and the copy to
// the screen, on one thread but for the renderer's own. Milliseconds a frame (median). To count instructions:
//
//   taskset -c 0 valgrind --tool=callgrind --toggle-collect='penpose::app::measured_frame*' window_bench turn
//
//   window_bench [turn|coarse|draw|rest] [MODEL] [WxH]     all, builtin:demo, 800x480 where they are left out

#include <SDL2/SDL_pixels.h>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <imgui.h>
#include <string>
#include <vector>

#include "tests/support/app_desk.h"
#include "ui/app/view/draw_frame.h"
#include "ui/app/view/present/cpu_presenter.h"
#include "ui/app/view/present/moving_detail.h"
#include "ui/app/view/present/output/px_copy.h"

namespace penpose::app {

constexpr int k_frames = 40;

/// A screen of 32 bits a px in memory.
class MemoryOutput final : public PictureOutput {
 public:
  explicit MemoryOutput(geometry::Viewport size)
      : size_(size), px_(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) * 4) {}
  [[nodiscard]] std::optional<geometry::Viewport> size() const override { return size_; }
  [[nodiscard]] double dpi() const override { return 0; }
  void show(const render::Image& picture, const std::vector<render::PxRect>& parts) override {
    for (const render::PxRect& part : parts)
      copy_px(picture, part, {px_.data(), size_.width * 4, SDL_PIXELFORMAT_ARGB8888, size_});
  }

 private:
  geometry::Viewport size_;
  std::vector<std::uint8_t> px_;
};

/// By its name callgrind knows when to count.
__attribute__((noinline)) void measured_frame(Desk& desk, FrameMaker& frames, Presenter& presenter) {
  desk.frames(1);
  const DrawFrame frame = frames.make();
  static_cast<void>(presenter.draw(frame, *ImGui::GetDrawData()));
  presenter.show();
}

void measure(const std::string& what, const std::string& model, geometry::Viewport size) {
  const bool coarse = what == "coarse";
  Desk desk("window_bench", model);
  desk.begin();
  App& app = *desk.app;
  app.of<Pointer>().resized(size, 0);
  desk.frames();
  FrameMaker frames({app.of<EditingSession>(), app.of<Canvas>(), app.of<CanvasLook>(), app.of<CanvasDrawing>(),
                     app.of<Controls>(), app.of<Preferences>(), app.of<Cast>()});
  MemoryOutput output(size);
  // By a clock that goes by itself pictures count as slow, for the time that a coarse one takes.
  std::int64_t clock_us = 0;
  const std::int64_t tick_us = coarse ? MovingDetail::k_most_us + 1 : 1;
  const auto presenter = make_cpu_presenter(output, Rotation::none, false, [&] { return clock_us += tick_us; });
  static_cast<void>(presenter->begin());
  Pointer& pointer = app.of<Pointer>();
  const auto draw = [&] {
    static_cast<void>(presenter->draw(frames.make(), *ImGui::GetDrawData()));
    presenter->show();
  };
  std::vector<PxPoint> line;
  const PxPoint middle{0.5 * size.width, 0.5 * size.height};
  if (what == "draw") {
    const std::string curve = any_curve(desk);
    desk.stroke(desk.named_curve(curve));
    line = desk.named_curve(curve, {0, -6});
    pointer.moved(line.front());
    pointer.button(MouseButton::left, true, line.front());
  } else if (what == "turn" || coarse) {
    pointer.button(MouseButton::middle, true, middle);
  }
  for (int i = 0; i < 4; ++i, desk.frames(1)) draw();
  std::vector<double> times;
  for (int i = 1; i <= k_frames; ++i) {
    if (what == "turn" || coarse) pointer.moved({middle.x + 6.0 + 3.0 * i, middle.y + i});
    if (what == "draw") {
      const double t = static_cast<double>(i) / k_frames * static_cast<double>(line.size() - 1);
      const auto k = std::min(static_cast<std::size_t>(t), line.size() - 2);
      pointer.moved(line[k] * (1 - t + static_cast<double>(k)) + line[k + 1] * (t - static_cast<double>(k)));
    }
    const auto began = std::chrono::steady_clock::now();
    measured_frame(desk, frames, *presenter);
    times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began).count());
  }
  presenter->end();
  std::sort(times.begin(), times.end());
  std::printf("%-6s %dx%d %s: %.2f ms a frame, %d frames\n", what.c_str(), size.width, size.height, model.c_str(),
              times[times.size() / 2], k_frames);
}

}  // namespace penpose::app

int main(int argc, char** argv) {
  const std::string only = argc > 1 ? argv[1] : "";
  penpose::geometry::Viewport size{800, 480};
  if (argc > 3 && std::sscanf(argv[3], "%dx%d", &size.width, &size.height) != 2) return 2;
  for (const char* what : {"turn", "coarse", "draw", "rest"}) {
    if (only.empty() || only == what) penpose::app::measure(what, argc > 2 ? argv[2] : "builtin:demo", size);
  }
  return 0;
}
