#include "replay/recording/usb/usb_recording.h"

#include <algorithm>
#include <cstdio>

#include "replay/recording/usb/wire_number.h"

namespace penpose::replay {
namespace {

constexpr int k_unknown_interface = 256;
/// More than a machine has; a hostile capture must not fill the memory.
constexpr std::size_t k_most_devices = 256;
constexpr int k_most_numbers = 4096;
/// A tablet has the descriptor that it has; one that always has another must not make a trace of them.
constexpr int k_most_declarations = 16;
constexpr std::size_t k_most_strings = 32;
constexpr std::size_t k_most_requests = 4096;
constexpr std::size_t k_most_descriptor_bytes = std::size_t{1} << 22;
/// The most that a trace takes of a report.
constexpr std::size_t k_most_of_a_report = 65536;
constexpr std::size_t k_piece = std::size_t{1} << 15;

constexpr std::uint8_t k_get_descriptor = 6;
constexpr std::uint8_t k_set_configuration = 9;
constexpr std::uint8_t k_from_device = 0x80;
constexpr std::uint8_t k_from_interface = 0x81;

std::string place_text(std::uint16_t bus, std::uint16_t device) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%03u:%03u", static_cast<unsigned>(bus), static_cast<unsigned>(device));
  return text.data();
}

}  // namespace

base::Result<bool> UsbRecording::next(std::string& out) {
  if (ended_) return false;
  while (writer_.pending() < k_piece) {
    const auto packet = capture_.next();
    if (!packet) return packet.error();
    if (!packet->has_value()) {
      ended_ = true;
      break;
    }
    if (!is_usb_link((*packet)->link_type)) {
      other_link_ = (*packet)->link_type;
      continue;
    }
    ++packets_;
    time_us_ = (*packet)->time_us;
    if (const auto usb = read_usb_packet(**packet)) take(*usb);
  }
  if (ended_) {
    if (const auto fine = check_end(); !fine) return fine.error();
    declare_news();
  }
  out += writer_.take();
  if (ended_ && capture_.is_cut()) {
    append_cut_report(out, span_us_, 1, {});
    out.pop_back();
  }
  return !ended_;
}

base::Status UsbRecording::check_end() const {
  constexpr std::string_view k_how =
      "capture usbmon0 on Linux (all buses) or with USBPcap on Windows, and draw meanwhile";
  if (packets_ == 0 && other_link_) {
    return base::Error{
        "is a capture of something else than USB requests (link type " + std::to_string(*other_link_) + ")", "",
        std::string(k_how)};
  }
  if (packets_ == 0) return base::Error{"is a capture without a whole packet", "", std::string(k_how)};
  if (reports_ > 0) return base::Done{};
  return base::Error{"is a capture without reports of a tablet: " + std::to_string(packets_) +
                         (packets_ == 1 ? " packet" : " packets") + " of USB, none of a HID interface",
                     "", std::string(k_how)};
}

void UsbRecording::take(const UsbPacket& packet) {
  if (packet.transfer == UsbTransfer::control) {
    take_control(packet);
  } else if (packet.transfer == UsbTransfer::interrupt && packet.succeeded && (packet.endpoint & 0x80) != 0 &&
             packet.length > 0 && packet.length <= k_most_of_a_report) {
    take_report(packet);
  }
}

void UsbRecording::take_control(const UsbPacket& packet) {
  const Place place{packet.bus, packet.device};
  const std::pair id{place, packet.id};
  if (!packet.is_answer) {
    requests_.erase(id);
    if (!packet.setup) return;
    const std::uint8_t type = (*packet.setup)[0];
    const std::uint8_t request = (*packet.setup)[1];
    const bool asks = request == k_get_descriptor && (type == k_from_device || type == k_from_interface);
    const bool sets = request == k_set_configuration && type == 0;
    if (!asks && !sets) return;
    if (requests_.size() >= k_most_requests) requests_.clear();
    requests_[id] = *packet.setup;
    return;
  }
  const auto found = requests_.find(id);
  if (found == requests_.end()) return;
  const Setup setup = found->second;
  requests_.erase(found);
  // An answer that was captured in part would say less than the device did.
  if (packet.succeeded && packet.data.size() >= packet.length) take_answer(place, setup, packet.data);
}

UsbRecording::Known* UsbRecording::known_at(const Place& place) {
  const auto found = known_.find(place);
  if (found != known_.end()) return &found->second;
  // A device has address 0 only until the host gives it one.
  if (place.second == 0 || known_.size() >= k_most_devices) return nullptr;
  return &known_[place];
}

void UsbRecording::take_answer(const Place& place, const Setup& setup, base::Bytes data) {
  Known* known = known_at(place);
  if (known == nullptr) return;
  const auto index = static_cast<std::uint16_t>(wire_number(setup, 4, 2, false));
  if (setup[1] == k_set_configuration) {
    known->usb.choose_configuration(setup[2]);
    return;
  }
  bool is_news = false;
  switch (setup[3]) {
    case 1: {
      const std::size_t kept = known->usb.kept();
      bool is_other = false;
      is_news = known->usb.take_device(data, is_other);
      if (is_other) {
        descriptor_bytes_ -= kept;
        *known = {known->usb, {}, {}};
      }
      for (auto& [interface, shown] : known->shown) shown.declared = shown.declared && !is_news;
      break;
    }
    case 2:
      is_news = known->usb.take_configuration(data);
      break;
    case 3:
      if (known->usb.strings().size() >= k_most_strings && !known->usb.strings().contains(setup[2])) break;
      is_news = known->usb.take_string(setup[2], index, data);
      if (is_news) known->new_strings.insert(setup[2]);
      break;
    case 0x22: {
      const std::size_t before = known->usb.kept();
      is_news = known->usb.take_report_descriptor(index, data, k_most_descriptor_bytes - descriptor_bytes_);
      descriptor_bytes_ += known->usb.kept() - before;
      if (is_news && known->shown.contains(index)) known->shown[index].declared = false;
      break;
    }
    default:
      break;
  }
  if (is_news) news_.insert(place);
}

/// Where the reports of an endpoint belong; nothing where they are none of HID.
std::optional<int> UsbRecording::shown_interface(Known& known, const UsbPacket& packet) {
  int interface = k_unknown_interface + (packet.endpoint & 15);
  if (known.usb.has_configuration()) {
    const auto told = known.usb.interface_of(packet.endpoint);
    if (!told || !known.usb.is_hid(*told)) return std::nullopt;
    interface = *told;
  } else if (packet.is_root_hub) {
    return std::nullopt;
  } else if (const auto all = known.usb.hid_interfaces(); all.size() == 1) {
    interface = *all.begin();
  }
  if (!known.shown.contains(interface)) {
    if (numbers_ >= k_most_numbers) return std::nullopt;
    known.shown[interface].number = numbers_++;
    news_.insert({packet.bus, packet.device});
  }
  return interface;
}

void UsbRecording::take_report(const UsbPacket& packet) {
  Known* known = known_at({packet.bus, packet.device});
  if (known == nullptr) return;
  // All that is known before a report is declared before it, in the order of buses and addresses.
  declare_news();
  const auto interface = shown_interface(*known, packet);
  if (!interface) return;
  declare_news();
  if (reports_ == 0) first_us_ = time_us_;
  span_us_ = std::max(span_us_, time_us_ - first_us_);
  ++reports_;
  const int number = known->shown[*interface].number;
  writer_.cut_report(number, span_us_, packet.length, packet.data.first(std::min(packet.data.size(), packet.length)));
}

void UsbRecording::declare_news() {
  for (const Place& place : news_) {
    Known& known = known_[place];
    // What endpoints stood for is known now.
    if (known.usb.has_configuration())
      known.shown.erase(known.shown.lower_bound(k_unknown_interface), known.shown.end());
    for (const int interface : known.usb.hid_interfaces()) {
      if (numbers_ < k_most_numbers && !known.shown.contains(interface)) known.shown[interface].number = numbers_++;
    }
    for (auto& [interface, shown] : known.shown) {
      if (!shown.declared && shown.declarations < k_most_declarations) {
        declare(place, known, interface, shown);
      } else {
        for (const int index : known.new_strings) tell_string(known, shown.number, index);
      }
    }
    known.new_strings.clear();
  }
  news_.clear();
}

void UsbRecording::declare(const Place& place, Known& known, int interface, Shown& shown) {
  TraceDevice facts;
  facts.report_descriptor = known.usb.report_descriptor(interface);
  facts.name = known.usb.name();
  facts.physical = "usb-" + place_text(place.first, place.second);
  if (interface < k_unknown_interface) facts.physical += "/input" + std::to_string(interface);
  facts.vendor = known.usb.vendor();
  facts.product = known.usb.product();
  writer_.declare(shown.number, facts);
  for (const auto& [index, text] : known.usb.strings()) tell_string(known, shown.number, index);
  shown.declared = true;
  ++shown.declarations;
}

void UsbRecording::tell_string(const Known& known, int number, int index) {
  writer_.string(number, index, known.usb.string(index));
}

}  // namespace penpose::replay
