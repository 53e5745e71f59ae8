#pragma once

#include <cerrno>
#include <fcntl.h>
#include <memory>
#include <string>
#include <unistd.h>
#include <xf86drmMode.h>

namespace penpose::app {

/// A device file that is open for reading and writing.
class OpenDevice {
 public:
  explicit OpenDevice(const std::string& path) : number_(::open(path.c_str(), O_RDWR | O_CLOEXEC)), reason_(errno) {}
  ~OpenDevice() {
    if (number_ >= 0) ::close(number_);
  }
  OpenDevice(const OpenDevice&) = delete;
  OpenDevice& operator=(const OpenDevice&) = delete;

  explicit operator bool() const { return number_ >= 0; }
  [[nodiscard]] int number() const { return number_; }
  /// The error number of opening it.
  [[nodiscard]] int reason() const { return reason_; }

 private:
  int number_;
  int reason_;
};

/// Frees what libdrm gave.
template <auto free>
struct DrmFree {
  template <typename Object>
  void operator()(Object* object) const {
    free(object);
  }
};
using DrmResources = std::unique_ptr<drmModeRes, DrmFree<drmModeFreeResources>>;
using DrmConnector = std::unique_ptr<drmModeConnector, DrmFree<drmModeFreeConnector>>;
using DrmEncoder = std::unique_ptr<drmModeEncoder, DrmFree<drmModeFreeEncoder>>;
using DrmCrtc = std::unique_ptr<drmModeCrtc, DrmFree<drmModeFreeCrtc>>;

/// The mode that a screen prefers, else its first. Precondition: it has one.
[[nodiscard]] inline const drmModeModeInfo& best_mode(const drmModeConnector& connector) {
  for (int i = 0; i < connector.count_modes; ++i) {
    if ((connector.modes[i].type & DRM_MODE_TYPE_PREFERRED) != 0) return connector.modes[i];
  }
  return connector.modes[0];
}

/// Px per inch of so many px over so many mm; 0 where the mm are not told.
[[nodiscard]] inline double dpi_of(unsigned px, unsigned mm) { return mm == 0 ? 0 : 25.4 * px / mm; }

}  // namespace penpose::app
