#include "firmware_io/record/tablet_recorder.h"

#include <algorithm>

namespace penpose::record {

int TabletRecorder::add_tablet(const decode::DeviceIdentity& identity, const std::string& physical,
                               const decode::TabletTable* own) {
  const int number = static_cast<int>(tablets_.size());
  own_ = own;
  read_as(tablets_[number], receivers_.connect(number, identity));
  writer_.declare(
      number, {identity.report_descriptor, identity.name, physical, identity.bus, identity.vendor, identity.product});
  for (const auto& [index, text] : identity.strings) {
    writer_.comment("string " + std::to_string(index) + ": \"" + text + "\"");
  }
  return number;
}

void TabletRecorder::read_as(Tablet& tablet, const decode::DeviceIdentity& identity) {
  auto recognition = decode::make_decoder(identity, own_);
  tablet.decoder = recognition ? std::move(recognition->decoder) : nullptr;
  tablet.hand = decode::make_hand_decoders(identity, own_);
  tablet.pad_events = tablet.hand.pad ? decode::PadEvents(tablet.hand.pad->features()) : decode::PadEvents();
}

void TabletRecorder::count_strokes() {
  for (const decode::PenEvent& event : new_events_) {
    if (event.kind == decode::PenEventKind::stroke_begin) ++counts_.strokes;
    if (event.kind == decode::PenEventKind::stroke_end) pen_up_ = true;
  }
  new_events_.clear();
}

void TabletRecorder::add(int number, const device::Record& record) {
  const auto found = tablets_.find(number);
  if (found == tablets_.end()) return;
  Tablet& tablet = found->second;
  switch (record.kind) {
    case device::RecordKind::note:
      writer_.comment(std::to_string(number) + ": " + std::string(base::as_text(record.bytes)));
      return;
    case device::RecordKind::lost:
      counts_.lost += record.lost;
      writer_.comment(std::to_string(number) + ": " + std::to_string(record.lost) + " reports were lost here");
      return;
    case device::RecordKind::report:
      break;
  }
  if (!begun_) first_us_ = record.time_us;
  begun_ = true;
  counts_.span_us = std::max(counts_.span_us, record.time_us - first_us_);
  ++counts_.reports;
  writer_.report(number, counts_.span_us, record.bytes);
  for (const auto& [part, heard] : receivers_.report(number, record.bytes)) {
    static_cast<void>(end(part));
    read_as(tablets_[part], heard);
  }
  if (tablet.decoder && tablet.decoder->decode(record.bytes) == decode::ReportKind::pen) {
    for (const decode::PenSample& sample : tablet.decoder->frames()) {
      tablet.events.add(sample, counts_.span_us, new_events_);
    }
    count_strokes();
  }
  count_keys(tablet, record.bytes);
}

void TabletRecorder::count_keys(Tablet& tablet, base::Bytes report) {
  if (!tablet.hand.pad || !tablet.hand.pad->decode(report)) return;
  tablet.pad_events.add(tablet.hand.pad->sample(), counts_.span_us, new_pad_events_);
  for (const decode::PadEvent& event : new_pad_events_) {
    if (event.kind == decode::PadEventKind::key_down) ++counts_.keys;
  }
  new_pad_events_.clear();
}

std::string TabletRecorder::end(int number) {
  const auto found = tablets_.find(number);
  if (found == tablets_.end()) return {};
  Tablet& tablet = found->second;
  tablet.events.finish(counts_.span_us, new_events_);
  count_strokes();
  const decode::PadKeys held = tablet.pad_events.held();
  tablet.pad_events.finish(counts_.span_us, new_pad_events_);
  new_pad_events_.clear();
  if (held.empty()) return {};
  std::string names = decode::key_names(held);
  writer_.comment(std::to_string(number) + ": held at its end and let go: " + names);
  return names;
}

bool TabletRecorder::take_pen_up() {
  const bool was = pen_up_;
  pen_up_ = false;
  return was;
}

}  // namespace penpose::record
