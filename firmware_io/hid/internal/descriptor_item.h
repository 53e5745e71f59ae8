#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/byte_reader.h"
#include "core/base/result.h"

namespace penpose::hid {

enum class ItemType : std::uint8_t { main = 0, global = 1, local = 2, reserved = 3 };

struct Item {
  std::size_t offset = 0;  ///< of its prefix
  ItemType type = ItemType::main;
  std::uint8_t tag = 0;
  std::uint8_t size = 0;  ///< bytes of data: 0, 1, 2 or 4
  std::uint32_t data = 0;

  [[nodiscard]] std::int32_t as_signed() const {
    if (size == 1) return static_cast<std::int8_t>(data);
    if (size == 2) return static_cast<std::int16_t>(data);
    return static_cast<std::int32_t>(data);
  }
};

/// A violation of HID 1.11, at a byte of a descriptor.
[[nodiscard]] base::Error illegal(std::size_t offset, std::string what);

/// The next short item; nothing at the end. Long items have no defined meaning (6.2.2.3) and are skipped.
[[nodiscard]] base::Result<std::optional<Item>> next_item(base::ByteReader& reader);

}  // namespace penpose::hid
