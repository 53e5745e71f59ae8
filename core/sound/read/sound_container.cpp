#include "core/sound/read/sound_container.h"

#include <algorithm>
#include <array>
#include <string>

#include "core/sound/read/read_sound.h"

namespace penpose::sound {
namespace {

using namespace std::string_view_literals;

struct Beginning {
  std::string_view at_0;
  std::string_view at_8;  ///< empty: anything
  SoundContainer container;
};

constexpr std::array k_beginnings{
    Beginning{"RIFF"sv, "WAVE"sv, {"WAV", true}},
    Beginning{"RIFX"sv, "WAVE"sv, {"WAV", true}},
    Beginning{"RF64"sv, "WAVE"sv, {"RF64", true}},
    Beginning{"riff\x2E\x91\xCF\x11"sv, {}, {"W64", true}},
    Beginning{"FORM"sv, "AIFF"sv, {"AIFF", true}},
    Beginning{"FORM"sv, "AIFC"sv, {"AIFF", true}},
    Beginning{"caff"sv, {}, {"CAF", true}},
    Beginning{"fLaC"sv, {}, {"FLAC", true}},
    Beginning{"OggS"sv, {}, {"OGG", true}},
    Beginning{".snd"sv, {}, {"AU", true}},
    Beginning{"\x30\x26\xB2\x75\x8E\x66\xCF\x11"sv, {}, {"WMA", false}},
    Beginning{"#!AMR"sv, {}, {"AMR", false}},
    Beginning{"\x1A\x45\xDF\xA3"sv, {}, {"WebM", false}},
};

/// A header of a frame of MPEG sound, layer III, whose fields all have a value.
bool begins_mp3_frame(base::Bytes bytes) {
  if (bytes.size() < 4 || bytes[0] != 0xFF || (bytes[1] & 0xE0) != 0xE0) return false;
  const unsigned version = (bytes[1] >> 3) & 3U, layer = (bytes[1] >> 1) & 3U;
  const unsigned bit_rate = bytes[2] >> 4, sample_rate = (bytes[2] >> 2) & 3U;
  return version != 1 && layer == 1 && bit_rate != 0 && bit_rate != 15 && sample_rate != 3;
}

/// A header of a frame of AAC by itself (ADTS).
bool begins_aac_frame(base::Bytes bytes) { return bytes.size() >= 2 && bytes[0] == 0xFF && (bytes[1] & 0xF6) == 0xF0; }

constexpr std::size_t k_id3_header = 10;

bool begins_with_id3(base::Bytes bytes) {
  return bytes.size() >= k_id3_header && base::as_text(bytes).starts_with("ID3") &&
         std::all_of(bytes.begin() + 6, bytes.begin() + k_id3_header, [](std::uint8_t b) { return b < 0x80; });
}

}  // namespace

base::Bytes without_id3(base::Bytes bytes) {
  if (!begins_with_id3(bytes)) return bytes;
  std::size_t size = 0;
  for (std::size_t i = 6; i < k_id3_header; ++i) size = size << 7 | bytes[i];  // seven bits a byte
  const bool has_footer = (bytes[5] & 0x10) != 0;
  return bytes.subspan(std::min(bytes.size(), k_id3_header + size + (has_footer ? k_id3_header : 0)));
}

std::optional<SoundContainer> sound_container(base::Bytes bytes) {
  const bool tagged = begins_with_id3(bytes);
  bytes = without_id3(bytes);
  // Some programs leave zeros between the tag and the first frame.
  while (tagged && !bytes.empty() && bytes.front() == 0) bytes = bytes.subspan(1);
  const std::string_view text = base::as_text(bytes);
  for (const Beginning& one : k_beginnings) {
    if (!text.starts_with(one.at_0)) continue;
    if (one.at_8.empty() || text.substr(0, 12).ends_with(one.at_8)) return one.container;
  }
  if (text.size() >= 8 && text.substr(4, 4) == "ftyp") return SoundContainer{"MP4", false};
  if (begins_mp3_frame(bytes)) return SoundContainer{"MP3", true};
  if (begins_aac_frame(bytes)) return SoundContainer{"AAC", false};
  if (tagged) return SoundContainer{"MP3", true};
  return std::nullopt;
}

bool looks_like_sound(base::Bytes bytes) { return sound_container(bytes).has_value(); }

}  // namespace penpose::sound
