#pragma once

#include "core/base/byte_reader.h"
#include "core/base/interface.h"
#include "firmware_io/decode/sample/pad_sample.h"

namespace penpose::decode {

/// Turns the raw reports of one interface into the state of the keys and wheels on the tablet. Works in parallel
/// with the interface's PenDecoder and gets all the same reports, in order. It never allocates in `decode`, never reads
/// outside the report, and accepts any bytes.
class PadDecoder : public base::Interface {
 public:
  explicit PadDecoder(const PadFeatures& features) : features_(features) {}

  /// One raw report, report id first. True if it was about the pad; its state is then in `sample()`, where wheels are
  /// the steps of this report alone.
  virtual bool decode(base::Bytes report) = 0;
  /// Resets all state, as after plugging in.
  virtual void reset() {
    sample_ = {};
    battery_ = {};
  }

  /// Sets the light that is on at a side, where another source than the reports knows it.
  virtual void set_light(std::size_t side, std::int8_t light) {
    static_cast<void>(side);
    static_cast<void>(light);
  }

  [[nodiscard]] const PadSample& sample() const { return sample_; }
  [[nodiscard]] const PadFeatures& features() const { return features_; }
  [[nodiscard]] const Battery& battery() const { return battery_; }

 protected:
  PadSample sample_;
  PadFeatures features_;
  Battery battery_;
};

}  // namespace penpose::decode
