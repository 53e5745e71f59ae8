#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"

namespace penpose::device {

/// Sees to it that the kernel's driver gets a USB interface back even when this process dies without a word, be it by
/// SIGKILL: a small process of its own waits for the end of this one and then asks the kernel to bind its driver again.
/// The usual way back, on an orderly close, is the owner's; the guard only stands by.
class DriverGuard {
 public:
  /// Errors: the node may not be opened, or no process can be made.
  [[nodiscard]] static base::Result<std::unique_ptr<DriverGuard>> start(const std::string& usb_node, int interface);

  /// Dismisses the other process: the driver was given back already.
  ~DriverGuard();
  DriverGuard(const DriverGuard&) = delete;
  DriverGuard& operator=(const DriverGuard&) = delete;

 private:
  DriverGuard(int pipe, int process) : pipe_(pipe), process_(process) {}

  int pipe_;
  int process_;
};

/// Asks the kernel to bind its own driver to a USB interface that has none. Errors: it may not be opened, it has a
/// driver, or no driver wants it.
[[nodiscard]] base::Status bind_kernel_driver(const std::string& usb_node, int interface);

}  // namespace penpose::device
