#pragma once

#include <array>

#include "firmware_io/decode/described/frame_list.h"
#include "firmware_io/decode/layout/pen_layout.h"
#include "firmware_io/decode/sample/pen_decoder.h"
#include "firmware_io/decode/wacom/wacom_tools.h"

namespace penpose::decode {

/// Wacom tablets that describe their reports, with the Digitizer page or with Wacom's mirror of it: Intuos Pro (2017),
/// Intuos (2018), MobileStudio, One, Cintiq Pro, and the sensors built into notebooks.
///
/// Differs from the standard reading: axes count only while the pen is in range, Sense keeps a pen near that is too far
/// for a position, the tool is determined once on entering (by Invert or by its number), both barrel switches at once
/// may be the third button, values outside of the logical range are ignored, and a report may hold several frames.
class WacomGenericDecoder final : public PenDecoder {
 public:
  explicit WacomGenericDecoder(PenLayout layout);

  ReportKind decode(base::Bytes report) override;
  void reset() override;
  [[nodiscard]] const PenAxes& axes() const override { return layout_.axes; }
  [[nodiscard]] std::span<const PenSample> frames() const override { return frames_.all(); }

 private:
  /// Frames held back while the pen is near but not yet identified.
  static constexpr unsigned k_longest_wait = 64;

  [[nodiscard]] bool waits_for_serial(const PenReport& report, base::Bytes raw);
  /// The tool's number with what a report adds to it, which comes behind the rotation.
  [[nodiscard]] std::uint32_t identified(const PenReport& report, base::Bytes raw) const;
  void apply(const PenReport& report, const PenControl& control, std::int64_t value);
  void end_frame(const PenReport& report);
  void set_axis(std::int32_t& axis, std::int64_t value);

  PenLayout layout_;
  WacomTool tool_ = WacomTool::none;
  std::uint32_t tool_number_ = 0;
  std::uint64_t serial_ = 0;
  unsigned waited_ = 0;
  bool in_range_ = false;
  bool sensed_ = false;
  bool turned_ = false;  ///< eraser end
  bool tip_ = false;
  std::array<bool, 3> barrels_{};
  bool rotates_ = false;  ///< an art pen
  bool invalid_frame_ = false;
  bool was_sensed_ = false;
  FrameList frames_;
};

}  // namespace penpose::decode
