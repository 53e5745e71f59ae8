#include "ui/live/live.h"

#include <algorithm>
#include <string>

namespace penpose::live {

std::vector<LiveOutput> known_live_outputs();  // written by the build

const std::vector<LiveOutput>& live_outputs() {
  static const std::vector<LiveOutput> all = known_live_outputs();
  return all;
}

base::Result<Listener> open_live_output(std::string_view text, std::span<const LiveOutput> outputs) {
  if (text.empty()) return Listener([](const FramePose&) {});
  const std::string_view name = text.substr(0, text.find('='));
  std::string names;
  for (const LiveOutput& output : outputs) {
    if (output.name == name) return output.open(text.substr(std::min(name.size() + 1, text.size())));
    names += (names.empty() ? "" : ", ") + std::string(output.name);
  }
  return base::Error{"no live output has the name \"" + std::string(name) + "\"", "", "there are: " + names};
}

}  // namespace penpose::live
