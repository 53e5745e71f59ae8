#include "firmware_io/decode/described/frame_list.h"
#include "firmware_io/decode/sample/report_bytes.h"
#include "firmware_io/decode/wacom/wacom_axes.h"
#include "firmware_io/decode/wacom/wacom_pens.h"
#include "firmware_io/decode/wacom/wacom_tools.h"

namespace penpose::decode {
namespace {

struct FrameLayout {
  std::size_t count;
  std::size_t size;
  std::size_t serial_at;
  std::size_t tool_at;
};
constexpr FrameLayout k_pro{7, 14, 99, 107};
constexpr FrameLayout k_small{4, 8, 33, 41};

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

WacomBluetoothDecoder::WacomBluetoothDecoder(const WacomModel& model)
    : axes_(wacom_axes(model)),
      is_pro_(model.family == WacomFamily::intuos_pro_bluetooth),
      max_distance_(model.max_distance) {
  if (is_pro_) {
    add_wacom_tilt(axes_);
    add_wacom_rotation_and_wheel(axes_, true);
  }
}

void WacomBluetoothDecoder::reset() {
  sample_ = {};
  frames_.clear();
  tool_ = WacomTool::none;
  tool_number_ = 0;
  serial_ = 0;
}

template <std::size_t frame_size>
void WacomBluetoothDecoder::decode_frames(base::Bytes frames) {
  for (; frames.size() >= frame_size; frames = frames.subspan(frame_size)) {
    const auto frame = frames.first<frame_size>();
    if (bit(frame, 0, 0x80) && !decode_frame<frame_size>(frame)) break;
  }
}

template <std::size_t frame_size>
bool WacomBluetoothDecoder::decode_frame(std::span<const std::uint8_t, frame_size> frame) {
  constexpr bool is_pro = frame_size == k_pro.size;
  const bool near = bit(frame, 0, 0x40);
  const bool has_position = bit(frame, 0, 0x20);
  const bool turned = bit(frame, 0, 0x10);
  if (!near) {
    const bool was_in_range = sample_.in_range;
    sample_ = {};
    tool_ = WacomTool::none;
    if (was_in_range) frames_.add(sample_);
    return false;
  }
  if (has_position) {
    if (tool_ == WacomTool::none) {
      tool_ = turned ? WacomTool::eraser : tool_number_ != 0 ? wacom_tool(tool_number_) : WacomTool::pen;
    }
    sample_.x = le16(frame, 1);
    sample_.y = le16(frame, 3);
    if constexpr (is_pro) {
      sample_.tilt_x = s8(frame, 7);
      sample_.tilt_y = s8(frame, 8);
      // The device counts from the top of the barrel, the older tablets from its left.
      const std::int32_t rotation = static_cast<std::int16_t>(le16(frame, 9)) + 450;
      sample_.rotation = rotation > 899 ? rotation - 1800 : rotation;
      sample_.wheel = le16(frame, 11);
    }
  }
  if (tool_ == WacomTool::none) return true;
  sample_.pressure = le16(frame, 5);
  sample_.distance = has_position ? frame[is_pro ? 13 : 7] : max_distance_;
  sample_.tip = (frame[0] & 0x09) != 0;
  sample_.buttons = (frame[0] >> 1) & 3;
  sample_.in_range = true;
  sample_.tool = tool_of(tool_);
  sample_.tool_id = wacom_tool_id(tool_number_);
  sample_.serial = serial_;
  frames_.add(sample_);
  return true;
}

ReportKind WacomBluetoothDecoder::decode(base::Bytes report) {
  const FrameLayout& layout = is_pro_ ? k_pro : k_small;
  if (report.size() < layout.tool_at + 2 || (report[0] != 0x80 && report[0] != 0x81)) return ReportKind::ignored;
  serial_ = le64(report, layout.serial_at);
  tool_number_ = static_cast<std::uint32_t>(le16(report, layout.tool_at));
  // Electromagnetic pens keep the part of the tool number that does not fit its own field in the serial's upper half.
  if (serial_ >> 52 == 1) tool_number_ |= static_cast<std::uint32_t>(serial_ >> 32) & 0xfffff;
  frames_.clear();
  const base::Bytes frames = report.subspan(1, layout.count * layout.size);
  if (is_pro_) {
    decode_frames<k_pro.size>(frames);
  } else {
    decode_frames<k_small.size>(frames);
  }
  return frames_.empty() ? ReportKind::ignored : ReportKind::pen;
}

}  // namespace

std::unique_ptr<PenDecoder> make_wacom_bluetooth(const WacomModel& model) {
  return std::make_unique<WacomBluetoothDecoder>(model);
}

}  // namespace penpose::decode
