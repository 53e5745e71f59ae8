// Makes a Linux input device out of an evemu recording, inside the virtual machine: virtual_input FILE [OPTION
// VALUE]...
//   --go FILE          send the frames once this file exists (default: at once)
//   --pace-us N        wait that long between frames (default 1000)
//   --unplug-after N   pull the plug after N frames (default: after all of them)
//   --pause-after N    stop after N frames, may be given several times; say so and go on once FILE.N exists, FILE that
//                      of --go
//   --keep FILE        stay plugged in until this file exists
//   --place NAME       where it is plugged in
// Prints how many frames were sent.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <iostream>
#include <linux/uinput.h>
#include <set>
#include <string>
#include <sys/ioctl.h>
#include <unistd.h>
#include <vector>

#include "firmware_io/event/evemu_line.h"
#include "tests/vm/pace.h"
#include "tests/vm/replaying.h"

namespace {

using namespace penpose;

struct Options : tests::Replaying {
  std::string place = "virtual/input0";
  std::set<long> pauses;
};

bool take_option(Options& options, const std::string& name, const std::string& value) {
  if (name == "--place") {
    options.place = value;
  } else if (name == "--pause-after") {
    options.pauses.insert(std::strtol(value.c_str(), nullptr, 10));
  } else {
    return options.take(name, value);
  }
  return true;
}

bool set_up(int file, const event::EventAxes& axes, const std::string& place) {
  bool done = true;
  const auto allow = [&](unsigned long type_request, int type, unsigned long request, const auto& codes) {
    if (codes.empty()) return;
    done = done && ::ioctl(file, type_request, type) == 0;
    for (const std::uint16_t code : codes) done = done && ::ioctl(file, request, code) == 0;
  };
  allow(UI_SET_EVBIT, EV_KEY, UI_SET_KEYBIT, axes.keys);
  allow(UI_SET_EVBIT, EV_REL, UI_SET_RELBIT, axes.rels);
  allow(UI_SET_EVBIT, EV_MSC, UI_SET_MSCBIT, axes.mscs);
  for (const std::uint16_t property : axes.properties) done = done && ::ioctl(file, UI_SET_PROPBIT, property) == 0;
  if (!axes.abs.empty()) done = done && ::ioctl(file, UI_SET_EVBIT, EV_ABS) == 0;
  for (const auto& [code, range] : axes.abs) {
    uinput_abs_setup axis{};
    axis.code = code;
    axis.absinfo.minimum = range.minimum;
    axis.absinfo.maximum = range.maximum;
    axis.absinfo.resolution = range.resolution;
    done = done && ::ioctl(file, UI_ABS_SETUP, &axis) == 0;
  }
  uinput_setup facts{};
  facts.id = {axes.bus, axes.vendor, axes.product, 1};
  std::strncpy(facts.name, axes.name.c_str(), sizeof facts.name - 1);
  done = done && ::ioctl(file, UI_SET_PHYS, place.c_str()) == 0;
  return done && ::ioctl(file, UI_DEV_SETUP, &facts) == 0 && ::ioctl(file, UI_DEV_CREATE) == 0;
}

int play(const char* path, const Options& options) {
  std::ifstream recording(path);
  event::EvemuLines lines;
  std::vector<std::vector<input_event>> frames(1);
  for (std::string text; std::getline(recording, text);) {
    if (lines.read(text) != event::EvemuLines::Kind::event) continue;
    input_event event{};
    event.type = lines.event().type;
    event.code = lines.event().code;
    event.value = lines.event().value;
    frames.back().push_back(event);
    if (event.type == EV_SYN && event.code == SYN_REPORT) frames.emplace_back();
  }
  frames.pop_back();
  const int file = ::open("/dev/uinput", O_RDWR | O_CLOEXEC);
  if (file < 0 || !set_up(file, lines.axes(), options.place)) {
    std::perror("virtual_input");
    return 1;
  }
  std::cerr << "plugged in" << std::endl;
  tests::wait_for(options.go);
  long sent = 0;
  tests::Pace pace(std::chrono::microseconds(options.pace_us), tests::k_at_once);
  for (const auto& frame : frames) {
    if (sent == options.unplug_after) break;
    pace.wait();
    const std::size_t size = frame.size() * sizeof(input_event);
    if (::write(file, frame.data(), size) != static_cast<ssize_t>(size)) break;
    ++sent;
    if (!options.pauses.contains(sent)) continue;
    std::cout << "paused after " << sent << std::endl;
    tests::wait_for(options.go + "." + std::to_string(sent));
    pace.begin();
  }
  std::cout << "sent " << sent << std::endl;
  tests::wait_for(options.keep);
  ::ioctl(file, UI_DEV_DESTROY);
  ::close(file);
  std::cerr << "unplugged" << std::endl;
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  Options options;
  for (int i = 2; i + 1 < argc; i += 2) {
    if (!take_option(options, argv[i], argv[i + 1])) return 2;
  }
  return play(argv[1], options);
}
