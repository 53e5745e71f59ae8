#pragma once

#include <libudev.h>
#include <memory>

namespace penpose::device {

template <typename Object, Object* (*unref)(Object*)>
struct Unref {
  void operator()(Object* object) const { unref(object); }
};
using Udev = std::unique_ptr<udev, Unref<udev, udev_unref>>;
using UdevDevice = std::unique_ptr<udev_device, Unref<udev_device, udev_device_unref>>;
using UdevEnumerate = std::unique_ptr<udev_enumerate, Unref<udev_enumerate, udev_enumerate_unref>>;
using UdevMonitor = std::unique_ptr<udev_monitor, Unref<udev_monitor, udev_monitor_unref>>;

}  // namespace penpose::device
