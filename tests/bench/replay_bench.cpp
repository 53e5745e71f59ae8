// An hour of drawing, replayed: 300 reports a second, about a million of them, on the built-in head with its fifteen
// deformers. The pen draws a reference and a target in turn along brows, lids, mouth and cheeks; after four pairs the
// curves are cleared, or never. Recorded sessions hold the state after every stroke, which is compared. The session
// lies in a file, so that the memory counted is the replay's own.

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include "core/character/demo_head.h"
#include "replay/session/live_session.h"
#include "replay/session/session_player.h"
#include "replay/session/session_recorder.h"
#include "replay/session/virtual_pen.h"
#include "ui/files/trace_file.h"

namespace penpose {
namespace {

constexpr int k_rate = 300;

class Drawing {
 public:
  Drawing(std::uint64_t reports, bool clears) : left_(reports), clears_(clears) {
    const geometry::CameraPose camera{{0.05, 0.02, 0.9}, {0, 0.0, 0}, {0, 1, 0}, 24};
    writer_.comment(replay::to_text(replay::ViewChanged{{camera, {1000, 1000}}}));
    writer_.declare(0, replay::virtual_pen_device());
  }

  base::Result<std::size_t> read(std::span<std::uint8_t> into) {
    while (text_.size() - at_ < into.size() && left_ > 0) make_stroke();
    const std::size_t count = std::min(into.size(), text_.size() - at_);
    std::copy_n(text_.begin() + static_cast<std::ptrdiff_t>(at_), count, into.begin());
    at_ += count;
    if (at_ > std::size_t{1} << 20U) {
      text_.erase(0, at_);
      at_ = 0;
    }
    return count;
  }

 private:
  /// A second of drawing and half a second in the air.
  void make_stroke() {
    const double height = 300 + 60 * static_cast<double>((stroke_ / 2) % 7);
    const double lift = stroke_ % 2 == 0 ? 0 : 12 * static_cast<double>((stroke_ / 2) % 3) - 12;
    for (int i = 0; i < k_rate * 3 / 2 && left_ > 0; ++i, --left_) {
      const bool tip = i < k_rate;
      const double u = tip ? static_cast<double>(i) / k_rate : 1;
      const replay::VirtualPenState state{
          {380 + 240 * u, height + lift * 4 * u * (1 - u)}, 0.5, true, tip, false, false};
      const auto report = replay::virtual_pen_report(state, {1000, 1000});
      writer_.report(0, time_us_, report);
      time_us_ += 1'000'000 / k_rate;
    }
    if (++stroke_ % 8 == 0 && clears_) writer_.comment(replay::to_text(replay::Performed{document::ClearCurves{}}));
    if (stroke_ % 8 == 0 && clears_) writer_.comment(replay::to_text(replay::Performed{document::ResetParameters{}}));
    text_ += writer_.take();
  }

  replay::TraceWriter writer_;
  std::string text_;
  std::size_t at_ = 0;
  std::uint64_t left_;
  bool clears_;
  std::uint64_t stroke_ = 0;
  std::int64_t time_us_ = 0;
};

double peak_mb() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void replay_drawing(benchmark::State& state) {
  const auto reports = static_cast<std::uint64_t>(state.range(0)) * 60 * k_rate;
  replay::PlayerOptions options;
  options.open = [](const std::string&) {
    return base::Result<document::Document>(document::make_document(character::make_demo_head().value()));
  };
  // As it was recorded: with the state after every stroke, in a file.
  const files::File file(std::tmpfile(), &std::fclose);
  {
    Drawing drawing(reports, state.range(1) != 0);
    replay::SessionWriter writer(
        [&](std::string_view text, bool) -> base::Status {
          if (std::fwrite(text.data(), 1, text.size(), file.get()) == text.size()) return base::Done{};
          return base::Error{"the session cannot be written", "", ""};
        },
        "bench");
    replay::SessionRecorder recorder(writer);
    options.observer = &recorder;
    const auto drawn = replay::play_session([&](std::span<std::uint8_t> into) { return drawing.read(into); }, options);
    if (!drawn.ok()) state.SkipWithError("the drawing is refused");
    if (!writer.flush(true)) state.SkipWithError("the session cannot be written");
    options.observer = nullptr;
  }
  replay::ReplayResult played;
  const double before = peak_mb();
  for (auto _ : state) {
    std::rewind(file.get());
    played = replay::play_session(files::read_from_file(file.get()), options).value();
  }
  if (played.checked == 0 || played.differing > 0) state.SkipWithError("the states are not those that were recorded");
  state.counters["reports"] = static_cast<double>(played.reports);
  state.counters["strokes"] = static_cast<double>(played.session->stroke_count());
  state.counters["refused"] = static_cast<double>(played.refused);
  state.counters["peak_MB"] = peak_mb();
  state.counters["peak_MB_before"] = before;
}
BENCHMARK(replay_drawing)
    ->ArgsProduct({{1, 10, 60}, {1, 0}})
    ->ArgNames({"minutes", "clears"})
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

}  // namespace
}  // namespace penpose
