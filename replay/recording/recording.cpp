#include "replay/recording/recording.h"

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "core/base/text/letters.h"
#include "replay/recording/byte_stream.h"
#include "replay/recording/decoration.h"
#include "replay/recording/formats.h"

namespace penpose::replay {
namespace {

bool marks_trace(std::string_view line) {
  std::vector<std::uint8_t> bytes;
  const TraceLineKind kind = parse_trace_line(line, bytes).kind;
  return kind == TraceLineKind::report || kind == TraceLineKind::descriptor;
}

RecordingFormat hid_recorder_recording() { return {"hid-recorder", nullptr, marks_trace, nullptr, nullptr}; }

/// Of two that recognise a file, or a line of it, the first has it.
std::span<const RecordingFormat> formats() {
  static const RecordingFormat all[] = {
      gzip_recording(),
      utf16_recording(),
      usb_capture_recording(),
      hid_recorder_recording(),
      usbhid_dump_recording(),
      tablet_debugger_recording(),
      open_tablet_driver_diagnostics(),
      evemu_recording(),
      libinput_recording(),
      evtest_recording(),
      wireshark_text(),
      usbmon_text(),
      usblyzer_text(),
  };
  return all;
}

/// What a front shows.
struct Recognition {
  const RecordingFormat* format = nullptr;  ///< null: nobody's
  bool decorated = false;
};

/// Comments of a session are penpose's, and its lines are as they were written.
bool is_session(std::string_view front) { return base::without_mark(front).starts_with("# penpose session "); }

Recognition recognise(base::Bytes front) {
  Recognition found;
  if (is_session(base::as_text(front))) return found;
  for (const RecordingFormat& format : formats()) {
    if (format.recognises != nullptr && format.recognises(front)) return {&format, false};
  }
  const bool begins_with_mark = base::without_mark(base::as_text(front)).size() < front.size();
  find_line(front, [&](std::string_view line) {
    const std::string bare = undecorated(line);
    const auto marked = std::find_if(formats().begin(), formats().end(), [&](const RecordingFormat& format) {
      return format.marks != nullptr && format.marks(bare);
    });
    if (marked == formats().end()) return false;
    if (found.format == nullptr) found.format = &*marked;
    found.decorated = found.format == &*marked && (begins_with_mark || bare != line);
    return found.decorated;
  });
  return found;
}

/// Opens the layers one after another.
base::Result<ReadBytes> open(ReadBytes read) {
  std::vector<const RecordingFormat*> opened;
  bool bare = false;
  for (;;) {
    auto bytes = std::make_shared<ByteStream>(std::move(read));
    const auto front = bytes->peek(k_front);
    if (!front) return front.error();
    const Recognition found = recognise(*front);
    read = [bytes](std::span<std::uint8_t> into) { return bytes->read(into); };
    if (found.decorated && !bare) {
      read = without_decoration(std::move(read));
      bare = true;
      continue;
    }
    const RecordingFormat* format = found.format;
    if (format == nullptr || (format->convert == nullptr && format->refusal == nullptr)) return read;
    if (format->convert == nullptr) return format->refusal();
    if (std::find(opened.begin(), opened.end(), format) != opened.end()) {
      return base::Error{"is wrapped in " + std::string(format->name) + " twice", "", "unwrap it first"};
    }
    opened.push_back(format);
    read = format->convert(std::move(read));
  }
}

}  // namespace

ReadBytes read_recording(ReadBytes read) {
  return [read = std::move(read), opened = false](std::span<std::uint8_t> into) mutable -> base::Result<std::size_t> {
    if (!opened) {
      auto inner = open(std::move(read));
      if (inner) {
        read = std::move(*inner);
      } else {
        read = [error = inner.error()](std::span<std::uint8_t>) -> base::Result<std::size_t> { return error; };
      }
      opened = true;
    }
    return read(into);
  };
}

}  // namespace penpose::replay
