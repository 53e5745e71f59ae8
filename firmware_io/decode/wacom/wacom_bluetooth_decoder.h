#pragma once

#include "firmware_io/decode/described/frame_list.h"
#include "firmware_io/decode/sample/pen_decoder.h"
#include "firmware_io/decode/wacom/wacom_models.h"
#include "firmware_io/decode/wacom/wacom_tools.h"

namespace penpose::decode {

/// Intuos Pro (2017) and Intuos (2018) over Bluetooth: reports 80 and 81 that hold up to seven or four pen frames and
/// one tool number and serial for all of them. The sample after a report is that of its last frame.
class WacomBluetoothDecoder final : public PenDecoder {
 public:
  explicit WacomBluetoothDecoder(const WacomModel& model);

  ReportKind decode(base::Bytes report) override;
  void reset() override;
  [[nodiscard]] const PenAxes& axes() const override { return axes_; }
  [[nodiscard]] std::span<const PenSample> frames() const override { return frames_.all(); }

 private:
  template <std::size_t frame_size>
  void decode_frames(base::Bytes frames);
  /// False when the frame says that the pen left, after which the report holds nothing more. Its size tells which kind
  /// of tablet it is from.
  template <std::size_t frame_size>
  bool decode_frame(std::span<const std::uint8_t, frame_size> frame);

  PenAxes axes_;
  FrameList frames_;
  bool is_pro_;
  std::int32_t max_distance_;
  WacomTool tool_ = WacomTool::none;
  std::uint32_t tool_number_ = 0;
  std::uint64_t serial_ = 0;
};

}  // namespace penpose::decode
