#pragma once

#include "firmware_io/decode/pen_decoder.h"
#include "firmware_io/decode/pen_layout.h"

namespace penpose::decode {

/// A tablet that describes a pen but may have been switched to its vendor's reports, which no descriptor mentions: each
/// report that a pen is described for, with just that length, goes to the first decoder, every other to the second.
class FallbackDecoder final : public PenDecoder {
 public:
  FallbackDecoder(PenLayout layout, std::unique_ptr<PenDecoder> described, std::unique_ptr<PenDecoder> vendor);

  ReportKind decode(base::Bytes report) override;
  void reset() override;
  /// Those of the decoder that gave the last pen sample; until there is one, the vendor's.
  [[nodiscard]] const PenAxes& axes() const override { return used_->axes(); }
  [[nodiscard]] std::span<const PenSample> frames() const override { return used_->frames(); }

 private:
  PenLayout layout_;
  std::unique_ptr<PenDecoder> described_;
  std::unique_ptr<PenDecoder> vendor_;
  PenDecoder* used_ = nullptr;
};

}  // namespace penpose::decode
