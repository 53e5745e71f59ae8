#include "firmware_io/device/tablet_lights.h"

#include <filesystem>
#include <fstream>
#include <system_error>

namespace penpose::device {
namespace {

constexpr std::string_view k_driver = "wacom";
/// "input12::wacom-0.2" is the third light of the first group.
constexpr std::string_view k_light_mark = "::wacom-";

bool is_on(const std::filesystem::path& light) {
  std::ifstream file(light / "brightness");
  int brightness = 0;
  return file >> brightness && brightness > 0;
}

void look_at(const std::filesystem::path& light, const HidInterface& interface, std::optional<decode::Lights>& seen) {
  const std::string name = light.filename().string();
  const std::size_t at = name.find(k_light_mark);
  if (at == std::string::npos || name.size() != at + k_light_mark.size() + 3) return;
  const int group = name[at + k_light_mark.size()] - '0';
  const int number = name.back() - '0';
  if (group < 0 || group >= static_cast<int>(decode::k_pad_sides) || number < 0 || number > 3) return;
  if (!seen) seen.emplace();
  if (is_on(light)) {
    (*seen)[decode::side_of_light_group(interface.identity, static_cast<std::size_t>(group))] =
        static_cast<std::int8_t>(number);
  }
}

}  // namespace

bool kernel_switches_lights(const LiveTablet& tablet) {
  return tablet.transport == Transport::hidraw && tablet.interface.driver == k_driver;
}

std::optional<decode::Lights> seen_lights(const HidInterface& interface, const std::string& folder) {
  std::optional<decode::Lights> seen;
  if (interface.hid_name.empty()) return seen;
  std::error_code error;
  const std::filesystem::path inputs = std::filesystem::path(folder) / interface.hid_name / "input";
  for (std::filesystem::directory_iterator input(inputs, error), end; !error && input != end; input.increment(error)) {
    std::error_code inner;
    for (std::filesystem::directory_iterator light(input->path(), inner); !inner && light != end;
         light.increment(inner)) {
      look_at(light->path(), interface, seen);
    }
  }
  return seen;
}

}  // namespace penpose::device
