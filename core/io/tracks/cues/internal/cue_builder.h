#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/io/tracks/cues/cue_file.h"
#include "core/phonetics/nine_mouths.h"

namespace penpose::io {

/// Nothing: all is well.
using CueProblem = std::optional<base::Error>;

/// Tells whether labels are mouth shapes, phonemes or words.
enum class LabelKind : std::uint8_t { mouths, phones, words };
[[nodiscard]] LabelKind kind_of_labels(const std::vector<std::string_view>& labels);

/// Collects what a file of cues says: shapes of mouths, phonemes, words, or labels of which nobody knows yet which of
/// these they are. Shapes come first, then phonemes, then words.
class CueBuilder {
 public:
  explicit CueBuilder(std::string_view remedy) : remedy_(remedy) {}

  [[nodiscard]] base::Error wrong(std::string what, std::string place) const;

  /// The mouth is a shape from then on. Errors: a time that steps back or none, a name that is none, too many.
  CueProblem shape(std::optional<double> start_s, std::string_view name, std::string place);
  CueProblem mouth(std::optional<double> start_s, speech::NineMouth mouth, std::string place);
  /// A label of phonemes; words, which share their time by their sounds; or a label of which the whole file tells what
  /// it is. `to_s` not after `from_s`: it lasts until the next one, or as long as words take. Errors: times that are
  /// none, too many.
  CueProblem phone(std::optional<double> from_s, std::optional<double> to_s, std::string_view label,
                   const std::string& place);
  CueProblem word(std::optional<double> from_s, std::optional<double> to_s, std::string_view text,
                  const std::string& place);
  CueProblem label(std::optional<double> from_s, std::optional<double> to_s, std::string_view text,
                   const std::string& place);
  void end(double end_s) { file_.end_s = std::max(file_.end_s, end_s); }
  void frames(double fps) { file_.fps = fps, file_.counts_frames = true; }
  void note(std::string text);
  [[nodiscard]] bool has_shapes() const { return !file_.list.empty(); }
  [[nodiscard]] bool empty() const {
    return file_.list.empty() && phones_.empty() && words_.empty() && labels_.empty();
  }

  base::Result<CueFile> finish(base::Bytes dictionary);

 private:
  struct Span {
    double from_s = 0;
    double to_s = 0;
    std::string text;
  };
  CueProblem add(std::vector<Span>& spans, std::optional<double> from_s, std::optional<double> to_s,
                 std::string_view text, const std::string& place);
  void sort_labels();
  void show_labels();
  [[nodiscard]] std::vector<speech::Phone> phones_of_words(std::size_t& most, base::Bytes dictionary);
  [[nodiscard]] std::vector<speech::Phone> phones_of_labels(const std::vector<speech::Phone>& said);
  void spell_shapes();
  void take(const std::vector<speech::Phone>& phones);

  std::string_view remedy_;
  CueFile file_;
  std::vector<Span> phones_;
  std::vector<Span> words_;
  std::vector<Span> labels_;
};

}  // namespace penpose::io
