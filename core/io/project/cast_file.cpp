#include "core/io/project/cast_file.h"

#include <limits>
#include <optional>
#include <utility>

#include "core/base/byte_writer.h"
#include "core/base/json/json.h"

namespace penpose::io {
namespace {

using json::Json;

constexpr std::size_t k_glb_head = 12;
constexpr std::size_t k_chunk_head = 8;
constexpr std::uint32_t k_cast_chunk = 0x43535050;  // "PPSC"
constexpr std::size_t k_most_cast_json = 65536;
constexpr double k_farthest = 1e9, k_least_scale = 1e-6, k_largest_scale = 1e6, k_most_degrees = 1e6;
constexpr const char* k_cast_form = "penpose_cast";
constexpr const char* k_save_again = "save the project again";

base::Error wrong_cast(std::string what, std::string place) {
  return {std::move(what), std::move(place), k_save_again};
}

std::string at_byte_of(std::size_t offset) { return "byte offset " + std::to_string(offset); }

/// Where the chunk is in a file, its head included; nothing: there is none.
std::optional<std::pair<std::size_t, std::size_t>> find_cast_chunk(base::Bytes bytes) {
  if (!base::as_text(bytes).starts_with("glTF")) return std::nullopt;
  base::ByteReader reader(bytes);
  if (!reader.seek(k_glb_head)) return std::nullopt;
  while (!reader.at_end()) {
    const std::size_t start = reader.offset();
    const auto size = reader.read<std::uint32_t>();
    const auto type = reader.read<std::uint32_t>();
    if (!size || !type || !reader.take(*size)) return std::nullopt;
    if (*type == k_cast_chunk) return std::pair(start, reader.offset());
  }
  return std::nullopt;
}

std::optional<double> number_within(const Json& object, const char* name, double usual, double least, double most) {
  const Json* found = json::find(object, name);
  const auto value = found == nullptr ? std::optional(usual) : json::number(*found);
  return value && *value >= least && *value <= most ? value : std::nullopt;
}

std::optional<geometry::ModelVector> place_of(const Json& object) {
  const Json* at = json::find(object, "at");
  if (at == nullptr) return geometry::ModelVector{0};
  if (!at->is_array() || at->size() != 3) return std::nullopt;
  geometry::ModelVector place{0};
  for (int i = 0; i < 3; ++i) {
    const auto value = json::number((*at)[static_cast<std::size_t>(i)]);
    if (!value || !(*value >= -k_farthest && *value <= k_farthest)) return std::nullopt;
    place[i] = *value;
  }
  return place;
}

std::string text_of(const Json& object, const char* name) {
  const Json* found = json::find(object, name);
  return found != nullptr && found->is_string() ? found->get_ref<const std::string&>() : std::string();
}

base::Result<CastMember> read_member(const Json& object, const std::string& here) {
  CastMember member;
  member.name = text_of(object, "name");
  if (member.name.empty() || member.name.size() > k_longest_character_name)
    return wrong_cast("a name of 1 to 100 bytes was expected", json::child(here, "name"));
  const auto at = place_of(object);
  if (!at) return wrong_cast("three numbers were expected", json::child(here, "at"));
  const auto turn = number_within(object, "turn_degrees", 0, -k_most_degrees, k_most_degrees);
  if (!turn) return wrong_cast("a number of degrees was expected", json::child(here, "turn_degrees"));
  const auto scale = number_within(object, "scale", 1, k_least_scale, k_largest_scale);
  if (!scale) return wrong_cast("a number from 0.000001 to 1000000 was expected", json::child(here, "scale"));
  member.placement = {*at, *turn, *scale};
  const Json* shown = json::find(object, "shown");
  if (shown != nullptr && !shown->is_boolean())
    return wrong_cast("true or false was expected", json::child(here, "shown"));
  member.shown = shown == nullptr || shown->get<bool>();
  member.session = text_of(object, "session");
  member.model = text_of(object, "model");
  return member;
}

base::Result<Cast> members_of(const Json& root) {
  const Json* form = json::find(root, k_cast_form);
  const auto format = form == nullptr ? std::nullopt : json::whole_number(*form, 1, 1'000'000);
  if (!format) return wrong_cast("the number of a format was expected", std::string("/") + k_cast_form);
  if (*format != k_cast_format) {
    return base::Error{
        "characters of format " + std::to_string(*format) + ", this program reads " + std::to_string(k_cast_format),
        std::string("/") + k_cast_form, "open the file with the version of penpose that saved it"};
  }
  const Json* list = json::find(root, "characters");
  if (list == nullptr || !list->is_array() || list->size() < 2 || list->size() > k_most_characters)
    return wrong_cast("a list of 2 to 32 characters was expected", "/characters");
  Cast cast;
  for (std::size_t i = 0; i < list->size(); ++i) {
    auto member = read_member((*list)[i], json::child("/characters", i));
    if (!member) return member.error();
    cast.members.push_back(std::move(*member));
  }
  const Json* active = json::find(root, "active");
  const auto number =
      active == nullptr ? 0 : json::whole_number(*active, 0, static_cast<std::int64_t>(list->size()) - 1);
  if (!number) return wrong_cast("the number of a character was expected", "/active");
  cast.active = static_cast<std::size_t>(*number);
  return cast;
}

base::Result<Json> parsed_cast(base::Bytes text) {
  if (text.size() > k_most_cast_json) return wrong_cast("is too large for a list of characters", "");
  return json::parse_json(text);
}

Json json_of(const Cast& cast) {
  Json list = Json::array();
  for (std::size_t i = 0; i < cast.members.size(); ++i) {
    const CastMember& member = cast.members[i];
    const geometry::ModelVector& at = member.placement.at;
    Json one = Json::object();
    one["name"] = member.name;
    one["at"] = std::vector<double>{at.x, at.y, at.z};
    one["turn_degrees"] = member.placement.turn_degrees;
    one["scale"] = member.placement.scale;
    one["shown"] = member.shown;
    if (!member.session.empty()) one["session"] = member.session;
    if (!member.model.empty()) one["model"] = member.model;
    if (i > 0 && i < cast.files.size()) one["bytes"] = cast.files[i].size();
    list.push_back(std::move(one));
  }
  Json root = Json::object();
  root[k_cast_form] = k_cast_format;
  root["active"] = cast.active;
  root["characters"] = std::move(list);
  return root;
}

std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

/// The first character's file, without what follows it.
std::vector<std::uint8_t> without_chunk(base::Bytes bytes, std::size_t from, std::size_t to) {
  base::ByteWriter out;
  out.append(bytes.first(k_glb_head - 4));
  out.write(static_cast<std::uint32_t>(bytes.size() - (to - from)));
  out.append(bytes.subspan(k_glb_head, from - k_glb_head));
  out.append(bytes.subspan(to));
  return out.take();
}

}  // namespace

bool holds_cast(base::Bytes bytes) { return find_cast_chunk(bytes).has_value(); }

base::Result<Cast> read_cast(base::Bytes bytes) {
  const auto found = find_cast_chunk(bytes);
  if (!found) return base::Error{"this is no project of several characters", "", "open it as a model"};
  const auto [from, to] = *found;
  base::ByteReader chunk(bytes.first(to));
  (void)chunk.seek(from + k_chunk_head);
  const auto length = chunk.read<std::uint32_t>();
  const auto text = length ? chunk.take(*length) : std::nullopt;
  if (!text || !chunk.take(padded(*length) - *length))
    return wrong_cast("the list of characters is cut off", at_byte_of(from));
  const auto root = parsed_cast(*text);
  if (!root) return root.error();
  auto cast = members_of(*root);
  if (!cast) return cast;
  cast->files.push_back(without_chunk(bytes, from, to));
  if (holds_cast(cast->files.front())) return wrong_cast("there are two lists of characters", at_byte_of(from));
  const Json& list = root->at("characters");
  for (std::size_t i = 1; i < cast->members.size(); ++i) {
    const std::string place = json::child(json::child("/characters", i), "bytes");
    const Json* bytes_of = json::find(list[i], "bytes");
    const auto size = bytes_of == nullptr
                          ? std::nullopt
                          : json::whole_number(*bytes_of, 0, static_cast<std::int64_t>(chunk.remaining()));
    const auto file = size ? chunk.take(static_cast<std::size_t>(*size)) : std::nullopt;
    if (!file || !chunk.take(padded(file->size()) - file->size()))
      return wrong_cast("the file of the character is cut off", place);
    // Else a character could hold characters without end.
    if (holds_cast(*file)) return wrong_cast("a file of one character was expected", place);
    cast->files.emplace_back(file->begin(), file->end());
  }
  if (!chunk.at_end()) return wrong_cast("the characters do not fill their part of the file", at_byte_of(from));
  return cast;
}

base::Result<std::vector<std::uint8_t>> write_cast(const Cast& cast) {
  const std::string text = json_of(cast).dump_as_made();
  const std::vector<std::uint8_t>& first = cast.files.front();
  std::size_t size = 4 + padded(text.size());
  for (std::size_t i = 1; i < cast.files.size(); ++i) size += padded(cast.files[i].size());
  const std::size_t whole = first.size() + k_chunk_head + size;
  if (whole > std::numeric_limits<std::uint32_t>::max()) {
    return base::Error{"the characters need more than the 4 GB that a project has room for", "",
                       "save them as several projects"};
  }
  base::ByteWriter out;
  out.append(base::Bytes(first).first(k_glb_head - 4));
  out.write(static_cast<std::uint32_t>(whole));
  out.append(base::Bytes(first).subspan(k_glb_head));
  out.write(static_cast<std::uint32_t>(size));
  out.write(k_cast_chunk);
  out.write(static_cast<std::uint32_t>(text.size()));
  out.append(text);
  out.align(4, ' ');
  for (std::size_t i = 1; i < cast.files.size(); ++i) {
    out.append(base::Bytes(cast.files[i]));
    out.align(4);
  }
  return out.take();
}

base::Result<Cast> read_cast_note(base::Bytes bytes) {
  const auto root = parsed_cast(bytes);
  if (!root) return root.error();
  return members_of(*root);
}

std::string write_cast_note(const Cast& cast) { return json_of(cast).dump_as_made(1) + "\n"; }

}  // namespace penpose::io
