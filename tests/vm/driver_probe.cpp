// What the kernel's own drivers make of reports, inside the virtual machine:
// driver_probe uhid|usb TRACE PORT [OPTION VALUE]...
//   --go FILE          send the reports once this file exists (default: at once)
//   others             what the USB device says and does, as of virtual_tablet
// Plugs in the trace's tablet, gives its reports to the kernel one at a time and prints what its nodes of keys and of
// fingers said after each, as tests/vm/README.md describes it.
#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <iostream>
#include <linux/input.h>
#include <memory>
#include <set>
#include <string>
#include <sys/ioctl.h>
#include <thread>
#include <unistd.h>

#include "replay/trace/trace_source.h"
#include "tests/support/shared_data.h"
#include "tests/vm/virtual_device.h"

namespace {

using namespace penpose;

constexpr std::size_t k_most_slots = 256;

/// One node of the kernel's input layer, with what it said so far.
class Node {
 public:
  Node(int file, std::string path) : file_(file), path_(std::move(path)) {
    std::array<char, 256> name{};
    ::ioctl(file_, EVIOCGNAME(name.size()), name.data());
    name_ = name.data();
    ::ioctl(file_, EVIOCGBIT(EV_KEY, sizeof keys_known_), keys_known_.data());
    ::ioctl(file_, EVIOCGBIT(EV_ABS, sizeof axes_known_), axes_known_.data());
    // Small moves count, too.
    for (const unsigned code : {ABS_X, ABS_Y, ABS_MT_POSITION_X, ABS_MT_POSITION_Y}) {
      input_absinfo axis{};
      if (!knows(axes_known_, code) || ::ioctl(file_, EVIOCGABS(code), &axis) != 0) continue;
      axis.fuzz = 0;
      ::ioctl(file_, EVIOCSABS(code), &axis);
    }
    // hid-uclogic makes a node of each kind of control.
    for (const char* end : {" Pad", " Touch Ring", " Touch Strip", " Dial"}) is_pad_ = is_pad_ || name_.ends_with(end);
    is_many_ = knows(axes_known_, ABS_MT_POSITION_X);
    is_touch_ = is_many_ || name_.ends_with(" Finger");
  }
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;
  ~Node() { ::close(file_); }

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] bool matters() const { return is_pad_ || is_touch_; }

  void describe(int number) {
    number_ = number;
    std::cout << "node " << number << (is_pad_ ? " pad " : " touch ") << name_ << std::endl;
  }

  /// Takes what was said since the last time; one line of state when that were any whole frames.
  void follow(long report) {
    wheel_ = {};
    bool ended = false;
    std::array<input_event, 64> events{};
    while (true) {
      const ssize_t size = ::read(file_, events.data(), sizeof events);
      if (size <= 0) break;
      for (std::size_t i = 0; i < static_cast<std::size_t>(size) / sizeof(input_event); ++i)
        ended = take(events[i]) || ended;
    }
    if (ended) print(report);
  }

 private:
  template <class Bits>
  static bool knows(const Bits& bits, unsigned code) {
    return (bits[code / 8] >> (code % 8) & 1) != 0;
  }

  bool take(const input_event& event) {
    switch (event.type) {
      case EV_SYN:
        return event.code == SYN_REPORT;
      case EV_KEY:
        if (event.value != 0) held_.insert(event.code);
        if (event.value == 0) held_.erase(event.code);
        return false;
      case EV_REL:
        if (event.code == REL_WHEEL) wheel_[0] += event.value;
        if (event.code == REL_HWHEEL) wheel_[1] += event.value;
        return false;
      case EV_ABS:
        if (event.code == ABS_MT_SLOT) slot_ = static_cast<std::size_t>(event.value) % k_most_slots;
        if (event.code == ABS_MT_TRACKING_ID) slots_[slot_].down = event.value >= 0;
        if (event.code == ABS_MT_POSITION_X) slots_[slot_].x = event.value;
        if (event.code == ABS_MT_POSITION_Y) slots_[slot_].y = event.value;
        if (event.code < ABS_CNT) values_[event.code] = event.value;
        return false;
      default:
        return false;
    }
  }

  void print_axis(unsigned code) const {
    if (knows(axes_known_, code)) {
      std::cout << ' ' << values_[code];
    } else {
      std::cout << " -";
    }
  }

  void print(long report) const {
    if (is_pad_) {
      std::cout << "pad " << report << ' ';
      const char* between = "";
      for (const int key : held_) {
        // Of the pen, the keyboard's tool and touch: no keys of a pad.
        if (key >= BTN_DIGI && key < BTN_WHEEL) continue;
        std::cout << between << key;
        between = "+";
      }
      if (*between == '\0') std::cout << '-';
      for (const unsigned code : {ABS_WHEEL, ABS_THROTTLE, ABS_RX, ABS_RY}) print_axis(code);
      std::cout << ' ' << wheel_[0] << ' ' << wheel_[1] << ' ' << number_ << '\n';
      return;
    }
    std::cout << "touch " << report;
    bool any = false;
    if (is_many_) {
      for (const Slot& slot : slots_) {
        if (!slot.down) continue;
        std::cout << ' ' << slot.x << ':' << slot.y;
        any = true;
      }
    } else if (held_.contains(BTN_TOUCH)) {
      std::cout << ' ' << values_[ABS_X] << ':' << values_[ABS_Y];
      any = true;
    }
    std::cout << (any ? "\n" : " -\n");
  }

  struct Slot {
    bool down = false;
    int x = 0;
    int y = 0;
  };

  int file_;
  int number_ = 0;
  std::string path_;
  std::string name_;
  bool is_pad_ = false;
  bool is_touch_ = false;
  bool is_many_ = false;
  std::array<std::uint8_t, KEY_CNT / 8> keys_known_{};
  std::array<std::uint8_t, ABS_CNT / 8> axes_known_{};
  std::set<int> held_;
  std::array<int, ABS_CNT> values_{};
  std::array<int, 2> wheel_{};
  std::array<Slot, k_most_slots> slots_{};
  std::size_t slot_ = 0;
};

/// Adds the nodes that have come.
void find_nodes(std::vector<std::unique_ptr<Node>>& nodes, int& count, bool tell = true) {
  std::set<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator("/dev/input")) paths.insert(entry.path());
  for (const auto& path : paths) {
    if (!path.filename().string().starts_with("event")) continue;
    if (std::any_of(nodes.begin(), nodes.end(), [&](const auto& node) { return node->path() == path; })) continue;
    const int file = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) continue;
    nodes.push_back(std::make_unique<Node>(file, path));
    if (!nodes.back()->matters()) continue;
    if (tell) nodes.back()->describe(count);
    ++count;
  }
}

/// Waits until the nodes of the tablet before are gone.
void wait_for_none() {
  constexpr int k_most_tries = 100;
  for (int i = 0; i < k_most_tries; ++i) {
    std::vector<std::unique_ptr<Node>> nodes;
    int count = 0;
    find_nodes(nodes, count, false);
    if (count == 0) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
}

int fail(const base::Error& error) {
  std::cerr << "driver_probe: " << error.line() << '\n';
  return 1;
}

struct Options {
  std::string go;
  tests::UsbBehaviour usb;
};

int run(const std::string& kind, const std::string& trace, const Options& options) {
  const auto bytes = tests::read_file(trace);
  replay::TraceSource source(replay::read_from(bytes));
  if (const auto header = source.read_header(); !header) return fail(header.error());
  wait_for_none();
  auto device =
      kind == "usb" ? tests::make_usb_device(source.devices(), options.usb) : tests::make_uhid_device(source.devices());
  if (!device) return fail(device.error());
  std::vector<std::unique_ptr<Node>> nodes;
  int count = 0;
  const auto wait_for_more = [&](int least) {
    constexpr int k_most_tries = 80;
    for (int i = 0; i < k_most_tries && count < least; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      find_nodes(nodes, count);
    }
    // The others of one tablet come at about the same time.
    for (int i = 0; i < 15; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      find_nodes(nodes, count);
    }
  };
  wait_for_more(1);
  while (!options.go.empty() && !std::filesystem::exists(options.go))
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  long number = 0;
  for (auto report = source.next(); report && report->has_value(); report = source.next(), ++number) {
    const auto& data = (*report)->bytes;
    if (const auto sent = (*device)->send((*report)->device, data); !sent) return fail(sent.error());
    if (const auto taken = (*device)->settle((*report)->device); !taken) return fail(taken.error());
    // A remote gets its node when a first report has named it.
    if (number == 0 && count == 0) wait_for_more(1);
    for (const auto& node : nodes) {
      if (node->matters()) node->follow(number);
    }
  }
  std::cout << "end " << number << std::endl;
  (*device)->unplug();
  std::_Exit(0);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return 2;
  Options options;
  options.usb.port = std::atoi(argv[3]);
  for (int i = 4; i + 1 < argc; i += 2) {
    if (std::string(argv[i]) == "--go") {
      options.go = argv[i + 1];
    } else if (!tests::take_usb_option(options.usb, argv[i], argv[i + 1])) {
      return 2;
    }
  }
  return run(argv[1], argv[2], options);
}
