#pragma once

#include <memory>

#include "firmware_io/decode/sample/touch_decoder.h"
#include "firmware_io/decode/table/tablet_table.h"

namespace penpose::decode {

/// Whether any report of a protocol has fingers.
[[nodiscard]] bool has_touch(const Protocol& protocol);

/// The fingers in the reports of a vendor's protocol. A finger's number is its slot; every report ends a frame.
class VendorTouchDecoder final : public TouchDecoder {
 public:
  /// `tablet` (may be null) gives ranges and resolution.
  VendorTouchDecoder(std::shared_ptr<const Protocol> protocol, const Tablet* tablet);

  bool decode(base::Bytes report) override;

 private:
  bool decode_contacts(const ContactList& list, base::Bytes report);
  bool decode_messages(base::Bytes report);
  void show(std::size_t slot, bool down, std::int32_t x, std::int32_t y);

  std::shared_ptr<const Protocol> protocol_;
};

}  // namespace penpose::decode
