#include "ui/app/files/dropped_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <vector>

#include "core/base/text/letters.h"
#include "core/io/model/model_formats.h"
#include "core/io/tracks/track_formats.h"
#include "core/sound/read/sound_container.h"
#include "ui/app/sound/sound_track.h"
#include "ui/files/load_model.h"
#include "ui/film/read_film.h"

namespace penpose::app {
namespace {

bool begins(base::Bytes bytes, std::string_view with, std::size_t at = 0) {
  return bytes.size() >= at + with.size() && base::as_text(bytes).substr(at, with.size()) == with;
}

bool is_sound(base::Bytes head) {
  const auto container = sound::sound_container(head);
  return container && container->is_read;
}

bool is_picture(base::Bytes head) {
  return begins(head, "\x89PNG") || begins(head, "\xFF\xD8\xFF") || (begins(head, "RIFF") && begins(head, "WEBP", 8));
}

bool is_svg(base::Bytes head) {
  const std::string_view text = base::without_mark(base::as_text(head));
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '<' && text.find("<svg") != std::string_view::npos;
}

/// Lines of hid-recorder at the beginning of a text: "# ..." or a letter and a colon.
bool is_recording(base::Bytes head) {
  std::string_view text = base::without_mark(base::as_text(head));
  int recorded = 0;
  while (!text.empty() && recorded < 2) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    if (line.empty() || line.front() == '#') continue;
    const bool known = line.size() > 2 && std::string_view("DRNPIE").find(line[0]) != std::string_view::npos &&
                       line[1] == ':' && line[2] == ' ';
    if (!known) return false;
    ++recorded;
  }
  return recorded > 0 || base::as_text(head).starts_with("# penpose");
}

bool has_ending(std::string_view name, std::initializer_list<std::string_view> endings) {
  const std::string lower = base::lower_case(std::string(name));
  return std::any_of(endings.begin(), endings.end(), [&](std::string_view one) { return lower.ends_with(one); });
}

struct KindRow {
  DroppedKind kind;
  std::string_view words;
  std::array<DropDeed, 3> deeds;
  std::size_t count;
};

constexpr std::array k_kinds{
    KindRow{DroppedKind::model, "a model", {DropDeed::open, DropDeed::add_beside}, 2},
    KindRow{DroppedKind::project, "a project", {DropDeed::open, DropDeed::add_beside}, 2},
    KindRow{DroppedKind::session, "a session, or a recording of a tablet", {DropDeed::open}, 1},
    KindRow{DroppedKind::sound, "a sound", {DropDeed::lay_sound}, 1},
    KindRow{DroppedKind::picture,
            "a picture",
            {DropDeed::reference_behind, DropDeed::reference_beside, DropDeed::read_drawing},
            3},
    KindRow{DroppedKind::film, "a film", {DropDeed::reference_behind, DropDeed::reference_beside}, 2},
    KindRow{DroppedKind::drawing, "a drawing", {DropDeed::read_drawing}, 1},
    KindRow{DroppedKind::take, "a take of a tracked face", {DropDeed::key_take}, 1},
    KindRow{DroppedKind::unknown, "nothing that penpose opens", {}, 0},
};

const KindRow& row_of(DroppedKind kind) { return k_kinds.at(static_cast<std::size_t>(kind)); }

}  // namespace

DroppedKind kind_of_content(base::Bytes head, std::string_view name) {
  if (is_sound(head)) return DroppedKind::sound;
  if (is_picture(head)) return DroppedKind::picture;
  if (film::is_film(head)) return DroppedKind::film;
  if (io::format_of_content(head) != nullptr) return DroppedKind::model;
  if (is_svg(head)) return DroppedKind::drawing;
  if (is_recording(head)) return DroppedKind::session;
  // A beginning of a text may lack what tells its format: then the name counts.
  if (has_ending(name, {".session", ".hid", ".trace", ".rec", ".pcap", ".pcapng", ".evemu"}))
    return DroppedKind::session;
  if (io::format_of_name(name) != nullptr) return DroppedKind::model;
  if (io::format_of_track(head) != nullptr || has_ending(name, {".csv", ".pts", ".vmd", ".vrma"}))
    return DroppedKind::take;
  return DroppedKind::unknown;
}

DroppedKind kind_of_dropped(const std::string& path) {
  std::error_code code;
  if (!std::filesystem::is_regular_file(path, code)) return DroppedKind::unknown;
  std::ifstream file(path, std::ios::binary);
  std::vector<char> head(k_drop_head);
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  const std::vector<std::uint8_t> bytes(head.begin(), head.begin() + file.gcount());
  const DroppedKind kind = kind_of_content(bytes, std::filesystem::path(path).filename().string());
  return kind == DroppedKind::model && files::is_project(path) ? DroppedKind::project : kind;
}

std::string_view words_of(DroppedKind kind) { return row_of(kind).words; }

std::span<const DropDeed> deeds_of(DroppedKind kind) {
  const KindRow& row = row_of(kind);
  return {row.deeds.data(), row.count};
}

DropDeedWords words_of(DropDeed deed) {
  switch (deed) {
    case DropDeed::open:
      return {"Open it", "In place of what is open"};
    case DropDeed::add_beside:
      return {"Add it beside", "As another character in this document"};
    case DropDeed::lay_sound:
      return {"Lay it beside the timeline", "Play it with the timeline, and let the face speak it"};
    case DropDeed::reference_behind:
      return {"Reference behind the model", "To animate after; it goes along with the view"};
    case DropDeed::reference_beside:
      return {"Reference on a card", "To animate after; it stays where it is on the window"};
    case DropDeed::read_drawing:
      return {"Read it as a drawing of the face", "The face takes what the lines show"};
    case DropDeed::key_take:
      return {"Key its motion", "The motion of the tracked face as keys of the timeline"};
  }
  return {"", ""};
}

}  // namespace penpose::app
