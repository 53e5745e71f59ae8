#include "core/io/tracks/cues/cue_file.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>

#include "core/base/json/loose_json.h"
#include "core/base/numbers.h"
#include "core/base/text/letters.h"
#include "core/io/text/text_lines.h"
#include "core/io/tracks/track_formats.h"

namespace penpose::io {
namespace {

using CueProblem = std::optional<base::Error>;

constexpr double k_moho_fps = 24;
constexpr std::size_t k_most_cues = 1'000'000;

using Cues = CueFile;

base::Error wrong_cues(std::string what, std::string place) {
  return {std::move(what), std::move(place), "export the cues again with Rhubarb (tsv, xml, json) or Papagayo (.dat)"};
}

CueProblem add(Cues& cues, std::optional<double> start, std::string_view shape, std::string place) {
  constexpr double k_latest = 1e6;
  if (!start || !(*start >= 0) || !(*start < k_latest))
    return wrong_cues("a time of 0 or more was expected", std::move(place));
  if (shape.empty() || shape.size() > 40) return wrong_cues("the name of a mouth shape was expected", std::move(place));
  if (!cues.list.empty() && *start < cues.list.back().start_s) {
    return wrong_cues("the cue comes before the one above it", std::move(place));
  }
  if (cues.list.size() >= k_most_cues) return wrong_cues("a track has at most 1,000,000 cues", std::move(place));
  cues.list.push_back({*start, std::string(shape), std::move(place)});
  return std::nullopt;
}

/// "0.05<tab>D".
CueProblem read_tsv(std::string_view text, Cues& cues) {
  TextLines lines(text);
  while (const auto line = lines.next()) {
    const std::string_view bare = base::trim(*line);
    if (bare.empty()) continue;
    const std::size_t gap = bare.find_first_of("\t ");
    if (gap == std::string_view::npos)
      return lines.error("a time and a mouth shape were expected", "export the cues again");
    if (auto problem = add(cues, base::parse_double(bare.substr(0, gap)), base::trim(bare.substr(gap)),
                           "line " + std::to_string(lines.number()))) {
      return problem;
    }
  }
  return std::nullopt;
}

/// "MohoSwitch1", then a frame from 1 and a shape a line.
CueProblem read_moho(std::string_view text, Cues& cues) {
  cues.fps = k_moho_fps;
  cues.counts_frames = true;
  TextLines lines(text);
  lines.next();
  while (const auto line = lines.next()) {
    const std::string_view bare = base::trim(*line);
    if (bare.empty()) continue;
    const std::size_t gap = std::min(bare.find_first_of("\t "), bare.size());
    auto frame = base::parse_double(bare.substr(0, gap));
    if (frame) frame = std::max(0.0, *frame - 1) / k_moho_fps;
    if (auto problem = add(cues, frame, base::trim(bare.substr(gap)), "line " + std::to_string(lines.number()))) {
      return problem;
    }
  }
  return std::nullopt;
}

CueProblem read_json(base::Bytes bytes, Cues& cues) {
  const auto root = json::parse_loose_json(bytes);
  if (!root) return root.error();
  const json::Json* list = json::find(*root, "mouthCues");
  if (list == nullptr || !list->is_array()) return wrong_cues("a list of cues was expected", "/mouthCues");
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string place = json::child("/mouthCues", i);
    const json::Json* start = json::find((*list)[i], "start");
    const json::Json* end = json::find((*list)[i], "end");
    const json::Json* value = json::find((*list)[i], "value");
    if (start == nullptr || value == nullptr || !value->is_string()) return wrong_cues("a cue was expected", place);
    if (auto problem = add(cues, json::number(*start), value->get_ref<const std::string&>(), place)) return problem;
    if (end != nullptr) cues.end_s = json::number(*end).value_or(cues.end_s);
  }
  return std::nullopt;
}

std::string_view attribute(std::string_view tag, std::string_view name) {
  for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1)) {
    std::string_view rest = base::trim(tag.substr(at + name.size()));
    if (!rest.starts_with('=')) continue;
    rest = base::trim(rest.substr(1));
    if (rest.empty() || (rest[0] != '"' && rest[0] != '\'')) continue;
    const std::size_t end = rest.find(rest[0], 1);
    return end == std::string_view::npos ? std::string_view() : rest.substr(1, end - 1);
  }
  return {};
}

/// <mouthCue start="0.00" end="0.05">X</mouthCue>.
CueProblem read_xml(std::string_view text, Cues& cues) {
  constexpr std::string_view k_tag = "<mouthCue ";
  for (std::size_t at = text.find(k_tag); at != std::string_view::npos; at = text.find(k_tag, at + 1)) {
    const std::string place = "byte offset " + std::to_string(at);
    const std::size_t close = text.find('>', at);
    const std::size_t end = close == std::string_view::npos ? close : text.find('<', close);
    if (end == std::string_view::npos) return wrong_cues("the cue does not end", place);
    const std::string_view tag = text.substr(at + k_tag.size() - 1, close - at - k_tag.size() + 1);
    if (auto problem = add(cues, base::parse_double(attribute(tag, "start")),
                           base::trim(text.substr(close + 1, end - close - 1)), place)) {
      return problem;
    }
    if (const auto last = base::parse_double(attribute(tag, "end"))) cues.end_s = *last;
  }
  return std::nullopt;
}

bool is_one_of(std::string_view name, std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(), [&](const char* one) { return base::same_but_case(name, one); });
}

/// Spells the shapes as their table does.
void spell_shapes(Cues& cues) {
  constexpr std::array<const char*, 10> k_blair{"AI", "E", "O", "U", "etc", "L", "WQ", "MBP", "FV", "rest"};
  cues.blair = std::any_of(cues.list.begin(), cues.list.end(), [](const CueFile::Cue& cue) {
    return is_one_of(cue.shape, {"AI", "O", "U", "etc", "L", "WQ", "MBP", "FV", "rest"});
  });
  for (CueFile::Cue& cue : cues.list) {
    for (const char* name : k_blair) {
      if (cues.blair && base::same_but_case(cue.shape, name)) cue.shape = name;
    }
    if (!cues.blair && cue.shape.size() == 1) cue.shape[0] = base::upper(cue.shape[0]);
  }
}

}  // namespace

bool is_xml_cues(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '<';
}

bool is_moho_switch(std::string_view text) { return base::trim(text).starts_with("MohoSwitch"); }

bool is_rhubarb_shape(std::string_view name) { return is_one_of(name, {"A", "B", "C", "D", "E", "F", "G", "H", "X"}); }

base::Result<CueFile> read_cues(base::Bytes bytes) {
  const std::string_view text = base::without_mark(base::as_text(bytes));
  Cues cues;
  CueProblem problem;
  if (looks_like_json(bytes)) {
    problem = read_json(bytes, cues);
  } else if (is_xml_cues(text)) {
    problem = read_xml(text, cues);
  } else if (is_moho_switch(text)) {
    problem = read_moho(text, cues);
  } else {
    problem = read_tsv(text, cues);
  }
  if (problem) return *problem;
  if (cues.list.empty()) return wrong_cues("there is no cue", "line 1");
  spell_shapes(cues);
  return cues;
}

}  // namespace penpose::io
