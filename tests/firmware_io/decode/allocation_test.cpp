// Decoding must not allocate: it runs between two reports of a device that sends a thousand a second.

#include <array>
#include <atomic>
#include <cstdlib>
#include <gtest/gtest.h>
#include <new>

#include "firmware_io/decode/decoder_factory.h"
#include "firmware_io/decode/hand_factory.h"
#include "firmware_io/decode/layout/protocol.h"
#include "firmware_io/decode/wacom/hand/wacom_hands.h"
#include "firmware_io/decode/wacom/wacom_models.h"
#include "tests/support/hands/hand_descriptors.h"
#include "tests/support/hands/pen_reports.h"

namespace {

std::atomic<std::size_t> allocations{0};

}  // namespace

// Kept out of line: where only one of the pair is inlined, GCC takes them for a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace penpose::decode {
namespace {

std::size_t allocations_of(PenDecoder& decoder, const std::vector<tests::Report>& reports) {
  const std::size_t before = allocations;
  for (const tests::Report& report : reports) decoder.decode(report);
  return allocations - before;
}

std::vector<tests::Report> reports_of_all_kinds() {
  std::vector<tests::Report> reports;
  PenSample sample;
  sample.in_range = sample.tip = true;
  sample.tool = Tool::pen;
  sample.pressure = 100;
  reports.push_back(tests::intuos_enter(0x10802, 7));
  reports.push_back(tests::intuos_pen(sample));
  reports.push_back(tests::bamboo_pen(sample));
  reports.push_back(tests::graphire_pen(sample));
  reports.push_back(tests::dtus_pen(sample));
  reports.push_back(tests::tablet_pc_pen(sample));
  reports.push_back(tests::ink_pen(sample));
  for (const std::size_t size : {1u, 7u, 10u, 12u, 14u, 64u, 361u}) {
    for (int first = 0; first < 256; ++first) {
      tests::Report report(size, static_cast<std::uint8_t>(first * 7));
      report[0] = static_cast<std::uint8_t>(first);
      reports.push_back(report);
    }
  }
  return reports;
}

std::array<DeviceIdentity, 2> on_both_buses(std::uint16_t product) {
  std::array<DeviceIdentity, 2> devices{tests::device(k_vendor_wacom, product), tests::device(k_vendor_wacom, product)};
  devices[0].bus = k_bus_usb;
  devices[1].bus = k_bus_bluetooth;
  return devices;
}

std::size_t allocations_of(HandDecoders& hand, const std::vector<tests::Report>& reports) {
  const std::size_t before = allocations;
  for (const tests::Report& report : reports) {
    if (hand.pad) hand.pad->decode(report);
    if (hand.touch) hand.touch->decode(report);
  }
  return allocations - before;
}

TEST(Allocation, CountingWorks) {
  const std::size_t before = allocations;
  const auto* memory = new int(5);
  EXPECT_EQ(allocations, before + 1);
  delete memory;
}

TEST(Allocation, NoWacomDecoderAllocates) {
  const auto reports = reports_of_all_kinds();
  for (const WacomModel& model : wacom_models()) {
    for (const DeviceIdentity& device : on_both_buses(model.product)) {
      auto made = make_decoder(device);
      if (!made) continue;
      EXPECT_EQ(allocations_of(*made->decoder, reports), 0u) << model.name;
    }
  }
}

TEST(Allocation, NoDescriptorDecoderAllocates) {
  const auto reports = reports_of_all_kinds();
  for (const std::uint16_t vendor : {std::uint16_t{0x1b96}, k_vendor_wacom}) {
    DeviceIdentity device;
    device.vendor = vendor;
    device.product = 0xffff;
    device.report_descriptor = tests::ink_descriptor();
    auto made = make_decoder(device);
    ASSERT_TRUE(made);
    EXPECT_EQ(allocations_of(*made->decoder, reports), 0u);
  }
}

TEST(Allocation, NoProtocolDecoderAllocates) {
  const auto reports = reports_of_all_kinds();
  for (const std::string& name : protocol_names()) {
    const auto decoder = make_protocol_decoder(name);
    EXPECT_EQ(allocations_of(*decoder, reports), 0u) << name;
  }
}

TEST(Allocation, NoHandDecoderAllocates) {
  const auto reports = reports_of_all_kinds();
  for (const WacomHand& known : wacom_hands()) {
    for (const DeviceIdentity& device : on_both_buses(known.product)) {
      auto hand = make_hand_decoders(device);
      EXPECT_EQ(allocations_of(hand, reports), 0u) << std::hex << known.product;
    }
  }
  for (const auto& descriptor :
       {tests::wacom_pad_descriptor(), tests::touch_descriptor(2), tests::uclogic_pad_descriptor()}) {
    for (const std::uint16_t vendor : {std::uint16_t{0x1b96}, k_vendor_wacom}) {
      DeviceIdentity device;
      device.vendor = vendor;
      device.product = 0xfff0;
      device.report_descriptor = descriptor;
      auto hand = make_hand_decoders(device);
      EXPECT_EQ(allocations_of(hand, reports), 0u);
    }
  }
  for (const std::string& name : protocol_names()) {
    auto hand = make_protocol_hand_decoders(name);
    EXPECT_EQ(allocations_of(hand, reports), 0u) << name;
  }
}

}  // namespace
}  // namespace penpose::decode
