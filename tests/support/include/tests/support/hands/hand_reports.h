#pragma once

// What must hold of keys, wheels and fingers whatever a device sends: shared by the fuzz targets of their decoders.
// Reports come with their lengths in front; a length of 255 stands for one of 400 bytes, so that reports over Bluetooth
// come, too.

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "firmware_io/decode/hand/palm_guard.h"
#include "firmware_io/decode/hand_factory.h"
#include "firmware_io/decode/layout/protocol.h"
#include "firmware_io/decode/sample/pad_events.h"
#include "firmware_io/hid/report_descriptor.h"

namespace penpose::fuzz {

constexpr std::size_t k_long_report = 400;

struct State {
  decode::PadSample pad;
  std::vector<decode::TouchContact> touch;
  friend bool operator==(const State&, const State&) = default;
};

/// What must hold whatever a device sends.
inline void check(const decode::PadDecoder& pad) {
  const decode::PadSample& sample = pad.sample();
  const decode::PadFeatures& has = pad.features();
  if (has.rings > decode::k_pad_sides || has.strips > decode::k_pad_sides || has.wheels > decode::k_pad_sides)
    std::abort();
  for (std::size_t i = 0; i < decode::k_pad_sides; ++i) {
    if (has.modes > i && (sample.mode[i] < 0 || static_cast<unsigned>(sample.mode[i]) >= has.lights)) std::abort();
  }
  if (pad.battery().percent < -1) std::abort();
  if (decode::key_names(sample.keys).empty()) std::abort();
}

inline void check(const decode::TouchDecoder& touch) {
  if (touch.contacts().size() > touch.axes().contacts) std::abort();
  for (const auto& one : touch.contacts()) {
    unsigned same = 0;
    for (const auto& other : touch.contacts()) same += one.id == other.id ? 1 : 0;
    if (same != 1) std::abort();
  }
}

/// Follows the keys and dials of a pad through its events: what is pressed was not, what is released was.
class Follower {
 public:
  explicit Follower(const decode::PadFeatures& features) : events_(features) {}

  void add(const decode::PadSample& sample, std::int64_t time_us) {
    out_.clear();
    events_.add(sample, time_us, out_);
    take();
    if (held_ != sample.keys || events_.held() != held_) std::abort();
  }
  void finish() {
    out_.clear();
    events_.finish(0, out_);
    take();
    if (!held_.empty() || touched_ != 0) std::abort();
  }

 private:
  void take() {
    constexpr std::int32_t k_most = 64 * decode::k_notch;
    for (const decode::PadEvent& event : out_) {
      const unsigned dial = 1U << (2 * static_cast<unsigned>(event.dial) + event.side);
      const bool pressed = event.kind == decode::PadEventKind::key_down;
      const bool touched = event.kind == decode::PadEventKind::touched;
      switch (event.kind) {
        case decode::PadEventKind::key_down:
        case decode::PadEventKind::key_up:
          if (held_.has(event.key) == pressed) std::abort();
          held_.set(event.key, pressed);
          break;
        case decode::PadEventKind::touched:
        case decode::PadEventKind::let_go:
          if (((touched_ & dial) != 0) == touched) std::abort();
          touched_ ^= dial;
          break;
        case decode::PadEventKind::turned:
          if (event.steps == 0 || event.steps > k_most || event.steps < -k_most) std::abort();
          if (event.dial != decode::PadDial::wheel && (touched_ & dial) == 0) std::abort();
          break;
      }
    }
  }

  decode::PadEvents events_;
  decode::PadKeys held_;
  unsigned touched_ = 0;
  std::vector<decode::PadEvent> out_;
};

inline std::vector<State> run(decode::HandDecoders& hand, base::ByteReader reader) {
  std::vector<State> states;
  Follower follower(hand.pad ? hand.pad->features() : decode::PadFeatures{});
  decode::PalmGuard palm;
  std::int64_t time_us = 0;
  while (const auto given = reader.read<std::uint8_t>()) {
    const std::size_t wanted = *given == 255 ? k_long_report : *given;
    // A length beyond the end takes what is left, so that every byte counts.
    const auto report = reader.take(wanted <= reader.remaining() ? wanted : reader.remaining());
    State state;
    if (hand.pad) {
      if (hand.pad->decode(*report)) follower.add(hand.pad->sample(), time_us);
      check(*hand.pad);
      state.pad = hand.pad->sample();
    }
    if (hand.touch) {
      hand.touch->decode(*report);
      check(*hand.touch);
      // A pen comes and goes with what was sent; of the fingers only those come through that are there.
      palm.pen(report->size() % 3 == 0, time_us);
      if (palm.let_through(hand.touch->contacts(), time_us).size() > hand.touch->contacts().size()) std::abort();
      if (palm.holds_back(time_us) && !palm.let_through(hand.touch->contacts(), time_us).empty()) std::abort();
      state.touch.assign(hand.touch->contacts().begin(), hand.touch->contacts().end());
    }
    time_us += 100'000;
    states.push_back(std::move(state));
  }
  follower.finish();
  return states;
}

/// The rest of `reader` are reports for `hand`. A reset leaves nothing behind: the same reports give the same states.
inline void try_reports(decode::HandDecoders hand, const base::ByteReader& reader) {
  if (!hand.pad && !hand.touch) return;
  const auto first = run(hand, reader);
  if (hand.pad) hand.pad->reset();
  if (hand.touch) hand.touch->reset();
  if (run(hand, reader) != first) std::abort();
}

/// A report descriptor: half its length in a byte, then its bytes.
inline std::vector<std::uint8_t> read_descriptor(base::ByteReader& reader) {
  const std::size_t length = reader.read<std::uint8_t>().value_or(0) * std::size_t{2};
  const auto bytes = reader.take(length);
  return bytes ? std::vector<std::uint8_t>(bytes->begin(), bytes->end()) : std::vector<std::uint8_t>{};
}

/// Names of the protocols of the table that have such hand decoders.
inline std::vector<std::string> protocols_with(bool (*has)(const decode::HandDecoders&)) {
  std::vector<std::string> names;
  for (const auto& [name, protocol] : decode::known_protocols()) {
    if (has(decode::make_protocol_hand_decoders(name))) names.push_back(name);
  }
  return names;
}

/// The hand decoders of one of the protocols; the first byte chooses it.
inline decode::HandDecoders choose_protocol(base::ByteReader& reader, const std::vector<std::string>& names) {
  return decode::make_protocol_hand_decoders(names[reader.read<std::uint8_t>().value_or(0) % names.size()]);
}

/// Reads a descriptor and, where `find` finds fingers in it, tries the remaining reports with a `Decoder`.
template <typename Decoder, typename Find, typename... Options>
void try_described_touch(base::ByteReader reader, Find find, Options... options) {
  const auto parsed = hid::parse_report_descriptor(read_descriptor(reader), hid::Strictness::tolerant);
  if (!parsed) return;
  auto fingers = find(*parsed);
  if (fingers) try_reports({nullptr, std::make_unique<Decoder>(std::move(*fingers), options...)}, reader);
}

}  // namespace penpose::fuzz
