// Reports a second of every vendor protocol on one core, and the promise that decoding allocates nothing.

#include <array>
#include <benchmark/benchmark.h>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include "firmware_io/decode/layout/protocol.h"

namespace {
std::size_t allocations = 0;
}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace {

namespace decode = penpose::decode;

using Report = std::array<std::uint8_t, 64>;

/// Reports in which the protocol sees a pen, or a pad where it has no pen: those that take a decoder longest.
std::vector<Report> busy_reports(decode::PenDecoder& decoder) {
  constexpr std::size_t k_most = 256;
  std::vector<Report> pens;
  std::vector<Report> pads;
  std::uint32_t noise = 1;
  for (const int id : {0x02, 0x10, 0x1e, 0x08, 0x01, 0x11, 0x00}) {
    for (int state = 0; state < 256; ++state) {
      for (const int third : {0xa1, 0x10, 0x61}) {
        Report report;
        for (auto& byte : report) {
          noise = noise * 1664525 + 1013904223;
          byte = static_cast<std::uint8_t>(noise >> 24);
        }
        // The skip1 families have one byte more in front, so the same head stands at both places in turn.
        const std::size_t at = (noise >> 20) & 1;
        report[at] = static_cast<std::uint8_t>(id);
        report[at + 1] = static_cast<std::uint8_t>(state);
        report[at + 2] = static_cast<std::uint8_t>(third);
        const auto kind = decoder.decode(report);
        if (kind == decode::ReportKind::pen && decoder.sample().in_range && pens.size() < k_most)
          pens.push_back(report);
        if (kind == decode::ReportKind::pad && pads.size() < k_most) pads.push_back(report);
      }
    }
  }
  return pens.empty() ? pads : pens;
}

void decode_reports(benchmark::State& state, const std::string& name) {
  const auto decoder = decode::make_protocol_decoder(name);
  const auto reports = busy_reports(*decoder);
  const std::size_t before = allocations;
  for (const auto& report : reports) decoder->decode(report);
  if (reports.empty() || allocations != before) state.SkipWithError("no report to read, or memory allocated");
  std::int64_t sum = 0;
  for (auto _ : state) {
    for (const auto& report : reports) {
      decoder->decode(report);
      sum += decoder->sample().x;
    }
  }
  benchmark::DoNotOptimize(sum);
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * reports.size()));
}

const bool k_registered = [] {
  for (const auto& name : decode::protocol_names()) {
    benchmark::RegisterBenchmark(name.c_str(), [name](benchmark::State& state) { decode_reports(state, name); });
  }
  return true;
}();

}  // namespace
