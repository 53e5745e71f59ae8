#include "firmware_io/decode/wacom/hand/wacom_touch_decoder.h"

#include <algorithm>

#include "firmware_io/decode/sample/report_bytes.h"

namespace penpose::decode {
namespace {

using Touch = WacomTouch;

constexpr std::size_t k_two_fingers = 20;
constexpr std::size_t k_finger_report = 64;

}  // namespace

WacomTouchDecoder::WacomTouchDecoder(WacomTouch format, const TouchAxes& axes, bool coarse)
    : TouchDecoder(axes), format_(format), coarse_(coarse) {}

void WacomTouchDecoder::reset() {
  TouchDecoder::reset();
  left_ = 0;
}

bool WacomTouchDecoder::finish() {
  slots_.publish();
  return true;
}

bool WacomTouchDecoder::decode(base::Bytes report) {
  if (report.empty()) return false;
  switch (format_) {
    case Touch::none:
      return false;
    case Touch::bamboo:
      if (report.size() == k_two_fingers) return decode_two(report);
      return report.size() == k_finger_report && decode_messages(report);
    case Touch::intuos:
      return report.size() == k_finger_report && decode_messages(report);
    case Touch::display:
    case Touch::display_27qhd:
      return decode_display(report);
    case Touch::tablet_pc:
    case Touch::tablet_pc_many:
    case Touch::tablet_pc_many_bare:
      return decode_tablet_pc(report);
    case Touch::bamboo_pad:
      return decode_bamboo_pad(report);
    case Touch::intuos_pro_bluetooth:
      return decode_pro_bluetooth(report);
  }
  return false;
}

bool WacomTouchDecoder::decode_two(base::Bytes report) {
  if (report[0] != 0x02 || slots_.size() < 2) return false;
  const std::size_t size = bit(report, 1, 0x80) ? 8 : 9;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t at = size * i + 3;
    const bool touches = bit(report, at, 0x80);
    slots_.set(i, touches);
    if (!touches) continue;
    const int shift = coarse_ ? 5 : 0;
    slots_.move(i, (be16(report, at) & 0x7ff) << shift, (be16(report, at + 2) & 0x7ff) << shift);
  }
  slots_.end_frame();
  return finish();
}

/// Messages of eight bytes, of which those with a number from 2 to 17 are fingers. A finger that did not change has
/// none.
bool WacomTouchDecoder::decode_messages(base::Bytes report) {
  if (report[0] != 0x02) return false;
  bool touched = false;
  const std::size_t count = report[1] & 0x07U;
  for (std::size_t i = 0; i < count; ++i) {
    const base::Bytes message = report.subspan(2 + 8 * i, 8);
    if (message[0] < 2 || message[0] > 17) continue;
    touched = true;
    const auto slot = slots_.slot_of(message[0]);
    if (!slot) continue;
    const bool touches = bit(message, 1, 0x80);
    slots_.set(*slot, touches);
    if (touches) slots_.move(*slot, message[2] << 4 | message[4] >> 4, message[3] << 4 | (message[4] & 0x0f));
  }
  if (touched) slots_.end_frame();
  return finish();
}

/// The first report of a frame says how many fingers it has in all.
bool WacomTouchDecoder::decode_display(base::Bytes report) {
  const bool wide = format_ == Touch::display_27qhd;
  const std::size_t count_at = wide ? 63 : 61;
  const std::int32_t most = wide ? 10 : 4;
  const std::size_t size = wide ? 6 : 14;
  const std::size_t y_at = wide ? 4 : 6;
  if (report.size() <= count_at) return false;
  if (report[count_at] != 0) left_ = report[count_at];
  const std::int32_t here = std::min(most, left_);
  for (std::int32_t i = 0; i < here; ++i) {
    const base::Bytes finger = report.subspan(1 + size * static_cast<std::size_t>(i), size);
    const auto slot = slots_.slot_of(finger[1]);
    if (!slot) continue;
    const bool touches = bit(finger, 0, 0x01);
    slots_.set(*slot, touches);
    if (touches) slots_.move(*slot, le16(finger, 2), le16(finger, y_at));
  }
  slots_.end_frame();
  left_ -= here;
  return finish();
}

/// Sensors of notebooks tell formats apart by length and, where that does not do, by report id.
bool WacomTouchDecoder::decode_tablet_pc(base::Bytes report) {
  constexpr std::size_t k_one_finger = 5;
  constexpr std::size_t k_one_finger_with_id = 10;
  constexpr std::size_t k_both_fingers = 14;
  const auto one_finger = [&]() -> bool {
    if (axes_.contacts > 1 || report.size() > k_both_fingers) return false;
    if (report.size() == k_one_finger) return decode_one(report, 0, 1);
    if (report.size() == k_one_finger_with_id) return decode_one(report, 2, 3);
    return report.size() >= 6 && decode_one(report, 1, 2);
  };
  if (report.size() == k_one_finger) return one_finger();
  if (report.size() == k_both_fingers) return decode_tablet_pc_two(report);
  switch (report[0]) {
    case 0x06:
    case 0x0f:
    case 0x10:
    case 0x12:
      return one_finger();
    case 0x0d:
    case 0x03:
      return decode_many(report);
    default:
      return false;
  }
}

bool WacomTouchDecoder::decode_one(base::Bytes report, std::size_t at_touch, std::size_t at_x) {
  if (slots_.size() == 0) return false;
  const bool touches = bit(report, at_touch, 0x01);
  slots_.set(0, touches);
  if (touches) slots_.move(0, le16(report, at_x), le16(report, at_x + 2));
  slots_.end_frame();
  return finish();
}

bool WacomTouchDecoder::decode_tablet_pc_two(base::Bytes report) {
  if (slots_.size() < 2) return false;
  for (std::size_t i = 0; i < 2; ++i) {
    const bool touches = bit(report, 1, static_cast<std::uint8_t>(1U << i));
    slots_.set(i, touches);
    if (touches) slots_.move(i, le16(report, 2 + 2 * i) & 0x7fff, le16(report, 6 + 2 * i) & 0x7fff);
  }
  slots_.end_frame();
  return finish();
}

bool WacomTouchDecoder::decode_many(base::Bytes report) {
  constexpr std::int32_t k_most = 5;
  const bool bare = format_ == Touch::tablet_pc_many_bare;
  const std::size_t size = bare ? 7 : 11;
  const std::size_t x_at = bare ? 3 : 7;
  if (report.size() < 3) return false;
  if (report[2] != 0) left_ = report[2];
  const std::int32_t here = std::min(k_most, left_);
  for (std::int32_t i = 0; i < here; ++i) {
    const std::size_t at = 3 + size * static_cast<std::size_t>(i);
    if (at + x_at + 4 > report.size()) break;
    const base::Bytes finger = report.subspan(at);
    const auto slot = slots_.slot_of(le16(finger, 1));
    if (!slot) continue;
    const bool touches = bit(finger, 0, 0x01);
    slots_.set(*slot, touches);
    if (touches) slots_.move(*slot, le16(finger, x_at), le16(finger, x_at + 2));
  }
  slots_.end_frame();
  left_ -= here;
  return finish();
}

bool WacomTouchDecoder::decode_bamboo_pad(base::Bytes report) {
  if ((report.size() != 32 && report.size() != 64) || report[0] != 0x10 || !bit(report, 1, 0x02)) return false;
  const std::uint8_t which = report[9];
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const bool touches = (which >> i & 1) != 0;
    slots_.set(i, touches);
    if (!touches) continue;
    const base::Bytes finger = report.subspan(10 + 3 * i, 3);
    slots_.move(i, finger[0] | (finger[1] & 0x0f) << 8, finger[2] << 4 | finger[1] >> 4);
  }
  slots_.end_frame();
  return finish();
}

/// Four frames of up to five fingers each; further ones of the same moment follow in the next.
bool WacomTouchDecoder::decode_pro_bluetooth(base::Bytes report) {
  constexpr std::size_t k_size = 286;
  constexpr std::size_t k_frames = 4;
  constexpr std::size_t k_frame_size = 43;
  constexpr std::int32_t k_most = 5;
  if ((report[0] != 0x80 && report[0] != 0x81) || report.size() < k_size) return false;
  bool ended = false;
  for (std::size_t i = 0; i < k_frames; ++i) {
    const base::Bytes frame = report.subspan(109 + i * k_frame_size, k_frame_size);
    if (!bit(frame, 0, 0x80)) continue;
    if ((frame[0] & 0x7f) != 0) left_ = frame[0] & 0x7f;
    const std::int32_t here = std::min(k_most, left_);
    for (std::int32_t j = 0; j < here; ++j) {
      const base::Bytes finger = frame.subspan(1 + 8 * static_cast<std::size_t>(j), 8);
      const auto slot = slots_.slot_of(finger[0]);
      if (!slot) continue;
      slots_.set(*slot, bit(finger, 1, 0x01));
      slots_.move(*slot, le16(finger, 2), le16(finger, 4));
    }
    slots_.end_frame();
    left_ -= here;
    if (left_ > 0) continue;
    left_ = 0;
    slots_.publish();
    ended = true;
  }
  return ended;
}

}  // namespace penpose::decode
