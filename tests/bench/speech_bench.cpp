// How well mouths are told from speech, and how fast: ten sentences in two voices of eSpeak NG, whose own events say
// when each phoneme begins. Prints what docs/measured.md quotes.
//
//   speech_bench
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <espeak-ng/speak_lib.h>
#include <string>
#include <vector>

#include "core/phonetics/nine_mouths.h"
#include "core/sound/sound.h"
#include "core/speech/closures.h"
#include "core/speech/cues.h"
#include "core/speech/mouth_keys.h"
#include "ui/speech/hear_phones.h"

namespace penpose {
namespace {

constexpr const char* k_sentences[]{"My baby puts big maps by the lamp.",
                                    "People became happy when the boat stopped beside the empty harbor.",
                                    "Please bring me a cup of coffee before breakfast.",
                                    "The number of problems may be impossible to remember.",
                                    "Bob and Mary bought paper bags from the market.",
                                    "We have only five minutes to open the front window.",
                                    "A small lamb jumped over the broken bamboo fence.",
                                    "The quick brown fox jumps over the lazy dog.",
                                    "I think that summer will probably be warm this year.",
                                    "Put the pepper and the butter upon the big table."};
constexpr const char* k_voices[]{"en-us", "en-us+f3"};
constexpr double k_fps = 24;
/// Before the burst of a p eSpeak is silent so long (median of 38).
constexpr double k_silence_of_p_s = 0.05;

struct Event {
  double time_s = 0;
  std::string phoneme;
};
struct Spoken {
  sound::Sound sound;
  std::vector<Event> events;
};

Spoken* g_spoken = nullptr;

int take(short* samples, int count, espeak_EVENT* events) {
  for (int i = 0; samples != nullptr && i < count; ++i)
    g_spoken->sound.samples.push_back(static_cast<float>(samples[i]) / 32768.0F);
  for (; events->type != espeakEVENT_LIST_TERMINATED; ++events) {
    if (events->type != espeakEVENT_PHONEME) continue;
    char name[9] = {};
    std::memcpy(name, events->id.string, 8);
    g_spoken->events.push_back({events->audio_position / 1000.0, name});
  }
  return 0;
}

Spoken speak(const char* voice, const char* text, int rate_hz) {
  Spoken spoken;
  spoken.sound.rate_hz = rate_hz;
  g_spoken = &spoken;
  espeak_SetVoiceByName(voice);
  espeak_Synth(text, std::strlen(text) + 1, 0, POS_CHARACTER, 0, espeakCHARS_UTF8, nullptr, nullptr);
  espeak_Synchronize();
  return spoken;
}

bool is_closed(const std::string& phoneme) { return phoneme == "p" || phoneme == "b" || phoneme == "m"; }

struct Figures {
  std::size_t closures = 0, met = 0, keyed_met = 0, timed = 0, in_time = 0;
  std::size_t told = 0, right = 0;
  double error_s = 0;
  double spoken_s = 0, took_s = 0;
};

struct Stretch {
  double from_s = 0, to_s = 0;
};

/// When the lips are closed, by cues or by keys.
template <typename Each>
std::vector<Stretch> closed_in(const Each& list, std::string Each::value_type::*mouth) {
  std::vector<Stretch> out;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i].*mouth != speech::name_of(speech::NineMouth::closed)) continue;
    const double to = i + 1 < list.size() ? list[i + 1].time_s : list[i].time_s;
    if (!out.empty() && out.back().to_s == list[i].time_s) {
      out.back().to_s = to;
    } else {
      out.push_back({list[i].time_s, to});
    }
  }
  return out;
}

void judge(const Spoken& spoken, bool with_text, const char* text, Figures& figures) {
  const auto begun = std::chrono::steady_clock::now();
  const auto phones = speech::hear_phones(spoken.sound, with_text ? text : "");
  if (!phones) {
    std::printf("%s: %s\n", text, phones.error().line().c_str());
    return;
  }
  const speech::Cues cues = speech::with_closures(speech::cues_of(*phones), spoken.sound);
  const document::SpokenMouths keys = speech::mouth_keys(cues, {k_fps, 0});
  figures.took_s += std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  figures.spoken_s += spoken.sound.duration_s();
  const auto closed = closed_in(cues, &speech::Cue::mouth);
  const auto keyed = closed_in(keys, &document::SpokenMouth::mouth);
  std::vector<Stretch> truth;
  for (std::size_t i = 0; i + 1 < spoken.events.size(); ++i) {
    const std::string& phoneme = spoken.events[i].phoneme;
    if (!is_closed(phoneme)) continue;
    // The event of a p is its burst, with which lips open; those of b and m are when they close.
    const double event_s = spoken.events[i].time_s;
    const bool opens = phoneme == "p";
    const Stretch one =
        opens ? Stretch{event_s - k_silence_of_p_s, event_s} : Stretch{event_s, spoken.events[i + 1].time_s};
    truth.push_back(one);
    ++figures.closures;
    const auto overlaps = [&](const Stretch& told) { return told.from_s < one.to_s && told.to_s > one.from_s; };
    if (std::any_of(keyed.begin(), keyed.end(), overlaps)) ++figures.keyed_met;
    const auto told = std::find_if(closed.begin(), closed.end(), overlaps);
    if (told == closed.end()) continue;
    ++figures.met;
    // Lips that stay closed from one to the next do neither between them.
    if (opens ? told->to_s > spoken.events[i + 1].time_s + 0.02 : i > 0 && is_closed(spoken.events[i - 1].phoneme))
      continue;
    const double error_s = std::abs((opens ? told->to_s : told->from_s) - event_s);
    ++figures.timed;
    figures.error_s += error_s;
    if (error_s <= 0.04) ++figures.in_time;
  }
  for (const Stretch& told : closed) {
    ++figures.told;
    const auto overlaps = [&](const Stretch& one) { return told.from_s < one.to_s && told.to_s > one.from_s; };
    if (std::any_of(truth.begin(), truth.end(), overlaps)) ++figures.right;
  }
}

}  // namespace
}  // namespace penpose

int main() {
  using namespace penpose;  // NOLINT(google-build-using-namespace): the program is of the project
  const int rate_hz = espeak_Initialize(AUDIO_OUTPUT_SYNCHRONOUS, 0, nullptr, espeakINITIALIZE_PHONEME_EVENTS);
  if (rate_hz <= 0) return std::printf("eSpeak NG does not start\n"), 1;
  espeak_SetSynthCallback(take);
  for (const bool with_text : {true, false}) {
    for (const char* voice : k_voices) {
      Figures figures;
      for (const char* text : k_sentences) judge(speak(voice, text, rate_hz), with_text, text, figures);
      const auto share = [](std::size_t part, std::size_t whole) {
        return whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0.0;
      };
      std::printf(
          "%s, %s: of %zu p, b, m lips are closed on %.1f %% (keys at 24 fps: %.1f %%), "
          "within 40 ms %.1f %%, mean error %.1f ms; of %zu closures %.1f %% are p, b, m; %.2f s for 10 s\n",
          voice, with_text ? "with the text" : "by ear", figures.closures, share(figures.met, figures.closures),
          share(figures.keyed_met, figures.closures), share(figures.in_time, figures.timed),
          figures.timed > 0 ? 1000 * figures.error_s / static_cast<double>(figures.timed) : 0.0, figures.told,
          share(figures.right, figures.told), 10 * figures.took_s / figures.spoken_s);
    }
  }
  return 0;
}
