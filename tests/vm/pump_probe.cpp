// What the live chain does inside the virtual machine:
//   pump_probe burst SECONDS RATE   a pen of RATE reports a second, from the report to the sample in its stroke
//   pump_probe lights STOP_FILE     follows the lights of the first tablet that has some, until the file exists
//   pump_probe watch STOP_FILE      prints what comes and goes until the file exists
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <thread>
#include <vector>

#include "firmware_io/decode/decoder_factory.h"
#include "firmware_io/decode/hand_factory.h"
#include "firmware_io/device/clock.h"
#include "firmware_io/device/list/event_list.h"
#include "firmware_io/device/list/tablet_watch.h"
#include "firmware_io/device/report_pump.h"
#include "firmware_io/device/tablet_lights.h"
#include "tests/support/hands/pen_reports.h"
#include "tests/support/hands/stroke_recorder.h"
#include "tests/vm/pace.h"
#include "tests/vm/virtual_device.h"

namespace {

using namespace penpose;

int fail(const base::Error& error) {
  std::cerr << "pump_probe: " << error.line() << '\n';
  return 1;
}

decode::DeviceIdentity ink_pen() { return tests::ink_device(0x0020, "Burst pen"); }

/// The report with that number, recognisable by its position; the pen lifts for ten reports of every two hundred.
tests::Report numbered(std::size_t number) {
  decode::PenSample sample;
  sample.in_range = true;
  sample.tool = decode::Tool::pen;
  sample.x = static_cast<std::int32_t>(number % 20000);
  sample.y = static_cast<std::int32_t>(number / 20000);
  sample.tip = number % 200 < 190;
  sample.pressure = sample.tip ? 1000 : 0;
  return tests::ink_pen(sample);
}

base::Result<device::LiveTablet> find_burst_pen() {
  for (int i = 0; i < 200; ++i) {
    auto tablets = device::list_tablets();
    for (auto& tablet : tablets) {
      if (tablet.interface.identity.name == "Burst pen" && tablet.access == device::Access::allowed) return tablet;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return base::Error{"the pen does not appear", "", ""};
}

void print_percentiles(const char* name, std::vector<std::int64_t> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double part) {
    return values.empty() ? 0 : values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
  };
  std::cout << ", \"" << name << "\": {\"p50\": " << at(0.5) << ", \"p95\": " << at(0.95) << ", \"p99\": " << at(0.99)
            << ", \"max\": " << at(1.0) << "}";
}

int burst(double seconds, double rate) {
  auto virtual_pen = tests::make_uhid_device({{0, ink_pen()}});
  if (!virtual_pen) return fail(virtual_pen.error());
  auto tablet = find_burst_pen();
  if (!tablet) return fail(tablet.error());
  auto source = device::open_tablet(*tablet);
  if (!source) return fail(source.error());
  auto recognition = decode::make_decoder(tablet->interface.identity);
  if (!recognition) return fail(recognition.error());

  const auto count = std::max<std::size_t>(static_cast<std::size_t>(seconds * rate), 1);
  std::vector<std::int64_t> sent_us(count);
  std::vector<std::int64_t> to_thread;
  std::vector<std::int64_t> to_stroke;
  to_thread.reserve(count);
  to_stroke.reserve(count);
  std::atomic<bool> done{false};
  device::ReportPump pump(std::move(*source), {});
  std::thread producer([&] {
    constexpr int k_at_once = 16;
    tests::Pace pace(std::chrono::microseconds(static_cast<std::int64_t>(1e6 / rate)), k_at_once);
    for (std::size_t i = 0; i < count; ++i) {
      pace.wait();
      const auto report = numbered(i);
      sent_us[i] = device::monotonic_us();
      if (!(*virtual_pen)->send(0, report)) break;
    }
    done = true;
  });

  tests::StrokeRecorder strokes;
  device::Record record;
  std::size_t wrong = 0;
  std::size_t expected = 0;
  for (;;) {
    const bool over = done;
    if (!pump.wait(200) && over) break;
    while (pump.take(record)) {
      if (record.kind != device::RecordKind::report) continue;
      if (recognition->decoder->decode(record.bytes) != decode::ReportKind::pen) ++wrong;
      const auto& sample = recognition->decoder->sample();
      strokes.add(sample, record.time_us);
      const auto number = static_cast<std::size_t>(sample.y) * 20000 + static_cast<std::size_t>(sample.x);
      if (number >= count || number < expected) {
        ++wrong;
        continue;
      }
      expected = number + 1;
      to_thread.push_back(record.time_us - sent_us[number]);
      to_stroke.push_back(device::monotonic_us() - sent_us[number]);
    }
  }
  producer.join();
  const double took = static_cast<double>(sent_us.back() - sent_us.front()) / 1e6;
  std::size_t points = 0;
  for (const auto& stroke : strokes.strokes()) points += stroke.points.size();
  std::cout << "{\"sent\": " << count << ", \"received\": " << pump.received() << ", \"wrong\": " << wrong
            << ", \"overruns\": " << pump.overruns() << ", \"strokes\": " << strokes.strokes().size()
            << ", \"points\": " << points << ", \"rate\": " << static_cast<double>(count) / took;
  print_percentiles("to_thread_us", to_thread);
  print_percentiles("to_stroke_us", to_stroke);
  std::cout << "}" << std::endl;
  return 0;
}

void print_seen(const device::LiveTablet& tablet) {
  const auto seen = device::seen_lights(tablet.interface);
  std::cout << "seen " << (seen ? std::to_string((*seen)[0]) : "none") << std::endl;
}

/// As the window does: the kernel's driver switches the light, or else this program.
int lights(const char* stop_file) {
  auto tablets = device::list_tablets();
  for (auto& tablet : tablets) {
    auto hand = decode::make_hand_decoders(tablet.interface.identity);
    if (!hand.pad || hand.pad->features().modes == 0) continue;
    auto source = device::open_tablet(tablet);
    if (!source) return fail(source.error());
    const bool by_kernel = device::kernel_switches_lights(tablet);
    print_seen(tablet);
    device::ReportPump pump(std::move(*source), device::ReportPump::Options{tablet.wake_up()});
    std::optional<decode::Lights> shown;
    device::Record record;
    std::cout << (by_kernel ? "kernel" : "ready") << std::endl;
    while (!pump.gone() && !std::filesystem::exists(stop_file)) {
      if (const decode::Lights now = hand.pad->sample().mode; shown != now) {
        shown = now;
        std::cout << "light " << static_cast<int>(now[0]) << std::endl;
        const auto report = decode::light_report(tablet.interface.identity, now);
        if (!by_kernel && report) pump.send_feature(*report);
      }
      pump.wait(100);
      // One at a time, so that each light is shown.
      if (pump.take(record) && record.kind == device::RecordKind::report) hand.pad->decode(record.bytes);
    }
    print_seen(tablet);
    return 0;
  }
  return fail({"no tablet has lights", "", ""});
}

int watch(const char* stop_file) {
  auto watching = device::TabletWatch::start();
  if (!watching) return fail(watching.error());
  std::cout << "watching" << std::endl;
  while (!std::filesystem::exists(stop_file)) {
    const auto changes = watching->next(200);
    for (const auto& tablet : changes.arrived) {
      std::cout << "arrived " << tablet.path() << ' ' << tablet.interface.identity.name << std::endl;
    }
    for (const auto& tablet : changes.left) {
      std::cout << "left " << tablet.path() << ' ' << tablet.interface.identity.name << std::endl;
    }
  }
  return 0;
}

/// What a look at the system costs, that at event devices apart from all of it; the best of many.
int listing() {
  constexpr int k_rounds = 50;
  const auto best_us = [](const auto& look) {
    std::int64_t best = INT64_MAX;
    for (int i = 0; i < k_rounds; ++i) {
      const std::int64_t begin = device::monotonic_us();
      look();
      best = std::min(best, device::monotonic_us() - begin);
    }
    return best;
  };
  std::size_t events = 0;
  const std::int64_t events_us = best_us([&] { events = device::list_event_devices().size(); });
  std::cout << "{\"event_tablets\": " << events << ", \"events_us\": " << events_us
            << ", \"all_us\": " << best_us([] { static_cast<void>(device::list_tablets()); }) << "}" << std::endl;
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  if (what == "burst" && argc == 4) return burst(std::strtod(argv[2], nullptr), std::strtod(argv[3], nullptr));
  if (what == "lights" && argc == 3) return lights(argv[2]);
  if (what == "watch" && argc == 3) return watch(argv[2]);
  if (what == "listing" && argc == 2) return listing();
  return 2;
}
