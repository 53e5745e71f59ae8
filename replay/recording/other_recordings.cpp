// Recordings of other programs that cannot be read, with what to do instead.

#include <string>
#include <string_view>

#include "replay/recording/formats.h"

namespace penpose::replay {
namespace {

constexpr const char* k_record_again =
    "record the tablet again with `penpose record` or hid-recorder, which keep its own reports";
constexpr const char* k_save_capture = "save the capture as a file of Wireshark (pcapng) and give that";

base::Error events(const std::string& program) {
  return {"is " + program + ", which holds what a driver made of the tablet's reports", "", k_record_again};
}

bool has(std::string_view line, std::string_view start, std::string_view later) {
  return line.starts_with(start) && line.find(later, start.size()) != std::string_view::npos;
}

// `libinput record` prints YAML, `libinput debug-events` a line an event.
bool marks_libinput(std::string_view line) {
  return line == "# libinput record" || has(line, "-event", "DEVICE_ADDED") || has(line, "event", "TABLET_TOOL_");
}
base::Error of_libinput() { return events("libinput's recording"); }

bool marks_evtest(std::string_view line) { return has(line, "Event: time ", "type "); }
base::Error of_evtest() { return events("evtest's text"); }

// "Export Packet Dissections": the summary's heading, or the first line of a packet's details.
bool marks_wireshark(std::string_view line) {
  return has(line, "No. ", "Protocol") || has(line, "Frame ", " bytes on wire");
}
base::Error of_wireshark() { return {"is Wireshark's text", "", k_save_capture}; }

// The kernel's "1u" form: URB tag, time, event type, "Ii:bus:device:endpoint" (Documentation/usb/usbmon.rst).
bool marks_usbmon(std::string_view line) {
  return has(line, "ffff", " C Ii:") || has(line, "ffff", " S Ii:") || has(line, "ffff", " S Ci:");
}
base::Error of_usbmon() {
  return {"is usbmon's text, which cuts reports off at 32 bytes", "",
          "capture with `tcpdump -i usbmonN -w FILE` or Wireshark and give that file"};
}

bool marks_usblyzer(std::string_view line) { return line.starts_with("Type,Seq,Time,Elapsed,Duration,Request,"); }
base::Error of_usblyzer() {
  return {"is USBlyzer's list of requests", "", "capture with Wireshark and USBPcap instead and give that file"};
}

}  // namespace

RecordingFormat libinput_recording() { return {"libinput", nullptr, marks_libinput, nullptr, of_libinput}; }
RecordingFormat evtest_recording() { return {"evtest", nullptr, marks_evtest, nullptr, of_evtest}; }
RecordingFormat wireshark_text() { return {"Wireshark's text", nullptr, marks_wireshark, nullptr, of_wireshark}; }
RecordingFormat usbmon_text() { return {"usbmon's text", nullptr, marks_usbmon, nullptr, of_usbmon}; }
RecordingFormat usblyzer_text() { return {"USBlyzer", nullptr, marks_usblyzer, nullptr, of_usblyzer}; }

}  // namespace penpose::replay
