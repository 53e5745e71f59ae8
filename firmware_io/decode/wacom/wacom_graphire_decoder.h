#pragma once

#include "firmware_io/decode/sample/pen_decoder.h"
#include "firmware_io/decode/wacom/wacom_models.h"

namespace penpose::decode {

/// Graphire, Volito, PenStation2 and the first Bamboos: little-endian reports of eight or nine bytes in which bits 5
/// and 6 of byte 1 tell pen, eraser and mouse apart.
class WacomGraphireDecoder final : public PenDecoder {
 public:
  explicit WacomGraphireDecoder(const WacomModel& model);

  ReportKind decode(base::Bytes report) override;
  void reset() override;
  [[nodiscard]] const PenAxes& axes() const override { return axes_; }

 private:
  void set_tool(base::Bytes report);

  WacomFamily family_;
  PenAxes axes_;
  Tool tool_ = Tool::none;  ///< the last tool, kept for the report that says that it left
};

/// PenPartner: report 1 with proximity, report 2 (of the serial tablet's successors and emulated ones) always near.
class WacomPenPartnerDecoder final : public PenDecoder {
 public:
  explicit WacomPenPartnerDecoder(const WacomModel& model);

  ReportKind decode(base::Bytes report) override;
  void reset() override { sample_ = {}; }
  [[nodiscard]] const PenAxes& axes() const override { return axes_; }

 private:
  PenAxes axes_;
};

}  // namespace penpose::decode
