#include "firmware_io/decode/sample/report_bytes.h"
#include "firmware_io/decode/wacom/wacom_axes.h"
#include "firmware_io/decode/wacom/wacom_pens.h"

namespace penpose::decode {
namespace {

class WacomBambooDecoder final : public PenDecoder {
 public:
  explicit WacomBambooDecoder(const WacomModel& model) : axes_(wacom_axes(model)), max_distance_(model.max_distance) {}

  ReportKind decode(base::Bytes report) override;
  void reset() override {
    sample_ = {};
    tool_ = Tool::none;
    reporting_ = false;
  }
  [[nodiscard]] const PenAxes& axes() const override { return axes_; }

 private:
  PenAxes axes_;
  std::int32_t max_distance_;
  Tool tool_ = Tool::none;
  bool reporting_ = false;  ///< a position was seen since the pen came near
};

ReportKind WacomBambooDecoder::decode(base::Bytes report) {
  if (report.size() < 9 || report.size() > 10 || report[0] != 0x02) return ReportKind::ignored;
  const bool near = bit(report, 1, 0x80);
  const bool has_position = bit(report, 1, 0x40);
  const bool has_data = bit(report, 1, 0x20);
  if (has_position) {
    tool_ = bit(report, 1, 0x08) ? Tool::eraser : Tool::pen;
    reporting_ = true;
  }
  if (!reporting_) return ReportKind::ignored;
  sample_.tip = has_data && bit(report, 1, 0x01);
  sample_.buttons = has_data ? (report[1] >> 1) & 3 : 0;
  sample_.pressure = has_data ? le16(report, 6) : 0;
  if (has_position || !near) {
    sample_.x = has_position ? le16(report, 2) : 0;
    sample_.y = has_position ? le16(report, 4) : 0;
  }
  // The device counts closeness, beyond the axis while it is pressed down.
  sample_.distance = near && report[8] <= max_distance_ ? max_distance_ - report[8] : 0;
  sample_.in_range = near;
  sample_.tool = near ? tool_ : Tool::none;
  sample_.tool_id = !near ? 0 : tool_ == Tool::eraser ? 0x0a : 0x02;
  if (!near) reporting_ = false;
  return ReportKind::pen;
}

}  // namespace

std::unique_ptr<PenDecoder> make_wacom_bamboo(const WacomModel& model) {
  return std::make_unique<WacomBambooDecoder>(model);
}

}  // namespace penpose::decode
