#include "core/io/tracks/cues/internal/cue_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"
#include "core/base/text/shown_text.h"
#include "core/phonetics/cues.h"
#include "core/phonetics/phone_names.h"
#include "core/phonetics/spoken_letters.h"
#include "core/phonetics/visemes.h"

namespace penpose::io {
namespace {

constexpr std::size_t k_most_cues = 1'000'000;
constexpr std::size_t k_most_labels = 300'000;
constexpr std::size_t k_most_sounds = 150'000;  // hours of speech
constexpr std::size_t k_most_sounds_a_word = 24;
constexpr double k_latest_s = 1e6;
/// A sound of a word of which nobody knows how long it lasts takes so long at most.
constexpr double k_longest_sound_s = 0.15;
constexpr double k_usual_sound_s = 0.09;

constexpr std::array<std::string_view, 10> k_blair{"AI", "E", "O", "U", "etc", "L", "WQ", "MBP", "FV", "rest"};

template <std::size_t N>
bool is_among(std::string_view name, const std::array<std::string_view, N>& names) {
  return std::any_of(names.begin(), names.end(), [&](std::string_view one) {
    return one.size() == 1 || name.size() == 1 ? one == name : base::same_but_case(name, one);
  });
}

bool is_letter_of_rhubarb(std::string_view name) {
  return name.size() == 1 && speech::k_mouth_letters.find(base::upper(name[0])) != std::string_view::npos;
}

std::string letter_of(speech::NineMouth mouth) {
  return std::string(speech::k_mouth_letters.substr(static_cast<std::size_t>(mouth), 1));
}

std::optional<speech::NineMouth> mouth_called(std::string_view name) {
  for (std::size_t i = 0; i < speech::k_nine; ++i) {
    const std::string_view one = speech::k_mouth_names[i];
    if (one.size() == 1 ? one == name : base::same_but_case(one, name)) return static_cast<speech::NineMouth>(i);
  }
  return std::nullopt;
}

/// The sounds of a word: at most so many, evenly chosen.
std::vector<std::string> thinned(const std::vector<std::string>& sounds, std::size_t most) {
  if (sounds.size() <= most) return sounds;
  std::vector<std::string> out;
  for (std::size_t i = 0; i < most; ++i) out.push_back(sounds[i * sounds.size() / most]);
  return out;
}

}  // namespace

LabelKind kind_of_labels(const std::vector<std::string_view>& labels) {
  std::size_t spoken = 0, letters = 0, blair = 0, nine = 0, oculus = 0;
  for (const std::string_view label : labels) {
    const std::string_view bare = base::trim(label);
    if (speech::is_pause_label(bare)) continue;
    ++spoken;
    if (is_letter_of_rhubarb(bare) && bare[0] == base::upper(bare[0])) ++letters;
    if (is_among(bare, k_blair)) ++blair;
    if (mouth_called(bare)) ++nine;
    if (speech::mouth_of_oculus(bare) || (bare.size() == 1 && std::string_view("EIOU").find(bare) != bare.npos))
      ++oculus;
  }
  const std::size_t mouths = std::max({letters, blair, nine, oculus});
  const speech::SpelledPhones phones = speech::spelling_of(labels);
  if (mouths > 0 && 10 * mouths >= 6 * spoken && mouths >= phones.known) return LabelKind::mouths;
  if (phones.known > 0 && 10 * phones.known >= 9 * spoken) return LabelKind::phones;
  return LabelKind::words;
}

base::Error CueBuilder::wrong(std::string what, std::string place) const {
  return {std::move(what), std::move(place), std::string(remedy_)};
}

CueProblem CueBuilder::shape(std::optional<double> start_s, std::string_view name, std::string place) {
  if (!start_s || !(*start_s >= 0) || !(*start_s < k_latest_s))
    return wrong("a time of 0 or more was expected", std::move(place));
  if (name.empty() || name.size() > 40) return wrong("the name of a mouth shape was expected", std::move(place));
  if (!file_.list.empty() && *start_s < file_.list.back().start_s)
    return wrong("the cue comes before the one above it", std::move(place));
  if (file_.list.size() >= k_most_cues) return wrong("a track has at most 1,000,000 cues", std::move(place));
  file_.list.push_back({*start_s, std::string(name), std::move(place)});
  return std::nullopt;
}

CueProblem CueBuilder::mouth(std::optional<double> start_s, speech::NineMouth mouth, std::string place) {
  return shape(start_s, letter_of(mouth), std::move(place));
}

CueProblem CueBuilder::add(std::vector<Span>& spans, std::optional<double> from_s, std::optional<double> to_s,
                           std::string_view text, const std::string& place) {
  constexpr double k_just_before_s = -0.5;
  if (from_s && *from_s <= 0 && *from_s > k_just_before_s) from_s = 0;
  if (!from_s || !(*from_s >= 0) || !(*from_s < k_latest_s)) return wrong("a time of 0 or more was expected", place);
  if (to_s && !(*to_s < k_latest_s)) return wrong("a time below 1,000,000 s was expected", place);
  if (spans.size() >= k_most_labels) return wrong("a list of cues has at most 300,000 labels", place);
  spans.push_back({*from_s, std::max(*from_s, to_s.value_or(0)), std::string(base::trim(text))});
  return std::nullopt;
}

CueProblem CueBuilder::phone(std::optional<double> from_s, std::optional<double> to_s, std::string_view label,
                             const std::string& place) {
  return add(phones_, from_s, to_s, label, place);
}

CueProblem CueBuilder::word(std::optional<double> from_s, std::optional<double> to_s, std::string_view text,
                            const std::string& place) {
  return add(words_, from_s, to_s, text, place);
}

CueProblem CueBuilder::label(std::optional<double> from_s, std::optional<double> to_s, std::string_view text,
                             const std::string& place) {
  return add(labels_, from_s, to_s, text, place);
}

void CueBuilder::note(std::string text) {
  constexpr std::size_t k_most_notes = 20;
  if (file_.notes.size() < k_most_notes) file_.notes.push_back(std::move(text));
}

/// Labels of mouths become shapes, with rest where none is.
void CueBuilder::show_labels() {
  const bool blair = std::any_of(labels_.begin(), labels_.end(), [](const Span& one) {
    return one.text.size() > 1 && is_among(one.text, k_blair) && !mouth_called(one.text);
  });
  const std::string rest = blair ? "rest" : "X";
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    const Span& one = labels_[i];
    const bool pause = speech::is_pause_label(one.text);
    if (!pause || i > 0) file_.list.push_back({one.from_s, pause ? rest : one.text.substr(0, 40), ""});
    const bool ends = one.to_s > one.from_s;
    const bool gap = i + 1 == labels_.size() || labels_[i + 1].from_s > one.to_s + 1e-6;
    if (ends && gap && !pause && i + 1 < labels_.size()) file_.list.push_back({one.to_s, rest, ""});
  }
  if (!labels_.empty()) end(labels_.back().to_s);
}

void CueBuilder::sort_labels() {
  if (labels_.empty()) return;
  std::stable_sort(labels_.begin(), labels_.end(), [](const Span& a, const Span& b) { return a.from_s < b.from_s; });
  std::vector<std::string_view> texts;
  for (const Span& one : labels_) texts.push_back(one.text);
  const LabelKind kind = kind_of_labels(texts);
  if (kind == LabelKind::mouths && file_.list.empty()) show_labels();
  if (kind == LabelKind::phones && phones_.empty()) phones_ = std::move(labels_);
  if (kind == LabelKind::words && words_.empty()) words_ = std::move(labels_);
}

std::vector<speech::Phone> CueBuilder::phones_of_words(std::size_t& most, base::Bytes dictionary) {
  std::stable_sort(words_.begin(), words_.end(), [](const Span& a, const Span& b) { return a.from_s < b.from_s; });
  struct Said {
    std::size_t span = 0;
    std::string_view shown;
    std::size_t first = 0, count = 0;  // among all that is to be said
  };
  std::vector<Said> said;
  std::vector<std::string> all;
  for (std::size_t i = 0; i < words_.size(); ++i) {
    std::string_view rest = words_[i].text;
    if (speech::is_pause_label(rest)) continue;
    while (!rest.empty()) {
      const std::size_t gap = std::min(rest.find_first_of(" \t\r\n"), rest.size());
      const std::string_view shown = rest.substr(0, gap);
      rest.remove_prefix(std::min(gap + 1, rest.size()));
      const auto spoken = speech::words_spoken(shown);
      if (spoken.empty()) continue;
      said.push_back({i, shown, all.size(), spoken.size()});
      all.insert(all.end(), spoken.begin(), spoken.end());
      if (all.size() > k_most_sounds) {
        most = all.size();
        return {};
      }
    }
  }
  const auto ways = speech::said_list(all, dictionary);
  std::vector<speech::Phone> phones;
  for (std::size_t k = 0; k < said.size();) {
    const Span& span = words_[said[k].span];
    std::size_t last = k;
    std::vector<std::vector<std::string>> sounds;
    std::size_t count = 0;
    for (; last < said.size() && said[last].span == said[k].span; ++last) {
      auto& own = sounds.emplace_back();
      for (std::size_t w = said[last].first; w < said[last].first + said[last].count; ++w)
        own.insert(own.end(), ways[w].phonemes.begin(), ways[w].phonemes.end());
      own = thinned(own, k_most_sounds_a_word);
      count += own.size();
    }
    most += count;
    if (most > k_most_sounds) return {};
    const double next_s = last < said.size() ? words_[said[last].span].from_s : k_latest_s;
    double to_s = std::min(span.to_s, next_s);
    if (span.to_s <= span.from_s) {
      const double each_s = last < said.size() ? k_longest_sound_s : k_usual_sound_s;
      to_s = std::min(next_s, span.from_s + each_s * static_cast<double>(count));
    }
    const double each_s = count == 0 ? 0 : (to_s - span.from_s) / static_cast<double>(count);
    std::size_t at = 0;
    for (std::size_t w = k; w < last && each_s > 0; ++w) {
      const auto& own = sounds[w - k];
      const double from_s = span.from_s + each_s * static_cast<double>(at);
      if (!own.empty()) {
        file_.words.push_back(
            {std::string(said[w].shown.substr(0, 200)), from_s, from_s + each_s * static_cast<double>(own.size())});
      }
      for (const std::string& sound : own) {
        const double start_s = span.from_s + each_s * static_cast<double>(at);
        ++at;
        phones.push_back({sound, start_s, span.from_s + each_s * static_cast<double>(at)});
      }
    }
    k = last;
  }
  return phones;
}

std::vector<speech::Phone> CueBuilder::phones_of_labels(const std::vector<speech::Phone>& said) {
  std::stable_sort(phones_.begin(), phones_.end(), [](const Span& a, const Span& b) { return a.from_s < b.from_s; });
  std::vector<std::string_view> texts;
  for (const Span& one : phones_) texts.push_back(one.text);
  const speech::PhoneAlphabet alphabet = speech::spelling_of(texts).alphabet;
  std::set<std::string> strangers;
  std::vector<speech::Phone> phones;
  std::size_t word = 0;
  for (std::size_t i = 0; i < phones_.size(); ++i) {
    const Span& one = phones_[i];
    const double next_s = i + 1 < phones_.size() ? phones_[i + 1].from_s : k_latest_s;
    const double to_s =
        one.to_s > one.from_s
            ? std::min(one.to_s, next_s)
            : std::min(next_s, one.from_s + (i + 1 < phones_.size() ? 2 * k_longest_sound_s : k_usual_sound_s));
    if (!(to_s > one.from_s)) continue;
    if (speech::is_unknown_label(one.text)) {
      // The neighbouring words say what is spoken there.
      while (word < said.size() && said[word].to_s <= one.from_s + 1e-6) ++word;
      const std::size_t before = phones.size();
      for (; word < said.size() && said[word].from_s < to_s - 1e-6; ++word) {
        speech::Phone part = said[word];
        part.from_s = std::max(part.from_s, one.from_s);
        part.to_s = std::min(part.to_s, to_s);
        phones.push_back(std::move(part));
      }
      if (phones.size() == before) phones.push_back({"AH", one.from_s, to_s});
      continue;
    }
    auto name = speech::phoneme_of_label(one.text, alphabet);
    for (const auto other :
         {speech::PhoneAlphabet::arpabet, speech::PhoneAlphabet::ipa, speech::PhoneAlphabet::sampa}) {
      if (!name) name = speech::phoneme_of_label(one.text, other);
    }
    if (!name) strangers.insert(one.text.substr(0, 20));
    phones.push_back({name.value_or(""), one.from_s, to_s});
  }
  if (!strangers.empty()) {
    std::string names;
    std::size_t count = 0;
    for (const std::string& one : strangers) {
      if (++count <= 5) names.append(names.empty() ? "" : ", ").append(base::shown_name(one));
    }
    note("labels that are no phonemes are spoken with the mouth at rest: " + names + (count > 5 ? ", ..." : ""));
  }
  return phones;
}

void CueBuilder::take(const std::vector<speech::Phone>& phones) {
  std::vector<speech::Phone> whole;
  for (const speech::Phone& phone : phones) {
    const double before_s = whole.empty() ? 0 : whole.back().to_s;
    if (phone.from_s > before_s + 1e-6) whole.push_back({"", before_s, phone.from_s});
    // Pauses that follow each other are one.
    if (phone.name.empty() && !whole.empty() && whole.back().name.empty()) {
      whole.back().to_s = phone.to_s;
    } else {
      whole.push_back(phone);
    }
  }
  const bool any = std::any_of(whole.begin(), whole.end(), [](const auto& phone) { return !phone.name.empty(); });
  if (!any) return;
  for (const speech::Cue& cue : speech::cues_of(whole)) {
    const auto mouth = mouth_called(cue.mouth);
    file_.list.push_back({cue.time_s, letter_of(mouth.value_or(speech::NineMouth::rest)), ""});
  }
  end(whole.back().to_s);
}

/// Spells the shapes as their table does.
void CueBuilder::spell_shapes() {
  const auto any = [&](auto is) {
    return std::any_of(file_.list.begin(), file_.list.end(), [&](const CueFile::Cue& cue) { return is(cue.shape); });
  };
  constexpr std::array<std::string_view, 2> k_own_names{"closed", "consonants"};
  constexpr std::array<std::string_view, 9> k_own_blair{"AI", "O", "U", "etc", "L", "WQ", "MBP", "FV", "rest"};
  const bool nine = any([&](const std::string& shape) { return is_among(shape, k_own_names); });
  constexpr std::array<std::string_view, 5> k_blair_alone{"AI", "etc", "WQ", "MBP", "FV"};
  const bool papagayo = any([&](const std::string& shape) { return is_among(shape, k_blair_alone); });
  const bool oculus = !nine && !papagayo && any([](const std::string& shape) {
    return shape.size() > 1 && speech::mouth_of_oculus(shape).has_value();
  });
  file_.blair = !nine && !oculus && any([&](const std::string& shape) {
    return std::any_of(k_own_blair.begin(), k_own_blair.end(),
                       [&](std::string_view one) { return base::same_but_case(one, shape); });
  });
  for (CueFile::Cue& cue : file_.list) {
    if (const auto mouth = mouth_called(cue.shape); nine && mouth) {
      cue.shape = letter_of(*mouth);
      continue;
    }
    if (oculus) {
      const bool bare = cue.shape.size() == 1 && std::string_view("EIOU").find(cue.shape) != std::string_view::npos;
      const auto mouth = speech::mouth_of_oculus((bare ? "viseme_" : "") + cue.shape);
      if (mouth) {
        cue.shape = letter_of(*mouth);
        continue;
      }
    }
    for (const std::string_view name : k_blair) {
      if (file_.blair && base::same_but_case(cue.shape, name)) cue.shape = name;
    }
    if (!file_.blair && cue.shape.size() == 1) cue.shape[0] = base::upper(cue.shape[0]);
  }
}

base::Result<CueFile> CueBuilder::finish(base::Bytes dictionary) {
  sort_labels();
  std::size_t sounds = 0;
  auto said = phones_of_words(sounds, dictionary);
  if (sounds > k_most_sounds)
    return base::Error{"its words have more than 150,000 sounds", "", "cut the file into shorter ones"};
  if (file_.list.empty() && !phones_.empty()) said = phones_of_labels(said);
  if (file_.list.empty()) take(said);
  if (file_.list.empty()) return wrong("there is no cue", "line 1");
  spell_shapes();
  return std::move(file_);
}

}  // namespace penpose::io
