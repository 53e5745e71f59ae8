// Reports a second through every kind of decoder, on one core.

#include <benchmark/benchmark.h>
#include <cstdlib>
#include <memory>
#include <vector>

#include "firmware_io/decode/decoder_factory.h"
#include "firmware_io/decode/wacom/wacom_models.h"
#include "tests/support/hands/pen_path.h"
#include "tests/support/hands/pen_reports.h"

namespace {

using namespace penpose;
using tests::Report;

std::unique_ptr<decode::PenDecoder> decoder_of(std::uint16_t vendor, std::uint16_t product, Report descriptor = {},
                                               std::uint16_t bus = decode::k_bus_usb) {
  decode::DeviceIdentity device;
  device.bus = bus;
  device.vendor = vendor;
  device.product = product;
  device.report_descriptor = std::move(descriptor);
  auto made = decode::make_decoder(device);
  if (!made) std::abort();
  return std::move(made->decoder);
}

template <typename Encode>
std::vector<Report> reports_of(const Encode& encode) {
  std::vector<Report> reports;
  for (const auto& sample : tests::pen_path({9000, 8000, 1000, true, -1}, 8, 128)) reports.push_back(encode(sample));
  return reports;
}

void run(benchmark::State& state, decode::PenDecoder& decoder, const std::vector<Report>& reports) {
  for (auto _ : state) {
    for (const Report& report : reports) {
      benchmark::DoNotOptimize(decoder.decode(report));
      benchmark::DoNotOptimize(decoder.sample());
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(reports.size()));
}

void windows_ink(benchmark::State& state) {
  run(state, *decoder_of(0x1b96, 0xffff, tests::ink_descriptor()), reports_of(tests::ink_pen));
}
void wacom_described(benchmark::State& state) {
  run(state, *decoder_of(decode::k_vendor_wacom, 0xffff, tests::ink_descriptor()), reports_of(tests::ink_pen));
}
void intuos(benchmark::State& state) {
  auto reports = reports_of(tests::intuos_pen);
  reports.insert(reports.begin(), tests::intuos_enter(0x10802, 1));
  run(state, *decoder_of(decode::k_vendor_wacom, 0x00b9), reports);
}
void bamboo(benchmark::State& state) {
  run(state, *decoder_of(decode::k_vendor_wacom, 0x00d4), reports_of(tests::bamboo_pen));
}
void graphire(benchmark::State& state) {
  run(state, *decoder_of(decode::k_vendor_wacom, 0x0013), reports_of(tests::graphire_pen));
}
void dtus(benchmark::State& state) {
  run(state, *decoder_of(decode::k_vendor_wacom, 0x00fb), reports_of(tests::dtus_pen));
}
/// Seven frames in each report of 361 bytes.
void intuos_pro_bluetooth(benchmark::State& state) {
  Report report(361);
  report[0] = 0x80;
  for (std::size_t i = 0; i < 7; ++i) report[1 + 14 * i] = 0xe1;
  run(state, *decoder_of(decode::k_vendor_wacom, 0x0360, {}, decode::k_bus_bluetooth), std::vector<Report>(64, report));
}

BENCHMARK(windows_ink);
BENCHMARK(wacom_described);
BENCHMARK(intuos);
BENCHMARK(bamboo);
BENCHMARK(graphire);
BENCHMARK(dtus);
BENCHMARK(intuos_pro_bluetooth);

}  // namespace
