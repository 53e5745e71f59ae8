#pragma once

#include <array>
#include <optional>

#include "firmware_io/decode/layout/pen_layout.h"
#include "firmware_io/decode/sample/pen_decoder.h"

namespace penpose::decode {

/// Lengths of the reports that a descriptor gives to a mouse, a keyboard, media keys or the keys of the tablet, by
/// report id; 0 elsewhere.
using ForeignReports = std::array<std::uint32_t, 256>;
[[nodiscard]] ForeignReports find_foreign_reports(const hid::ReportDescriptor& descriptor);

/// A tablet with a vendor protocol that its descriptor does not mention, in addition to described reports. A report
/// with the id and exact length of a described pen goes to the first decoder (if there is one), one of a described
/// mouse, keyboard or pad to none, every other to the vendor's.
class FallbackDecoder final : public PenDecoder {
 public:
  FallbackDecoder(const hid::ReportDescriptor& descriptor, std::optional<PenLayout> layout,
                  std::unique_ptr<PenDecoder> described, std::unique_ptr<PenDecoder> vendor);

  ReportKind decode(base::Bytes report) override;
  void reset() override;
  /// Those of the decoder that gave the last pen sample; until there is one, the vendor's.
  [[nodiscard]] const PenAxes& axes() const override { return used_->axes(); }
  [[nodiscard]] std::span<const PenSample> frames() const override { return used_->frames(); }

 private:
  [[nodiscard]] bool is_foreign(base::Bytes report) const;

  bool has_report_ids_;
  ForeignReports foreign_;
  std::optional<PenLayout> layout_;
  std::unique_ptr<PenDecoder> described_;  ///< null when the descriptor has no pen
  std::unique_ptr<PenDecoder> vendor_;
  PenDecoder* used_ = nullptr;
};

}  // namespace penpose::decode
