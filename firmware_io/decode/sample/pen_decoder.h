#pragma once

#include <memory>
#include <span>

#include "core/base/byte_reader.h"
#include "core/base/interface.h"
#include "firmware_io/decode/sample/pen_sample.h"

namespace penpose::decode {

/// The kind of a report.
enum class ReportKind : std::uint8_t {
  ignored,  ///< not used: touch, status, unknown id, wrong length
  pen,      ///< has pen state: the sample after this report is in `sample()`
  pad,      ///< express keys, wheels: see `pad()`
};

/// The state of the keys and wheels on the tablet itself.
struct PadState {
  std::uint64_t keys = 0;               ///< bit i: key i is down
  std::int32_t wheel_delta = 0;         ///< steps since the previous report, clockwise positive
  std::int32_t second_wheel_delta = 0;  ///< the same of a second dial
  std::int32_t wheel_position = -1;     ///< absolute position of a touch ring, -1 while not touched
  std::int32_t second_wheel_position = -1;
  std::int32_t strip = 0;  ///< position on a touch strip, 0 while not touched
  std::int32_t second_strip = 0;
  std::uint32_t wheel_buttons = 0;  ///< bit i: the button in wheel i is down
  std::int8_t battery = -1;         ///< percent; -1: unknown
};

/// Turns the raw input reports of one interface into pen samples. Stateful: feed every report of the interface in
/// order. A decoder never allocates in `decode`, never reads outside the report, and accepts any bytes.
class PenDecoder : public base::Interface {
 public:
  /// One raw report, report id first as from hidraw and hid-recorder.
  virtual ReportKind decode(base::Bytes report) = 0;
  /// Resets all state, as after plugging in.
  virtual void reset() = 0;
  [[nodiscard]] virtual const PenAxes& axes() const = 0;

  /// The full state after the last report of kind `pen`.
  [[nodiscard]] const PenSample& sample() const { return sample_; }
  [[nodiscard]] const PadState& pad() const { return pad_; }

  /// Whether the last sample was read by a protocol of a table, with the ranges of the tablet that was found there.
  /// `axes` may change when this does.
  [[nodiscard]] virtual bool by_table() const { return false; }

  /// All states that the last report of kind `pen` went through, oldest first: the last one is `sample()`. More than
  /// one only if a device puts several frames into a report (over Bluetooth). Valid until the next call of `decode`.
  [[nodiscard]] virtual std::span<const PenSample> frames() const { return {&sample_, 1}; }

 protected:
  PenSample sample_;
  PadState pad_;
};

}  // namespace penpose::decode
