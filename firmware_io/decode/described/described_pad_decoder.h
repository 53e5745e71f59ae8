#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "firmware_io/decode/described/battery_decoder.h"
#include "firmware_io/decode/described/described_pad.h"
#include "firmware_io/decode/sample/pad_decoder.h"

namespace penpose::decode {

/// The keys, rings, strips and wheels of a pad that describes itself, as Linux reads them (6.1, hid-input.c).
///
/// Of a tablet in the table it has as many keys as the table says, where the descriptor has room for more. Reports that
/// fit no described one go to the decoder of the vendor's protocol.
class DescribedPadDecoder final : public PadDecoder {
 public:
  /// `vendor` may be null. `keys`: how many the tablet has; 0: unknown.
  DescribedPadDecoder(DescribedPad pad, const std::optional<BatteryLayout>& battery, std::unique_ptr<PadDecoder> vendor,
                      unsigned keys);

  bool decode(base::Bytes report) override;
  void reset() override;

 private:
  bool decode_vendor(base::Bytes report);
  void apply(const DescribedPadControl& control, std::int64_t value);

  DescribedPad pad_;
  std::vector<std::int64_t> last_;  ///< of the controls: what does not change says nothing
  std::optional<BatteryLayout> charge_;
  std::unique_ptr<PadDecoder> vendor_;
};

}  // namespace penpose::decode
