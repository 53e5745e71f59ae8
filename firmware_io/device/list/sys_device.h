#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace penpose::device {

/// A device of the kernel as its folder in /sys shows it, which needs neither udev nor its library. Source of the
/// names: Linux, Documentation/ABI/stable/sysfs-devices and Documentation/admin-guide/sysfs-rules.rst.
class SysDevice {
 public:
  /// `folder` may be a link, as those below /sys/class are. Nothing where there is no device (any more).
  [[nodiscard]] static std::optional<SysDevice> at(const std::string& folder);

  /// The same for one device whatever link led to it: "/sys/devices/...".
  [[nodiscard]] const std::string& path() const { return path_; }
  /// "hidraw3", "1-2:1.0".
  [[nodiscard]] std::string name() const;
  /// The driver that has it; empty where none.
  [[nodiscard]] std::string driver() const;
  /// "/dev/hidraw3"; empty where it has no node.
  [[nodiscard]] std::string node() const;
  /// A line of its `uevent`: "HID_NAME", "DEVTYPE". Empty where there is none.
  [[nodiscard]] std::string property(std::string_view name) const;
  /// The first line of a file in its folder; empty where there is none.
  [[nodiscard]] std::string attribute(const std::string& name) const;
  /// The device that it is part of.
  [[nodiscard]] std::optional<SysDevice> parent() const;
  /// The nearest one above it in a subsystem, and of a type where that is named.
  [[nodiscard]] std::optional<SysDevice> parent_in(std::string_view subsystem, std::string_view type = {}) const;

 private:
  SysDevice() = default;

  std::string path_;
  std::map<std::string, std::string, std::less<>> properties_;
};

/// The first line of a file in /sys, of at most some thousand bytes; empty where there is none.
[[nodiscard]] std::string read_sys_line(const std::string& path);

}  // namespace penpose::device
