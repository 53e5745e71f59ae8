#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <initializer_list>
#include <iostream>
#include <mutex>
#include <poll.h>
#include <sys/socket.h>
#include <system_error>
#include <thread>
#include <unistd.h>

#include "tests/vm/virtual_device.h"

// The device's side of USB/IP as the Linux kernel's documentation describes it (usb/usbip_protocol): the host
// controller sends transfers over a socket, this program answers them.
namespace penpose::tests {
namespace {

using Buffer = std::vector<std::uint8_t>;

constexpr std::uint32_t k_submit = 1;
constexpr std::uint32_t k_unlink = 2;
constexpr std::uint32_t k_submit_reply = 3;
constexpr std::uint32_t k_unlink_reply = 4;
constexpr std::size_t k_header_words = 12;
constexpr int k_full_speed = 2;  // USB_SPEED_FULL
constexpr const char* k_controller = "/sys/devices/platform/vhci_hcd.0/";
using Header = std::array<std::uint32_t, k_header_words>;  // big endian

base::Error system_error(const char* what) { return {what, std::generic_category().message(errno), ""}; }

bool write_text(const std::string& path, const std::string& text) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool written = ::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  ::close(file);
  return written;
}

void append(Buffer& out, base::Bytes bytes) {
  for (const std::uint8_t byte : bytes) out.push_back(byte);
}

void append(Buffer& out, std::initializer_list<std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) out.push_back(byte);
}

void append16(Buffer& out, std::size_t value) {
  out.push_back(static_cast<std::uint8_t>(value & 0xff));
  out.push_back(static_cast<std::uint8_t>(value >> 8));
}

class UsbDevice final : public VirtualDevice {
 public:
  UsbDevice(const Interfaces& interfaces, UsbBehaviour behaviour) : behaviour_(std::move(behaviour)) {
    for (const auto& [number, identity] : interfaces) {
      numbers_[number] = interfaces_.size();
      interfaces_.push_back({identity, 0, 0});
    }
  }
  ~UsbDevice() override {
    unplug();
    stop_ = true;
    if (thread_.joinable()) thread_.join();
    if (socket_ >= 0) ::close(socket_);
  }

  base::Status attach() {
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return system_error("no socket");
    socket_ = ends[0];
    const int id = (1 << 16) | (behaviour_.port + 1);
    const std::string line = std::to_string(behaviour_.port) + " " + std::to_string(ends[1]) + " " +
                             std::to_string(id) + " " + std::to_string(k_full_speed);
    const bool attached = write_text(std::string(k_controller) + "attach", line);
    ::close(ends[1]);
    if (!attached) return system_error("the host controller takes no device");
    attached_ = true;
    thread_ = std::thread([this] { serve(); });
    return base::Done{};
  }

  base::Status send(int interface, base::Bytes report) override {
    const auto number = numbers_.find(interface);
    if (number == numbers_.end()) return base::Error{"no such interface", "", ""};
    std::unique_lock lock(mutex_);
    Interface& to = interfaces_[number->second];
    const bool ready = changed_.wait_for(lock, std::chrono::seconds(20), [&] { return to.waiting != 0 && is_awake(); });
    if (!ready) return base::Error{"nobody reads this interface", "", ""};
    const std::uint32_t transfer = to.waiting;
    to.waiting = 0;
    reply(transfer, 0, report.first(std::min<std::size_t>(report.size(), to.room)), true);
    advance_queue();
    return base::Done{};
  }

  /// The driver asks for the next report when it has done with one.
  base::Status settle(int interface) override {
    const auto number = numbers_.find(interface);
    if (number == numbers_.end()) return base::Error{"no such interface", "", ""};
    std::unique_lock lock(mutex_);
    const Interface& of = interfaces_[number->second];
    if (changed_.wait_for(lock, std::chrono::seconds(20), [&] { return of.waiting != 0; })) return base::Done{};
    return base::Error{"nobody reads this interface any more", "", ""};
  }

  void unplug() override {
    if (!attached_.exchange(false)) return;
    write_text(std::string(k_controller) + "detach", std::to_string(behaviour_.port));
  }

 private:
  struct Interface {
    decode::DeviceIdentity identity;
    std::uint32_t waiting;  ///< sequence number of the IN transfer that waits, 0: none
    std::size_t room;       ///< its length
  };

  [[nodiscard]] bool is_awake() const { return behaviour_.asleep_until_string < 0 || woken_; }

  /// Precondition: the mutex is held.
  void reply(std::uint32_t transfer, int status, base::Bytes bytes, bool in) {
    Header header{};
    header[0] = htonl(k_submit_reply);
    header[1] = htonl(transfer);
    header[5] = htonl(static_cast<std::uint32_t>(status));
    header[6] = htonl(static_cast<std::uint32_t>(bytes.size()));
    Buffer out(sizeof header + (in ? bytes.size() : 0));
    std::memcpy(out.data(), header.data(), sizeof header);
    if (in && !bytes.empty()) std::memcpy(out.data() + sizeof header, bytes.data(), bytes.size());
    ::send(socket_, out.data(), out.size(), MSG_NOSIGNAL);
  }

  bool receive(void* into, std::size_t count) const {
    return ::recv(socket_, into, count, MSG_WAITALL) == static_cast<ssize_t>(count);
  }

  void serve() {
    while (!stop_) {
      pollfd waiting{socket_, POLLIN, 0};
      if (::poll(&waiting, 1, 1000) <= 0) continue;
      Header header{};
      if (!receive(header.data(), sizeof header)) return;
      for (std::uint32_t& word : header) word = ntohl(word);
      const std::lock_guard lock(mutex_);
      if (header[0] == k_submit) {
        if (!submit(header)) return;
      } else if (header[0] == k_unlink) {
        unlink(header[1], header[5]);
      }
      changed_.notify_all();
    }
  }

  void unlink(std::uint32_t request, std::uint32_t transfer) {
    Header header{};
    header[0] = htonl(k_unlink_reply);
    header[1] = htonl(request);
    for (Interface& interface : interfaces_) {
      if (interface.waiting == transfer) {
        interface.waiting = 0;
        header[5] = htonl(static_cast<std::uint32_t>(-ECONNRESET));
      }
    }
    for (auto queued = queue_.begin(); queued != queue_.end(); ++queued) {
      if (queued->transfer != transfer) continue;
      header[5] = htonl(static_cast<std::uint32_t>(-ECONNRESET));
      queue_.erase(queued);
      break;
    }
    ::send(socket_, header.data(), sizeof header, MSG_NOSIGNAL);
    advance_queue();
  }

  static void tell(const Buffer& report) {
    std::string text = "took report";
    for (std::size_t i = 0; i < std::min<std::size_t>(report.size(), 16); ++i) {
      char byte[4];
      std::snprintf(byte, sizeof byte, " %02x", report[i]);
      text += byte;
    }
    std::cerr << text << std::endl;
  }

  bool submit(const Header& header) {
    const bool in = header[3] != 0;
    const std::uint32_t endpoint = header[4];
    const std::size_t length = header[6];
    if (length > 65536) return false;
    Buffer data(in ? 0 : length);
    if (!data.empty() && !receive(data.data(), data.size())) return false;
    std::array<std::uint8_t, 8> setup{};
    // The words were swapped; the setup packet is bytes.
    const std::uint32_t words[2] = {htonl(header[10]), htonl(header[11])};
    std::memcpy(setup.data(), words, sizeof setup);
    if (endpoint == 0) {
      // A class request that sets a report (HID 1.11, 7.2.2).
      if (!in && setup[0] == 0x21 && setup[1] == 9) tell(data);
      control(header[1], in, setup, length);
    } else if (in && endpoint <= interfaces_.size()) {
      queue_.push_back({endpoint - 1, header[1], length});
      advance_queue();
    } else if (in) {
      reply(header[1], -EPIPE, {}, true);
    } else {
      reply_out(header[1], length);
    }
    return true;
  }

  /// Several transfers may wait at one endpoint; they are served in order.
  void advance_queue() {
    for (auto queued = queue_.begin(); queued != queue_.end();) {
      Interface& interface = interfaces_[queued->interface];
      if (interface.waiting == 0) {
        interface.waiting = queued->transfer;
        interface.room = queued->length;
        queued = queue_.erase(queued);
      } else {
        ++queued;
      }
    }
  }

  void control(std::uint32_t transfer, bool in, const std::array<std::uint8_t, 8>& setup, std::size_t length) {
    const int request = setup[1];
    const int index = setup[4] | setup[5] << 8;
    const bool is_class = (setup[0] & 0x60) == 0x20;
    if (!in) return reply_out(transfer, length);
    Buffer answer;
    bool known = true;
    if (!is_class && request == 6) {
      known = describe(setup[3], setup[2], static_cast<std::size_t>(index), answer);
    } else if (!is_class && request == 0) {
      answer = {0, 0};
    } else if (!is_class && (request == 8 || request == 10)) {
      answer = {static_cast<std::uint8_t>(request == 8 ? 1 : 0)};
    } else {
      known = false;
    }
    answer.resize(std::min(answer.size(), length));
    reply(transfer, known ? 0 : -EPIPE, answer, true);
  }

  void reply_out(std::uint32_t transfer, std::size_t length) {
    const Buffer taken(length);
    reply(transfer, 0, taken, false);
  }

  bool describe(int type, int number, std::size_t interface, Buffer& out) {
    const auto& first = interfaces_[0].identity;
    switch (type) {
      case 1:
        append(out, {18, 1, 0x10, 1, 0, 0, 0, 64});
        append16(out, first.vendor);
        append16(out, first.product);
        append16(out, 0x0100);
        append(out, {0, 2, 3, 1});
        return true;
      case 2:
        describe_configuration(out);
        return true;
      case 3:
        return describe_string(number, out);
      case 0x21:
        if (interface >= interfaces_.size()) return false;
        append_hid(out, interfaces_[interface]);
        return true;
      case 0x22:
        if (interface >= interfaces_.size()) return false;
        out = interfaces_[interface].identity.report_descriptor;
        return true;
      default:
        return false;
    }
  }

  static void append_hid(Buffer& out, const Interface& interface) {
    append(out, {9, 0x21, 0x10, 1, 0, 1, 0x22});
    append16(out, interface.identity.report_descriptor.size());
  }

  void describe_configuration(Buffer& out) const {
    Buffer body;
    for (std::size_t i = 0; i < interfaces_.size(); ++i) {
      const Buffer& descriptor = interfaces_[i].identity.report_descriptor;
      // Drivers of tablets look for the boot mouse that real ones begin their descriptor with.
      const bool mouse =
          descriptor.size() > 4 && descriptor[0] == 5 && descriptor[1] == 1 && descriptor[2] == 9 && descriptor[3] == 2;
      const auto byte = static_cast<std::uint8_t>(i);
      const std::uint8_t endpoints = behaviour_.takes_output ? 2 : 1;
      append(body, {9, 4, byte, 0, endpoints, 3, static_cast<std::uint8_t>(mouse ? 1 : 0),
                    static_cast<std::uint8_t>(mouse ? 2 : 0), 0});
      append_hid(body, interfaces_[i]);
      append(body, {7, 5, static_cast<std::uint8_t>(0x81 + i), 3, 64, 0, 1});
      if (behaviour_.takes_output) append(body, {7, 5, static_cast<std::uint8_t>(0x01 + i), 3, 64, 0, 1});
    }
    append(out, {9, 2});
    append16(out, 9 + body.size());
    append(out, {static_cast<std::uint8_t>(interfaces_.size()), 1, 0, 0x80, 49});
    append(out, base::Bytes(body));
  }

  bool describe_string(int number, Buffer& out) {
    if (number == 0) {
      out = {4, 3, 9, 4};
      return true;
    }
    Buffer text;
    if (const auto given = behaviour_.strings.find(number); given != behaviour_.strings.end()) {
      text = given->second;
    } else if (number == 2) {
      text = as_utf16(interfaces_[0].identity.name);
    } else if (number == 3) {
      text = as_utf16("virtual-" + std::to_string(behaviour_.port));
    } else {
      return false;
    }
    if (number == behaviour_.asleep_until_string) woken_ = true;
    text.resize(std::min<std::size_t>(text.size(), 240));
    append(out, {static_cast<std::uint8_t>(2 + text.size()), 3});
    append(out, base::Bytes(text));
    return true;
  }

  struct Queued {
    std::size_t interface;
    std::uint32_t transfer;
    std::size_t length;
  };

  UsbBehaviour behaviour_;
  std::map<int, std::size_t> numbers_;  ///< by the trace's number
  std::vector<Interface> interfaces_;
  std::vector<Queued> queue_;
  int socket_ = -1;
  bool woken_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<bool> attached_{false};
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace

std::vector<std::uint8_t> as_utf16(const std::string& text) {
  Buffer bytes;
  for (const char c : text) append16(bytes, static_cast<std::uint8_t>(c));
  return bytes;
}

bool take_usb_option(UsbBehaviour& behaviour, const std::string& name, const std::string& value) {
  const auto number = static_cast<int>(std::strtol(value.c_str(), nullptr, 10));
  if (name == "--port") {
    behaviour.port = number;
  } else if (name == "--asleep-until") {
    behaviour.asleep_until_string = number;
  } else if (name == "--output") {
    behaviour.takes_output = value == "yes";
  } else if ((name == "--string" || name == "--bytes") && value.find('=') != std::string::npos) {
    const std::string text = value.substr(value.find('=') + 1);
    Buffer& string = behaviour.strings[number];
    if (name == "--string") {
      string = as_utf16(text);
      return true;
    }
    for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
      string.push_back(static_cast<std::uint8_t>(std::strtoul(text.substr(i, 2).c_str(), nullptr, 16)));
    }
  } else {
    return false;
  }
  return true;
}

base::Result<std::unique_ptr<VirtualDevice>> make_usb_device(const VirtualDevice::Interfaces& interfaces,
                                                             const UsbBehaviour& behaviour) {
  auto device = std::make_unique<UsbDevice>(interfaces, behaviour);
  if (const auto attached = device->attach(); !attached) return attached.error();
  return std::unique_ptr<VirtualDevice>(std::move(device));
}

}  // namespace penpose::tests
