#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"

namespace penpose::device {

/// Ensures that the kernel's driver gets a USB interface back even if this process is killed, also by SIGKILL: a small
/// child process waits for the end of this one and then asks the kernel to bind its driver again. On an orderly close
/// the owner gives the interface back; the guard is only a fallback.
class DriverGuard {
 public:
  /// Errors: no permission to open the node, or no process can be made.
  [[nodiscard]] static base::Result<std::unique_ptr<DriverGuard>> start(const std::string& usb_node, int interface);

  /// Ends the child process: the driver already has the interface back.
  ~DriverGuard();
  DriverGuard(const DriverGuard&) = delete;
  DriverGuard& operator=(const DriverGuard&) = delete;

 private:
  DriverGuard(int pipe, int process) : pipe_(pipe), process_(process) {}

  int pipe_;
  int process_;
};

/// Asks the kernel to bind its own driver to a USB interface that has none. Errors: no permission to open it, it has
/// a driver, or no driver binds to it.
[[nodiscard]] base::Status bind_kernel_driver(const std::string& usb_node, int interface);

}  // namespace penpose::device
