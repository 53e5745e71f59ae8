#include "ui/app/settings.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "core/base/numbers.h"
#include "ui/files/files.h"

namespace penpose::app {
namespace {

constexpr const char* k_name = "settings";

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

constexpr const char* k_flag = "is neither 0 nor 1";
constexpr const char* k_number = "is out of its range";

using Why = std::string;  // why a line was not taken; empty: it was

Why take_flag(bool& flag, std::string_view value) {
  if (value != "0" && value != "1") return k_flag;
  flag = value == "1";
  return {};
}

/// Labels of actions with '|' between them.
Why take_radial(std::array<Action, 8>& radial, std::string_view value) {
  auto places = radial;
  for (Action& place : places) {
    const std::size_t end = std::min(value.find('|'), value.size());
    const auto all = all_actions();
    const auto named =
        std::find_if(all.begin(), all.end(), [&](const ActionInfo& one) { return one.label == value.substr(0, end); });
    if (named == all.end()) return "names no action in one of its eight places";
    place = named->action;
    value.remove_prefix(std::min(end + 1, value.size()));
  }
  radial = places;
  return {};
}

/// "TABLET|CONTROL|BINDING".
Why take_pad(Settings& settings, std::string_view value) {
  const std::size_t first = value.find('|');
  const std::size_t second = first == std::string_view::npos ? first : value.find('|', first + 1);
  if (second == std::string_view::npos) return "is not a tablet, what is pressed on it, and what that does";
  const auto binding = parse_binding(value.substr(second + 1));
  if (!binding) return "says nothing that a key of a tablet does";
  const std::string tablet(value.substr(0, first));
  if (settings.pads.size() >= k_most_pads && !settings.pads.contains(tablet)) return "is of too many tablets";
  auto& bindings = settings.pads[tablet];
  if (bindings.size() >= k_most_bindings) return "is one of too many of that tablet";
  bindings[std::string(value.substr(first + 1, second - first - 1))] = *binding;
  return {};
}

/// One of a few that are numbered from 0.
template <typename Enum>
Why take_one(Enum& value, std::string_view text, std::int64_t count) {
  const auto number = base::parse_int(text);
  if (!number || *number < 0 || *number >= count) return k_number;
  value = static_cast<Enum>(*number);
  return {};
}

Why take_scale(Settings& settings, std::string_view value) {
  const auto number = base::parse_double(value);
  if (!number || !(*number >= 0.5 && *number <= 3)) return k_number;
  settings.scale = *number;
  return {};
}

Why take_height(double& height, std::string_view value) {
  const auto number = base::parse_double(value);
  if (!number || !(*number == 0 || (*number >= k_least_rows_px && *number <= k_most_rows_px))) return k_number;
  height = *number;
  return {};
}

Why take_rate(Settings& settings, std::string_view value) {
  const auto number = base::parse_int(value);
  if (!number || std::find(k_frame_rates.begin(), k_frame_rates.end(), *number) == k_frame_rates.end()) return k_number;
  settings.rate = static_cast<int>(*number);
  return {};
}

Why take_area(Settings& settings, std::string_view value) {
  const auto area = numbers(value, 4);
  if (!area || area->size() != 4 || !((*area)[0] < (*area)[2] && (*area)[1] < (*area)[3]))
    return "is no area: left, top, right and bottom from 0 to 1";
  settings.tablet.area = *area;
  return {};
}

Why take_pressure(Settings& settings, std::string_view value) {
  const auto points = numbers(value, 16);
  if (!points || points->size() % 2 != 0) return "is no curve: at most eight pairs of numbers from 0 to 1";
  settings.tablet.pressure.clear();
  for (std::size_t i = 0; i + 1 < points->size(); i += 2) {
    settings.tablet.pressure.push_back({(*points)[i], (*points)[i + 1]});
  }
  return {};
}

Why take_key(KeyMap& keys, std::string_view value) {
  const auto taken = keys.take(value);
  return taken ? Why() : taken.error().what;
}

Why take_pose_folder(Settings& settings, std::string_view value) {
  if (!value.starts_with('/')) return "is no folder: its path begins with /";
  settings.pose_folder = value;
  return {};
}

Why take_recent(Settings& settings, std::string_view value) {
  if (settings.recent.size() < k_most_recent) settings.recent.emplace_back(value);
  return {};
}

struct Line {
  std::string_view name;
  Why (*take)(Settings& settings, std::string_view value);
};
using View = std::string_view;
constexpr std::array k_lines{
    Line{"scale", take_scale},
    Line{"light", [](Settings& to, View value) { return take_flag(to.light, value); }},
    Line{"soft_shadows", [](Settings& to, View value) { return take_flag(to.soft_shadows, value); }},
    Line{"steps_seen", [](Settings& to, View value) { return take_flag(to.steps_seen, value); }},
    Line{"pose_first", [](Settings& to, View value) { return take_flag(to.pose_first, value); }},
    Line{"side_closed", [](Settings& to, View value) { return take_flag(to.side_closed, value); }},
    Line{"density", [](Settings& to, View value) { return take_one(to.density, value, 3); }},
    Line{"stabiliser", [](Settings& to, View value) { return take_one(to.stabiliser, value, 3); }},
    Line{"rate", take_rate},
    Line{"sheet_height", [](Settings& to, View value) { return take_height(to.sheet_height, value); }},
    Line{"curves_height", [](Settings& to, View value) { return take_height(to.curves_height, value); }},
    Line{"file_sort", [](Settings& to, View value) { return take_one(to.file_sort, value, 3); }},
    Line{"hidden_files", [](Settings& to, View value) { return take_flag(to.hidden_files, value); }},
    Line{"system_dialogs", [](Settings& to, View value) { return take_flag(to.system_dialogs, value); }},
    Line{"tablet_keep_aspect", [](Settings& to, View value) { return take_flag(to.tablet.keep_aspect, value); }},
    Line{"tablet_left_handed", [](Settings& to, View value) { return take_flag(to.tablet.left_handed, value); }},
    Line{"tablet_area", take_area},
    Line{"tablet_pressure", take_pressure},
    Line{"radial", [](Settings& to, View value) { return take_radial(to.radial, value); }},
    Line{"key", [](Settings& to, View value) { return take_key(to.keys, value); }},
    Line{"pad", take_pad},
    Line{"pose_folder", take_pose_folder},
    Line{"recent", take_recent},
};

Why take(Settings& settings, std::string_view line) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) return "is not NAME=VALUE";
  const auto named =
      std::find_if(k_lines.begin(), k_lines.end(), [&](const Line& one) { return one.name == line.substr(0, equals); });
  if (named == k_lines.end()) return "sets nothing that is known";
  return named->take(settings, line.substr(equals + 1));
}

}  // namespace

Settings parse_settings(std::string_view text, std::vector<base::Error>* refused) {
  Settings settings;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty()) continue;
    const bool remark = line.front() == '#';
    const Why why = remark ? Why() : take(settings, line);
    if (remark || !why.empty()) settings.unread.emplace_back(line);
    if (why.empty() || refused == nullptr) continue;
    std::string what = "\"";
    what.append(line).append("\" is not taken: ").append(why);
    std::string place = "line ";
    place += std::to_string(number);
    refused->push_back({std::move(what), std::move(place), "mend the line or take it out"});
  }
  settings.keys.settle();
  return settings;
}

std::string to_text(const Settings& settings) {
  const auto flag = [](bool on) { return on ? std::string("1\n") : std::string("0\n"); };
  std::string text = "scale=" + base::format_double(settings.scale) + "\n";
  text += "light=" + flag(settings.light);
  text += "soft_shadows=" + flag(settings.soft_shadows);
  text += "steps_seen=" + flag(settings.steps_seen);
  text += "pose_first=" + flag(settings.pose_first);
  text += "side_closed=" + flag(settings.side_closed);
  text += "density=" + std::to_string(static_cast<int>(settings.density)) + "\n";
  text += "stabiliser=" + std::to_string(static_cast<int>(settings.stabiliser)) + "\n";
  text += "rate=" + std::to_string(settings.rate) + "\n";
  text += "sheet_height=" + base::format_double(settings.sheet_height) + "\n";
  text += "curves_height=" + base::format_double(settings.curves_height) + "\n";
  text += "file_sort=" + std::to_string(static_cast<int>(settings.file_sort)) + "\n";
  text += "hidden_files=" + flag(settings.hidden_files);
  text += "system_dialogs=" + flag(settings.system_dialogs);
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
  for (const std::string& line : settings.keys.lines()) text += "key=" + line + "\n";
  for (const std::string& line : settings.unread) text += line + "\n";
  return text;
}

std::string settings_file(const std::string& folder) { return folder + "/" + k_name; }

Settings load_settings(const std::string& folder, std::vector<base::Error>* refused) {
  if (folder.empty()) return {};
  const auto bytes = files::read_plain_file(settings_file(folder), files::k_most_settings_bytes);
  if (!bytes) return {};
  return parse_settings(std::string(bytes->begin(), bytes->end()), refused);
}

base::Status save_settings(const Settings& settings, const std::string& folder) {
  if (folder.empty()) return base::Done{};
  std::error_code code;
  std::filesystem::create_directories(folder, code);
  const std::string text = to_text(settings);
  return files::write_file(settings_file(folder), std::vector<std::uint8_t>(text.begin(), text.end()));
}

void remember_file(Settings& settings, const std::string& path) {
  std::erase(settings.recent, path);
  settings.recent.insert(settings.recent.begin(), path);
  if (settings.recent.size() > k_most_recent) settings.recent.resize(k_most_recent);
}

}  // namespace penpose::app
