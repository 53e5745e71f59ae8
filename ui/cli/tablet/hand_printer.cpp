#include "ui/cli/tablet/hand_printer.h"

#include <algorithm>
#include <tuple>
#include <vector>

#include "core/base/json/json.h"
#include "core/base/numbers.h"
#include "ui/cli/tablet/sample_printer.h"
#include "ui/cli/tablet/trace_output.h"

namespace penpose::cli {
namespace {

void append_start(std::string& out, std::uint64_t report, std::int64_t time_us) {
  out += std::to_string(report);
  out += ',';
  out += std::to_string(time_us);
  out += ',';
}

void append_device(std::string& out, int device, bool with_device) {
  if (with_device) out += ',' + std::to_string(device);
  out += '\n';
}

/// The rows say what Linux's driver says. It means to send KEY_PROG3 for the third of the keys beside the numbered
/// ones, but adds to the code of the first, where another key lies that its pads do not have: nothing comes of it. The
/// window and the JSON have that key.
constexpr decode::PadKeys k_lost_in_linux{decode::PadKey::program3};

/// In the order in which people read them, whatever order they were put down in.
std::vector<decode::TouchContact> sorted(std::span<const decode::TouchContact> contacts) {
  std::vector<decode::TouchContact> list(contacts.begin(), contacts.end());
  std::sort(list.begin(), list.end(),
            [](const auto& a, const auto& b) { return std::tuple(a.x, a.y, a.id) < std::tuple(b.x, b.y, b.id); });
  return list;
}

template <typename Values>
void append_json_list(std::string& out, const char* name, const Values& values, unsigned count) {
  if (count == 0) return;
  out += ", \"" + std::string(name) + "\": [";
  for (unsigned i = 0; i < count; ++i) out += (i == 0 ? "" : ", ") + std::to_string(values[i]);
  out += ']';
}

void append_json_names(std::string& out, const decode::PadKeys& keys) {
  out += '[';
  bool first = true;
  keys.for_each([&](decode::PadKey key) {
    out += (first ? "\"" : ", \"") + decode::key_name(key) + '"';
    first = false;
  });
  out += ']';
}

void append_json_axis(std::string& out, const char* name, const decode::Axis& axis) {
  out += ", \"" + std::string(name) + "\": [" + std::to_string(axis.minimum) + ", " + std::to_string(axis.maximum) +
         ", " + base::format_double(axis.units_per_mm) + ']';
}

}  // namespace

void append_csv_pad_header(std::string& out, bool with_device) {
  out += "report,time_us,keys,ring,ring2,strip,strip2,wheel,hwheel";
  out += with_device ? ",device\n" : "\n";
}

void append_csv_pad(std::string& out, const PrintedPad& printed, bool with_device) {
  const decode::PadSample& sample = *printed.sample;
  append_start(out, printed.report, printed.time_us);
  out += decode::key_names(sample.keys - k_lost_in_linux);
  const auto positions = [&](const auto& values, unsigned count) {
    for (unsigned i = 0; i < decode::k_pad_sides; ++i) {
      out += ',';
      if (i < count) out += std::to_string(values[i]);
    }
  };
  positions(sample.ring, printed.features->rings);
  positions(sample.strip, printed.features->strips);
  for (const std::int32_t steps : sample.wheel) out += ',' + std::to_string(steps);
  append_device(out, printed.device, with_device);
}

void append_csv_touch_header(std::string& out, bool with_device) {
  out += "report,time_us,contacts";
  out += with_device ? ",device\n" : "\n";
}

void append_csv_touch(std::string& out, const PrintedTouch& printed, bool with_device) {
  append_start(out, printed.report, printed.time_us);
  if (printed.contacts.empty()) out += '-';
  bool first = true;
  for (const auto& contact : sorted(printed.contacts)) {
    if (!first) out += ' ';
    first = false;
    out += std::to_string(contact.x) + ':' + std::to_string(contact.y);
  }
  append_device(out, printed.device, with_device);
}

void append_json_pad(std::string& out, const PrintedPad& printed, const decode::Battery& battery) {
  const decode::PadSample& sample = *printed.sample;
  const decode::PadFeatures& has = *printed.features;
  out += "\"report\": " + std::to_string(printed.report) + ", \"time_us\": " + std::to_string(printed.time_us) +
         ", \"device\": " + std::to_string(printed.device) + ", \"keys\": ";
  append_json_names(out, sample.keys);
  append_json_list(out, "rings", sample.ring, has.rings);
  append_json_list(out, "strips", sample.strip, has.strips);
  append_json_list(out, "wheels", sample.wheel, has.wheels);
  append_json_list(out, "wheels_120", sample.fine_wheel, has.wheels);
  append_json_list(out, "modes", sample.mode, has.modes);
  if (battery.percent >= 0) {
    out += ", \"battery\": " + std::to_string(battery.percent) + ", \"charging\": ";
    out += battery.charging ? "true" : "false";
  }
  out += '}';
}

void append_json_touch(std::string& out, const PrintedTouch& printed) {
  out += "\"report\": " + std::to_string(printed.report) + ", \"time_us\": " + std::to_string(printed.time_us) +
         ", \"device\": " + std::to_string(printed.device) + ", \"contacts\": [";
  bool first = true;
  for (const auto& contact : sorted(printed.contacts)) {
    out += first ? "{" : ", {";
    first = false;
    out += "\"id\": " + std::to_string(contact.id) + ", \"x\": " + std::to_string(contact.x) +
           ", \"y\": " + std::to_string(contact.y) + '}';
  }
  out += "]}";
}

void append_json_hand(std::string& out, int device, const std::string& name, const decode::HandDecoders& hand) {
  out += "\"device\": " + std::to_string(device) + ", \"name\": ";
  json::append_text(out, name);
  out += ", \"guess\": ";
  append_json_guess(out, hand.guess);
  if (hand.pad) {
    const decode::PadFeatures& has = hand.pad->features();
    out += ", \"pad\": {\"keys\": ";
    append_json_names(out, has.keys);
    out += ", \"rings\": " + std::to_string(has.rings) + ", \"ring_maximum\": " + std::to_string(has.ring_maximum) +
           ", \"strips\": " + std::to_string(has.strips) + ", \"wheels\": " + std::to_string(has.wheels) +
           ", \"modes\": " + std::to_string(has.modes) + ", \"lights\": " + std::to_string(has.lights) + '}';
  }
  if (hand.touch) {
    out += ", \"touch\": {\"contacts\": " + std::to_string(hand.touch->axes().contacts);
    append_json_axis(out, "x", hand.touch->axes().x);
    append_json_axis(out, "y", hand.touch->axes().y);
    out += '}';
  }
}

}  // namespace penpose::cli
