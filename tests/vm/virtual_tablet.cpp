// Makes tablets out of a trace, inside the virtual machine: virtual_tablet uhid|usb TRACE [OPTION VALUE]...
//   --go FILE          send the reports once this file exists (default: at once)
//   --pace-us N        wait that long between reports (default 1000)
//   --unplug-after N   pull the plug after N reports (default: after all of them)
//   --keep FILE        stay plugged in until this file exists
//   --port N           of the virtual USB host controller
//   --string N=TEXT    a USB string descriptor
//   --bytes N=HEX      the same, of any bytes
//   --asleep-until N   send nothing before this string was read
//   --output yes       endpoints for output beside those for input
// Prints how many reports were sent.
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string>
#include <thread>

#include "replay/trace/trace_source.h"
#include "tests/support/shared_data.h"
#include "tests/vm/pace.h"
#include "tests/vm/replaying.h"
#include "tests/vm/virtual_device.h"

namespace {

using namespace penpose;

struct Options : tests::Replaying {
  tests::UsbBehaviour usb;
};

int fail(const base::Error& error) {
  std::cerr << "virtual_tablet: " << error.line() << '\n';
  return 1;
}

int play(const std::string& kind, const std::string& trace, const Options& options) {
  const auto bytes = tests::read_file(trace);
  replay::TraceSource source(replay::read_from(bytes));
  if (const auto header = source.read_header(); !header) return fail(header.error());
  auto device =
      kind == "usb" ? tests::make_usb_device(source.devices(), options.usb) : tests::make_uhid_device(source.devices());
  if (!device) return fail(device.error());
  std::cerr << "plugged in" << std::endl;
  tests::wait_for(options.go);
  long sent = 0;
  tests::Pace pace(std::chrono::microseconds(options.pace_us), tests::k_at_once);
  for (auto report = source.next(); report && report->has_value(); report = source.next()) {
    if (options.unplug_after >= 0 && sent >= options.unplug_after) break;
    pace.wait();
    if (const auto done = (*device)->send((*report)->device, (*report)->bytes); !done) {
      std::cout << "sent " << sent << std::endl;
      return fail(done.error());
    }
    ++sent;
  }
  // What was sent last is still on its way through the cable; /dev/uhid has none.
  if (kind == "usb") std::this_thread::sleep_for(std::chrono::milliseconds(300));
  std::cout << "sent " << sent << std::endl;
  tests::wait_for(options.keep);
  (*device)->unplug();
  std::cerr << "unplugged" << std::endl;
  // Closing the server's end of a virtual USB device may wait for the kernel for good; the end of the machine frees
  // all.
  std::_Exit(0);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  Options options;
  for (int i = 3; i + 1 < argc; i += 2) {
    if (!options.take(argv[i], argv[i + 1]) && !tests::take_usb_option(options.usb, argv[i], argv[i + 1])) return 2;
  }
  return play(argv[1], argv[2], options);
}
