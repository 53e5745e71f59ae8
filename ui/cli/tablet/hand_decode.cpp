#include "ui/cli/tablet/hand_decode.h"

#include <iostream>
#include <map>
#include <memory>
#include <set>

#include "firmware_io/decode/hand_factory.h"
#include "firmware_io/decode/wacom/wacom_receiver.h"
#include "replay/session/touch_switches.h"
#include "replay/trace/trace_source.h"
#include "ui/cli/commands.h"
#include "ui/cli/tablet/hand_printer.h"
#include "ui/cli/tablet/no_rows.h"
#include "ui/cli/tablet/trace_output.h"
#include "ui/files/files.h"
#include "ui/files/trace_file.h"

namespace penpose::cli {
namespace {

/// One interface of the trace, and what was last printed of it.
struct Interface {
  decode::HandDecoders hand;
  decode::PadSample printed;
  std::shared_ptr<decode::TouchSwitch> touch_switch;  ///< the tablet's; null where reports are read by a protocol
};

class HandRun {
 public:
  HandRun(const HandDecodeOptions& options, const decode::TabletTable* own)
      : options_(options), own_(own), switches_(own) {}

  int run();

 private:
  base::Status decode(replay::TraceSource& source);
  Interface& interface_for(const replay::TraceSource& source, int device);
  void print_pad(const replay::TraceReport& report, Interface& interface);
  void print_touch(const replay::TraceReport& report, const Interface& interface);
  void make_decoders(Interface& interface, int device, const decode::DeviceIdentity& identity);
  void end_frames_early(const replay::TraceReport& report, const decode::TouchSwitch* told);
  void hear(const replay::TraceReport& report);
  void begin(int device);
  void begin_row(const Interface& interface);
  void end_output(const replay::TraceSource& source);

  const HandDecodeOptions& options_;
  const decode::TabletTable* own_;
  replay::TouchSwitches switches_;
  decode::WacomReceivers receivers_;
  std::map<int, Interface> interfaces_;
  std::set<int> begun_devices_;
  std::set<std::string> guesses_;  ///< that rows were read by
  std::string out_;
  bool with_device_ = false;
  std::uint64_t rows_ = 0;
  std::uint64_t reports_ = 0;
};

void HandRun::make_decoders(Interface& interface, int device, const decode::DeviceIdentity& identity) {
  interface.touch_switch = switches_.join(device, identity);
  interface.hand = decode::make_hand_decoders(identity, own_, interface.touch_switch);
}

Interface& HandRun::interface_for(const replay::TraceSource& source, int device) {
  const auto found = interfaces_.find(device);
  if (found != interfaces_.end()) return found->second;
  Interface& made = interfaces_[device];
  const auto declared = source.devices().find(device);
  if (!options_.protocol.empty()) {
    made.hand = decode::make_protocol_hand_decoders(options_.protocol);
  } else if (declared != source.devices().end()) {
    make_decoders(made, device, receivers_.connect(device, declared->second));
  }
  return made;
}

/// Its reports begin, or begin again: another recording in the same file, or a tablet that was plugged in again.
void HandRun::begin(int device) {
  if (begun_devices_.insert(device).second) return;
  interfaces_.erase(device);
  switches_.leave(device);
}

void HandRun::begin_row(const Interface& interface) {
  if (!interface.hand.guess.empty()) guesses_.insert(interface.hand.guess);
  if (options_.json) out_ += rows_ == 0 ? "\n{" : ",\n{";
  ++rows_;
}

void HandRun::print_pad(const replay::TraceReport& report, Interface& interface) {
  const decode::PadSample& sample = interface.hand.pad->sample();
  decode::PadSample still = sample;
  still.wheel = {};
  still.fine_wheel = {};
  if (still == interface.printed && sample.wheel == still.wheel && sample.fine_wheel == still.fine_wheel) return;
  interface.printed = still;
  begin_row(interface);
  const PrintedPad printed{report.index, report.time_us, report.device, &sample, &interface.hand.pad->features()};
  if (options_.json) {
    append_json_pad(out_, printed, interface.hand.pad->battery());
  } else {
    append_csv_pad(out_, printed, with_device_);
  }
}

void HandRun::print_touch(const replay::TraceReport& report, const Interface& interface) {
  begin_row(interface);
  const PrintedTouch printed{report.index, report.time_us, report.device, interface.hand.touch->contacts()};
  if (options_.json) {
    append_json_touch(out_, printed);
  } else {
    append_csv_touch(out_, printed, with_device_);
  }
}

/// The key or slide that turns off a tablet's fingers was told of, which shows what the fingers' own interface has said
/// so far.
void HandRun::end_frames_early(const replay::TraceReport& report, const decode::TouchSwitch* told) {
  for (auto& [device, interface] : interfaces_) {
    if (interface.touch_switch.get() != told || !interface.hand.touch || !interface.hand.touch->end_early()) continue;
    replay::TraceReport here = report;
    here.device = device;
    print_touch(here, interface);
  }
}

/// Behind a wireless receiver is another tablet from now on.
void HandRun::hear(const replay::TraceReport& report) {
  if (!options_.protocol.empty()) return;
  for (const auto& [device, identity] : receivers_.report(report.device, report.bytes)) {
    if (decode::is_receiver_monitor(identity)) continue;
    make_decoders(interfaces_[device], device, identity);
  }
}

base::Status HandRun::decode(replay::TraceSource& source) {
  return each_report(source, [&](const replay::TraceReport& report) {
    ++reports_;
    Interface& interface = interface_for(source, report.device);
    // Both get every report: a key of the pad may turn off the fingers.
    hear(report);
    const auto touch_switch = interface.touch_switch;
    const unsigned told = touch_switch ? touch_switch->told : 0;
    const bool pad = interface.hand.pad && interface.hand.pad->decode(report.bytes);
    const bool touch = interface.hand.touch && interface.hand.touch->decode(report.bytes);
    if (options_.part == HandPart::pad && pad) print_pad(report, interface);
    if (options_.part == HandPart::touch && touch) print_touch(report, interface);
    if (options_.part == HandPart::touch && touch_switch && touch_switch->told != told)
      end_frames_early(report, touch_switch.get());
    print_gathered(out_, std::size_t{1} << 16);
  });
}

void HandRun::end_output(const replay::TraceSource& source) {
  if (options_.json) {
    out_ += "],\n\"devices\": [";
    bool first = true;
    for (const auto& [number, device] : source.devices()) {
      const auto& hand = interface_for(source, number).hand;
      out_ += first ? "\n{" : ",\n{";
      first = false;
      append_json_hand(out_, number, device.name, hand);
      out_ += '}';
    }
    out_ += "]}\n";
  }
  print_gathered(out_, 0);
  std::cout.flush();
}

int HandRun::run() {
  auto file = files::open_trace(options_.trace);
  if (!file) return files::report(file.error(), options_.trace);
  replay::TraceSource source(files::read_recording_file(file->get()));
  source.listen({}, [this](int device, const decode::DeviceIdentity&) { begin(device); });
  if (const auto header = source.read_header(); !header) return files::report(header.error(), options_.trace);
  with_device_ = source.devices().size() > 1;
  // All interfaces first: what one has may bear on the others from the first report.
  for (const auto& [number, device] : source.devices()) (void)interface_for(source, number);
  if (options_.json) {
    out_ += options_.part == HandPart::pad ? "{\"pad\": [" : "{\"touch\": [";
  } else if (options_.part == HandPart::pad) {
    append_csv_pad_header(out_, with_device_);
  } else {
    append_csv_touch_header(out_, with_device_);
  }
  const auto done = decode(source);
  if (!done) return files::report(done.error(), options_.trace);
  end_output(source);
  const int status = end_of_trace(source, options_.trace, reports_);
  if (status == k_success && rows_ == 0) {
    const base::Error none{reports_in_words(reports_) + ", none " +
                               (options_.part == HandPart::pad ? "of keys, rings or wheels" : "of fingers") +
                               " that are known of this tablet",
                           "", "without --pad and --touch the pen is printed"};
    std::cerr << "penpose: " << (reports_ == 0 ? why_no_rows({}) : none).line(options_.trace) << '\n';
  }
  if (status == k_success) warn_of_guesses(guesses_, options_.trace);
  return status;
}

}  // namespace

int decode_hands(const HandDecodeOptions& options, const decode::TabletTable* own) {
  return HandRun(options, own).run();
}

}  // namespace penpose::cli
