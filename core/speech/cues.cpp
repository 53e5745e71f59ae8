#include "core/speech/cues.h"

#include <algorithm>

#include "core/io/tracks/cues/cue_file.h"
#include "core/speech/nine_mouths.h"

namespace penpose::speech {
namespace {

/// Rhubarb's letter, or one of Preston Blair's names.
std::string mouth_of_shape(const std::string& shape, bool blair) {
  if (blair) return mouth_of_blair(shape);
  const std::size_t letter = shape.size() == 1 ? k_mouth_letters.find(shape[0]) : std::string_view::npos;
  return letter == std::string_view::npos ? shape : std::string(k_mouth_names[letter]);
}

/// Lips that come out of a pause are closed so long before they are heard.
constexpr double k_before_closed_s = 0.08;

void add_cue(Cues& cues, double time_s, std::string mouth) {
  // Of two at a moment the later one counts, and one that changes nothing is none.
  if (!cues.empty() && cues.back().time_s >= time_s) cues.pop_back();
  if (cues.empty() || cues.back().mouth != mouth) cues.push_back({time_s, std::move(mouth)});
}

}  // namespace

base::Result<Cues> read_mouth_cues(base::Bytes bytes, double moho_fps) {
  const auto file = io::read_cues(bytes);
  if (!file) return file.error();
  const double slower = file->counts_frames ? file->fps / moho_fps : 1;
  Cues cues;
  for (const io::CueFile::Cue& one : file->list)
    add_cue(cues, one.start_s * slower, mouth_of_shape(one.shape, file->blair));
  if (file->end_s > cues.back().time_s) add_cue(cues, file->end_s * slower, std::string(name_of(NineMouth::rest)));
  return cues;
}

Cues cues_of(const std::vector<Phone>& phones) {
  Cues cues;
  for (std::size_t i = 0; i < phones.size(); ++i) {
    const Phone& phone = phones[i];
    if (!phone.name.empty()) {
      add_cue(cues, phone.from_s, std::string(name_of(mouth_of_phoneme(phone.name))));
      continue;
    }
    const auto is_closed = [&](const Phone& one) { return mouth_of_phoneme(one.name) == NineMouth::closed; };
    const Phone* next = i + 1 < phones.size() ? &phones[i + 1] : nullptr;
    if (next == nullptr || phone.to_s - phone.from_s >= k_least_pause_s) {
      add_cue(cues, phone.from_s, std::string(name_of(NineMouth::rest)));
      // Out of a pause lips are closed in time.
      if (next != nullptr && is_closed(*next))
        add_cue(cues, next->from_s - k_before_closed_s, std::string(name_of(NineMouth::closed)));
    } else if (i == 0 || !is_closed(phones[i - 1])) {
      // The silence of a stop is a part of it; after an m it is the end of its hum.
      add_cue(cues, phone.from_s, std::string(name_of(mouth_of_phoneme(next->name))));
    }
  }
  if (!phones.empty()) add_cue(cues, phones.back().to_s, std::string(name_of(NineMouth::rest)));
  return cues;
}

}  // namespace penpose::speech
