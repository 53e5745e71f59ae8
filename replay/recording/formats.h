#pragma once

#include "replay/recording/recording_format.h"

namespace penpose::replay {

// Each is in the file of its name; a new one is that file, a line here and a row in recording.cpp.

// Of bytes.
RecordingFormat gzip_recording();
RecordingFormat utf16_recording();
RecordingFormat usb_capture_recording();  ///< pcap and pcapng of usbmon and USBPcap, in usb/

// Of text.
RecordingFormat usbhid_dump_recording();           ///< descriptors and reports as usbhid-dump of DIGImend prints them
RecordingFormat tablet_debugger_recording();       ///< reports as OpenTabletDriver's tablet debugger records them
RecordingFormat open_tablet_driver_diagnostics();  ///< in the same file
RecordingFormat evemu_recording();                 ///< events of a Linux input device as evemu-record writes them

// In other_recordings.cpp: they cannot be read.
RecordingFormat libinput_recording();
RecordingFormat evtest_recording();
RecordingFormat wireshark_text();
RecordingFormat usbmon_text();
RecordingFormat usblyzer_text();

}  // namespace penpose::replay
