#include <algorithm>
#include <string_view>

#include "core/base/text/letters.h"
#include "replay/recording/formats.h"

namespace penpose::replay {
namespace {

bool holds(std::string_view line, std::string_view part) { return line.find(part) != std::string_view::npos; }

/// Lines of what Wireshark and tshark print or export: packets in words, lists of packets, JSON, PDML and PSML.
bool marks_wireshark(std::string_view line) {
  return (line.starts_with("Frame ") && holds(line, " bytes on wire (")) ||
         (line.starts_with("No. ") && holds(line, "Protocol Length Info")) || line.starts_with("\"No.\",\"Time\"") ||
         line.starts_with("\"_index\": \"packets-") || line.starts_with("<pdml ") || line.starts_with("<psml ");
}

base::Error refuse_wireshark() {
  return {"is text that Wireshark made of a capture", "",
          "save the capture itself (in Wireshark \"Save As\", pcapng) and give that file"};
}

/// Lines of usbmon's text (Linux, Documentation/usb/usbmon.rst): the URB's address, its time, the kind of event, and
/// transfer, bus, device and endpoint as in "Ii:1:005:1".
bool marks_usbmon_text(std::string_view line) {
  const auto word = [&] {
    const std::size_t end = std::min(line.find(' '), line.size());
    const std::string_view found = line.substr(0, end);
    line.remove_prefix(std::min(end + 1, line.size()));
    return found;
  };
  const std::string_view address = word();
  const std::string_view time = word();
  const std::string_view event = word();
  const std::string_view place = word();
  const auto is_hex = [](char c) { return base::hex_value(c).has_value(); };
  return address.size() >= 8 && std::all_of(address.begin(), address.end(), is_hex) && !time.empty() &&
         std::all_of(time.begin(), time.end(), is_hex) && (event == "S" || event == "C" || event == "E") &&
         place.size() > 6 && std::string_view("CZIB").find(place[0]) != std::string_view::npos &&
         (place[1] == 'i' || place[1] == 'o') && place[2] == ':' && std::count(place.begin(), place.end(), ':') == 3;
}

base::Error refuse_usbmon_text() {
  return {"is usbmon's text, which keeps no more than 32 bytes of a transfer", "",
          "capture the interface usbmon0 with Wireshark or tcpdump and give that file"};
}

}  // namespace

RecordingFormat wireshark_export() { return {"Wireshark's text", nullptr, marks_wireshark, nullptr, refuse_wireshark}; }

RecordingFormat usbmon_text() { return {"usbmon's text", nullptr, marks_usbmon_text, nullptr, refuse_usbmon_text}; }

}  // namespace penpose::replay
