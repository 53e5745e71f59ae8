#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include "firmware_io/event/evemu_line.h"
#include "firmware_io/event/event_encoder.h"
#include "replay/recording/byte_stream.h"
#include "replay/recording/formats.h"
#include "replay/trace/trace_writer.h"

namespace penpose::replay {
namespace {

/// Longer names are none.
constexpr std::size_t k_most_of_a_name = 1024;
/// Later times count as this one: some 70,000 years. Two of them still fit into one number.
constexpr std::int64_t k_latest_event_us = std::int64_t{1} << 61;

/// The events of one device as reports of the HID device that stands for it.
class EvemuRecording final : public LineConverter {
 public:
  base::Status line(std::string_view text, std::string& out) override {
    // Several recordings may stand one behind the other.
    if (event::EvemuLines::marks(text)) {
      lines_ = {};
      encoder_.reset();
    }
    switch (lines_.read(text)) {
      case event::EvemuLines::Kind::event:
        take(out);
        break;
      case event::EvemuLines::Kind::broken:
        writer_.comment("unread: " + std::string(text.substr(0, k_most_of_a_name)));
        out += writer_.take();
        break;
      case event::EvemuLines::Kind::facts:
      case event::EvemuLines::Kind::other:
        break;
    }
    return base::Done{};
  }
  void finish(std::string&) override {}

 private:
  void take(std::string& out) {
    const std::int64_t time_us = std::min(lines_.time_us(), k_latest_event_us);
    if (!encoder_) {
      encoder_.emplace(lines_.axes());
      const event::EventAxes& axes = lines_.axes();
      writer_.declare(0, {event::report_descriptor(axes), axes.name.substr(0, k_most_of_a_name), axes.physical,
                          axes.bus, axes.vendor, axes.product});
      // Where times begin anew they go on from the last one.
      if (!first_us_ || time_us - *first_us_ < last_us_) first_us_ = time_us - last_us_;
    }
    last_us_ = std::clamp(time_us - *first_us_, last_us_, k_latest_event_us);
    for (const auto& report : encoder_->take(lines_.event())) writer_.report(0, last_us_, report);
    out += writer_.take();
  }

  event::EvemuLines lines_;
  std::optional<event::EventEncoder> encoder_;
  TraceWriter writer_;
  std::optional<std::int64_t> first_us_;
  std::int64_t last_us_ = 0;
};

ReadBytes convert_evemu(ReadBytes read) { return convert_lines(std::move(read), std::make_shared<EvemuRecording>()); }

}  // namespace

RecordingFormat evemu_recording() { return {"evemu", nullptr, event::EvemuLines::marks, convert_evemu, nullptr}; }

}  // namespace penpose::replay
