#include "firmware_io/decode/sample/pad_events.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace penpose::decode {
namespace {

/// A ring says nothing of the way between two places; farther than a third of it, a second finger came down.
constexpr std::int32_t k_farthest_share = 3;
/// Strips of this range have one bit for each place.
constexpr std::int32_t k_bit_strip_maximum = 4096;
/// No hand turns a wheel farther within a report.
constexpr std::int32_t k_most_notches = 64;

std::int32_t place_of_bits(std::int32_t bits) {
  return static_cast<std::int32_t>(std::bit_width(static_cast<std::uint32_t>(bits)));
}

}  // namespace

std::int32_t PadEvents::ring_steps(std::int32_t from, std::int32_t to) const {
  const std::int64_t places = std::int64_t{features_.ring_maximum} + 1;
  if (places <= 1) return 0;
  std::int64_t by = (std::int64_t{to} - from) % places;
  if (2 * by > places) by -= places;
  if (2 * by < -places) by += places;
  if (k_farthest_share * std::abs(by) > places) return 0;
  // The place as a part of the whole turn, so that no rest of a division is lost on the way round.
  const std::int64_t begin = from % places + 2 * places;
  const auto notches = [&](std::int64_t at) {
    return at * std::min<std::int64_t>(k_ring_notches, places) * k_notch / places;
  };
  return static_cast<std::int32_t>(notches(begin + by) - notches(begin));
}

std::int32_t PadEvents::strip_steps(std::int32_t from, std::int32_t to) const {
  const bool bits = features_.strip_maximum == k_bit_strip_maximum;
  const std::int64_t by = bits ? place_of_bits(to) - place_of_bits(from) : std::int64_t{to} - from;
  return std::abs(by) > k_most_notches ? 0 : static_cast<std::int32_t>(by) * k_notch;
}

void PadEvents::add_keys(const PadSample& sample, std::int64_t time_us, std::vector<PadEvent>& out) const {
  (sample.keys ^ last_.keys).for_each([&](PadKey key) {
    PadEvent event;
    event.key = key;
    event.kind = sample.keys.has(key) ? PadEventKind::key_down : PadEventKind::key_up;
    event.time_us = time_us;
    out.push_back(event);
  });
}

void PadEvents::add_touch(PadEvent event, bool was, Touch now, std::int32_t by, std::vector<PadEvent>& out) const {
  if (was == now.on) {
    if (!was || by == 0) return;
    event.kind = PadEventKind::turned;
    event.steps = by;
  } else {
    event.kind = now.on ? PadEventKind::touched : PadEventKind::let_go;
  }
  out.push_back(event);
}

void PadEvents::add_wheel(PadEvent event, const PadSample& sample, std::vector<PadEvent>& out) const {
  const std::int32_t fine = sample.fine_wheel[event.side];
  const std::int64_t steps = fine != 0 ? fine : std::int64_t{sample.wheel[event.side]} * k_notch;
  if (steps == 0 || std::abs(steps) > std::int64_t{k_most_notches} * k_notch) return;
  event.kind = PadEventKind::turned;
  // Linux's wheels are positive away from oneself.
  event.steps = static_cast<std::int32_t>(features_.wheels_clockwise ? steps : -steps);
  out.push_back(event);
}

void PadEvents::add(const PadSample& sample, std::int64_t time_us, std::vector<PadEvent>& out) {
  add_keys(sample, time_us, out);
  for (std::uint8_t i = 0; i < k_pad_sides; ++i) {
    PadEvent event;
    event.side = i;
    event.mode = sample.mode[i];
    event.time_us = time_us;
    if (i < features_.rings) {
      const Touch now{sample.ring_touched[i], sample.ring[i]};
      add_touch(event, last_.ring_touched[i], now, ring_steps(last_.ring[i], now.at), out);
    }
    event.dial = PadDial::strip;
    if (i < features_.strips) {
      const Touch now{sample.strip[i] > 0, sample.strip[i]};
      add_touch(event, last_.strip[i] > 0, now, now.on ? strip_steps(last_.strip[i], now.at) : 0, out);
    }
    event.dial = PadDial::wheel;
    if (i < features_.wheels) add_wheel(event, sample, out);
  }
  last_ = sample;
}

void PadEvents::finish(std::int64_t time_us, std::vector<PadEvent>& out) {
  PadSample nothing;
  nothing.mode = last_.mode;
  add(nothing, time_us, out);
}

}  // namespace penpose::decode
