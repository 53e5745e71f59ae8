#include "firmware_io/decode/fallback_decoder.h"

namespace penpose::decode {

FallbackDecoder::FallbackDecoder(PenLayout layout, std::unique_ptr<PenDecoder> described,
                                 std::unique_ptr<PenDecoder> vendor)
    : layout_(std::move(layout)), described_(std::move(described)), vendor_(std::move(vendor)), used_(vendor_.get()) {}

void FallbackDecoder::reset() {
  sample_ = {};
  pad_ = {};
  described_->reset();
  vendor_->reset();
  used_ = vendor_.get();
}

ReportKind FallbackDecoder::decode(base::Bytes report) {
  const PenReport* const described = layout_.find(report);
  const bool fits = described != nullptr && described->length == report.size();
  PenDecoder* const chosen = fits ? described_.get() : vendor_.get();
  const ReportKind kind = chosen->decode(report);
  if (kind == ReportKind::pen) {
    sample_ = chosen->sample();
    used_ = chosen;
  } else if (kind == ReportKind::pad) {
    pad_ = chosen->pad();
  }
  return kind;
}

}  // namespace penpose::decode
