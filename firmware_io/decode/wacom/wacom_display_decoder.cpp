#include "firmware_io/decode/wacom/wacom_display_decoder.h"

#include "firmware_io/decode/sample/report_bytes.h"
#include "firmware_io/decode/wacom/wacom_axes.h"

namespace penpose::decode {

WacomDisplayDecoder::WacomDisplayDecoder(const WacomModel& model) : WacomDisplayDecoder(model, wacom_axes(model)) {}

WacomDisplayDecoder::WacomDisplayDecoder(const WacomModel& model, const PenAxes& axes)
    : family_(model.family), max_pressure_(axes.pressure.maximum), axes_(axes) {}

void WacomDisplayDecoder::reset() {
  sample_ = {};
  tool_ = Tool::none;
  inside_ = false;
}

ReportKind WacomDisplayDecoder::decode(base::Bytes report) {
  if (report.size() < 7) return ReportKind::ignored;
  if (family_ == WacomFamily::dtus) return decode_dtus(report);
  if (report.size() < 8) return ReportKind::ignored;
  if (family_ == WacomFamily::pl) return decode_pl(report);
  if (family_ == WacomFamily::ptu) return decode_ptu(report);
  return family_ == WacomFamily::dtu ? decode_dtu(report) : decode_tablet_pc(report);
}

ReportKind WacomDisplayDecoder::finish(bool near) {
  const bool was_in_range = sample_.in_range;
  const bool known = near && tool_ != Tool::none;
  sample_.in_range = known;
  sample_.tool = known ? tool_ : Tool::none;
  sample_.tool_id = !known ? 0 : tool_ == Tool::eraser ? 0x0a : 0x02;
  return known || was_in_range ? ReportKind::pen : ReportKind::ignored;
}

/// The second barrel button and the eraser share a bit: set on entering it is the eraser, later the button. An eraser
/// always has it set, so one that loses it was a pen with its button down.
ReportKind WacomDisplayDecoder::decode_pl(base::Bytes report) {
  if (report[0] != 0x02) return ReportKind::ignored;
  const bool near = bit(report, 1, 0x40);
  const bool shared_bit = bit(report, 4, 0x20);
  if (!inside_) tool_ = shared_bit ? Tool::eraser : Tool::pen;
  if (!shared_bit) tool_ = Tool::pen;
  inside_ = near;
  if (near) {
    const auto high = static_cast<std::int8_t>(static_cast<std::uint8_t>((report[7] << 1) | ((report[4] >> 2) & 1)));
    std::int32_t pressure = high;
    if (max_pressure_ > 255) pressure = pressure * 2 + ((report[4] >> 6) & 1);
    sample_.pressure = pressure + (max_pressure_ + 1) / 2;
    sample_.x = report[3] | (report[2] << 7) | ((report[1] & 0x03) << 14);
    sample_.y = report[6] | (report[5] << 7) | ((report[4] & 0x03) << 14);
    sample_.tip = bit(report, 4, 0x08);
    sample_.buttons = (bit(report, 4, 0x10) ? 1u : 0u) | (shared_bit && tool_ == Tool::pen ? 2u : 0u);
  }
  return finish(near);
}

ReportKind WacomDisplayDecoder::decode_ptu(base::Bytes report) {
  if (report[0] != 0x02) return ReportKind::ignored;
  tool_ = bit(report, 1, 0x04) ? Tool::eraser : Tool::pen;
  sample_.tip = bit(report, 1, tool_ == Tool::eraser ? 0x08 : 0x01);
  sample_.x = le16(report, 2);
  sample_.y = le16(report, 4);
  sample_.pressure = le16(report, 6);
  sample_.buttons = (bit(report, 1, 0x02) ? 1u : 0u) | (bit(report, 1, 0x10) ? 2u : 0u);
  return finish(bit(report, 1, 0x20));
}

void WacomDisplayDecoder::read_state(base::Bytes report, std::uint8_t high_pressure) {
  sample_.x = le16(report, 2);
  sample_.y = le16(report, 4);
  sample_.pressure = report[6] | ((report[7] & high_pressure) << 8);
  sample_.tip = (report[1] & 0x05) != 0;
  sample_.buttons = (bit(report, 1, 0x02) ? 1u : 0u) | (bit(report, 1, 0x10) ? 2u : 0u);
}

ReportKind WacomDisplayDecoder::decode_dtu(base::Bytes report) {
  const bool near = bit(report, 1, 0x20);
  if (near) tool_ = (report[1] & 0x0c) != 0 ? Tool::eraser : Tool::pen;
  read_state(report, 0x01);
  return finish(near);
}

ReportKind WacomDisplayDecoder::decode_dtus(base::Bytes report) {
  constexpr std::uint8_t k_pen_report = 0x11;
  /// Contact is judged by pressure.
  constexpr std::int32_t k_contact_threshold = 10;
  if (report[0] != k_pen_report) return ReportKind::ignored;
  const bool near = bit(report, 1, 0x80);
  if (near) {
    const int kind = (report[1] >> 3) & 3;
    if (kind == 1) tool_ = Tool::eraser;
    if (kind == 2) tool_ = Tool::pen;
  }
  sample_.x = be16(report, 3);
  sample_.y = be16(report, 5);
  sample_.pressure = ((report[1] & 0x03) << 8) | report[2];
  sample_.tip = sample_.pressure > k_contact_threshold;
  sample_.buttons = (bit(report, 1, 0x20) ? 1u : 0u) | (bit(report, 1, 0x40) ? 2u : 0u);
  return finish(near);
}

/// The report that brings the pen near determines its tool until it leaves.
ReportKind WacomDisplayDecoder::decode_tablet_pc(base::Bytes report) {
  if (report[0] != 0x02 && report.size() != 8) return ReportKind::ignored;
  if (!inside_) tool_ = (report[1] & 0x0c) != 0 ? Tool::eraser : Tool::pen;
  inside_ = bit(report, 1, 0x20);
  read_state(report, 0x07);
  return finish(inside_);
}

}  // namespace penpose::decode
