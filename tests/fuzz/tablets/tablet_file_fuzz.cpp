// Any bytes as a tablet file or an OpenTabletDriver configuration; what is accepted must then find and decode without
// trouble.

#include <cstdint>
#include <cstdlib>
#include <vector>

#include "core/base/byte_reader.h"
#include "firmware_io/decode/table/tablet_reader.h"

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace decode = penpose::decode;
  const auto table = decode::read_tablet_file(penpose::base::as_text({data, size}));
  if (!table) {
    if (table.error().what.empty() || table.error().place.empty()) std::abort();
    return 0;
  }
  for (const auto& tablet : table->tablets()) {
    for (const auto& identifier : tablet.identifiers) {
      decode::DeviceIdentity device;
      device.vendor = identifier.vendor;
      device.product = identifier.product;
      device.name = tablet.name;
      device.strings[201] = "HUION_T173_200101";
      const auto match = decode::find_tablet(device, &*table);
      if (!match) continue;
      const auto decoder = decode::make_tablet_decoder(*match);
      for (std::size_t length = 0; length < 70; ++length) {
        decoder->decode(std::vector<std::uint8_t>(length, static_cast<std::uint8_t>(length * 37)));
      }
    }
  }
  return 0;
}
