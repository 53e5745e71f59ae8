// A timeline of many keys: what a frame of the app costs while it is scrubbed, panels and draw lists with it, without
// what draws them.
//
//   timeline_bench [MODEL [KEYS]]      (the built-in head, 10000 keys of all controls)

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "core/document/commands/list/time_commands.h"
#include "ui/app/app.h"
#include "ui/app/interface.h"

namespace penpose::app {
namespace {

int measure(const std::string& model, std::size_t count) {
  std::int64_t now_us = 0;
  AppOptions options;
  options.clock = [&] { return now_us; };
  App app(options);
  if (const auto opened = app.of<Files>().open(model); !opened) {
    std::fprintf(stderr, "%s\n", opened.error().line(model).c_str());
    return 1;
  }
  auto& editing = app.of<EditingSession>();
  document::KeyPoses keys;
  const auto parameters = editing.document().model->rig->parameters();
  for (const auto& parameter : parameters) keys.names.push_back(parameter.name);
  for (std::size_t k = 0; k < count; ++k) {
    keys.times_s.push_back(static_cast<double>(k) / 24);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const double share = 0.5 + 0.5 * std::sin(0.1 * static_cast<double>(k * (i + 1)));
      keys.values.push_back(parameters[i].rest + share * (parameters[i].maximum - parameters[i].rest));
    }
  }
  editing.perform(keys);
  Interface interface(app);
  app.of<Dialogs>().show(Dialog::none);
  const auto frame = [&] {
    now_us += 16'667;
    app.begin_frame();
    interface.frame(0.016667);
  };
  for (const auto& [part, name] : {std::pair{TimelinePart::poses, "poses"}, std::pair{TimelinePart::sheet, "sheet"},
                                   std::pair{TimelinePart::curves, "curves"}}) {
    app.of<PanelState>().own.of<TimelineShown>().part = part;
    app.of<PanelState>().own.of<TimelineShown>().all_rows = true;
    for (int i = 0; i < 5; ++i) frame();
    std::vector<double> ms;
    for (int i = 0; i < 200; ++i) {
      app.of<Playback>().scrub(static_cast<double>(i * 37 % 1000) / 1000 * static_cast<double>(count) / 24);
      const auto start = std::chrono::steady_clock::now();
      frame();
      ms.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    std::sort(ms.begin(), ms.end());
    std::printf("%-8s %zu keys of %zu controls: median %6.2f ms, p99 %6.2f ms a frame\n", name, count,
                parameters.size(), ms[100], ms[198]);
  }
  return 0;
}

}  // namespace
}  // namespace penpose::app

int main(int argc, char** argv) {
  return penpose::app::measure(argc > 1 ? argv[1] : "builtin:demo", argc > 2 ? std::stoul(argv[2]) : 10000);
}
