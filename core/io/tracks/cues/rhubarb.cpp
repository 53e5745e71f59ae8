#include "core/base/json/loose_json.h"
#include "core/base/numbers.h"
#include "core/base/text/letters.h"
#include "core/io/text/text_lines.h"
#include "core/io/tracks/cues/internal/cue_reader.h"

namespace penpose::io {
namespace {

bool begins_xml(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '<';
}

CueProblem read_rhubarb_json(std::string_view text, CueBuilder& cues) {
  const auto root = json::parse_loose_json(base::as_bytes(text));
  if (!root) return root.error();
  const json::Json* list = json::find(*root, "mouthCues");
  if (list == nullptr || !list->is_array()) return cues.wrong("a list of cues was expected", "/mouthCues");
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string place = json::child("/mouthCues", i);
    const json::Json* start = json::find((*list)[i], "start");
    const json::Json* end = json::find((*list)[i], "end");
    const json::Json* value = json::find((*list)[i], "value");
    if (start == nullptr || value == nullptr || !value->is_string()) return cues.wrong("a cue was expected", place);
    if (auto problem = cues.shape(json::number(*start), value->get_ref<const std::string&>(), place)) return problem;
    if (end != nullptr) cues.end(json::number(*end).value_or(0));
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
CueProblem read_rhubarb_xml(std::string_view text, CueBuilder& cues) {
  constexpr std::string_view k_tag = "<mouthCue ";
  for (std::size_t at = text.find(k_tag); at != std::string_view::npos; at = text.find(k_tag, at + 1)) {
    const std::string place = "byte offset " + std::to_string(at);
    const std::size_t close = text.find('>', at);
    const std::size_t end = close == std::string_view::npos ? close : text.find('<', close);
    if (end == std::string_view::npos) return cues.wrong("the cue does not end", place);
    const std::string_view tag = text.substr(at + k_tag.size() - 1, close - at - k_tag.size() + 1);
    if (auto problem = cues.shape(base::parse_double(attribute(tag, "start")),
                                  base::trim(text.substr(close + 1, end - close - 1)), place)) {
      return problem;
    }
    cues.end(base::parse_double(attribute(tag, "end")).value_or(0));
  }
  return std::nullopt;
}

/// Returns true if the text begins with a time, a tab and one of Rhubarb's letters.
bool begins_with_letter(std::string_view text) {
  const std::string_view line = base::trim(text.substr(0, std::min(text.find_first_of("\r\n"), text.size())));
  const std::size_t tab = line.find('\t');
  if (tab == std::string_view::npos || !base::parse_double(line.substr(0, tab))) return false;
  const std::string_view name = base::trim(line.substr(tab));
  return name.size() == 1 && speech::k_mouth_letters.find(base::upper(name[0])) != std::string_view::npos;
}

}  // namespace

CueProblem read_timed_names(std::string_view text, CueBuilder& cues) {
  TextLines lines(text);
  while (const auto line = lines.next()) {
    const std::string_view bare = base::trim(*line);
    if (bare.empty()) continue;
    const std::string place = "line " + std::to_string(lines.number());
    const std::size_t gap = bare.find_first_of("\t ");
    const auto start_s = base::parse_double(bare.substr(0, std::min(gap, bare.size())));
    if (cues.empty() && (gap == std::string_view::npos || !start_s))
      return cues.wrong("this is no list of cues that is read here", place);
    if (gap == std::string_view::npos) return cues.wrong("a time and a mouth shape were expected", place);
    if (auto problem = cues.shape(start_s, base::trim(bare.substr(gap)), place)) return problem;
  }
  return std::nullopt;
}

CueReader rhubarb_reader() {
  return {"Rhubarb (tsv, xml, json)", "export the cues again with Rhubarb Lip Sync",
          [](std::string_view text) {
            if (begins_json(text)) return mentions(text, "\"mouthCues\"");
            return begins_xml(text) ? mentions(text, "<mouthCue") : begins_with_letter(text);
          },
          [](std::string_view text, CueBuilder& cues) {
            if (begins_json(text)) return read_rhubarb_json(text, cues);
            return begins_xml(text) ? read_rhubarb_xml(text, cues) : read_timed_names(text, cues);
          }};
}

}  // namespace penpose::io
