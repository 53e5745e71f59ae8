#include "firmware_io/hid/internal/descriptor_item.h"

#include <utility>

namespace penpose::hid {

base::Error illegal(std::size_t offset, std::string what) {
  return {"report descriptor: " + std::move(what), "byte " + std::to_string(offset),
          "the device's descriptor breaks HID 1.11; choose a protocol by name if the tablet is known to have one"};
}

base::Result<std::optional<Item>> next_item(base::ByteReader& reader) {
  constexpr std::uint8_t k_long_item = 0xfe;
  while (!reader.at_end()) {
    Item item;
    item.offset = reader.offset();
    const std::uint8_t prefix = *reader.read<std::uint8_t>();
    if (prefix == k_long_item) {
      const auto size = reader.read<std::uint8_t>();
      const auto tag = reader.read<std::uint8_t>();
      if (!size || !tag || !reader.take(*size)) return illegal(item.offset, "ends within a long item");
      continue;
    }
    item.type = static_cast<ItemType>((prefix >> 2) & 3);
    item.tag = static_cast<std::uint8_t>(prefix >> 4);
    item.size = (prefix & 3) == 3 ? 4 : (prefix & 3);
    const auto data = reader.take(item.size);
    if (!data) return illegal(item.offset, "ends within an item");
    for (std::size_t i = 0; i < item.size; ++i) item.data |= static_cast<std::uint32_t>((*data)[i]) << (8 * i);
    return std::optional(item);
  }
  return std::optional<Item>();
}

}  // namespace penpose::hid
