#include <memory>

#include "replay/recording/byte_stream.h"
#include "replay/recording/formats.h"
#include "replay/recording/usb/usb_recording.h"

namespace penpose::replay {
namespace {

ReadBytes convert_capture(ReadBytes read) {
  auto recording = std::make_shared<UsbRecording>(std::move(read));
  return read_pieces([recording](std::string& out) { return recording->next(out); });
}

}  // namespace

RecordingFormat usb_capture_recording() {
  return {"USB capture", CaptureReader::recognises, nullptr, convert_capture, nullptr};
}

}  // namespace penpose::replay
