#include <algorithm>

#include "core/base/numbers.h"
#include "core/io/text/text_lines.h"
#include "core/io/tracks/cues/internal/cue_reader.h"

namespace penpose::io {
namespace {

/// "01:02:03,450", "02:03.450" or "3.45".
std::optional<double> caption_time(std::string_view text) {
  text = base::trim(text);
  double seconds = 0;
  int parts = 0;
  while (parts < 3) {
    const std::size_t colon = text.find(':');
    std::string part(text.substr(0, colon));
    std::replace(part.begin(), part.end(), ',', '.');
    const auto number = base::parse_double(part);
    if (!number || !(*number >= 0)) return std::nullopt;
    seconds = seconds * 60 + *number;
    ++parts;
    if (colon == std::string_view::npos) return seconds;
    text.remove_prefix(colon + 1);
  }
  return std::nullopt;
}

struct CaptionTime {
  double from_s = 0, to_s = 0;
};

/// "FROM --> TO", behind which WebVTT may say where the text stands.
std::optional<CaptionTime> times_in(std::string_view line) {
  const std::size_t arrow = line.find("-->");
  if (arrow == std::string_view::npos) return std::nullopt;
  std::string_view end = base::trim(line.substr(arrow + 3));
  end = end.substr(0, end.find_first_of(" \t"));
  const auto from = caption_time(line.substr(0, arrow));
  const auto to = caption_time(end);
  if (!from || !to) return std::nullopt;
  return CaptionTime{*from, *to};
}

/// A part of a caption: its text, when it is said where the text tells, and whether it is marked as what is said now.
struct CaptionPart {
  std::optional<double> from_s;
  std::string text;
  bool marked = false;
};

/// The parts of a line between its tags: <00:01.500> tells a time, <u>, <b>, <i> and <font> mark.
std::vector<CaptionPart> parts_of(std::string_view line, std::size_t& depth) {
  std::vector<CaptionPart> parts(1);
  parts.back().marked = depth > 0;
  while (!line.empty()) {
    const std::size_t open = line.find('<');
    const std::size_t close = open == std::string_view::npos ? open : line.find('>', open);
    if (close == std::string_view::npos) {
      parts.back().text += line;
      break;
    }
    parts.back().text += line.substr(0, open);
    const std::string_view tag = line.substr(open + 1, close - open - 1);
    line.remove_prefix(close + 1);
    const bool ends = tag.starts_with('/');
    const std::string_view name = tag.substr(ends ? 1 : 0, tag.substr(ends ? 1 : 0).find_first_of(" .="));
    const bool marks = name == "u" || name == "b" || name == "i" || name == "font";
    if (const auto time = caption_time(tag)) {
      parts.push_back({time, "", depth > 0});
    } else if (marks) {
      depth = ends ? (depth > 0 ? depth - 1 : 0) : depth + 1;
      parts.push_back({std::nullopt, "", depth > 0});
    }
  }
  return parts;
}

/// Returns the spoken part of a text: without [music], (laughs), {\an8}, the name of who speaks, and &amp;.
std::string heard_of(std::string_view text) {
  std::string out;
  char until = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (until != 0) {
      if (c == until) until = 0;
    } else if (c == '[' || c == '(' || c == '{') {
      const char close = c == '[' ? ']' : c == '(' ? ')' : '}';
      if (text.find(close, i) != std::string_view::npos) until = close;
    } else if (c == '&') {
      const std::size_t end = text.find(';', i);
      if (end != std::string_view::npos && end - i < 8) i = end;
      out += ' ';
    } else {
      out += c;
    }
  }
  // "ANNA: hello".
  const std::size_t colon = out.find(": ");
  const bool speaker = colon != std::string::npos && colon < 30 && colon > 0 &&
                       std::all_of(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(colon),
                                   [](char c) { return !(c >= 'a' && c <= 'z'); });
  return speaker ? out.substr(colon + 2) : out;
}

struct Caption {
  CaptionTime time;
  std::vector<CaptionPart> parts;
  std::string place;
};

bool is_blank_text(std::string_view text) { return text.find_first_not_of(" \t\r\n\xa0") == std::string_view::npos; }

/// Returns true if only one word is marked: such captions mark the word that is being said.
bool marks_a_word(const Caption& caption) {
  bool marked = false, plain = false;
  for (const CaptionPart& part : caption.parts) {
    if (is_blank_text(part.text)) continue;
    (part.marked ? marked : plain) = true;
  }
  return marked && plain;
}

bool tells_times(const Caption& caption) {
  return std::any_of(caption.parts.begin(), caption.parts.end(),
                     [](const auto& part) { return part.from_s.has_value(); });
}

base::Result<std::vector<Caption>> captions_in(std::string_view text, CueBuilder& cues) {
  constexpr std::size_t k_most_captions = 300'000;
  std::vector<Caption> captions;
  TextLines lines(text);
  bool inside = false;
  std::size_t depth = 0;
  while (const auto line = lines.next()) {
    if (line->find("-->") != std::string_view::npos) {
      const auto time = times_in(*line);
      const std::string place = "line " + std::to_string(lines.number());
      if (!time) return cues.wrong("the times of a caption were expected", place);
      if (captions.size() >= k_most_captions) return cues.wrong("a file has at most 300,000 captions", place);
      captions.push_back({*time, {}, place});
      inside = true;
      depth = 0;
    } else if (base::trim(*line).empty()) {
      inside = false;
    } else if (inside) {
      auto parts = parts_of(*line, depth);
      // Lines are words apart; a line whose words have times begins with the caption.
      if (parts.size() > 1 && parts[1].from_s && !is_blank_text(parts[0].text))
        parts[0].from_s = captions.back().time.from_s;
      for (CaptionPart& part : parts) captions.back().parts.push_back(std::move(part));
      captions.back().parts.back().text += ' ';
    }
  }
  return captions;
}

CueProblem read_captions(std::string_view text, CueBuilder& cues) {
  const auto captions = captions_in(text, cues);
  if (!captions) return captions.error();
  const bool timed = std::any_of(captions->begin(), captions->end(), tells_times);
  const auto marking = static_cast<std::size_t>(std::count_if(captions->begin(), captions->end(), marks_a_word));
  const bool marked = !timed && captions->size() > 2 && 2 * marking >= captions->size();
  for (const Caption& caption : *captions) {
    // Where words have times, captions without repeat what was said before.
    if (timed && !tells_times(caption)) continue;
    if (marked && !marks_a_word(caption)) continue;
    std::string whole;
    for (std::size_t i = 0; i < caption.parts.size(); ++i) {
      const CaptionPart& part = caption.parts[i];
      if (!timed) {
        if (!marked || part.marked) whole += part.text;
        continue;
      }
      if (!part.from_s || is_blank_text(part.text)) continue;
      double to_s = caption.time.to_s;
      for (std::size_t k = i + 1; k < caption.parts.size(); ++k) {
        if (!caption.parts[k].from_s) continue;
        to_s = *caption.parts[k].from_s;
        break;
      }
      if (auto problem = cues.word(part.from_s, to_s, heard_of(part.text), caption.place)) return problem;
    }
    if (timed || is_blank_text(whole)) continue;
    if (auto problem = cues.word(caption.time.from_s, caption.time.to_s, heard_of(whole), caption.place))
      return problem;
  }
  return std::nullopt;
}

}  // namespace

CueReader captions_reader() {
  return {"captions (SRT, WebVTT)", "save the captions again as SRT or WebVTT",
          [](std::string_view text) {
            const auto start = text.find_first_not_of(" \t\r\n");
            if (start == std::string_view::npos) return false;
            text.remove_prefix(start);
            if (text.starts_with("WEBVTT")) return true;
            TextLines lines(text.substr(0, 1000));
            for (int i = 0; i < 3; ++i) {
              const auto line = lines.next();
              if (line && times_in(*line)) return true;
            }
            return false;
          },
          read_captions};
}

}  // namespace penpose::io
