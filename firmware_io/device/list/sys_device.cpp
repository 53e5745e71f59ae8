#include "firmware_io/device/list/sys_device.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace penpose::device {
namespace {

constexpr std::string_view k_above_all = "/sys";
/// As long as a page, which is what one file of /sys holds at most.
constexpr std::size_t k_longest_file = 4096;

/// Empty where there is no such file.
std::optional<std::string> read_file(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) return std::nullopt;
  std::array<char, k_longest_file> text{};
  return std::string(text.data(), std::fread(text.data(), 1, text.size(), file.get()));
}

/// What a link's name ends with.
std::string end_of_link(const std::string& path) {
  std::error_code error;
  return std::filesystem::read_symlink(path, error).filename().string();
}

}  // namespace

std::string read_sys_line(const std::string& path) {
  std::string line = read_file(path).value_or(std::string());
  line.erase(std::min(line.find('\n'), line.size()));
  return line;
}

std::optional<SysDevice> SysDevice::at(const std::string& folder) {
  SysDevice device;
  std::error_code error;
  device.path_ = std::filesystem::canonical(folder, error).string();
  if (error) return std::nullopt;
  const auto facts = read_file(device.path_ + "/uevent");
  if (!facts) return std::nullopt;
  for (std::size_t begin = 0; begin < facts->size();) {
    const std::size_t end = std::min(facts->find('\n', begin), facts->size());
    const std::string_view line = std::string_view(*facts).substr(begin, end - begin);
    if (const std::size_t sign = line.find('='); sign != std::string_view::npos) {
      device.properties_.emplace(line.substr(0, sign), line.substr(sign + 1));
    }
    begin = end + 1;
  }
  return device;
}

std::string SysDevice::name() const { return std::filesystem::path(path_).filename().string(); }

std::string SysDevice::driver() const { return end_of_link(path_ + "/driver"); }

std::string SysDevice::node() const {
  const std::string name = property("DEVNAME");
  return name.empty() || name.front() == '/' ? name : "/dev/" + name;
}

std::string SysDevice::property(std::string_view name) const {
  const auto found = properties_.find(name);
  return found == properties_.end() ? std::string() : found->second;
}

std::string SysDevice::attribute(const std::string& name) const { return read_sys_line(path_ + "/" + name); }

std::optional<SysDevice> SysDevice::parent() const {
  std::filesystem::path above = std::filesystem::path(path_).parent_path();
  for (; above.has_relative_path() && above != k_above_all; above = above.parent_path()) {
    if (auto device = at(above.string())) return device;
  }
  return std::nullopt;
}

std::optional<SysDevice> SysDevice::parent_in(std::string_view subsystem, std::string_view type) const {
  for (auto above = parent(); above; above = above->parent()) {
    if (end_of_link(above->path_ + "/subsystem") != subsystem) continue;
    if (type.empty() || above->property("DEVTYPE") == type) return above;
  }
  return std::nullopt;
}

}  // namespace penpose::device
