#include "core/portrait/read_drawing.h"

#include <algorithm>
#include <cmath>

#include "core/curve/polyline.h"
#include "core/portrait/reading/reader.h"
#include "core/portrait/reading/strokes.h"

namespace penpose::portrait {
namespace {

/// A sheet's frame: its lines about their middle, as large as a face.
struct Sheet {
  PxPoint middle{0, 0};
  double scale = 1;
};

base::Result<Sheet> sheet_of(std::span<const DrawnLine> lines, const char* sheet) {
  if (lines.size() > k_most_lines) {
    return base::Error{std::to_string(lines.size()) + " lines are more than the 60 of a face", sheet,
                       "draw fewer, longer lines"};
  }
  if (auto status = check_lines(lines, sheet); !status) return status.error();
  PxPoint low{1e300, 1e300}, high{-1e300, -1e300};
  for (const DrawnLine& line : lines) {
    for (const PxPoint& p : line) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  const PxPoint size = high - low;
  return Sheet{(low + high) * 0.5, k_face_px / std::sqrt(size.x * size.x + size.y * size.y)};
}

std::vector<Trace> traces_of(std::span<const Stroke> strokes, const Sheet& frame) {
  std::vector<Trace> out;
  for (const Stroke& stroke : strokes) {
    DrawnLine framed;
    for (const PxPoint& p : stroke.points) framed.push_back((p - frame.middle) * frame.scale);
    out.push_back(trace_of(framed));
  }
  return out;
}

/// What was said of each stroke; empty where nothing was.
std::vector<GivenLabel> given_of(std::span<const Stroke> strokes, std::span<const GivenLabel> given) {
  std::vector<GivenLabel> out;
  for (const Stroke& stroke : strokes) {
    const std::size_t line = stroke.lines.front();
    if (!given.empty()) out.push_back(line < given.size() ? given[line] : std::nullopt);
  }
  return out;
}

/// What the lines of a drawing were taken for, by their strokes.
std::vector<LineRead> lines_of(const FaceView& face, const Stretches& stretches, const Reading& reading,
                               std::span<const Stroke> strokes, std::size_t count) {
  std::vector<LineRead> out(count);
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const Label& label = reading.labels[i];
    if (label.stretch == k_nothing) continue;
    const Stretch& stretch = stretches[label.stretch];
    const auto curve = face.meant(stretch.curve);
    if (!curve) continue;
    for (const std::size_t line : strokes[i].lines) {
      if (strokes[i].lower) {
        out[line].lower = curve;
      } else {
        out[line].curve = curve;
        out[line].from = stretch.from;
        out[line].to = stretch.to;
        out[line].reversed = label.reversed;
      }
    }
  }
  for (LineRead& line : out) {
    if (!line.curve) std::swap(line.curve, line.lower);
  }
  return out;
}

/// The curves at rest as a sheet shows them: where it has a line of them, that; else the model's in its proportions.
std::vector<std::vector<PxPoint>> rest_of(const FaceView& face, const Stretches& stretches, const Reading& reading,
                                          std::span<const Trace> lines) {
  std::vector<std::vector<PxPoint>> out;
  for (std::size_t c = 0; c < face.curve_count(); ++c) {
    const auto rest = face.rest_line(c);
    const auto ways = face.proportion_lines(c);
    std::vector<PxPoint> own(rest.begin(), rest.end()), drawn(rest.size());
    std::vector<double> counts(rest.size(), 0.0);
    for (std::size_t p = 0; p < reading.proportions.size(); ++p) {
      for (std::size_t i = 0; i < own.size(); ++i) own[i] = own[i] + ways[p][i] * reading.proportions[p];
    }
    for (std::size_t l = 0; l < lines.size(); ++l) {
      const Label& label = reading.labels[l];
      if (label.stretch == k_nothing) continue;
      const Stretch& stretch = stretches[label.stretch];
      if (stretch.curve != c) continue;
      const Trace there = reading.placement(lines[l]);
      for (std::size_t i = 0; i < own.size(); ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(own.size() - 1);
        double along = (share - stretch.from) / (stretch.to - stretch.from);
        if (along < -1e-9 || along > 1.0 + 1e-9) continue;
        along = std::clamp(label.reversed ? 1.0 - along : along, 0.0, 1.0) * static_cast<double>(k_points - 1);
        const std::size_t k = std::min(static_cast<std::size_t>(along), k_points - 2);
        const double f = along - static_cast<double>(k);
        const PxPoint a{there[2 * k], there[2 * k + 1]}, b{there[2 * k + 2], there[2 * k + 3]};
        drawn[i] = drawn[i] + a * (1.0 - f) + b * f;
        counts[i] += 1.0;
      }
    }
    // Beyond what was drawn of a curve, the rest of it goes along.
    std::optional<std::size_t> first, last;
    std::vector<PxPoint> offset(own.size());
    for (std::size_t i = 0; i < own.size(); ++i) {
      if (counts[i] == 0.0) continue;
      offset[i] = drawn[i] * (1.0 / counts[i]) - own[i];
      if (!first) first = i;
      for (std::size_t k = last ? *last + 1 : i; k < i; ++k) {
        const double f = static_cast<double>(k - *last) / static_cast<double>(i - *last);
        offset[k] = offset[*last] * (1.0 - f) + offset[i] * f;
      }
      last = i;
    }
    for (std::size_t i = 0; first && i < own.size(); ++i)
      own[i] = own[i] + (i < *first ? offset[*first] : i > *last ? offset[*last] : offset[i]);
    out.push_back(std::move(own));
  }
  return out;
}

/// How a hand draws over a face that it sees.
constexpr Hand k_drawn_over{0.03, 1.0, true};

/// How the same hand draws once its face at rest is known: its proportions are those of that sheet, and the lines of
/// both stray.
constexpr Hand k_known_hand{0.005, 1.3};

/// A drawing shows this very face if its lines cost at most this, on the mean.
constexpr double k_like_this_face = 18.5;

}  // namespace

base::Status check_lines(std::span<const DrawnLine> lines, const char* sheet) {
  if (lines.empty()) return base::Error{"the drawing has no lines", "", "draw the features of the face"};
  if (lines.size() > k_most_drawn_lines) {
    return base::Error{std::to_string(lines.size()) + " lines are more than the " + std::to_string(k_most_drawn_lines) +
                           " of a drawing",
                       sheet, "draw fewer, longer lines"};
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string place = std::string(sheet) + ", line " + std::to_string(i);
    for (const PxPoint& p : lines[i]) {
      if (!(std::abs(p.x) < 1e9 && std::abs(p.y) < 1e9))
        return base::Error{"a point is not on a sheet", place, "use numbers of px"};
    }
    if (lines[i].size() < 2 || !(curve::arc_length<PxPoint>(lines[i]) > 0.0))
      return base::Error{"a line has no length", place, "leave dots out"};
  }
  return base::Done{};
}

base::Result<DrawingRead> read_drawing(const FaceView& face, const Drawing& drawing) {
  if (drawing.lines.empty()) return base::Error{"the drawing has no lines", "", "draw the features of the face"};
  if (!drawing.given.empty() && drawing.given.size() != drawing.lines.size())
    return base::Error{"there are other numbers of labels than of lines", "given", "give one a line"};
  for (const auto& labels : {drawing.given, drawing.given_neutral}) {
    for (const GivenLabel& label : labels) {
      if (label && *label != k_nothing && *label >= face.curve_count())
        return base::Error{"the face has no curve " + std::to_string(*label), "given", "name one that it has"};
    }
  }
  const auto on_sheet = [&](std::span<const DrawnLine> lines, const char* name) {
    auto sheet = sheet_of(lines, name);
    if (sheet && drawing.in_view) *sheet = {face.middle(), face.scale()};
    return sheet;
  };
  const auto sheet = on_sheet(drawing.lines, "drawing");
  if (!sheet) return sheet.error();
  const Hand hand = drawing.in_view ? k_drawn_over : Hand{};
  const auto strokes = strokes_of(drawing.lines, drawing.given);
  const auto given = given_of(strokes, drawing.given);
  const auto lines = traces_of(strokes, *sheet);
  DrawingRead out;
  std::optional<FaceView> own;
  if (!drawing.neutral.empty()) {
    const auto neutral = on_sheet(drawing.neutral, "neutral drawing");
    if (!neutral) return neutral.error();
    const auto neutral_strokes = strokes_of(drawing.neutral, drawing.given_neutral);
    const auto given_neutral = given_of(neutral_strokes, drawing.given_neutral);
    const auto traces = traces_of(neutral_strokes, *neutral);
    SheetReader reader(face, traces, {Hand{}, drawing.in_view, true, given_neutral});
    const Reading reading = reader.read();
    out.neutral = lines_of(face, reader.stretches(), reading, neutral_strokes, drawing.neutral.size());
    own = face.drawn_as(rest_of(face, reader.stretches(), reading, traces), true);
  }
  const bool known = own.has_value();
  Sketching drawn{known ? k_known_hand : hand, drawing.in_view, false, given};
  drawn.hand.over = drawing.in_view;
  SheetReader reader(known ? *own : face, lines, drawn);
  Reading reading = reader.read();
  out.of_this_face = known || drawing.in_view || reading.energy < k_like_this_face * static_cast<double>(lines.size());
  if (!out.of_this_face) {
    out.lines.resize(drawing.lines.size());
    out.shares.assign(face.controls().size(), 0.0);
    out.proportions.assign(face.proportion_count(), 0.0);
    out.energy = reading.energy;
    return out;
  }
  // What is drawn over a face is in its proportions.
  if (known || drawing.in_view) {
    out.lines = lines_of(face, reader.stretches(), reading, strokes, drawing.lines.size());
  } else {
    // What controls do is drawn in the same proportions.
    own = face.drawn_as(rest_of(face, reader.stretches(), reading, {}), false);
    SheetReader again(*own, lines, drawn);
    reading = again.read_from(reading, reader.stretches());
    out.lines = lines_of(face, again.stretches(), reading, strokes, drawing.lines.size());
  }
  out.shares = reading.pose.shares;
  out.proportions = reading.proportions;
  out.energy = reading.energy;
  const Placement& p = reading.placement;
  out.placement = {p.along * sheet->scale, p.across * sheet->scale, PxPoint{0, 0}};
  out.placement.shift = p.shift - out.placement(sheet->middle);
  return out;
}

}  // namespace penpose::portrait
