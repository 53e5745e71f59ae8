#pragma once

#include <memory>

#include "firmware_io/decode/sample/touch_decoder.h"
#include "firmware_io/decode/wacom/hand/wacom_hands.h"

namespace penpose::decode {

/// The fingers on Wacom's tablets that do not describe their reports.
class WacomTouchDecoder final : public TouchDecoder {
 public:
  /// `coarse` is for Bamboos with reports of two fingers in 32nds of the axes' units.
  WacomTouchDecoder(WacomTouch format, const TouchAxes& axes, bool coarse = false);

  bool decode(base::Bytes report) override;
  void reset() override;

 private:
  bool decode_two(base::Bytes report);
  bool decode_messages(base::Bytes report);
  bool decode_display(base::Bytes report);
  bool decode_tablet_pc(base::Bytes report);
  bool decode_one(base::Bytes report, std::size_t at_touch, std::size_t at_x);
  bool decode_tablet_pc_two(base::Bytes report);
  bool decode_many(base::Bytes report);
  bool decode_bamboo_pad(base::Bytes report);
  bool decode_pro_bluetooth(base::Bytes report);
  bool finish();

  WacomTouch format_;
  bool coarse_;
  std::int32_t left_ = 0;  ///< fingers of this frame in further reports
};

}  // namespace penpose::decode
