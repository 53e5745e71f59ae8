#pragma once

#include "firmware_io/decode/sample/pen_decoder.h"
#include "firmware_io/decode/wacom/wacom_models.h"

namespace penpose::decode {

/// The pens of Wacom's office displays (PL, Cintiq Partner, DTU, DTU-S) and of tablet PCs (ISDv4): one small report
/// with a fixed layout for each state, without tilt.
class WacomDisplayDecoder final : public PenDecoder {
 public:
  explicit WacomDisplayDecoder(const WacomModel& model);
  /// The same with axes from the interface's descriptor.
  WacomDisplayDecoder(const WacomModel& model, const PenAxes& axes);

  ReportKind decode(base::Bytes report) override;
  void reset() override;
  [[nodiscard]] const PenAxes& axes() const override { return axes_; }

 private:
  ReportKind decode_pl(base::Bytes report);
  ReportKind decode_ptu(base::Bytes report);
  ReportKind decode_dtu(base::Bytes report);
  ReportKind decode_dtus(base::Bytes report);
  ReportKind decode_tablet_pc(base::Bytes report);
  /// Reads what DTU and tablet PC reports share; `high_pressure`: mask of the pressure bits in byte 7.
  void read_state(base::Bytes report, std::uint8_t high_pressure);
  /// Sets tool and proximity; a repeated report that nothing is near is not a pen report.
  ReportKind finish(bool near);

  WacomFamily family_;
  std::int32_t max_pressure_;
  PenAxes axes_;
  Tool tool_ = Tool::none;
  bool inside_ = false;  ///< near since the tool was determined
};

}  // namespace penpose::decode
