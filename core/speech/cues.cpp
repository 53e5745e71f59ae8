#include "core/speech/cues.h"

#include "core/base/text/utf8.h"
#include "core/document/sound/spoken_words.h"
#include "core/io/tracks/cues/cue_file.h"
#include "core/phonetics/nine_mouths.h"

namespace penpose::speech {
namespace {

/// Rhubarb's letter, or one of Preston Blair's names.
std::string mouth_of_shape(const std::string& shape, bool blair) {
  if (blair) return mouth_of_blair(shape);
  const std::size_t letter = shape.size() == 1 ? k_mouth_letters.find(shape[0]) : std::string_view::npos;
  return letter == std::string_view::npos ? shape : std::string(k_mouth_names[letter]);
}

}  // namespace

base::Result<MouthCues> read_mouth_cues(base::Bytes bytes, double moho_fps, base::Bytes dictionary) {
  auto file = io::read_cues(bytes, dictionary);
  if (!file) return file.error();
  const double slower = file->counts_frames ? file->fps / moho_fps : 1;
  MouthCues out;
  for (const io::CueFile::Cue& one : file->list)
    add_cue(out.cues, one.start_s * slower, mouth_of_shape(one.shape, file->blair));
  if (file->end_s * slower > out.cues.back().time_s)
    add_cue(out.cues, file->end_s * slower, std::string(name_of(NineMouth::rest)));
  out.words = std::move(file->words);
  out.notes = std::move(file->notes);
  return out;
}

document::SetWords words_kept(const std::vector<HeardWord>& words) {
  document::SetWords command;
  for (const HeardWord& one : words) {
    const std::string word = base::valid_utf8(one.word);
    const bool fits = !word.empty() && word.size() <= document::k_longest_word && one.from_s >= 0;
    if (!fits || (!command.times_s.empty() && one.from_s < command.times_s.back())) continue;
    if (command.words.size() == document::k_most_words) break;
    command.times_s.push_back(one.from_s);
    command.words.push_back(word);
  }
  return command;
}

}  // namespace penpose::speech
