// Reports of any content on the three interfaces of a wireless receiver: which tablet each stands for, and what is
// decoded of it. Each report has its interface and its length in front.

#include <array>

#include "firmware_io/decode/decoder_factory.h"
#include "firmware_io/decode/wacom/wacom_models.h"
#include "firmware_io/decode/wacom/wacom_receiver.h"
#include "tests/support/hands/hand_reports.h"

using namespace penpose;

namespace {

decode::DeviceIdentity interface_of_receiver(int number) {
  decode::DeviceIdentity identity;
  identity.vendor = decode::k_vendor_wacom;
  identity.product = decode::k_wacom_receiver;
  identity.interface_number = number;
  return identity;
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr int k_interfaces = 3;
  decode::WacomReceivers receivers;
  std::array<std::unique_ptr<decode::PenDecoder>, k_interfaces> pens;
  std::array<decode::HandDecoders, k_interfaces> hands;
  const auto read_as = [&](int device, const decode::DeviceIdentity& identity) {
    auto made = decode::make_decoder(identity);
    pens[static_cast<std::size_t>(device)] = made ? std::move(made->decoder) : nullptr;
    hands[static_cast<std::size_t>(device)] = decode::make_hand_decoders(identity);
  };
  for (int i = 0; i < k_interfaces; ++i) read_as(i, receivers.connect(i, interface_of_receiver(i)));
  base::ByteReader reader(base::Bytes(data, size));
  while (const auto head = reader.read<std::uint8_t>()) {
    const int device = *head % k_interfaces;
    const std::size_t wanted = *head / k_interfaces;
    const auto report = reader.take(std::min(wanted, reader.remaining()));
    for (const auto& [number, identity] : receivers.report(device, *report)) {
      if (number < 0 || number >= k_interfaces || receivers.shown(number) == nullptr) std::abort();
      if (decode::is_receiver_monitor(identity) != (number == 0)) std::abort();
      if (number != 0) read_as(number, identity);
    }
    const auto at = static_cast<std::size_t>(device);
    if (pens[at]) pens[at]->decode(*report);
    if (hands[at].pad) {
      hands[at].pad->decode(*report);
      fuzz::check(*hands[at].pad);
    }
    if (hands[at].touch) {
      hands[at].touch->decode(*report);
      fuzz::check(*hands[at].touch);
    }
  }
  return 0;
}
