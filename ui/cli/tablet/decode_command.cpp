#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "core/base/json/json.h"
#include "firmware_io/decode/decoder_factory.h"
#include "firmware_io/decode/described/described_pad.h"
#include "firmware_io/decode/described/fallback_decoder.h"
#include "firmware_io/decode/layout/protocol.h"
#include "firmware_io/decode/wacom/wacom_receiver.h"
#include "replay/trace/trace_source.h"
#include "ui/cli/subcommand.h"
#include "ui/cli/tablet/hand_decode.h"
#include "ui/cli/tablet/no_rows.h"
#include "ui/cli/tablet/sample_printer.h"
#include "ui/cli/tablet/tablet_options.h"
#include "ui/cli/tablet/trace_output.h"
#include "ui/files/files.h"
#include "ui/files/trace_file.h"

namespace penpose::cli {
namespace {

struct DecodeOptions {
  std::string trace;
  std::string protocol;
  files::OwnTablets own;
  bool csv = false;
  bool pad = false;
  bool touch = false;
  bool json = false;
};

/// One interface of the trace.
struct DecodedInterface {
  std::unique_ptr<decode::PenDecoder> decoder;  ///< null: nothing to read here
  std::string method;
  std::string guess;                        ///< which of several tablets it is read as; empty where something tells
  decode::ForeignReports desktop{};         ///< of a mouse or keyboard, by report id
  std::optional<decode::DescribedPad> pad;  ///< keys of the tablet, which are not printed here
  bool has_report_ids = false;
  bool is_anew = false;    ///< declared again behind its reports: a decoder is to be chosen
  bool axes_told = false;  ///< with its first sample
  bool guessed = false;    ///< samples were read by the guess
};

class DecodeRun {
 public:
  DecodeRun(const DecodeOptions& options, const decode::TabletTable* own) : options_(options), own_(own) {}

  int run();

 private:
  base::Result<std::size_t> count_devices();
  base::Status decode(replay::TraceSource& source);
  DecodedInterface& interface_for(const replay::TraceSource& source, int device);
  void begin(int device);
  void read_as(DecodedInterface& interface, const decode::DeviceIdentity& identity);
  void hear(const replay::TraceReport& report);
  void print(const replay::TraceReport& report, DecodedInterface& interface);
  void begin_output(const decode::PenAxes& axes);
  [[nodiscard]] std::string shown(const decode::PenAxes& axes) const;
  void tell_axes(int device, const decode::PenAxes& axes);
  void end_output(const replay::TraceSource& source);

  const DecodeOptions& options_;
  const decode::TabletTable* own_;
  decode::WacomReceivers receivers_;
  std::map<int, DecodedInterface> interfaces_;
  std::set<int> begun_devices_;
  std::string out_;
  RowlessReports rowless_;  ///< `all` counts every report
  bool with_device_ = false;
  bool begun_ = false;
  std::uint64_t samples_ = 0;
  std::string first_axes_;                ///< as they are printed, those at the top
  std::map<int, std::string> told_axes_;  ///< of devices, those of the samples printed last
  std::set<std::string> guesses_;         ///< that samples were read by
};

/// Looks ahead for the `device` column; a pipe cannot be read twice, there only what comes before the first report
/// counts.
base::Result<std::size_t> DecodeRun::count_devices() {
  std::error_code code;
  if (!std::filesystem::is_regular_file(options_.trace, code)) return std::size_t{0};
  auto file = files::open_trace(options_.trace);
  if (!file) return file.error();
  replay::TraceReader reader(files::read_recording_file(file->get()));
  std::map<int, bool> devices;
  int device = 0;
  for (;;) {
    const auto line = reader.next();
    if (!line) return line.error();
    if (!line->has_value()) return devices.size();
    const auto kind = (*line)->kind;
    if (kind == replay::TraceLineKind::device) {
      device = (*line)->device;
    } else if (kind != replay::TraceLineKind::other) {
      devices[device] = true;
    }
  }
}

DecodedInterface& DecodeRun::interface_for(const replay::TraceSource& source, int device) {
  const auto found = interfaces_.find(device);
  if (found != interfaces_.end() && !found->second.is_anew) return found->second;
  DecodedInterface& made = interfaces_[device];
  made.is_anew = false;
  if (!options_.protocol.empty()) {
    made.decoder = decode::make_protocol_decoder(options_.protocol);
    made.method = "protocol " + options_.protocol;
    return made;
  }
  const auto declared = source.devices().find(device);
  read_as(made,
          declared == source.devices().end() ? decode::DeviceIdentity{} : receivers_.connect(device, declared->second));
  return made;
}

void DecodeRun::read_as(DecodedInterface& interface, const decode::DeviceIdentity& identity) {
  if (const auto parsed = hid::parse_report_descriptor(identity.report_descriptor, hid::Strictness::tolerant)) {
    interface.desktop = decode::find_foreign_reports(*parsed);
    interface.pad = decode::find_described_pad(*parsed);
    interface.has_report_ids = parsed->has_report_ids;
  }
  auto recognition = decode::make_decoder(identity, own_);
  if (recognition) {
    interface.decoder = std::move(recognition->decoder);
    interface.method = recognition->method;
    interface.guess = recognition->guess;
    interface.axes_told = false;
  } else {
    interface.decoder.reset();
    if (rowless_.refusals++ == 0) {
      rowless_.refusal = recognition.error();
      rowless_.refused = identity;
    }
  }
}

/// Its reports begin, or begin again: another recording in the same file, or a tablet that was plugged in again.
void DecodeRun::begin(int device) {
  if (begun_devices_.insert(device).second) return;
  DecodedInterface& anew = interfaces_[device];
  anew = {};
  anew.is_anew = true;
}

/// Behind a wireless receiver is another tablet from now on.
void DecodeRun::hear(const replay::TraceReport& report) {
  for (const auto& [device, identity] : receivers_.report(report.device, report.bytes)) {
    if (!decode::is_receiver_monitor(identity)) read_as(interfaces_[device], identity);
  }
}

void DecodeRun::begin_output(const decode::PenAxes& axes) {
  begun_ = true;
  first_axes_ = shown(axes);
  if (options_.json) {
    out_ += "{\"axes\": {" + first_axes_ + "},\n\"samples\": [";
  } else {
    append_csv_header(out_, axes, with_device_);
  }
}

/// Axes as they are printed.
std::string DecodeRun::shown(const decode::PenAxes& axes) const {
  std::string text;
  options_.json ? append_json_axes(text, axes) : append_csv_axes(text, axes);
  return text;
}

/// The axes of a device's samples from here on, if they are others than those before: lines before the first row, or a
/// member of the first sample.
void DecodeRun::tell_axes(int device, const decode::PenAxes& axes) {
  std::string& told = told_axes_.try_emplace(device, first_axes_).first->second;
  std::string now = shown(axes);
  if (now != told) {
    if (options_.json) {
      out_ += ", \"axes\": {" + now + '}';
    } else {
      if (with_device_) out_ += "# device " + std::to_string(device) + '\n';
      out_ += now;
    }
  }
  told = std::move(now);
}

void DecodeRun::end_output(const replay::TraceSource& source) {
  if (!begun_) {
    const decode::PenAxes none;
    const decode::PenAxes* axes = &none;
    for (const auto& [device, interface] : interfaces_) {
      if (interface.decoder && axes == &none) axes = &interface.decoder->axes();
    }
    begin_output(*axes);
  }
  if (options_.json) {
    out_ += "],\n\"devices\": [";
    bool first = true;
    for (const auto& [number, device] : source.devices()) {
      const auto interface = interfaces_.find(number);
      const bool read = interface != interfaces_.end() && interface->second.decoder;
      out_ += first ? "\n" : ",\n";
      first = false;
      out_ += "{\"device\": " + std::to_string(number) + ", \"vendor\": " + std::to_string(device.vendor) +
              ", \"product\": " + std::to_string(device.product) + ", \"name\": ";
      json::append_text(out_, device.name);
      out_ += ", \"method\": ";
      if (read) {
        json::append_text(out_, interface->second.method);
      } else {
        out_ += "null";
      }
      out_ += ", \"guess\": ";
      append_json_guess(out_, read && interface->second.guessed ? interface->second.guess : std::string());
      out_ += '}';
    }
    out_ += "],\n\"reports\": " + std::to_string(rowless_.all) + "}\n";
  }
  print_gathered(out_, 0);
  std::cout.flush();
}

void DecodeRun::print(const replay::TraceReport& report, DecodedInterface& interface) {
  for (const decode::PenSample& sample : interface.decoder->frames()) {
    const decode::PenAxes& axes = interface.decoder->axes();
    if (!begun_) begin_output(axes);
    const bool told = std::exchange(interface.axes_told, true);
    const PrintedSample printed{report.index, report.time_us, report.device, &sample, &axes};
    if (options_.json) {
      out_ += samples_ == 0 ? "\n{" : ",\n{";
      append_json_sample(out_, printed);
      if (!told) tell_axes(report.device, axes);
      out_ += '}';
    } else {
      if (!told) tell_axes(report.device, axes);
      append_csv_row(out_, printed, with_device_);
    }
    ++samples_;
  }
  print_gathered(out_, std::size_t{1} << 16);
}

base::Status DecodeRun::decode(replay::TraceSource& source) {
  return each_report(source, [&](const replay::TraceReport& report) {
    ++rowless_.all;
    DecodedInterface& interface = interface_for(source, report.device);
    hear(report);
    const std::size_t id = interface.has_report_ids && !report.bytes.empty() ? report.bytes[0] : 0;
    if (interface.pad && interface.pad->has(report.bytes)) {
      // Keys of the tablet, which --pad prints.
    } else if (interface.desktop[id] != 0 && interface.desktop[id] == report.bytes.size()) {
      ++rowless_.desktop;
    } else if (!interface.decoder) {
      ++rowless_.unread;
    }
    if (interface.decoder && interface.decoder->decode(report.bytes) == decode::ReportKind::pen) {
      print(report, interface);
      if (!interface.guess.empty() && interface.decoder->by_table()) {
        interface.guessed = true;
        guesses_.insert(interface.guess);
      }
    }
  });
}

int DecodeRun::run() {
  const auto devices = count_devices();
  if (!devices) return files::report(devices.error(), options_.trace);
  auto file = files::open_trace(options_.trace);
  if (!file) return files::report(file.error(), options_.trace);
  replay::TraceSource source(files::read_recording_file(file->get()));
  source.listen({}, [this](int device, const decode::DeviceIdentity&) { begin(device); });
  if (const auto header = source.read_header(); !header) return files::report(header.error(), options_.trace);
  with_device_ = *devices > 1 || source.devices().size() > 1;
  for (const auto& [number, device] : source.devices()) {
    // Those of a receiver first: one of them says what the others bring.
    if (decode::is_wacom_receiver(device)) (void)interface_for(source, number);
  }
  const auto done = decode(source);
  if (!done) return files::report(done.error(), options_.trace);
  end_output(source);
  if (const int status = end_of_trace(source, options_.trace, rowless_.all); status != k_success) return status;
  if (samples_ == 0) std::cerr << "penpose: " << why_no_rows(rowless_).line(options_.trace) << '\n';
  warn_of_guesses(guesses_, options_.trace);
  return k_success;
}

int decode_trace(const DecodeOptions& options) {
  if (!options.protocol.empty() && decode::make_protocol_decoder(options.protocol) == nullptr) {
    return files::report({"no protocol is named \"" + options.protocol + "\"", "",
                          "`penpose devices --known` lists them with their tablets"});
  }
  const auto own = files::read_own_tablets(options.own);
  if (!own) return files::report(own.error());
  if (options.pad || options.touch) {
    const HandPart part = options.pad ? HandPart::pad : HandPart::touch;
    return decode_hands({options.trace, options.protocol, part, options.json}, &*own);
  }
  return DecodeRun(options, &*own).run();
}

void add_options(const Command& command, DecodeOptions& options) {
  command
      .add_option("trace", options.trace,
                  "Recording of a tablet: of penpose, hid-recorder, usbhid-dump, evemu, OpenTabletDriver or usbmon")
      .required();
  const Option csv = command.add_flag("--csv", options.csv, "Comma-separated rows (the default)");
  command.add_flag("--json", options.json, "One JSON object").excludes(csv);
  const Option pad =
      command.add_flag("--pad", options.pad, "Keys, rings, strips and wheels of the tablet instead of its pen");
  command.add_flag("--touch", options.touch, "Fingers on the tablet instead of its pen").excludes(pad);
  command.add_option("--protocol", options.protocol,
                     "Read every report with this protocol, whatever the trace's device is");
  add_tablet_options(command, options.own);
}

}  // namespace

Subcommand decode_subcommand() {
  return subcommand<DecodeOptions>("decode", files::Rights::reads_only,
                                   "Prints what pen or hand did in a recording of raw reports", add_options,
                                   decode_trace, {"penpose decode pen.hid --csv", "the pen, sample by sample"},
                                   {"penpose decode pen.hid --pad", "what the keys and rings of the tablet did"},
                                   {{"--protocol", Completes::nothing}, {"--tablet", Completes::nothing}});
}

}  // namespace penpose::cli
