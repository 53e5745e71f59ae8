#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <utility>

namespace penpose::app {

/// The event devices that can be read, to see whether one came. SDL looks for mice, keyboards and touch panels when its
/// video starts, and hears of later ones from udev alone.
class InputNodes {
 public:
  explicit InputNodes(std::string folder = "/dev/input");

  /// Whether a device is there that was not at the last call, or on construction. One that is plugged in again is
  /// another.
  [[nodiscard]] bool has_new();

 private:
  using Node = std::pair<std::string, std::int64_t>;  ///< its name and when it was made or its rights changed, ns
  [[nodiscard]] std::set<Node> readable() const;

  std::string folder_;
  std::set<Node> known_;
};

}  // namespace penpose::app
