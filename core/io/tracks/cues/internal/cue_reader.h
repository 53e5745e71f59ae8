#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/json/json.h"
#include "core/base/result.h"
#include "core/io/tracks/cues/internal/cue_builder.h"

namespace penpose::io {

/// A form of cues: how it is told and read.
struct CueReader {
  std::string_view name;    ///< for people: "Rhubarb (tsv, xml, json)"
  std::string_view remedy;  ///< of a file of it that cannot be read
  bool (*looks_like)(std::string_view text);
  CueProblem (*read)(std::string_view text, CueBuilder& cues);
};

// One each, a file each.
[[nodiscard]] CueReader textgrid_reader();
[[nodiscard]] CueReader papagayo_reader();
[[nodiscard]] CueReader moho_reader();
[[nodiscard]] CueReader captions_reader();
[[nodiscard]] CueReader rhubarb_reader();
[[nodiscard]] CueReader speech_marks_reader();
[[nodiscard]] CueReader azure_reader();
[[nodiscard]] CueReader word_json_reader();
[[nodiscard]] CueReader labels_reader();

/// A time, a gap and the name of a mouth a line, which nothing else says.
CueProblem read_timed_names(std::string_view text, CueBuilder& cues);

/// Returns true if a text begins as JSON does and has a word near its beginning.
[[nodiscard]] bool begins_json(std::string_view text);
[[nodiscard]] bool mentions(std::string_view text, std::string_view word);
/// A number of JSON, also in quotes.
[[nodiscard]] std::optional<double> json_time(const json::Json* value);
/// The text of a member that is one; nothing else.
[[nodiscard]] std::optional<std::string_view> json_text(const json::Json& object,
                                                        std::initializer_list<const char*> names);
/// The member of the first of the names that an object has; null: none.
[[nodiscard]] const json::Json* json_member(const json::Json& object, std::initializer_list<const char*> names);

}  // namespace penpose::io
