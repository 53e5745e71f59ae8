#pragma once

#include <memory>

#include "firmware_io/decode/sample/pad_decoder.h"
#include "firmware_io/decode/sample/pen_decoder.h"
#include "firmware_io/decode/table/tablet_table.h"

namespace penpose::decode {

/// Whether any report of a protocol has keys or wheels.
[[nodiscard]] bool has_battery(const Protocol& protocol);
[[nodiscard]] bool has_pad(const Protocol& protocol);

/// The controls of the pad of a tablet in the table; for a protocol alone (`tablet` null), all that its reports can
/// have.
[[nodiscard]] PadFeatures pad_features(const Protocol& protocol, const Tablet* tablet);

/// The keys and wheels of a vendor's protocol. Keys are numbered as in Linux; the buttons in wheels follow the others.
class VendorPadDecoder final : public PadDecoder {
 public:
  /// `reports` decodes the protocol's reports; it must be a separate decoder from the pen's.
  VendorPadDecoder(std::unique_ptr<PenDecoder> reports, const Protocol& protocol, const Tablet* tablet);

  bool decode(base::Bytes report) override;
  void reset() override;

 private:
  std::unique_ptr<PenDecoder> reports_;
  unsigned first_wheel_button_ = 0;
  PadState last_;
};

}  // namespace penpose::decode
