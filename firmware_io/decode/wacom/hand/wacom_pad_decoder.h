#pragma once

#include <array>

#include "firmware_io/decode/described/mode_light.h"
#include "firmware_io/decode/sample/pad_decoder.h"
#include "firmware_io/decode/sample/touch_decoder.h"
#include "firmware_io/decode/wacom/hand/wacom_hands.h"

namespace penpose::decode {

/// The keys, rings and strips of Wacom's tablets that do not describe themselves. As in the Linux wacom driver:
/// a ring that is not touched is at 0, and keys beyond a model's number do not exist.
class WacomPadDecoder final : public PadDecoder {
 public:
  explicit WacomPadDecoder(const WacomHand& hand);

  bool decode(base::Bytes report) override;
  void reset() override;
  void set_light(std::size_t side, std::int8_t light) override;

 private:
  /// Numbered keys, keys with a name, rings with their touch bit, and strips, as the formats have them.
  struct Frame {
    std::uint64_t numbered = 0;
    PadKeys named;
    std::array<std::uint8_t, k_pad_sides> ring{};
    std::array<std::int32_t, k_pad_sides> strip{};
  };

  void take_status(base::Bytes report);
  bool decode_graphire(base::Bytes report);
  bool decode_bamboo(base::Bytes report);
  bool decode_dtus(base::Bytes report);
  bool decode_intuos(base::Bytes report);
  bool decode_intuos_bluetooth(base::Bytes report);
  bool decode_pro_bluetooth(base::Bytes report);
  bool decode_2018_bluetooth(base::Bytes report);
  bool decode_remote(base::Bytes report);
  [[nodiscard]] Frame read_intuos(base::Bytes report) const;
  void show(const Frame& frame);

  WacomHand hand_;
  bool active_ = false;  ///< the last shared report of pen and pad had pad data
  std::array<ModeLight, k_pad_sides> lights_;
};

}  // namespace penpose::decode
