#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/base/numbers.h"
#include "replay/recording/byte_stream.h"
#include "replay/recording/formats.h"
#include "replay/recording/hex_line.h"
#include "replay/trace/trace_writer.h"

namespace penpose::replay {
namespace {

constexpr std::int64_t k_micros = 1000000;
constexpr std::uint64_t k_latest_second = 9'000'000'000'000;
/// More interfaces than are at all USB buses of a machine.
constexpr std::size_t k_most_dumped_interfaces = 4096, k_most_told_devices = 4096;

struct BusDevice {
  int bus = 0;
  int device = 0;
  auto operator<=>(const BusDevice&) const = default;
};

enum class Entity : std::uint8_t { descriptor, stream };

/// "BUS:DEVICE:INTERFACE:ENTITY TIMESTAMP", as the manual page of usbhid-dump describes it.
struct DumpHeader {
  BusDevice where;
  int interface_number = 0;
  Entity entity = Entity::stream;
  std::int64_t time_us = 0;
};

std::optional<int> byte_number(std::string_view text) {
  const auto value = text.size() <= 3 ? decimal_number(text, 255) : std::nullopt;
  if (!value) return std::nullopt;
  return static_cast<int>(*value);
}

std::optional<std::int64_t> epoch_time(std::string_view text) {
  const std::size_t point = text.find('.');
  if (point == std::string_view::npos || text.size() - point != 7) return std::nullopt;
  const auto seconds = decimal_number(text.substr(0, point), k_latest_second);
  const auto micros = decimal_number(text.substr(point + 1), k_micros - 1);
  if (!seconds || !micros) return std::nullopt;
  return static_cast<std::int64_t>(*seconds) * k_micros + static_cast<std::int64_t>(*micros);
}

std::optional<DumpHeader> dump_header(std::string_view line) {
  std::string_view rest = line;
  std::string_view address = next_word(rest);
  std::vector<int> numbers;
  for (std::size_t colon = address.find(':'); colon != std::string_view::npos; colon = address.find(':')) {
    const auto value = byte_number(address.substr(0, colon));
    if (!value || numbers.size() == 3) return std::nullopt;
    numbers.push_back(*value);
    address.remove_prefix(colon + 1);
  }
  // Editions of 2010 wrote the interface alone.
  if (numbers.size() == 1) numbers.insert(numbers.begin(), 2, 0);
  if (numbers.size() != 3) return std::nullopt;
  if (address != "DESCRIPTOR" && address != "STREAM") return std::nullopt;
  const auto time = epoch_time(next_word(rest));
  if (!time || !next_word(rest).empty()) return std::nullopt;
  return DumpHeader{
      {numbers[0], numbers[1]}, numbers[2], address == "STREAM" ? Entity::stream : Entity::descriptor, *time};
}

bool marks_usbhid_dump(std::string_view line) { return dump_header(line).has_value(); }

/// What text around a dump says of a device, which the dump itself does not: its ids and name.
struct ToldDevice {
  UsbIds ids;
  std::string name;
};

/// Ids that people write beside a dump: lines of lsusb, and the command that made it.
class ToldDevices {
 public:
  void read(std::string_view line) {
    // "Bus 003 Device 004: ID 256c:006e HUION"
    std::string_view rest = line;
    if (next_word(rest) == "Bus") {
      const auto bus = byte_number(next_word(rest));
      const bool device_follows = next_word(rest) == "Device";
      std::string_view number = next_word(rest);
      const bool id_follows = next_word(rest) == "ID";
      if (!bus || !device_follows || !id_follows || !number.ends_with(':')) return;
      number.remove_suffix(1);
      const auto device = byte_number(number);
      const auto ids = usb_ids(next_word(rest));
      if (device && ids && devices_.size() < k_most_told_devices)
        devices_[{*bus, *device}] = {*ids, std::string(base::trim(rest))};
      return;
    }
    // "$ sudo usbhid-dump -m 256c:006e -es"
    const std::size_t command = line.find("usbhid-dump ");
    if (command == std::string_view::npos) return;
    rest = line.substr(command);
    for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
      if (word == "-m" || word == "-d" || word == "--model") {
        word = next_word(rest);
      } else if (word.starts_with("--model=")) {
        word.remove_prefix(8);
      } else if (word.starts_with("-m") || word.starts_with("-d")) {
        word.remove_prefix(2);
      } else {
        continue;
      }
      if (const auto ids = usb_ids(word)) asked_ = *ids;
    }
  }

  [[nodiscard]] ToldDevice of(BusDevice where) const {
    const auto found = devices_.find(where);
    return found != devices_.end() ? found->second : ToldDevice{asked_, {}};
  }

 private:
  std::map<BusDevice, ToldDevice> devices_;
  UsbIds asked_;
};

/// Blocks of a header and lines of bytes as lines of a trace.
class UsbhidDump final : public LineConverter {
 public:
  explicit UsbhidDump(ToldDevices told) : told_(std::move(told)) {}

  base::Status line(std::string_view text, std::string& out) override {
    if (const auto header = dump_header(text)) {
      end_block(out);
      header_ = header;
      return base::Done{};
    }
    std::string_view rest = text;
    const std::string_view first = next_word(rest);
    if (header_ && first.size() == 2 && usb_id(first)) {
      whole_ = append_hex_words(text, bytes_) && whole_;
      return base::Done{};
    }
    end_block(out);
    told_.read(text);
    return base::Done{};
  }

  void finish(std::string& out) override { end_block(out); }

 private:
  void end_block(std::string& out) {
    if (header_ && !whole_) {
      out += k_unreadable_line;
    } else if (header_ && !bytes_.empty()) {
      write_block(*header_);
      out += writer_.take();
    }
    header_.reset();
    bytes_.clear();
    whole_ = true;
  }

  void write_block(const DumpHeader& header) {
    const std::pair key{header.where, header.interface_number};
    const auto found = numbers_.find(key);
    const bool is_new = found == numbers_.end();
    if (is_new && numbers_.size() >= k_most_dumped_interfaces) return;
    const int number = is_new ? static_cast<int>(numbers_.size()) : found->second;
    if (is_new) numbers_[key] = number;
    if (is_new || header.entity == Entity::descriptor) declare(header, number);
    if (header.entity == Entity::descriptor) return;
    if (!first_us_) first_us_ = header.time_us;
    last_us_ = std::max(last_us_, header.time_us - *first_us_);
    writer_.report(number, last_us_, bytes_);
  }

  void declare(const DumpHeader& header, int number) {
    const ToldDevice told = told_.of(header.where);
    TraceDevice device;
    if (header.entity == Entity::descriptor) device.report_descriptor = bytes_;
    device.name = told.name;
    device.physical = "usb-" + std::to_string(header.where.bus) + ":" + std::to_string(header.where.device) + "/input" +
                      std::to_string(header.interface_number);
    device.vendor = told.ids.vendor;
    device.product = told.ids.product;
    writer_.declare(number, device);
  }

  ToldDevices told_;
  std::map<std::pair<BusDevice, int>, int> numbers_;  ///< of the trace's devices
  std::optional<DumpHeader> header_;                  ///< of the block that is read
  std::vector<std::uint8_t> bytes_;
  bool whole_ = true;
  std::optional<std::int64_t> first_us_;  ///< of the first report since the epoch
  std::int64_t last_us_ = 0;              ///< since then
  TraceWriter writer_;
};

ReadBytes convert_usbhid_dump(ReadBytes read) {
  auto bytes = std::make_shared<ByteStream>(std::move(read));
  // What is told of the devices may also stand behind the first dump.
  ToldDevices told;
  if (const auto front = bytes->peek(k_front)) {
    find_line(*front, [&](std::string_view line) {
      told.read(line);
      return false;
    });
  }
  return convert_lines([bytes](std::span<std::uint8_t> into) { return bytes->read(into); },
                       std::make_shared<UsbhidDump>(std::move(told)));
}

}  // namespace

RecordingFormat usbhid_dump_recording() {
  return {"usbhid-dump", nullptr, marks_usbhid_dump, convert_usbhid_dump, nullptr};
}

}  // namespace penpose::replay
