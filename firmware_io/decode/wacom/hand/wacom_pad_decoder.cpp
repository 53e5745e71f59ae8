#include "firmware_io/decode/wacom/hand/wacom_pad_decoder.h"

#include <algorithm>

#include "firmware_io/decode/sample/report_bytes.h"

namespace penpose::decode {
namespace {

using Pad = WacomPad;

constexpr std::size_t k_intuos_size = 10;
constexpr std::size_t k_bamboo_two_fingers = 20;
constexpr std::size_t k_many_fingers = 64;
constexpr std::int32_t k_ring_maximum = 71;
constexpr std::int32_t k_strip_maximum = 4096;

constexpr PadKeys k_bamboo_keys{PadKey::left, PadKey::right, PadKey::forward, PadKey::back};
constexpr PadKeys k_program_keys{PadKey::program1, PadKey::program2, PadKey::program3};

/// The keys that `show` and its like read the lights from.
PadKeys mode_keys_of(const WacomHand& hand, const PadFeatures& has) {
  if (has.modes == 0 || hand.pad == Pad::remote) return {};
  if (hand.pad == Pad::intuos_pro_bluetooth) return {numbered_key(hand.keys - 1U)};
  PadKeys keys;
  for (unsigned group = 0; group < has.modes; ++group) {
    const unsigned first = group * (hand.keys / has.modes);
    const unsigned count = hand.pad == Pad::cintiq_24hd ? has.lights : 1;
    for (unsigned i = 0; i < count; ++i) keys.set(numbered_key(first + i));
  }
  return keys;
}

PadFeatures features_of(const WacomHand& hand) {
  PadFeatures has;
  has.keys = numbered_keys(~std::uint64_t{0}, hand.keys);
  const auto rings = [&](unsigned count) {
    has.rings = count;
    has.ring_maximum = k_ring_maximum;
  };
  const auto strips = [&](unsigned count) {
    has.strips = count;
    has.strip_maximum = k_strip_maximum;
  };
  const auto modes = [&](unsigned groups, unsigned lights) {
    has.modes = groups;
    has.lights = lights;
  };
  switch (hand.pad) {
    case Pad::none:
    case Pad::dtus:
    case Pad::dtk:
    case Pad::cintiq_hybrid:
    case Pad::cintiq_companion2:
    case Pad::graphire_bluetooth:
    case Pad::intuos_2018_bluetooth:
      break;
    case Pad::graphire4:
      has.keys = {PadKey::back, PadKey::forward};
      has.wheels = 1;
      break;
    case Pad::bamboo_first:
      has.keys = k_bamboo_keys;
      rings(1);
      break;
    case Pad::bamboo:
    case Pad::intuos_ht:
      has.keys = k_bamboo_keys;
      break;
    case Pad::intuos3_small:
      strips(1);
      break;
    case Pad::intuos3:
      strips(2);
      break;
    case Pad::intuos4:
    case Pad::intuos4_bluetooth:
    case Pad::intuos5:
    case Pad::intuos_pro_bluetooth:
    case Pad::remote:
      rings(1);
      modes(1, 4);
      break;
    case Pad::cintiq_21ux2:
      strips(2);
      modes(2, 4);
      break;
    case Pad::cintiq_22hd:
      has.keys |= k_program_keys | PadKeys{PadKey::button_config, PadKey::info};
      strips(2);
      break;
    case Pad::cintiq_24hd:
      has.keys |= k_program_keys | PadKeys{PadKey::screen_keyboard, PadKey::info};
      if (!hand.has_partner) has.keys.set(PadKey::button_config);
      rings(2);
      modes(2, 3);
      break;
    case Pad::cintiq_27qhd:
      has.keys |= k_program_keys | PadKeys{PadKey::screen_keyboard, PadKey::button_config};
      if (!hand.has_partner) has.keys.set(PadKey::control_panel);
      break;
    case Pad::cintiq_13hd:
      rings(1);  // as Linux has it; no report ever moves it
      break;
  }
  has.mode_keys = mode_keys_of(hand, has);
  return has;
}

constexpr std::uint8_t k_pad_status_report = 0xc0;

/// Models that take a module with a battery, for a receiver.
bool has_wireless_kit(Pad pad) { return pad == Pad::bamboo || pad == Pad::intuos_ht || pad == Pad::intuos5; }

PadKeys when(bool holds, PadKey key) { return holds ? PadKeys{key} : PadKeys{}; }

/// The three keys that are areas of one touch strip, or that a model has beside its numbered ones.
PadKeys program_keys(unsigned bits) {
  return when((bits & 1) != 0, PadKey::program1) | when((bits & 2) != 0, PadKey::program2) |
         when((bits & 4) != 0, PadKey::program3);
}

}  // namespace

WacomPadDecoder::WacomPadDecoder(const WacomHand& hand) : PadDecoder(features_of(hand)), hand_(hand) {}

void WacomPadDecoder::reset() {
  PadDecoder::reset();
  active_ = false;
  for (ModeLight& light : lights_) light.reset();
}

void WacomPadDecoder::set_light(std::size_t side, std::int8_t light) {
  // A remote tells of its own.
  if (side >= features_.modes || hand_.pad == Pad::remote) return;
  lights_[side].set(light, features_.lights);
  sample_.mode[side] = lights_[side].now();
}

bool WacomPadDecoder::decode(base::Bytes report) {
  if (report.empty()) return false;
  if (report[0] == k_pad_status_report && has_wireless_kit(hand_.pad)) {
    take_status(report);
    return false;
  }
  switch (hand_.pad) {
    case Pad::none:
      return false;
    case Pad::graphire4:
    case Pad::graphire_bluetooth:
    case Pad::bamboo_first:
      return decode_graphire(report);
    case Pad::bamboo:
    case Pad::intuos_ht:
      return decode_bamboo(report);
    case Pad::dtus:
      return decode_dtus(report);
    case Pad::intuos4_bluetooth:
      return decode_intuos_bluetooth(report);
    case Pad::intuos_pro_bluetooth:
      return decode_pro_bluetooth(report);
    case Pad::intuos_2018_bluetooth:
      return decode_2018_bluetooth(report);
    case Pad::remote:
      return decode_remote(report);
    case Pad::intuos5:
      return report.size() != k_many_fingers && decode_intuos(report);
    default:
      return decode_intuos(report);
  }
}

/// What the tablet says of its wireless module, on its cable too: whether there is one, and the charge in 31sts.
/// Source: Linux, wacom_wac.c, wacom_status_irq.
void WacomPadDecoder::take_status(base::Bytes report) {
  constexpr std::size_t k_size = 10;
  if (report.size() < k_size) return;
  battery_ = {};
  const int percent = std::min((report[8] & 0x3f) * 100 / 31, 100);
  if (bit(report, 9, 0x02)) battery_ = {static_cast<std::int8_t>(percent), bit(report, 8, 0x80)};
}

/// Pen and keys share a report. Keys are told of while one is held, and once more when the last is let go.
bool WacomPadDecoder::decode_graphire(base::Bytes report) {
  const bool bluetooth = hand_.pad == Pad::graphire_bluetooth;
  const std::size_t size = hand_.pad == Pad::bamboo_first ? 9 : 8;
  if (report.size() < size || report[0] != (bluetooth ? 0x03 : 0x02)) return false;
  sample_.wheel = {};
  const std::uint8_t byte = report[7];
  bool active = false;
  PadKeys keys;
  if (hand_.pad == Pad::graphire4) {
    active = (byte & 0xf8) != 0;
    keys = when((byte & 0x40) != 0, PadKey::back) | when((byte & 0x80) != 0, PadKey::forward);
  } else if (hand_.pad == Pad::bamboo_first) {
    active = (byte & 0xf8) != 0 || report[8] != 0;
    keys = when((byte & 0x08) != 0, PadKey::back) | when((byte & 0x20) != 0, PadKey::left) |
           when((byte & 0x10) != 0, PadKey::forward) | when((byte & 0x40) != 0, PadKey::right);
  } else {
    active = (byte & 0x03) != 0;
    keys = when((byte & 0x02) != 0, PadKey::button0) | when((byte & 0x01) != 0, PadKey::button1);
    constexpr std::array<std::int8_t, 8> k_charge{1, 15, 25, 35, 50, 70, 100, 100};
    battery_ = {k_charge[byte >> 2 & 7], (byte >> 2 & 7) == 7};
  }
  const bool told = active || active_;
  active_ = active;
  if (!told) return false;
  sample_.keys = keys;
  if (hand_.pad == Pad::graphire4) sample_.wheel[0] = ((byte & 0x18) >> 3) - ((byte & 0x20) >> 3);
  if (hand_.pad == Pad::bamboo_first) {
    sample_.ring[0] = report[8] & 0x7f;
    sample_.ring_touched[0] = bit(report, 8, 0x80);
  }
  return true;
}

/// The keys of these models come with the fingers: in a bit of the report of two fingers, or in a message of their own
/// among those of many.
bool WacomPadDecoder::decode_bamboo(base::Bytes report) {
  if (report[0] != 0x02) return false;
  const auto keys = [](unsigned bits, unsigned left, unsigned back) {
    return when((bits & left) != 0, PadKey::left) | when((bits & back) != 0, PadKey::back) |
           when((bits & 0x04) != 0, PadKey::forward) | when((bits & 0x01) != 0, PadKey::right);
  };
  if (report.size() == k_bamboo_two_fingers) {
    sample_.keys = keys(report[1], 0x08, 0x02);
    return true;
  }
  if (report.size() != k_many_fingers) return false;
  constexpr std::uint8_t k_keys_message = 128;
  const bool swapped = hand_.pad == Pad::intuos_ht;
  bool told = false;
  const std::size_t count = report[1] & 0x07U;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = 2 + 8 * i;
    if (report[at] != k_keys_message) continue;
    sample_.keys = swapped ? keys(report[at + 1], 0x02, 0x08) : keys(report[at + 1], 0x08, 0x02);
    told = true;
  }
  return told;
}

bool WacomPadDecoder::decode_dtus(base::Bytes report) {
  constexpr std::uint8_t k_pad_report = 0x15;
  if (report.size() < 2 || report[0] != k_pad_report) return false;
  sample_.keys = numbered_keys(report[1] & 0x0fU, hand_.keys);
  return true;
}

bool WacomPadDecoder::decode_intuos(base::Bytes report) {
  const std::uint8_t id = report[0];
  if (report.size() < k_intuos_size || (id != 0x0c && id != 0x03 && id != 0x11)) return false;
  show(read_intuos(report));
  return true;
}

WacomPadDecoder::Frame WacomPadDecoder::read_intuos(base::Bytes report) const {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned>(report[i]); };
  Frame frame;
  const auto read_strips = [&] {
    frame.strip = {static_cast<std::int32_t>((byte(1) & 0x1f) << 8 | byte(2)),
                   static_cast<std::int32_t>((byte(3) & 0x1f) << 8 | byte(4))};
  };
  switch (hand_.pad) {
    case Pad::intuos4:
    case Pad::intuos4_bluetooth:
      frame.numbered = byte(3) << 1 | (byte(2) & 1);
      frame.ring[0] = report[1];
      break;
    case Pad::intuos5:
      frame.numbered = byte(4) << 1 | (byte(3) & 1);
      frame.ring[0] = report[2];
      break;
    case Pad::dtk:
      frame.numbered = byte(6);
      break;
    case Pad::cintiq_13hd:
    case Pad::cintiq_hybrid:
      frame.numbered = byte(4) << 1 | (byte(3) & 1);
      break;
    case Pad::cintiq_companion2:
      frame.numbered = (byte(2) >> 4) << 7 | (byte(1) & 0x04) << 4 | (byte(2) & 0x0f) << 2 | (byte(1) & 0x03);
      break;
    case Pad::cintiq_24hd: {
      frame.numbered = byte(8) << 8 | byte(6);
      frame.ring = {report[1], report[2]};
      const bool first = (byte(4) & 0x07) != 0;
      const bool second = (byte(4) & 0xe0) != 0;
      const bool third = (byte(3) & 0x1c) != 0;
      frame.named = program_keys((first ? 1U : 0U) | (second ? 2U : 0U) | (third ? 4U : 0U)) |
                    when(second, PadKey::screen_keyboard) | when(third, PadKey::info) |
                    when(first, PadKey::button_config);
      break;
    }
    case Pad::cintiq_27qhd:
      frame.named = program_keys(byte(2) & 0x07) | when((byte(2) & 0x01) != 0, PadKey::button_config) |
                    when((byte(2) & 0x02) != 0, PadKey::screen_keyboard) |
                    when((byte(2) & 0x04) != 0, PadKey::control_panel);
      break;
    case Pad::cintiq_21ux2:
    case Pad::cintiq_22hd:
      frame.numbered = byte(8) << 10 | (byte(7) & 1) << 9 | byte(6) << 1 | (byte(5) & 1);
      if (hand_.pad == Pad::cintiq_22hd) {
        frame.named = program_keys(byte(9) & 0x07) | when((byte(9) & 0x01) != 0, PadKey::info) |
                      when((byte(9) & 0x02) != 0, PadKey::button_config);
      }
      read_strips();
      break;
    default:
      frame.numbered = (byte(6) & 0x10) << 5 | (byte(5) & 0x10) << 4 | (byte(6) & 0x0f) << 4 | (byte(5) & 0x0f);
      read_strips();
      break;
  }
  return frame;
}

void WacomPadDecoder::show(const Frame& frame) {
  sample_.keys = numbered_keys(frame.numbered, hand_.keys) | (frame.named & features_.keys);
  for (std::size_t i = 0; i < k_pad_sides; ++i) {
    if (i < features_.rings) {
      sample_.ring_touched[i] = (frame.ring[i] & 0x80) != 0;
      sample_.ring[i] = sample_.ring_touched[i] ? frame.ring[i] & 0x7f : 0;
    }
    if (i < features_.strips) sample_.strip[i] = frame.strip[i];
  }
  if (hand_.pad == Pad::cintiq_24hd) {
    sample_.mode[0] = lights_[0].choose(frame.numbered & 0xff, features_.lights);
    sample_.mode[1] = lights_[1].choose(static_cast<unsigned>(frame.numbered >> 8), features_.lights);
    return;
  }
  for (unsigned i = 0; i < features_.modes; ++i) {
    const unsigned key = i * (hand_.keys / features_.modes);
    sample_.mode[i] = lights_[i].press((frame.numbered >> key & 1) != 0, features_.lights);
  }
}

/// Report 3 holds two reports of the wired kind, report 4 three; the battery's state follows them.
bool WacomPadDecoder::decode_intuos_bluetooth(base::Bytes report) {
  if (report[0] != 0x03 && report[0] != 0x04) return false;
  const std::size_t count = report[0] == 0x04 ? 3 : 2;
  const std::size_t power_at = 1 + count * k_intuos_size;
  if (report.size() < power_at + 1) return false;
  bool told = false;
  for (std::size_t i = 0; i < count; ++i) {
    told = decode_intuos(report.subspan(1 + i * k_intuos_size, k_intuos_size)) || told;
  }
  constexpr std::array<std::int8_t, 8> k_charge{1, 15, 30, 45, 60, 70, 85, 100};
  battery_ = {k_charge[report[power_at] & 7], (report[power_at] & 0x08) != 0};
  return told;
}

bool WacomPadDecoder::decode_pro_bluetooth(base::Bytes report) {
  constexpr std::size_t k_size = 286;
  if ((report[0] != 0x80 && report[0] != 0x81) || report.size() < k_size) return false;
  const unsigned mode_key = hand_.keys - 1U;
  const bool center = bit(report, 281, 0x40);
  sample_.keys = numbered_keys(report[282] | (center ? std::uint64_t{1} << mode_key : 0), hand_.keys);
  // The device counts from the top against the clock; the wired models from the left with it.
  std::int32_t ring = k_ring_maximum - (report[285] & 0x7f) + 3 * (k_ring_maximum + 1) / 16;
  if (ring > k_ring_maximum) ring -= k_ring_maximum + 1;
  sample_.ring_touched[0] = bit(report, 285, 0x80);
  sample_.ring[0] = sample_.ring_touched[0] ? ring : 0;
  sample_.mode[0] = lights_[0].press(center, features_.lights);
  battery_ = {static_cast<std::int8_t>(report[284] & 0x7f), bit(report, 284, 0x80)};
  return true;
}

bool WacomPadDecoder::decode_2018_bluetooth(base::Bytes report) {
  constexpr std::size_t k_size = 46;
  if ((report[0] != 0x80 && report[0] != 0x81) || report.size() < k_size) return false;
  sample_.keys = numbered_keys(report[44], hand_.keys);
  battery_ = {static_cast<std::int8_t>(report[45] & 0x7f), bit(report, 45, 0x80)};
  return true;
}

bool WacomPadDecoder::decode_remote(base::Bytes report) {
  constexpr std::uint8_t k_keys_report = 0x11;
  if (report.size() < 13 || report[0] != k_keys_report) return false;
  sample_.keys = numbered_keys(report[9] | report[10] << 8 | (report[11] & 0x03U) << 16, hand_.keys);
  sample_.ring_touched[0] = bit(report, 12, 0x80);
  sample_.ring[0] = sample_.ring_touched[0] ? (report[12] & 0x7f) - 1 : 0;
  sample_.mode[0] = static_cast<std::int8_t>(report[11] >> 6);
  battery_ = {static_cast<std::int8_t>(report[7] & 0x7f), bit(report, 7, 0x80)};
  return true;
}

}  // namespace penpose::decode
