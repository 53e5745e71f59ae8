#pragma once

#include "replay/recording/recording_format.h"

namespace penpose::replay {

// Each is in the file of its name; a new one is that file, a line here and a row in recording.cpp.

// Of bytes.
RecordingFormat gzip_recording();
RecordingFormat utf16_recording();
RecordingFormat usb_capture_recording();  ///< pcap and pcapng of usbmon and USBPcap, in usb/

// Text made of captures of USB: named, not read; both in usb/exported_captures.cpp.
RecordingFormat wireshark_export();
RecordingFormat usbmon_text();

}  // namespace penpose::replay
