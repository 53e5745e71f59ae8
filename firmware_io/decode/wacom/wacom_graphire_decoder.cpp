#include <algorithm>

#include "firmware_io/decode/sample/report_bytes.h"
#include "firmware_io/decode/wacom/wacom_axes.h"
#include "firmware_io/decode/wacom/wacom_pens.h"

namespace penpose::decode {
namespace {

// Tool numbers as Linux prints them for tools without one of their own.
constexpr std::uint32_t k_pen_id = 0x02;
constexpr std::uint32_t k_mouse_id = 0x06;
constexpr std::uint32_t k_eraser_id = 0x0a;

class WacomGraphireDecoder final : public PenDecoder {
 public:
  explicit WacomGraphireDecoder(const WacomModel& model) : family_(model.family), axes_(wacom_axes(model)) {}

  ReportKind decode(base::Bytes report) override;
  void reset() override {
    sample_ = {};
    tool_ = Tool::none;
  }
  [[nodiscard]] const PenAxes& axes() const override { return axes_; }

 private:
  void set_tool(base::Bytes report);

  WacomFamily family_;
  PenAxes axes_;
  Tool tool_ = Tool::none;  ///< the last tool, kept for the report that says that it left
};

class WacomPenPartnerDecoder final : public PenDecoder {
 public:
  explicit WacomPenPartnerDecoder(const WacomModel& model);

  ReportKind decode(base::Bytes report) override;
  void reset() override { sample_ = {}; }
  [[nodiscard]] const PenAxes& axes() const override { return axes_; }

 private:
  PenAxes axes_;
};

void WacomGraphireDecoder::set_tool(base::Bytes report) {
  switch ((report[1] >> 5) & 3) {
    case 0:
      tool_ = Tool::pen;
      sample_.tool_id = k_pen_id;
      break;
    case 1:
      tool_ = Tool::eraser;
      sample_.tool_id = k_eraser_id;
      break;
    default:
      tool_ = Tool::mouse;
      sample_.tool_id = k_mouse_id;
      break;
  }
}

ReportKind WacomGraphireDecoder::decode(base::Bytes report) {
  const bool bluetooth = family_ == WacomFamily::graphire_bluetooth;
  const std::size_t size = family_ == WacomFamily::bamboo_first ? 9 : 8;
  if (report.size() < size || report[0] != (bluetooth ? 0x03 : 0x02)) return ReportKind::ignored;

  const bool near = bit(report, 1, 0x80);
  if (!near && !sample_.in_range) return ReportKind::ignored;
  if (near) set_tool(report);
  sample_.x = le16(report, 2);
  sample_.y = le16(report, 4);
  if (tool_ == Tool::mouse) {
    const bool middle = (report[1] & 0x60) == 0x40 && bit(report, 1, 0x04);
    sample_.buttons = (report[1] & 3u) | (middle ? 4u : 0u);
    sample_.tip = false;
    if (family_ == WacomFamily::graphire4 || family_ == WacomFamily::bamboo_first) {
      sample_.distance = report[6] & 0x3f;
    } else if (bluetooth) {
      sample_.distance = std::clamp(44 - (report[6] >> 2), 0, 31);
    } else {
      sample_.distance = report[7] & 0x3f;
    }
  } else {
    const std::int32_t high = bluetooth ? (report[1] & 0x08) << 5 : (report[7] & 0x03) << 8;
    sample_.pressure = report[6] | high;
    sample_.tip = bit(report, 1, 0x01);
    sample_.buttons = (report[1] >> 1) & 3;
  }
  sample_.in_range = near;
  sample_.tool = near ? tool_ : Tool::none;
  if (!near) sample_.tool_id = 0;
  return ReportKind::pen;
}

WacomPenPartnerDecoder::WacomPenPartnerDecoder(const WacomModel& model) : axes_(wacom_axes(model)) {}

ReportKind WacomPenPartnerDecoder::decode(base::Bytes report) {
  if (report.size() < 7 || (report[0] != 0x01 && report[0] != 0x02)) return ReportKind::ignored;
  const bool was_in_range = sample_.in_range;
  const std::int32_t pressure = s8(report, 6);
  if (report[0] == 0x01 && !bit(report, 5, 0x80)) {
    sample_ = {};
    return was_in_range ? ReportKind::pen : ReportKind::ignored;
  }
  const bool eraser = report[0] == 0x01 && bit(report, 5, 0x20);
  sample_.in_range = true;
  sample_.tool = eraser ? Tool::eraser : Tool::pen;
  sample_.tool_id = eraser ? k_eraser_id : k_pen_id;
  sample_.x = le16(report, 1);
  sample_.y = le16(report, 3);
  sample_.pressure = pressure + 127;
  sample_.tip = report[0] == 0x01 ? pressure > -127 : pressure > -80 && !bit(report, 5, 0x20);
  sample_.buttons = bit(report, 5, 0x40) ? 1 : 0;
  return ReportKind::pen;
}

}  // namespace

std::unique_ptr<PenDecoder> make_wacom_graphire(const WacomModel& model) {
  return std::make_unique<WacomGraphireDecoder>(model);
}

std::unique_ptr<PenDecoder> make_wacom_penpartner(const WacomModel& model) {
  return std::make_unique<WacomPenPartnerDecoder>(model);
}

}  // namespace penpose::decode
