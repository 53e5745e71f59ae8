#include "core/io/fbx/write/fbx_writer.h"

#include <bit>

#include "core/io/fbx/tree/fbx_forms.h"

namespace penpose::io {
namespace {

constexpr std::size_t k_end_of_records = 13;
constexpr std::uint32_t k_version = 7400;
// Readers based on Autodesk's SDK expect a file id that matches its time, and this footer (Blender writes the same).
constexpr std::string_view k_file_id("\x28\xb3\x2a\xeb\xb6\x24\xcc\xc2\xbf\xc8\xb0\x2a\xa9\x2b\xfc\xf1", 16);
constexpr std::string_view k_time = "1970-01-01 10:00:00:000";
constexpr std::string_view k_foot_id("\xfa\xbc\xab\x09\xd0\xc8\xd4\x66\xb1\x76\xfb\x83\x1c\xf7\x26\x7e", 16);
constexpr std::string_view k_foot("\xf8\x5a\x8c\x6a\xde\xf5\xd9\x7e\xec\xe9\x0c\xe3\x75\x8f\x29\x0b", 16);

template <typename Unsigned>
void add(std::vector<std::uint8_t>& out, Unsigned value) {
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) out.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

void add_text(std::vector<std::uint8_t>& out, std::string_view text) {
  out.insert(out.end(), text.begin(), text.end());
}

}  // namespace

FbxWriter::FbxWriter() {
  add_text(out_, k_fbx_magic);
  add(out_, k_version);
  begin("FBXHeaderExtension")
      .entry("FBXHeaderVersion", 1003)
      .entry("FBXVersion", static_cast<std::int32_t>(k_version))
      .end();
  begin("FileId").bytes(k_file_id).end();
  entry("CreationTime", k_time);
  entry("Creator", "penpose");
}

void FbxWriter::put(std::size_t at, std::size_t value) {
  for (std::size_t i = 0; i < 4; ++i) out_[at + i] = static_cast<std::uint8_t>(value >> (8 * i));
}

void FbxWriter::close_values() {
  if (open_.empty() || open_.back().holds) return;
  Open& record = open_.back();
  put(record.head + 4, record.count);
  put(record.head + 8, out_.size() - record.values);
}

FbxWriter& FbxWriter::begin(std::string_view name) {
  close_values();
  if (!open_.empty()) open_.back().holds = true;
  Open record;
  record.head = out_.size();
  out_.resize(out_.size() + 12);
  out_.push_back(static_cast<std::uint8_t>(name.size()));
  add_text(out_, name);
  record.values = out_.size();
  open_.push_back(record);
  return *this;
}

FbxWriter& FbxWriter::end() {
  close_values();
  // One without values is a list, if an empty one.
  if (open_.back().holds || open_.back().count == 0) out_.resize(out_.size() + k_end_of_records);
  put(open_.back().head, out_.size());
  open_.pop_back();
  return *this;
}

FbxWriter& FbxWriter::value(char kind) {
  ++open_.back().count;
  out_.push_back(static_cast<std::uint8_t>(kind));
  return *this;
}

FbxWriter& FbxWriter::whole(std::int32_t one) {
  value('I');
  add(out_, static_cast<std::uint32_t>(one));
  return *this;
}
FbxWriter& FbxWriter::id(std::int64_t one) {
  value('L');
  add(out_, static_cast<std::uint64_t>(one));
  return *this;
}
FbxWriter& FbxWriter::number(double one) {
  value('D');
  add(out_, std::bit_cast<std::uint64_t>(one));
  return *this;
}
FbxWriter& FbxWriter::text(std::string_view one) {
  value('S');
  add(out_, static_cast<std::uint32_t>(one.size()));
  add_text(out_, one);
  return *this;
}
FbxWriter& FbxWriter::bytes(std::string_view one) {
  value('R');
  add(out_, static_cast<std::uint32_t>(one.size()));
  add_text(out_, one);
  return *this;
}

void FbxWriter::array(char kind, std::size_t count, std::size_t size) {
  value(kind);
  add(out_, static_cast<std::uint32_t>(count));
  add(out_, std::uint32_t{0});
  add(out_, static_cast<std::uint32_t>(count * size));
}
FbxWriter& FbxWriter::numbers(std::span<const double> values) {
  array('d', values.size(), 8);
  for (const double one : values) add(out_, std::bit_cast<std::uint64_t>(one));
  return *this;
}
FbxWriter& FbxWriter::floats(std::span<const double> values) {
  array('f', values.size(), 4);
  for (const double one : values) add(out_, std::bit_cast<std::uint32_t>(static_cast<float>(one)));
  return *this;
}
FbxWriter& FbxWriter::wholes(std::span<const std::int32_t> values) {
  array('i', values.size(), 4);
  for (const std::int32_t one : values) add(out_, static_cast<std::uint32_t>(one));
  return *this;
}
FbxWriter& FbxWriter::ids(std::span<const std::int64_t> values) {
  array('l', values.size(), 8);
  for (const std::int64_t one : values) add(out_, static_cast<std::uint64_t>(one));
  return *this;
}

std::string FbxWriter::named(std::string_view name, std::string_view kind) {
  std::string out(name);
  out.append(std::string_view("\0\1", 2));
  out.append(kind);
  return out;
}

std::vector<std::uint8_t> FbxWriter::take() {
  out_.resize(out_.size() + k_end_of_records);
  add_text(out_, k_foot_id);
  out_.resize(out_.size() + 4);
  out_.resize(out_.size() + 16 - out_.size() % 16);
  add(out_, k_version);
  out_.resize(out_.size() + 120);
  add_text(out_, k_foot);
  return std::move(out_);
}

}  // namespace penpose::io
