#include "replay/trace/trace_writer.h"

#include <utility>

namespace penpose::replay {

void TraceWriter::switch_to(int device) {
  if (device_ == device) return;
  append_device(out_, device, style_);
  device_ = device;
}

void TraceWriter::declare(int device, const TraceDevice& facts) {
  switch_to(device);
  append_descriptor(out_, facts.report_descriptor, style_);
  append_name(out_, facts.name, style_);
  if (!facts.physical.empty()) append_physical(out_, facts.physical, style_);
  append_identity(out_, facts.bus, facts.vendor, facts.product, style_);
  for (const auto& [index, text] : facts.strings) append_string(out_, index, text, style_);
}

void TraceWriter::report(int device, std::int64_t time_us, base::Bytes bytes) {
  switch_to(device);
  append_report(out_, time_us, bytes, style_);
}

void TraceWriter::cut_report(int device, std::int64_t time_us, std::size_t length, base::Bytes first) {
  switch_to(device);
  append_cut_report(out_, time_us, length, first, style_);
}

void TraceWriter::string(int device, int index, std::string_view text) {
  switch_to(device);
  append_string(out_, index, text, style_);
}

void TraceWriter::comment(std::string_view text) { append_comment(out_, text, style_); }

std::string TraceWriter::take() { return std::exchange(out_, {}); }

}  // namespace penpose::replay
