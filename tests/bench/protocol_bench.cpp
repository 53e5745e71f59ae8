// Reports a second of every vendor protocol on one core, and the promise that decoding allocates nothing.

#include <array>
#include <benchmark/benchmark.h>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include "firmware_io/decode/protocol.h"

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

/// Reports of 64 bytes that, between them, reach every rule of a protocol: leading bytes that its tests look for, and
/// noise.
std::vector<std::array<std::uint8_t, 64>> reports() {
  constexpr std::array<std::uint8_t, 8> k_ids{0x02, 0x10, 0x1e, 0x08, 0x09, 0x11, 0x01, 0x0c};
  constexpr std::array<std::uint8_t, 8> k_states{0xe1, 0xa0, 0x81, 0x41, 0xea, 0xf4, 0x42, 0x61};
  std::vector<std::array<std::uint8_t, 64>> list;
  std::uint32_t noise = 1;
  for (const auto id : k_ids) {
    for (const auto state : k_states) {
      auto& report = list.emplace_back();
      for (auto& byte : report) {
        noise = noise * 1664525 + 1013904223;
        byte = static_cast<std::uint8_t>(noise >> 24);
      }
      report[0] = id;
      report[1] = state;
      report[2] = (noise & 0x10000) != 0 ? 0xa1 : report[2];
    }
  }
  return list;
}

void decode_reports(benchmark::State& state, const std::string& name) {
  const auto list = reports();
  const auto decoder = decode::make_protocol_decoder(name);
  const std::size_t before = allocations;
  std::int64_t sum = 0;
  for (auto _ : state) {
    for (const auto& report : list) {
      decoder->decode(report);
      sum += decoder->sample().x;
    }
  }
  benchmark::DoNotOptimize(sum);
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * list.size()));
  state.counters["allocations"] = static_cast<double>(allocations - before);
}

const bool k_registered = [] {
  for (const auto& name : decode::protocol_names()) {
    benchmark::RegisterBenchmark(name.c_str(), [name](benchmark::State& state) { decode_reports(state, name); });
  }
  return true;
}();

}  // namespace
