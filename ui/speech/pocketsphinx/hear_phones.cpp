#include "ui/speech/hear_phones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <pocketsphinx.h>
#include <sphinxbase/cmn.h>
#include <sphinxbase/err.h>
#include <sphinxbase/fe.h>
#include <sphinxbase/feat.h>
#include <sphinxbase/fsg_model.h>
#include <utility>

#include "core/sound/resample.h"
#include "ui/files/files.h"

namespace penpose::speech {
namespace {

constexpr int k_rate_hz = 16000;
constexpr double k_frame_s = 0.01;
/// Of full scale; what is never louder is no speech.
constexpr float k_least_speech = 1e-3F;
constexpr const char* k_debian_model = "/usr/share/pocketsphinx/model/en-us";
constexpr std::uint64_t k_most_dictionary_bytes = std::uint64_t{1} << 26;

constexpr std::array k_phonemes{"AA", "AE", "AH", "AO", "AW", "AY", "B",  "CH", "D", "DH", "EH", "ER", "EY",
                                "F",  "G",  "HH", "IH", "IY", "JH", "K",  "L",  "M", "N",  "NG", "OW", "OY",
                                "P",  "R",  "S",  "SH", "T",  "TH", "UH", "UW", "V", "W",  "Y",  "Z",  "ZH"};

struct Free {
  void operator()(ps_decoder_t* decoder) const { ps_free(decoder); }
  void operator()(fsg_model_t* grammar) const { fsg_model_free(grammar); }
  void operator()(cmd_ln_t* config) const { cmd_ln_free_r(config); }
};
using Decoder = std::unique_ptr<ps_decoder_t, Free>;

base::Error no_model(const std::string& folder) {
  return {"PocketSphinx has no English there", folder, "install pocketsphinx-en-us"};
}

Decoder decoder_of(cmd_ln_t* made) {
  const std::unique_ptr<cmd_ln_t, Free> config(made);
  return Decoder(config ? ps_init(config.get()) : nullptr);
}

/// Phonemes one after the other, with pauses where they fit.
bool take_line(ps_decoder_t& decoder, const std::vector<std::string>& phonemes) {
  for (const char* name : k_phonemes) {
    if (ps_add_word(&decoder, name, name, 0) < 0) return false;
  }
  const auto count = static_cast<int>(phonemes.size());
  const std::unique_ptr<fsg_model_t, Free> line(fsg_model_init("line", ps_get_logmath(&decoder), 1.0F, count + 1));
  if (!line) return false;
  line->start_state = 0;
  line->final_state = count;
  for (int i = 0; i < count; ++i) {
    const int word = fsg_model_word_add(line.get(), phonemes[static_cast<std::size_t>(i)].c_str());
    fsg_model_trans_add(line.get(), i, i + 1, 0, word);
  }
  return ps_set_fsg(&decoder, "line", line.get()) == 0 && ps_set_search(&decoder, "line") == 0;
}

using Pcm = std::vector<std::int16_t>;

/// `noise`: as loud as a share of the loudest sample. The model was made of rooms, in which it is never as silent as
/// between the sounds of a synthetic voice or behind a noise gate.
Pcm pcm_of(const sound::Sound& sound, double noise) {
  const sound::Sound resampled = sound::resampled(sound, k_rate_hz);
  float loudest = 0;
  for (const float sample : resampled.samples) loudest = std::max(loudest, std::abs(sample));
  Pcm out;
  out.reserve(resampled.samples.size());
  std::uint32_t random = 1;
  for (const float sample : resampled.samples) {
    random = random * 1664525U + 1013904223U;
    const double share = static_cast<double>(random >> 8U) / (1U << 23U) - 1;
    const double value = static_cast<double>(sample) + share * noise * static_cast<double>(loudest);
    out.push_back(static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0, 1.0) * 32767.0)));
  }
  return out;
}

/// A part of all listening: from one share of it to another.
struct Part {
  Listening& listening;
  double from = 0, to = 1;
};

/// The cepstra of a sound, a row a frame of k_frame_s.
struct Cepstra {
  std::vector<mfcc_t> values;
  std::vector<mfcc_t*> rows;
};

/// Less the mean of the whole sound, which tells more than that of what was heard so far.
std::optional<Cepstra> cepstra_of(ps_decoder_t& decoder, const Pcm& pcm) {
  fe_t* front = ps_get_fe(&decoder);
  const auto width = static_cast<std::size_t>(fe_get_output_size(front));
  const std::size_t most = pcm.size() / static_cast<std::size_t>(k_rate_hz * k_frame_s) + 8;
  Cepstra out{std::vector<mfcc_t>(most * width), {}};
  for (std::size_t i = 0; i < most; ++i) out.rows.push_back(out.values.data() + i * width);
  const std::int16_t* from = pcm.data();
  std::size_t left = pcm.size();
  auto count = static_cast<std::int32_t>(most - 1);
  std::int32_t last = 0;
  if (fe_start_utt(front) < 0 || fe_process_frames(front, &from, &left, out.rows.data(), &count, nullptr) < 0)
    return std::nullopt;
  fe_end_utt(front, out.rows[static_cast<std::size_t>(count)], &last);
  out.rows.resize(static_cast<std::size_t>(count + last));
  feat_t* features = ps_get_feat(&decoder);
  cmn(features->cmn_struct, out.rows.data(), 0, count + last);
  features->cmn = CMN_NONE;
  return out;
}

base::Error not_heard() { return {"the sound cannot be listened to", "", "give speech alone, without music"}; }

/// In short stretches, so that it can be stopped; PocketSphinx loses frames of longer ones.
base::Status listen(ps_decoder_t& decoder, const Pcm& pcm, const Part& part) {
  constexpr std::size_t k_stretch = 8;
  auto cepstra = cepstra_of(decoder, pcm);
  if (!cepstra || ps_start_utt(&decoder) < 0) return not_heard();
  auto& rows = cepstra->rows;
  for (std::size_t i = 0; i < rows.size() && !part.listening.stopped; i += k_stretch) {
    const std::size_t count = std::min(k_stretch, rows.size() - i);
    if (ps_process_cep(&decoder, rows.data() + i, static_cast<int>(count), 0, 0) < 0) return not_heard();
    part.listening.share =
        part.from + (part.to - part.from) * static_cast<double>(i + count) / static_cast<double>(rows.size());
  }
  if (ps_end_utt(&decoder) < 0) return not_heard();
  if (part.listening.stopped) return base::Error{"stopped", "", ""};
  return base::Done{};
}

base::Error nothing_spoken() { return {"nothing is spoken in the sound", "", "give speech alone, without music"}; }

bool is_phoneme(const std::string& name) {
  for (const char* one : k_phonemes) {
    if (name == one) return true;
  }
  return false;
}

std::vector<Phone> heard(ps_decoder_t& decoder, double end_s) {
  std::vector<Phone> phones;
  for (ps_seg_t* segment = ps_seg_iter(&decoder); segment != nullptr; segment = ps_seg_next(segment)) {
    int first = 0;
    int last = 0;
    ps_seg_frames(segment, &first, &last);
    const std::string name = ps_seg_word(segment);
    const Phone phone{is_phoneme(name) ? name : std::string(), first * k_frame_s, (last + 1) * k_frame_s};
    if (phone.to_s > end_s + 1 || (!phones.empty() && phone.from_s < phones.back().from_s)) continue;
    phones.push_back(phone);
  }
  return phones;
}

std::size_t spoken_in(const std::vector<Phone>& phones) {
  return static_cast<std::size_t>(
      std::count_if(phones.begin(), phones.end(), [](const Phone& phone) { return !phone.name.empty(); }));
}

/// Tells which phonemes begin the words; there are as many as the words have.
void name_words(std::vector<Phone>& phones, const std::vector<SaidWord>& words) {
  auto phone = phones.begin();
  for (const SaidWord& one : words) {
    bool begins = true;
    for (std::size_t left = one.phonemes.size(); left > 0 && phone != phones.end(); ++phone) {
      if (phone->name.empty()) continue;
      if (std::exchange(begins, false)) phone->word = one.word;
      --left;
    }
  }
}

/// The phonemes of words, laid along the sound.
base::Result<std::vector<Phone>> lay_along(const std::string& folder, const std::vector<SaidWord>& words,
                                           const Pcm& pcm, const Part& part) {
  std::vector<std::string> phonemes;
  for (const SaidWord& one : words) phonemes.insert(phonemes.end(), one.phonemes.begin(), one.phonemes.end());
  if (phonemes.empty()) return base::Error{"the text has no words", "", "give what is said, in English"};
  const Decoder decoder =
      decoder_of(cmd_ln_init(nullptr, ps_args(), 1, "-hmm", (folder + "/en-us").c_str(), "-dither", "no",
                             "-remove_silence", "no", "-remove_noise", "no", "-fwdflat", "no", "-bestpath", "no",
                             "-beam", "1e-120", "-wbeam", "1e-100", "-pbeam", "1e-120", nullptr));
  if (!decoder || !take_line(*decoder, phonemes)) return no_model(folder);
  if (const auto listened = listen(*decoder, pcm, part); !listened) return listened.error();
  auto phones = heard(*decoder, static_cast<double>(pcm.size()) / k_rate_hz);
  if (spoken_in(phones) < phonemes.size())
    return base::Error{"the sound does not say the text", "", "give exactly what is said, or no text"};
  name_words(phones, words);
  return phones;
}

/// Phonemes one by one, without words.
base::Result<std::vector<Phone>> single_phones(const std::string& folder, const Pcm& pcm, const Part& part) {
  const Decoder decoder = decoder_of(cmd_ln_init(
      nullptr, ps_args(), 1, "-hmm", (folder + "/en-us").c_str(), "-allphone", (folder + "/en-us-phone.lm.bin").c_str(),
      "-allphone_ci", "yes", "-lw", "1.0", "-silprob", "0.001", "-fillprob", "1e-8", "-beam", "1e-20", "-pbeam",
      "1e-20", "-dither", "no", "-remove_silence", "no", "-remove_noise", "no", nullptr));
  if (!decoder) return no_model(folder);
  if (const auto listened = listen(*decoder, pcm, part); !listened) return listened.error();
  auto phones = heard(*decoder, static_cast<double>(pcm.size()) / k_rate_hz);
  if (spoken_in(phones) == 0) return nothing_spoken();
  return phones;
}

/// The words that the language makes likely; none where its model is not there.
base::Result<std::string> likely_words(const std::string& folder, const Pcm& pcm, const Part& part) {
  const std::string language = folder + "/en-us.lm.bin";
  std::error_code ignored;
  if (!std::filesystem::exists(language, ignored)) return std::string();
  const Decoder decoder = decoder_of(cmd_ln_init(nullptr, ps_args(), 1, "-hmm", (folder + "/en-us").c_str(), "-lm",
                                                 language.c_str(), "-dict", (folder + "/cmudict-en-us.dict").c_str(),
                                                 "-dither", "no", "-remove_silence", "no", nullptr));
  if (!decoder) return std::string();
  if (const auto listened = listen(*decoder, pcm, part); !listened) return listened.error();
  const char* words = ps_get_hyp(decoder.get(), nullptr);
  return std::string(words != nullptr ? words : "");
}

/// The words that are heard laid along the sound, with the stops that are heard besides; the phonemes alone where no
/// words are heard.
base::Result<std::vector<Phone>> by_ear(const std::string& folder, base::Bytes dictionary, const sound::Sound& sound,
                                        Listening& listening) {
  constexpr double k_noise = 0.01;
  const Pcm pcm = pcm_of(sound, k_noise);
  const auto text = likely_words(folder, pcm, {listening, 0, 0.7});
  if (!text) return text.error();
  auto phones = single_phones(folder, pcm, {listening, 0.7, 0.85});
  const auto words = said_words(*text, dictionary);
  if (!phones || words.empty()) return phones;
  const auto laid = lay_along(folder, words, pcm, {listening, 0.85, 1});
  if (laid) return with_stops(*laid, *phones);
  if (listening.stopped) return laid.error();
  return phones;
}

}  // namespace

base::Status can_hear(const std::string& model) {
  const std::string folder = model.empty() ? k_debian_model : model;
  std::error_code ignored;
  if (!std::filesystem::exists(folder + "/en-us/mdef", ignored)) return no_model(folder);
  return base::Done{};
}

base::Result<std::vector<Phone>> hear_phones(const sound::Sound& sound, const std::string& text,
                                             const std::string& model, Listening* listening) {
  if (sound.duration_s() > k_longest_speech_s)
    return base::Error{"the sound is longer than 600 s", "", "cut it into scenes"};
  // A text can be laid along anything, silence too.
  const bool silent = std::none_of(sound.samples.begin(), sound.samples.end(),
                                   [](float sample) { return std::abs(sample) > k_least_speech; });
  if (silent) return nothing_spoken();
  err_set_logfp(nullptr);
  if (const auto can = can_hear(model); !can) return can.error();
  const std::string folder = model.empty() ? k_debian_model : model;
  const auto dictionary = files::read_file(folder + "/cmudict-en-us.dict", k_most_dictionary_bytes);
  if (!dictionary) return no_model(folder);
  Listening alone;
  Listening& told = listening != nullptr ? *listening : alone;
  if (text.empty()) return by_ear(folder, *dictionary, sound, told);
  return lay_along(folder, said_words(text, *dictionary), pcm_of(sound, 0), {told, 0, 1});
}

}  // namespace penpose::speech
