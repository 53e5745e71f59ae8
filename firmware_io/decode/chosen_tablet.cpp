#include "firmware_io/decode/chosen_tablet.h"

#include <optional>
#include <utility>

#include "firmware_io/decode/decoder_factory.h"
#include "firmware_io/decode/wacom/wacom_models.h"

namespace penpose::decode {

DeviceIdentity identified(const DeviceIdentity& device, const TabletTable* own) {
  if (own == nullptr || !own->is_choice() || device.vendor != 0 || device.product != 0) return device;
  const Tablet& tablet = own->tablets().front();
  for (const auto* identifiers : {&tablet.identifiers, &tablet.pads}) {
    std::optional<DeviceIdentity> found;
    for (const TabletIdentifier& one : *identifiers) {
      DeviceIdentity named = device;
      complete_identity(named);
      if (named.bus != k_bus_bluetooth) named.bus = k_bus_usb;
      named.vendor = one.vendor;
      named.product = one.product;
      if (!own->find(named)) continue;
      if (find_wacom_model(named.bus, named.vendor, named.product) != nullptr) return named;
      if (!found) found = std::move(named);
    }
    if (found) return *found;
  }
  return device;
}

}  // namespace penpose::decode
