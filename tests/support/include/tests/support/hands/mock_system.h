#pragma once

#include <gtest/gtest.h>
#include <string>
#include <sys/stat.h>
#include <umockdev.h>
#include <vector>

namespace penpose::tests {

/// A /sys, a /dev and udev events of the test's own, for this process and its children (needs umockdev's preload).
class MockSystem : public testing::Test {
 protected:
  void SetUp() override {
    testbed_ = umockdev_testbed_new();
    ASSERT_TRUE(umockdev_in_mock_environment()) << "run it in umockdev-wrapper";
  }
  void TearDown() override { g_clear_object(&testbed_); }

  /// A USB HID interface with its device, its hid device of that driver (none: no hid device) and its hidraw node.
  /// `port`: "1-2". `number`: of the interface and, with `first`, of its /dev/hidraw.
  void plug_in(const std::string& port, int number, const std::vector<std::uint8_t>& descriptor,
               const std::string& name, const std::string& driver = "hid-generic", const std::string& vendor = "056A",
               const std::string& product = "00B8") {
    const std::string usb = "/devices/pci0000:00/usb1/" + port;
    const std::string index = std::to_string(next_hidraw_);
    std::string text;
    if (number == 0) {
      const std::string node = "bus/usb/001/00" + std::to_string(next_usb_++);
      text +=
          "P: " + usb + "\nN: " + node + "\nE: DEVNAME=/dev/" + node + "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\n";
      text += "A: idVendor=" + lower(vendor) + "\\n\nA: idProduct=" + lower(product) + "\\n\nA: product=" + name +
              "\\n\n\n";
    }
    const std::string interface = usb + "/" + port + ":1." + std::to_string(number);
    text += "P: " + interface + "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\nL: driver=../../../../bus/usb/drivers/" +
            (driver.empty() ? "usbfs" : "usbhid") + "\nA: bInterfaceNumber=0" + std::to_string(number) +
            "\\n\nA: bInterfaceClass=03\\n\n\n";
    const std::string hid = interface + "/0003:" + vendor + ":" + product + ".000" + index;
    if (!driver.empty()) {
      text += "P: " + hid + "\nE: SUBSYSTEM=hid\nL: driver=../../../../../bus/hid/drivers/" + driver +
              "\nE: HID_ID=0003:0000" + vendor + ":0000" + product + "\nE: HID_NAME=" + name + "\nE: HID_PHYS=usb-" +
              port + "/input" + std::to_string(number) + "\nH: report_descriptor=" + hex(descriptor) + "\n\n";
      text += "P: " + hid + "/hidraw/hidraw" + index + "\nN: hidraw" + index + "\nE: DEVNAME=/dev/hidraw" + index +
              "\nE: SUBSYSTEM=hidraw\n\n";
      ++next_hidraw_;
      hidraw_.push_back(hid + "/hidraw/hidraw" + index);
    }
    GError* error = nullptr;
    ASSERT_TRUE(umockdev_testbed_add_from_string(testbed_, text.c_str(), &error)) << error->message;
  }

  /// An input device below `parent` ("/devices/platform/i2c-1") with a pen and its node, /dev/input/event`number`.
  void plug_in_event_pen(const std::string& parent, int number, const std::string& name) {
    const std::string index = std::to_string(number);
    const std::string input = parent + "/input/input" + index;
    // Pen, eraser, contact and two buttons; position, pressure, distance and tilt.
    const std::string keys = sizeof(long) == 8 ? "1c03 0 0 0 0 0" : "1c03 0 0 0 0 0 0 0 0 0 0";
    std::string text =
        "P: " + input + "\nE: SUBSYSTEM=input\nA: name=" + name +
        "\\n\nA: phys=\\n\nA: id/bustype=0018\\n\nA: id/vendor=056a\\n\nA: id/product=00b8\\n\nA: capabilities/key=" +
        keys + "\\n\nA: capabilities/abs=f000003\\n\nA: capabilities/rel=0\\n\n\n";
    text += "P: " + input + "/event" + index + "\nN: input/event" + index + "\nL: device=../../input" + index +
            "\nE: DEVNAME=/dev/input/event" + index + "\nE: SUBSYSTEM=input\n\n";
    GError* error = nullptr;
    ASSERT_TRUE(umockdev_testbed_add_from_string(testbed_, text.c_str(), &error)) << error->message;
  }
  /// An I2C device without HID, for event pens below it.
  void plug_in_i2c(const std::string& path) {
    const std::string text = "P: " + path + "\nE: SUBSYSTEM=i2c\n\n";
    GError* error = nullptr;
    ASSERT_TRUE(umockdev_testbed_add_from_string(testbed_, text.c_str(), &error)) << error->message;
  }

  /// Takes away the device whose hidraw node was the n-th to come, and tells.
  void pull_out(std::size_t n) {
    std::string path = "/sys" + hidraw_[n];
    umockdev_testbed_uevent(testbed_, path.c_str(), "remove");
    // From the node over the hid device and the interface to the device.
    const auto parent = [](const std::string& of) { return of.substr(0, of.rfind('/')); };
    const std::string hid = parent(parent(path));
    for (const auto& gone : {path, hid, parent(hid), parent(parent(hid))}) {
      umockdev_testbed_remove_device(testbed_, gone.c_str());
    }
  }
  void tell_added(std::size_t n) {
    const std::string path = "/sys" + hidraw_[n];
    umockdev_testbed_uevent(testbed_, path.c_str(), "add");
  }
  /// Where a node really lies.
  [[nodiscard]] std::string real(const std::string& node) const {
    char* root = umockdev_testbed_get_root_dir(testbed_);
    const std::string path = std::string(root) + node;
    g_free(root);
    return path;
  }

  UMockdevTestbed* testbed_ = nullptr;

 private:
  static std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(g_ascii_tolower(c));
    return text;
  }
  static std::string hex(const std::vector<std::uint8_t>& bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes) {
      text += "0123456789ABCDEF"[byte >> 4];
      text += "0123456789ABCDEF"[byte & 0xf];
    }
    return text;
  }

  int next_hidraw_ = 0;
  int next_usb_ = 2;
  std::vector<std::string> hidraw_;
};

}  // namespace penpose::tests
