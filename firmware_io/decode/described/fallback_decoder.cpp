#include "firmware_io/decode/described/fallback_decoder.h"

namespace penpose::decode {
namespace {

bool is_desktop_application(hid::Usage usage) {
  constexpr hid::Usage k_keyboard = hid::usage(hid::k_page_generic_desktop, 0x06);
  constexpr hid::Usage k_system_control = hid::usage(hid::k_page_generic_desktop, 0x80);
  constexpr std::uint16_t k_page_consumer = 0x0c;
  return usage == hid::k_mouse || usage == hid::k_pointer || usage == k_keyboard || usage == k_system_control ||
         hid::page_of(usage) == k_page_consumer;
}

}  // namespace

ForeignReports find_foreign_reports(const hid::ReportDescriptor& descriptor) {
  ForeignReports foreign{};
  for (const hid::Field& field : descriptor.fields) {
    if (field.type != hid::ReportType::input) continue;
    const hid::Usage application = descriptor.enclosing(field, hid::k_collection_application);
    const bool pad = application == hid::k_keypad || descriptor.is_inside(field, hid::k_tablet_function_keys);
    if (!pad && !is_desktop_application(application)) continue;
    foreign[field.report_id] = descriptor.report_length(hid::ReportType::input, field.report_id);
  }
  return foreign;
}

FallbackDecoder::FallbackDecoder(const hid::ReportDescriptor& descriptor, std::optional<PenLayout> layout,
                                 std::unique_ptr<PenDecoder> described, std::unique_ptr<PenDecoder> vendor)
    : has_report_ids_(descriptor.has_report_ids),
      foreign_(find_foreign_reports(descriptor)),
      layout_(std::move(layout)),
      described_(std::move(described)),
      vendor_(std::move(vendor)),
      used_(vendor_.get()) {}

void FallbackDecoder::reset() {
  sample_ = {};
  pad_ = {};
  if (described_) described_->reset();
  vendor_->reset();
  used_ = vendor_.get();
}

bool FallbackDecoder::is_foreign(base::Bytes report) const {
  if (report.empty()) return false;
  const std::uint32_t length = foreign_[has_report_ids_ ? report[0] : 0];
  return length != 0 && length == report.size();
}

ReportKind FallbackDecoder::decode(base::Bytes report) {
  const PenReport* const found = described_ ? layout_->find(report) : nullptr;
  const bool fits = found != nullptr && found->length == report.size();
  if (!fits && is_foreign(report)) return ReportKind::ignored;
  PenDecoder* const chosen = fits ? described_.get() : vendor_.get();
  const ReportKind kind = chosen->decode(report);
  if (kind == ReportKind::pen) {
    sample_ = chosen->sample();
    pad_ = chosen->pad();
    used_ = chosen;
  } else if (kind == ReportKind::pad) {
    pad_ = chosen->pad();
  }
  return kind;
}

}  // namespace penpose::decode
