#include "replay/tablet_recorder.h"

#include <algorithm>

namespace penpose::replay {

int TabletRecorder::add_tablet(const decode::DeviceIdentity& identity, const std::string& physical,
                               const decode::TabletTable* own) {
  const int number = static_cast<int>(tablets_.size());
  Tablet& tablet = tablets_[number];
  auto recognition = decode::make_decoder(identity, own);
  if (recognition) tablet.decoder = std::move(recognition->decoder);
  writer_.declare(
      number, {identity.report_descriptor, identity.name, physical, identity.bus, identity.vendor, identity.product});
  for (const auto& [index, text] : identity.strings) {
    writer_.comment("string " + std::to_string(index) + ": \"" + text + "\"");
  }
  return number;
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
  if (tablet.decoder && tablet.decoder->decode(record.bytes) == decode::ReportKind::pen) {
    for (const decode::PenSample& sample : tablet.decoder->frames()) {
      tablet.events.add(sample, counts_.span_us, new_events_);
    }
    count_strokes();
  }
}

void TabletRecorder::end(int number) {
  const auto found = tablets_.find(number);
  if (found == tablets_.end()) return;
  found->second.events.finish(counts_.span_us, new_events_);
  count_strokes();
}

bool TabletRecorder::take_pen_up() {
  const bool was = pen_up_;
  pen_up_ = false;
  return was;
}

}  // namespace penpose::replay
