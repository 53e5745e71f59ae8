#include "core/phonetics/cues.h"

#include "core/phonetics/nine_mouths.h"

namespace penpose::speech {
namespace {

/// Lips that come out of a pause are closed so long before they are heard.
constexpr double k_before_closed_s = 0.08;

}  // namespace

void add_cue(Cues& cues, double time_s, std::string mouth) {
  if (!cues.empty() && cues.back().time_s >= time_s) cues.pop_back();
  if (cues.empty() || cues.back().mouth != mouth) cues.push_back({time_s, std::move(mouth)});
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
