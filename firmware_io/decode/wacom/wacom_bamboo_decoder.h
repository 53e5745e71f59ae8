#pragma once

#include "firmware_io/decode/sample/pen_decoder.h"
#include "firmware_io/decode/wacom/wacom_models.h"

namespace penpose::decode {

/// Bamboo of 2009 and later and the consumer Intuos of 2013: reports 02 of nine or ten bytes whose bits tell apart a
/// pen that is near, one with a position and one with data. Touch comes in reports of 20 and 64 bytes with the same id.
class WacomBambooDecoder final : public PenDecoder {
 public:
  explicit WacomBambooDecoder(const WacomModel& model);

  ReportKind decode(base::Bytes report) override;
  void reset() override;
  [[nodiscard]] const PenAxes& axes() const override { return axes_; }

 private:
  PenAxes axes_;
  std::int32_t max_distance_;
  Tool tool_ = Tool::none;
  bool reporting_ = false;  ///< a position was seen since the pen came near
};

}  // namespace penpose::decode
