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

std::vector<std::int16_t> pcm_of(const sound::Sound& sound) {
  const sound::Sound resampled = sound::resampled(sound, k_rate_hz);
  std::vector<std::int16_t> out;
  out.reserve(resampled.samples.size());
  for (const float sample : resampled.samples) out.push_back(static_cast<std::int16_t>(std::lround(sample * 32767.0F)));
  return out;
}

/// The cepstra of a sound, a row a frame of k_frame_s.
struct Cepstra {
  std::vector<mfcc_t> values;
  std::vector<mfcc_t*> rows;
};

/// Less the mean of the whole sound, which tells more than that of what was heard so far.
std::optional<Cepstra> cepstra_of(ps_decoder_t& decoder, const std::vector<std::int16_t>& pcm) {
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

/// In short stretches, so that it can be stopped. False: it cannot be listened to.
bool listen(ps_decoder_t& decoder, const sound::Sound& sound, Listening& listening) {
  constexpr std::size_t k_stretch = 50;
  auto cepstra = cepstra_of(decoder, pcm_of(sound));
  if (!cepstra || ps_start_utt(&decoder) < 0) return false;
  auto& rows = cepstra->rows;
  for (std::size_t i = 0; i < rows.size() && !listening.stopped; i += k_stretch) {
    const std::size_t count = std::min(k_stretch, rows.size() - i);
    if (ps_process_cep(&decoder, rows.data() + i, static_cast<int>(count), 0, 0) < 0) return false;
    listening.share = static_cast<double>(i + count) / static_cast<double>(rows.size());
  }
  return ps_end_utt(&decoder) >= 0;
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

}  // namespace

bool hears_speech() { return true; }

base::Result<std::vector<Phone>> hear_phones(const sound::Sound& sound, const std::string& text,
                                             const std::string& model, Listening* listening) {
  if (sound.duration_s() > k_longest_speech_s)
    return base::Error{"the sound is longer than 600 s", "", "cut it into scenes"};
  // A text can be laid along anything, silence too.
  const bool silent = std::none_of(sound.samples.begin(), sound.samples.end(),
                                   [](float sample) { return std::abs(sample) > k_least_speech; });
  if (silent) return nothing_spoken();
  err_set_logfp(nullptr);
  const std::string folder = model.empty() ? k_debian_model : model;
  const std::string acoustic = folder + "/en-us";
  std::error_code ignored;
  if (!std::filesystem::exists(acoustic + "/mdef", ignored)) return no_model(folder);
  std::vector<SaidWord> words;
  std::vector<std::string> phonemes;
  if (!text.empty()) {
    const auto dictionary = files::read_file(folder + "/cmudict-en-us.dict", k_most_dictionary_bytes);
    if (!dictionary) return no_model(folder);
    words = said_words(text, *dictionary);
    for (const SaidWord& one : words) phonemes.insert(phonemes.end(), one.phonemes.begin(), one.phonemes.end());
    if (phonemes.empty()) return base::Error{"the text has no words", "", "give what is said, in English"};
  }
  const std::string phone_model = folder + "/en-us-phone.lm.bin";
  Decoder decoder;
  if (text.empty()) {
    decoder = decoder_of(cmd_ln_init(nullptr, ps_args(), 1, "-hmm", acoustic.c_str(), "-allphone", phone_model.c_str(),
                                     "-allphone_ci", "yes", "-lw", "2.0", "-beam", "1e-20", "-pbeam", "1e-20",
                                     "-dither", "no", "-remove_silence", "no", "-remove_noise", "no", nullptr));
  } else {
    decoder = decoder_of(cmd_ln_init(nullptr, ps_args(), 1, "-hmm", acoustic.c_str(), "-dither", "no",
                                     "-remove_silence", "no", "-remove_noise", "no", "-fwdflat", "no", "-bestpath",
                                     "no", "-beam", "1e-120", "-wbeam", "1e-100", "-pbeam", "1e-120", nullptr));
  }
  if (!decoder || (!text.empty() && !take_line(*decoder, phonemes))) return no_model(folder);
  Listening alone;
  Listening& told = listening != nullptr ? *listening : alone;
  const bool listened = listen(*decoder, sound, told);
  if (told.stopped) return base::Error{"stopped", "", ""};
  if (!listened) return base::Error{"the sound cannot be listened to", "", "give speech alone, without music"};
  std::vector<Phone> phones = heard(*decoder, sound.duration_s());
  std::size_t spoken = 0;
  for (const Phone& phone : phones) spoken += phone.name.empty() ? 0U : 1U;
  if (!text.empty() && spoken < phonemes.size())
    return base::Error{"the sound does not say the text", "", "give exactly what is said, or no text"};
  if (spoken == 0) return nothing_spoken();
  name_words(phones, words);
  return phones;
}

}  // namespace penpose::speech
