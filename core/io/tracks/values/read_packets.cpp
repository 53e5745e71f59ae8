#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/math.h"
#include "core/base/numbers.h"
#include "core/base/text/letters.h"
#include "core/io/text/text_lines.h"
#include "core/io/tracks/read_track.h"
#include "core/io/tracks/values/value_rows.h"
#include "core/io/tracks/values/value_tables.h"

namespace penpose::io {
namespace {

constexpr double k_packet_fps = 60;

/// Holds one part of a packet: the weight of a shape, or the turn of the head or an eye.
struct PacketPart {
  std::string_view name;
  std::vector<double> numbers;
  bool turns = false;
};

std::vector<double> numbers_in(std::string_view list) {
  std::vector<double> numbers;
  while (!list.empty()) {
    const std::size_t comma = std::min(list.find(','), list.size());
    const auto number = base::parse_double(base::trim(list.substr(0, comma)));
    if (!number || !std::isfinite(*number)) return {};
    numbers.push_back(*number);
    list.remove_prefix(std::min(comma + 1, list.size()));
  }
  return numbers;
}

std::optional<PacketPart> part_of(std::string_view text) {
  text = base::trim(text);
  if (text.starts_with('=')) text.remove_prefix(1);
  const std::size_t hash = text.find('#');
  const std::size_t sign = hash == std::string_view::npos ? text.find_first_of("&-") : hash;
  if (sign == std::string_view::npos || sign == 0) return std::nullopt;
  PacketPart part{text.substr(0, sign), numbers_in(text.substr(sign + 1)), hash != std::string_view::npos};
  const bool known = std::all_of(part.name.begin(), part.name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
  });
  if (!known || part.numbers.empty() || (!part.turns && part.numbers.size() != 1)) return std::nullopt;
  return part;
}

/// A packet in a line, and what stands before it.
struct Packet {
  std::string_view time;
  std::vector<PacketPart> parts;
};

Packet packet_in(std::string_view line) {
  Packet packet;
  line = base::trim(line);
  // Python prints bytes this way.
  const std::size_t quote = line.find("b'");
  if (quote != std::string_view::npos && line.ends_with('\'')) {
    packet.time = base::trim(line.substr(0, quote));
    line = line.substr(quote + 2, line.size() - quote - 3);
  } else if (const std::size_t bar = line.find('|'); bar != std::string_view::npos) {
    const std::string_view first = line.substr(0, bar);
    const std::size_t gap = first.find_last_of(" \t,;");
    if (base::parse_double(first)) {
      packet.time = first;
      line.remove_prefix(bar + 1);
    } else if (gap != std::string_view::npos && !first.starts_with('=')) {
      packet.time = base::trim(first.substr(0, gap));
      line.remove_prefix(gap + 1);
    }
  }
  while (!packet.time.empty() && std::string_view(" \t,;[]()\"").find(packet.time.back()) != std::string_view::npos)
    packet.time.remove_suffix(1);
  while (!packet.time.empty() && std::string_view(" [(\"").find(packet.time.front()) != std::string_view::npos)
    packet.time.remove_prefix(1);
  while (!line.empty()) {
    const std::size_t bar = std::min(line.find('|'), line.size());
    if (auto part = part_of(line.substr(0, bar))) packet.parts.push_back(*std::move(part));
    line.remove_prefix(std::min(bar + 1, line.size()));
  }
  return packet;
}

/// The columns of a turn: pitch, yaw and roll, as Live Link Face calls them.
std::array<std::string, 3> turn_names(std::string_view part) {
  const std::string of = part == "head" ? "Head" : part == "leftEye" ? "LeftEye" : "RightEye";
  return {of + "Pitch", of + "Yaw", of + "Roll"};
}

/// Values by name, where a row may have other names than the one before.
class PacketRows {
 public:
  base::Status add(const Packet& packet, std::size_t line) {
    if (rows_.values.size() >= k_most_track_frames)
      return base::Error{"the take has too many frames", "line " + std::to_string(line), "cut it"};
    rows_.named.push_back("line " + std::to_string(line));
    std::string& why = rows_.why.emplace_back();
    auto& values = rows_.values.emplace_back(before_);
    clock_.add(packet.time, base::parse_double(packet.time));
    for (const PacketPart& part : packet.parts) {
      if (part.turns) {
        if (part.name != "head" && part.name != "leftEye" && part.name != "rightEye") continue;
        const auto names = turn_names(part.name);
        for (std::size_t k = 0; k < names.size() && k < part.numbers.size(); ++k)
          set(values, names[k], base::radians(part.numbers[k]));
      } else if (base::same_but_case(part.name, "trackingStatus")) {
        if (part.numbers[0] == 0) why = "the tracker found no face";
      } else if (!base::same_but_case(part.name, "hapihapi") && !base::same_but_case(part.name, "version")) {
        set(values, part.name, part.numbers[0] / 100);
      }
    }
    before_ = values;
    if ((rows_.values.size() + 1) * rows_.names.size() > k_most_values)
      return base::Error{"the take has over 50,000,000 values", "line " + std::to_string(line), "cut it"};
    return base::Done{};
  }

  [[nodiscard]] bool empty() const { return rows_.values.empty(); }
  base::Result<animation::WeightTrack> finish() {
    for (auto& values : rows_.values) values.resize(rows_.names.size());
    return make_value_track(std::move(rows_), clock_);
  }

 private:
  void set(std::vector<double>& values, std::string_view name, double value) {
    auto at = index_.find(name);
    if (at == index_.end()) {
      at = index_.emplace(std::string(name), rows_.names.size()).first;
      rows_.names.emplace_back(name);
    }
    if (at->second >= values.size()) values.resize(at->second + 1);
    values[at->second] = std::abs(value) < 1e6 ? value : 0;
  }

  ValueRows rows_;
  ValueClock clock_{k_packet_fps};
  std::map<std::string, std::size_t, std::less<>> index_;
  std::vector<double> before_;
};

constexpr std::string_view k_stream_end = "___iFacialMocap";

}  // namespace

bool has_packets(std::string_view text) {
  TextLines lines(base::without_mark(text).substr(0, std::size_t{1} << 14U));
  for (int i = 0; i < 5; ++i) {
    const auto line = lines.next();
    if (!line) return false;
    if (line->find('|') == std::string_view::npos) continue;
    const Packet packet = packet_in(*line);
    const auto shapes =
        std::count_if(packet.parts.begin(), packet.parts.end(), [](const auto& one) { return !one.turns; });
    if (shapes >= 3 || (shapes >= 1 && packet.parts.size() > static_cast<std::size_t>(shapes))) return true;
  }
  return false;
}

base::Result<animation::WeightTrack> read_packets(base::Bytes bytes) {
  PacketRows rows;
  TextLines lines(base::without_mark(base::as_text(bytes)));
  while (auto line = lines.next()) {
    // Streams over TCP put packets one behind the other.
    std::string_view rest = *line;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(k_stream_end), rest.size());
      const Packet packet = packet_in(rest.substr(0, end));
      rest.remove_prefix(std::min(end + k_stream_end.size(), rest.size()));
      if (packet.parts.empty()) continue;
      if (auto added = rows.add(packet, lines.number()); !added) return added.error();
    }
  }
  if (rows.empty()) return lines.error("there is no packet of a face", "write down one packet a line");
  return rows.finish();
}

}  // namespace penpose::io
