#include "firmware_io/decode/wacom/wacom_intuos_decoder.h"

#include "firmware_io/decode/sample/report_bytes.h"
#include "firmware_io/decode/wacom/wacom_axes.h"

namespace penpose::decode {
namespace {

constexpr std::size_t k_report_size = 10;
constexpr std::size_t k_touch_report_size = 64;
/// Contact is judged by pressure; the pens rest at a few units.
constexpr std::int32_t k_contact_threshold = 10;
/// Pressure is sent with eleven bits; models of fewer levels ignore the lowest.
constexpr std::int32_t k_full_pressure = 2047;

bool is_pen_id(std::uint8_t id) { return id == 0x02 || id == 0x10; }
bool is_proximity_id(std::uint8_t id) { return id == 0x05 || id == 0x06; }

}  // namespace

WacomIntuosDecoder::WacomIntuosDecoder(const WacomModel& model) : model_(model), axes_(wacom_axes(model)) {
  using F = WacomFamily;
  const F family = model.family;
  two_tools_ = family == F::intuos;
  fine_ = family != F::intuos;
  has_tilt_ = family != F::intuos_2015;
  distance_down_ = family == F::intuos_2015;
  needs_ready_bit_ = family == F::cintiq;
  needs_new_pen_ = family == F::cintiq_21ux2;
  has_lens_ = family != F::intuos3 && family != F::intuos4 && family != F::intuos5;
  has_side_buttons_ = family == F::intuos3 || family == F::intuos3_large;
  has_touch_reports_ = family == F::intuos5 || family == F::intuos5_large || family == F::intuos_2015;
  bluetooth_ = family == F::intuos4_bluetooth;
  if (has_tilt_) {
    add_wacom_tilt(axes_);
    add_wacom_rotation_and_wheel(axes_, fine_);
  }
}

void WacomIntuosDecoder::reset() {
  sample_ = {};
  tools_ = {};
  reporting_ = false;
}

ReportKind WacomIntuosDecoder::decode(base::Bytes report) {
  if (bluetooth_) return decode_bluetooth(report);
  if (has_touch_reports_ && report.size() == k_touch_report_size) return ReportKind::ignored;
  return decode_one(report);
}

/// Report 3 holds two reports of the wired kind, report 4 three, each without loss; the last state is the sample.
ReportKind WacomIntuosDecoder::decode_bluetooth(base::Bytes report) {
  if (report.empty() || (report[0] != 0x03 && report[0] != 0x04)) return ReportKind::ignored;
  const std::size_t count = report[0] == 0x04 ? 3 : 2;
  if (report.size() < 1 + count * k_report_size) return ReportKind::ignored;
  frames_.clear();
  ReportKind kind = ReportKind::ignored;
  for (std::size_t i = 0; i < count; ++i) {
    const ReportKind one = decode_one(report.subspan(1 + i * k_report_size, k_report_size));
    if (one != ReportKind::pen) continue;
    frames_.add(sample_);
    kind = one;
  }
  return kind;
}

ReportKind WacomIntuosDecoder::decode_one(base::Bytes report) {
  if (report.size() < k_report_size) return ReportKind::ignored;
  const std::uint8_t id = report[0];
  if (!is_pen_id(id) && !is_proximity_id(id)) return ReportKind::ignored;

  ToolState& tool = tools_[two_tools_ ? report[1] & 1u : 0u];
  if ((report[1] & 0xfc) == 0xc0) {
    enter(report, tool);
    return ReportKind::ignored;
  }
  if ((report[1] & 0xfe) == 0x20) {
    if (!reporting_) return ReportKind::ignored;
    sample_.tip = false;
    sample_.pressure = 0;
    sample_.distance = model_.max_distance;
    return ReportKind::pen;
  }
  if ((report[1] & 0xfe) == 0x80) return leave(tool);
  if (!is_pen_id(id) || tool.number == 0 || is_refused(report, tool)) return ReportKind::ignored;
  return decode_data(report, tool);
}

void WacomIntuosDecoder::enter(base::Bytes report, ToolState& tool) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(report[i]); };
  tool.serial = ((byte(3) & 0x0f) << 28) | (byte(4) << 20) | (byte(5) << 12) | (byte(6) << 4) | (byte(7) >> 4);
  tool.number = (byte(2) << 4) | (byte(3) >> 4) | ((byte(7) & 0x0f) << 16) | ((byte(8) & 0xf0) << 8);
  tool.kind = wacom_tool(tool.number);
}

ReportKind WacomIntuosDecoder::leave(ToolState& tool) {
  reporting_ = false;
  if (tool.number == 0) return ReportKind::ignored;
  tool.number = 0;
  const std::uint64_t serial = tool.serial;
  sample_ = {};
  sample_.serial = serial;
  return ReportKind::pen;
}

bool WacomIntuosDecoder::is_refused(base::Bytes report, const ToolState& tool) const {
  const bool old_pen = needs_new_pen_ && (tool.number & 0x10000) == 0;
  const bool foreign_lens = !has_lens_ && tool.kind == WacomTool::lens;
  const bool not_ready = needs_ready_bit_ && (report[1] & 0x40) == 0;
  return old_pen || foreign_lens || not_ready;
}

ReportKind WacomIntuosDecoder::decode_data(base::Bytes report, const ToolState& tool) {
  const std::int32_t low = report[9];
  if (fine_) {
    sample_.x = (be16(report, 2) << 1) | ((low >> 1) & 1);
    sample_.y = (be16(report, 4) << 1) | (low & 1);
    sample_.distance = low >> 2;
  } else {
    sample_.x = be16(report, 2);
    sample_.y = be16(report, 4);
    sample_.distance = low >> 3;
  }
  if (distance_down_) sample_.distance = model_.max_distance - sample_.distance;

  const unsigned function = (report[1] >> 1) & 0x0f;
  switch (function) {
    case 0x0:
    case 0x1:
    case 0x2:
    case 0x3:
      set_pen(report);
      break;
    case 0x4:
    case 0x6:
    case 0x8:
      set_mouse(report, function, tool.kind);
      break;
    case 0x5:
      set_rotation(report);
      break;
    case 0xa:
      sample_.wheel = (report[6] << 2) | (report[7] >> 6);
      set_tilt(report);
      break;
    default:
      break;
  }
  sample_.in_range = true;
  sample_.tool = tool_of(tool.kind);
  sample_.tool_id = wacom_tool_id(tool.number);
  sample_.serial = tool.serial;
  reporting_ = true;
  return ReportKind::pen;
}

void WacomIntuosDecoder::set_pen(base::Bytes report) {
  const std::int32_t raw = (report[6] << 3) | ((report[7] & 0xc0) >> 5) | (report[1] & 1);
  sample_.pressure = model_.max_pressure < k_full_pressure ? raw >> 1 : raw;
  sample_.tip = sample_.pressure > k_contact_threshold;
  sample_.buttons = (report[1] >> 1) & 3;
  if (has_tilt_) set_tilt(report);
}

void WacomIntuosDecoder::set_tilt(base::Bytes report) {
  sample_.tilt_x = (((report[7] << 1) & 0x7e) | (report[8] >> 7)) - 64;
  sample_.tilt_y = (report[8] & 0x7f) - 64;
}

/// Half units of 0.2 degrees from the top of the barrel; the art pen's zero lies a quarter turn away. The 4D mouse of
/// the first two generations sends the same packet, with the sign in bit 5.
void WacomIntuosDecoder::set_rotation(base::Bytes report) {
  const std::int32_t raw = (report[6] << 3) | (report[7] >> 5);
  const bool second_half = (report[7] & 0x20) != 0;
  if (!fine_) {
    sample_.rotation = second_half ? (raw - 1) / 2 : -(raw / 2);
  } else if (!second_half) {
    sample_.rotation = 450 - raw / 2;
  } else {
    sample_.rotation = (raw - 1) / 2 + (raw > 900 ? -1350 : 450);
  }
}

void WacomIntuosDecoder::set_mouse(base::Bytes report, unsigned function, WacomTool kind) {
  // Bits of left, right, middle, side and extra button in `from`.
  const auto buttons = [](std::uint8_t from, std::array<std::uint8_t, 5> masks) {
    std::uint32_t result = 0;
    for (std::size_t i = 0; i < masks.size(); ++i) {
      if ((from & masks[i]) != 0) result |= 1u << i;
    }
    return result;
  };
  if (function == 0x4) {
    sample_.buttons = buttons(report[8], {0x01, 0x04, 0x02, 0x20, 0x10});
    const std::int32_t throttle = (report[6] << 2) | (report[7] >> 6);
    sample_.wheel = (report[8] & 0x08) != 0 ? -throttle : throttle;
  } else if (function == 0x6) {
    sample_.buttons = buttons(report[6], {0x01, 0x04, 0x02, 0x08, 0x10});
    set_tilt(report);
  } else if (kind == WacomTool::mouse) {
    const std::uint8_t side = has_side_buttons_ ? 0x40 : 0;
    const std::uint8_t extra = has_side_buttons_ ? 0x20 : 0;
    sample_.buttons = buttons(report[8], {0x04, 0x10, 0x08, side, extra});
  } else if (kind == WacomTool::lens) {
    sample_.buttons = buttons(report[8], {0x01, 0x04, 0x02, 0x10, 0x08});
  }
}

}  // namespace penpose::decode
