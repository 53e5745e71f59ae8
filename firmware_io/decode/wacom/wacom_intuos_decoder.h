#pragma once

#include <array>

#include "firmware_io/decode/described/frame_list.h"
#include "firmware_io/decode/sample/pen_decoder.h"
#include "firmware_io/decode/wacom/wacom_models.h"
#include "firmware_io/decode/wacom/wacom_tools.h"

namespace penpose::decode {

/// Intuos, Cintiq and DTK reports of ten bytes: big-endian positions, a tool that is identified by number and serial
/// in a separate report when it enters, and pen, rotation, airbrush and mouse data in alternating reports.
///
/// Nothing is reported for a tool without an enter report. An "in range" report has no position; it ends contact of the
/// tool before it.
class WacomIntuosDecoder final : public PenDecoder {
 public:
  explicit WacomIntuosDecoder(const WacomModel& model);

  ReportKind decode(base::Bytes report) override;
  void reset() override;
  [[nodiscard]] const PenAxes& axes() const override { return axes_; }
  [[nodiscard]] std::span<const PenSample> frames() const override {
    return bluetooth_ ? frames_.all() : PenDecoder::frames();
  }

 private:
  struct ToolState {
    WacomTool kind = WacomTool::none;
    std::uint32_t number = 0;
    std::uint64_t serial = 0;
  };

  ReportKind decode_one(base::Bytes report);
  ReportKind decode_bluetooth(base::Bytes report);
  void enter(base::Bytes report, ToolState& tool);
  ReportKind leave(ToolState& tool);
  [[nodiscard]] bool is_refused(base::Bytes report, const ToolState& tool) const;
  ReportKind decode_data(base::Bytes report, const ToolState& tool);
  void set_pen(base::Bytes report);
  void set_tilt(base::Bytes report);
  void set_rotation(base::Bytes report);
  void set_mouse(base::Bytes report, unsigned function, WacomTool kind);

  WacomModel model_;
  PenAxes axes_;
  FrameList frames_;  ///< of the Bluetooth model
  std::array<ToolState, 2> tools_;
  bool reporting_ = false;

  // Differences between the models.
  bool two_tools_ = false;
  bool fine_ = true;  ///< one more bit of position
  bool has_tilt_ = true;
  bool distance_down_ = false;
  bool needs_ready_bit_ = false;
  bool needs_new_pen_ = false;
  bool has_lens_ = true;
  bool has_side_buttons_ = false;
  bool has_touch_reports_ = false;
  bool bluetooth_ = false;
};

}  // namespace penpose::decode
