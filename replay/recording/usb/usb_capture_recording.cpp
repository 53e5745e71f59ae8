#include "replay/recording/byte_stream.h"
#include "replay/recording/formats.h"
#include "replay/recording/usb/usb_recording.h"

namespace penpose::replay {

RecordingFormat usb_capture_recording() {
  return {"USB capture", CaptureReader::recognises, nullptr, read_through<UsbRecording>, nullptr};
}

}  // namespace penpose::replay
