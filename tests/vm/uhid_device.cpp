#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <iostream>
#include <linux/uhid.h>
#include <poll.h>
#include <system_error>
#include <thread>
#include <unistd.h>

#include "tests/vm/virtual_device.h"

namespace penpose::tests {
namespace {

base::Error system_error(const char* what) { return {what, std::generic_category().message(errno), ""}; }

/// One interface: a file of /dev/uhid and a thread that answers the kernel's requests with "no such report".
class UhidInterface {
 public:
  explicit UhidInterface(int file) : file_(file), thread_([this] { answer(); }) {}
  ~UhidInterface() { unplug(); }

  bool write(const uhid_event& event) const { return ::write(file_, &event, sizeof event) == sizeof event; }

  void unplug() {
    if (stop_.exchange(true)) return;
    uhid_event destroy{};
    destroy.type = UHID_DESTROY;
    write(destroy);
    thread_.join();
    ::close(file_);
  }

 private:
  static void tell(const uhid_set_report_req& request) {
    std::string text = "took report";
    for (unsigned i = 0; i < std::min<unsigned>(request.size, 16); ++i) {
      char byte[4];
      std::snprintf(byte, sizeof byte, " %02x", request.data[i]);
      text += byte;
    }
    std::cerr << text << std::endl;
  }

  void answer() {
    while (!stop_) {
      pollfd waiting{file_, POLLIN, 0};
      if (::poll(&waiting, 1, 1000) <= 0) continue;
      uhid_event request{};
      if (::read(file_, &request, sizeof request) <= 0) continue;
      uhid_event reply{};
      if (request.type == UHID_GET_REPORT) {
        reply.type = UHID_GET_REPORT_REPLY;
        reply.u.get_report_reply.id = request.u.get_report.id;
        reply.u.get_report_reply.err = EIO;
        write(reply);
      } else if (request.type == UHID_SET_REPORT) {
        tell(request.u.set_report);
        reply.type = UHID_SET_REPORT_REPLY;
        reply.u.set_report_reply.id = request.u.set_report.id;
        write(reply);
      }
    }
  }

  int file_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

class UhidDevice final : public VirtualDevice {
 public:
  base::Status add(int number, const decode::DeviceIdentity& identity) {
    const int file = ::open("/dev/uhid", O_RDWR | O_CLOEXEC);
    if (file < 0) return system_error("/dev/uhid cannot be opened");
    uhid_event create{};
    create.type = UHID_CREATE2;
    auto& facts = create.u.create2;
    std::strncpy(reinterpret_cast<char*>(facts.name), identity.name.c_str(), sizeof facts.name - 1);
    std::strncpy(reinterpret_cast<char*>(facts.phys), "virtual/input0", sizeof facts.phys - 1);
    facts.bus = identity.bus;
    facts.vendor = identity.vendor;
    facts.product = identity.product;
    facts.rd_size = static_cast<std::uint16_t>(std::min(identity.report_descriptor.size(), sizeof facts.rd_data));
    std::copy_n(identity.report_descriptor.begin(), facts.rd_size, facts.rd_data);
    if (::write(file, &create, sizeof create) != sizeof create) return system_error("the kernel makes no device");
    interfaces_[number] = std::make_unique<UhidInterface>(file);
    return base::Done{};
  }

  base::Status send(int interface, base::Bytes report) override {
    uhid_event event{};
    event.type = UHID_INPUT2;
    event.u.input2.size = static_cast<std::uint16_t>(std::min(report.size(), sizeof event.u.input2.data));
    std::copy_n(report.begin(), event.u.input2.size, event.u.input2.data);
    const auto found = interfaces_.find(interface);
    if (found == interfaces_.end() || !found->second->write(event)) return system_error("a report was not taken");
    return base::Done{};
  }
  void unplug() override { interfaces_.clear(); }

 private:
  std::map<int, std::unique_ptr<UhidInterface>> interfaces_;
};

}  // namespace

base::Result<std::unique_ptr<VirtualDevice>> make_uhid_device(const VirtualDevice::Interfaces& interfaces) {
  auto device = std::make_unique<UhidDevice>();
  for (const auto& [number, identity] : interfaces) {
    if (const auto added = device->add(number, identity); !added) return added.error();
  }
  return std::unique_ptr<VirtualDevice>(std::move(device));
}

}  // namespace penpose::tests
