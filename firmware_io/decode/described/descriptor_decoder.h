#pragma once

#include "firmware_io/decode/layout/pen_layout.h"
#include "firmware_io/decode/sample/pen_decoder.h"

namespace penpose::decode {

/// Pens that describe themselves with the Digitizer page (Windows Ink tablets, N-trig, USI and AES pens).
///
/// A pen reports its two ends with In Range, Invert and Eraser; this follows Linux's hid-input where devices deviate
/// from the usage tables: Eraser alone makes the tool an eraser, and the tip switch counts for the pen end only. Values
/// outside of their logical range are left out where the field has a null state and clamped where it has none.
class DescriptorDecoder final : public PenDecoder {
 public:
  explicit DescriptorDecoder(PenLayout layout);

  ReportKind decode(base::Bytes report) override;
  void reset() override;
  [[nodiscard]] const PenAxes& axes() const override { return layout_.axes; }

 private:
  struct Proximity {
    Tool tool = Tool::none;
    bool active = false;   ///< some control of the report so far indicates a tool
    bool erasing = false;  ///< Eraser was on in the last report
  };

  void apply(const PenReport& report, const PenControl& control, std::int64_t value, Proximity& proximity);
  void release(Tool tool, Proximity& proximity);
  void take(Tool tool, Proximity& proximity);
  void press(unsigned button, bool down);

  PenLayout layout_;
  std::vector<Proximity> proximity_;  ///< one for each report of the layout
};

}  // namespace penpose::decode
