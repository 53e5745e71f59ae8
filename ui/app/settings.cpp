#include "ui/app/settings.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "core/base/numbers.h"
#include "ui/files/files.h"

namespace penpose::app {
namespace {

constexpr const char* k_name = "settings";

std::string file_of(const std::string& folder) { return folder + "/" + k_name; }

std::optional<std::vector<double>> numbers(std::string_view text, std::size_t most) {
  std::vector<double> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const auto value = base::parse_double(text.substr(0, end));
    if (!value || !(*value >= 0 && *value <= 1) || out.size() == most) return std::nullopt;
    out.push_back(*value);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

/// Labels of actions with '|' between them; a place whose label is not known keeps what it has.
void take_radial(std::array<Action, 8>& radial, std::string_view value) {
  for (Action& place : radial) {
    const std::size_t end = std::min(value.find('|'), value.size());
    for (const ActionInfo& one : all_actions()) {
      if (one.label == value.substr(0, end)) place = one.action;
    }
    value.remove_prefix(std::min(end + 1, value.size()));
  }
}

/// "TABLET|CONTROL|BINDING".
void take_pad(Settings& settings, std::string_view value) {
  const std::size_t first = value.find('|');
  const std::size_t second = first == std::string_view::npos ? first : value.find('|', first + 1);
  if (second == std::string_view::npos) return;
  const auto binding = parse_binding(value.substr(second + 1));
  const std::string tablet(value.substr(0, first));
  if (!binding || (settings.pads.size() >= k_most_pads && !settings.pads.contains(tablet))) return;
  auto& bindings = settings.pads[tablet];
  if (bindings.size() < k_most_bindings) bindings[std::string(value.substr(first + 1, second - first - 1))] = *binding;
}

/// One of a few that are numbered from 0.
template <typename Enum>
void take_one(Enum& value, std::string_view text, std::int64_t count) {
  const auto number = base::parse_int(text);
  if (number && *number >= 0 && *number < count) value = static_cast<Enum>(*number);
}

void take(Settings& settings, std::string_view name, std::string_view value) {
  if (name == "scale") {
    const auto number = base::parse_double(value);
    if (number && *number >= 0.5 && *number <= 3) settings.scale = *number;
  } else if (name == "light") {
    settings.light = value == "1";
  } else if (name == "steps_seen") {
    settings.steps_seen = value == "1";
  } else if (name == "pose_first") {
    settings.pose_first = value == "1";
  } else if (name == "density") {
    take_one(settings.density, value, 3);
  } else if (name == "stabiliser") {
    take_one(settings.stabiliser, value, 3);
  } else if (name == "rate") {
    const auto number = base::parse_int(value);
    for (const int rate : k_frame_rates) settings.rate = number && *number == rate ? rate : settings.rate;
  } else if (name == "tablet_keep_aspect") {
    settings.tablet.keep_aspect = value == "1";
  } else if (name == "tablet_left_handed") {
    settings.tablet.left_handed = value == "1";
  } else if (name == "tablet_area") {
    const auto area = numbers(value, 4);
    if (area && area->size() == 4 && (*area)[0] < (*area)[2] && (*area)[1] < (*area)[3]) settings.tablet.area = *area;
  } else if (name == "tablet_pressure") {
    const auto points = numbers(value, 16);
    if (!points || points->size() % 2 != 0) return;
    settings.tablet.pressure.clear();
    for (std::size_t i = 0; i + 1 < points->size(); i += 2) {
      settings.tablet.pressure.push_back({(*points)[i], (*points)[i + 1]});
    }
  } else if (name == "radial") {
    take_radial(settings.radial, value);
  } else if (name == "pad") {
    take_pad(settings, value);
  } else if (name == "pose_folder") {
    if (value.starts_with('/')) settings.pose_folder = value;
  } else if (name == "recent" && settings.recent.size() < k_most_recent) {
    settings.recent.emplace_back(value);
  }
}

}  // namespace

Settings parse_settings(std::string_view text) {
  Settings settings;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    const std::size_t equals = line.find('=');
    if (equals != std::string_view::npos) take(settings, line.substr(0, equals), line.substr(equals + 1));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return settings;
}

std::string to_text(const Settings& settings) {
  const auto flag = [](bool on) { return on ? std::string("1\n") : std::string("0\n"); };
  std::string text = "scale=" + base::format_double(settings.scale) + "\n";
  text += "light=" + flag(settings.light);
  text += "steps_seen=" + flag(settings.steps_seen);
  text += "pose_first=" + flag(settings.pose_first);
  text += "density=" + std::to_string(static_cast<int>(settings.density)) + "\n";
  text += "stabiliser=" + std::to_string(static_cast<int>(settings.stabiliser)) + "\n";
  text += "rate=" + std::to_string(settings.rate) + "\n";
  text += "tablet_keep_aspect=" + flag(settings.tablet.keep_aspect);
  text += "tablet_left_handed=" + flag(settings.tablet.left_handed);
  if (!settings.tablet.area.empty()) {
    text += "tablet_area=";
    for (const double value : settings.tablet.area) text += base::format_double(value) + " ";
    text.back() = '\n';
  }
  if (!settings.tablet.pressure.empty()) {
    text += "tablet_pressure=";
    for (const auto& p : settings.tablet.pressure)
      text += base::format_double(p.x) + " " + base::format_double(p.y) + " ";
    text.back() = '\n';
  }
  text += "radial=";
  for (const Action action : settings.radial) text += std::string(info(action).label) + "|";
  text.back() = '\n';
  for (const auto& [tablet, bindings] : settings.pads) {
    for (const auto& [control, binding] : bindings)
      text += "pad=" + tablet + "|" + control + "|" + to_text(binding) + "\n";
  }
  if (!settings.pose_folder.empty() && settings.pose_folder.find('\n') == std::string::npos)
    text += "pose_folder=" + settings.pose_folder + "\n";
  for (const std::string& path : settings.recent) {
    if (path.find('\n') == std::string::npos) text += "recent=" + path + "\n";
  }
  return text;
}

Settings load_settings(const std::string& folder) {
  if (folder.empty()) return {};
  const auto bytes = files::read_plain_file(file_of(folder), files::k_most_settings_bytes);
  if (!bytes) return {};
  return parse_settings(std::string(bytes->begin(), bytes->end()));
}

base::Status save_settings(const Settings& settings, const std::string& folder) {
  if (folder.empty()) return base::Done{};
  std::error_code code;
  std::filesystem::create_directories(folder, code);
  const std::string text = to_text(settings);
  return files::write_file(file_of(folder), std::vector<std::uint8_t>(text.begin(), text.end()));
}

void remember_file(Settings& settings, const std::string& path) {
  std::erase(settings.recent, path);
  settings.recent.insert(settings.recent.begin(), path);
  if (settings.recent.size() > k_most_recent) settings.recent.resize(k_most_recent);
}

}  // namespace penpose::app
