#include <algorithm>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"
#include "core/base/text/shown_text.h"
#include "core/io/tracks/cues/internal/cue_reader.h"
#include "core/phonetics/phone_names.h"

namespace penpose::io {
namespace {

/// Reads what Praat reads from a text file, long or short: numbers, texts in quotes and flags that stand free; names of
/// fields, indices in brackets and what follows an exclamation mark are for people (Praat's manual, "TextGrid file
/// formats").
class GridTokens {
 public:
  explicit GridTokens(std::string_view text) : text_(text) {}

  struct Token {
    bool is_text = false;
    std::string text;
    double number = 0;
  };
  /// The next one; nothing at the end.
  std::optional<Token> next() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (is_blank(c)) {
        skip();
      } else if (c == '!') {
        while (at_ < text_.size() && text_[at_] != '\n') ++at_;
      } else if (c == '"') {
        return Token{true, quoted()};
      } else if (const auto word = bare(); c == '<') {
        return Token{true, std::string(word)};
      } else if (const auto number = base::parse_double(word)) {
        return Token{false, {}, *number};
      }
    }
    return std::nullopt;
  }
  std::optional<double> number() {
    const auto token = next();
    return token && !token->is_text ? std::optional(token->number) : std::nullopt;
  }
  std::optional<std::string> text() {
    auto token = next();
    return token && token->is_text ? std::optional(std::move(token->text)) : std::nullopt;
  }
  [[nodiscard]] std::string place() const { return "line " + std::to_string(line_); }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
  void skip() {
    if (text_[at_] == '\n') ++line_;
    ++at_;
  }
  std::string_view bare() {
    const std::size_t from = at_;
    while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
    return text_.substr(from, at_ - from);
  }
  /// A quote in a text is two.
  std::string quoted() {
    std::string out;
    ++at_;
    while (at_ < text_.size()) {
      if (text_[at_] == '"') {
        if (at_ + 1 >= text_.size() || text_[at_ + 1] != '"') break;
        ++at_;
      }
      out += text_[at_];
      skip();
    }
    if (at_ < text_.size()) ++at_;
    return out;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

struct GridLabel {
  double from_s = 0, to_s = 0;
  std::string text;
};
struct GridTier {
  std::string name;
  bool points = false;
  std::vector<GridLabel> labels;
  std::size_t spoken = 0;
  LabelKind kind = LabelKind::words;
};

constexpr std::size_t k_most_grid_labels = 600'000;

/// Returns the kind of labels that the name of a tier announces.
std::optional<LabelKind> kind_named(std::string_view name) {
  const std::string folded = base::lower_case(name);
  const auto has = [&](const char* part) { return folded.find(part) != std::string::npos; };
  if (has("phon") || has("segment") || folded == "mau" || has("mau:") || folded == "phs") return LabelKind::phones;
  if (has("word") || has("ort") || has("text") || has("transcript")) return LabelKind::words;
  if (has("mouth") || has("viseme") || has("cue")) return LabelKind::mouths;
  return std::nullopt;
}

void tell_kind(GridTier& tier) {
  std::vector<std::string_view> texts;
  for (const GridLabel& label : tier.labels) {
    texts.push_back(label.text);
    if (!speech::is_pause_label(label.text)) ++tier.spoken;
  }
  tier.kind = kind_of_labels(texts);
  const auto named = kind_named(tier.name);
  if (named == LabelKind::words && tier.kind == LabelKind::phones) tier.kind = LabelKind::words;
  if (named == LabelKind::phones && tier.kind == LabelKind::mouths) tier.kind = LabelKind::phones;
  // A few signs that nobody knows do not make phonemes words.
  if (named == LabelKind::phones && tier.kind == LabelKind::words) {
    const auto known = speech::spelling_of(texts).known;
    if (2 * known >= tier.spoken) tier.kind = LabelKind::phones;
  }
}

/// The tier of that kind in which most is said; null: none.
const GridTier* most_said(const std::vector<GridTier>& tiers, LabelKind kind) {
  const GridTier* best = nullptr;
  for (const GridTier& tier : tiers) {
    if (tier.kind != kind || tier.spoken == 0) continue;
    const auto rank = [&](const GridTier& one) { return std::pair(kind_named(one.name) == kind ? 1 : 0, one.spoken); };
    if (best == nullptr || rank(tier) > rank(*best)) best = &tier;
  }
  return best;
}

base::Result<std::vector<GridTier>> read_tiers(std::string_view text, CueBuilder& cues) {
  GridTokens tokens(text);
  const auto wrong = [&](const char* what) { return cues.wrong(what, tokens.place()); };
  const auto kind = tokens.text();
  if (kind && kind->find("chronological") != std::string::npos) return wrong("this is a TextGrid in the order of time");
  const auto file_class = tokens.text();
  if (!file_class || *file_class != "TextGrid") return wrong("this file of Praat is no TextGrid");
  const auto begin = tokens.number();
  const auto end = tokens.number();
  const auto flag = tokens.text();
  if (!begin || !end || !flag) return wrong("the times of the TextGrid were expected");
  std::vector<GridTier> tiers;
  if (*flag != "<exists>") return tiers;
  const auto count = tokens.number();
  if (!count) return wrong("the number of tiers was expected");
  std::size_t labels = 0;
  for (double t = 0; t < *count; ++t) {
    const auto tier_class = tokens.text();
    auto name = tokens.text();
    if (!tier_class || !name) break;
    GridTier& tier = tiers.emplace_back();
    tier.name = *std::move(name);
    tier.points = *tier_class == "TextTier";
    if (!tokens.number() || !tokens.number()) return wrong("the times of a tier were expected");
    const auto size = tokens.number();
    if (!size) return wrong("the number of labels of a tier was expected");
    for (double i = 0; i < *size; ++i) {
      const auto from = tokens.number();
      const auto to = tier.points ? from : tokens.number();
      auto label = tokens.text();
      if (!from || !to || !label) return wrong("the times and the text of a label were expected");
      if (++labels > k_most_grid_labels) return wrong("a TextGrid has at most 600,000 labels");
      tier.labels.push_back({*from, *to, *std::move(label)});
    }
  }
  if (*end < 1e6) cues.end(*end);
  return tiers;
}

/// Tiers of another speaker and the like.
void note_others(const std::vector<GridTier>& tiers, std::initializer_list<const GridTier*> taken, CueBuilder& cues) {
  std::string names;
  for (const GridTier& tier : tiers) {
    const bool used = std::find(taken.begin(), taken.end(), &tier) != taken.end();
    const bool same_kind = std::any_of(taken.begin(), taken.end(),
                                       [&](const GridTier* one) { return one != nullptr && one->kind == tier.kind; });
    if (!used && same_kind && tier.spoken > 0 && names.size() < 200)
      names += (names.empty() ? "" : ", ") + base::shown_name(tier.name.substr(0, 40));
  }
  if (!names.empty()) cues.note("more tiers say something; not taken: " + names);
}

CueProblem read_textgrid(std::string_view text, CueBuilder& cues) {
  auto tiers = read_tiers(text, cues);
  if (!tiers) return tiers.error();
  for (GridTier& tier : *tiers) tell_kind(tier);
  const GridTier* mouths = most_said(*tiers, LabelKind::mouths);
  const GridTier* phones = most_said(*tiers, LabelKind::phones);
  const GridTier* words = most_said(*tiers, LabelKind::words);
  // The words of the one whose phonemes are taken: "name - words" beside "name - phones".
  if (const GridTier* spoken = mouths != nullptr ? mouths : phones; spoken != nullptr && words != nullptr) {
    const std::size_t dash = spoken->name.rfind(" - ");
    for (const GridTier& tier : *tiers) {
      if (dash != std::string::npos && tier.kind == LabelKind::words && tier.spoken > 0 &&
          tier.name.starts_with(spoken->name.substr(0, dash + 3))) {
        words = &tier;
      }
    }
  }
  if (mouths == nullptr && phones == nullptr && words == nullptr) return cues.wrong("no tier says anything", "line 1");
  for (const GridTier* tier : {mouths, phones, words}) {
    if (tier == nullptr || (tier == phones && mouths != nullptr)) continue;
    for (const GridLabel& label : tier->labels) {
      const std::optional<double> to = tier->points ? std::nullopt : std::optional(label.to_s);
      const std::string place = "tier " + base::shown_name(tier->name.substr(0, 40));
      const CueProblem problem = tier == mouths   ? cues.label(label.from_s, to, label.text, place)
                                 : tier == phones ? cues.phone(label.from_s, to, label.text, place)
                                                  : cues.word(label.from_s, to, label.text, place);
      if (problem) return problem;
    }
  }
  note_others(*tiers, {mouths, phones, words}, cues);
  return std::nullopt;
}

}  // namespace

CueReader textgrid_reader() {
  return {"TextGrid (Praat, MFA)", "save it in Praat as a text file, \"Save as text file...\"",
          [](std::string_view text) {
            const std::string_view first = text.substr(0, 300);
            return first.find("ooTextFile") != std::string_view::npos &&
                   first.find("TextGrid") != std::string_view::npos;
          },
          read_textgrid};
}

}  // namespace penpose::io
