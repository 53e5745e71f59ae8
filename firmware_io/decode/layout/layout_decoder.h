#pragma once

#include <memory>

#include "firmware_io/decode/layout/layout.h"
#include "firmware_io/decode/sample/pen_decoder.h"

namespace penpose::decode {

/// Decodes the reports of one protocol by its layouts. Axes that no layout of the protocol has are not present.
class LayoutDecoder final : public PenDecoder {
 public:
  /// `axes` gives ranges and resolutions where known; the protocol determines which axes are present.
  explicit LayoutDecoder(std::shared_ptr<const Protocol> protocol, const PenAxes& axes = {});

  ReportKind decode(base::Bytes report) override;
  void reset() override;
  [[nodiscard]] const PenAxes& axes() const override { return axes_; }
  [[nodiscard]] bool by_table() const override { return true; }

 private:
  /// State that one report leaves for later ones.
  struct Memory {
    std::int32_t pressure = 0, tilt_x = 0, tilt_y = 0;
    std::uint32_t buttons = 0;
    std::uint32_t tool_id = 0;
    std::uint64_t serial = 0;
    bool tool_is_eraser = false;
    bool was_out = true;
    bool entered_as_eraser = false;
  };

  [[nodiscard]] const std::vector<Protocol::Rule>& rules_for(base::Bytes report);
  ReportKind apply(const Layout& layout, base::Bytes report);
  void apply_pen(const Layout& layout, base::Bytes report);
  void apply_mouse(const Layout& layout, base::Bytes report);
  void apply_position(const Layout& layout, base::Bytes report);
  void apply_pad(const Layout& layout, base::Bytes report);
  bool apply_touch_pad(base::Bytes report);
  void leave();

  std::shared_ptr<const Protocol> protocol_;
  PenAxes axes_;
  Memory memory_;
  const Protocol::Variant* told_ = nullptr;  ///< by reports so far
};

}  // namespace penpose::decode
