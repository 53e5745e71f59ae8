#include "core/portrait/read_drawing.h"

#include <algorithm>
#include <cmath>

#include "core/curve/polyline.h"
#include "core/portrait/reading/reader.h"

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
  PxPoint low{1e300, 1e300}, high{-1e300, -1e300};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string place = std::string(sheet) + ", line " + std::to_string(i);
    for (const PxPoint& p : lines[i]) {
      if (!(std::abs(p.x) < 1e9 && std::abs(p.y) < 1e9))
        return base::Error{"a point is not on a sheet", place, "use numbers of px"};
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    if (lines[i].size() < 2 || !(curve::arc_length<PxPoint>(lines[i]) > 0.0))
      return base::Error{"a line has no length", place, "leave dots out"};
  }
  const PxPoint size = high - low;
  return Sheet{(low + high) * 0.5, k_face_px / std::sqrt(size.x * size.x + size.y * size.y)};
}

std::vector<Trace> traces_of(std::span<const DrawnLine> lines, const Sheet& frame) {
  std::vector<Trace> out;
  for (const DrawnLine& line : lines) {
    DrawnLine framed;
    for (const PxPoint& p : line) framed.push_back((p - frame.middle) * frame.scale);
    out.push_back(trace_of(framed));
  }
  return out;
}

std::vector<LineRead> lines_of(const Stretches& stretches, const Reading& reading) {
  std::vector<LineRead> out;
  for (const Label& label : reading.labels) {
    if (label.stretch == k_nothing) {
      out.push_back({});
      continue;
    }
    const Stretch& stretch = stretches[label.stretch];
    out.push_back({stretch.curve, stretch.from, stretch.to, label.reversed});
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
    for (std::size_t p = 0; p < ways.size(); ++p) {
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
constexpr Hand k_drawn_over{0.03, 1.0};

/// How the same hand draws once its face at rest is known: its proportions are those of that sheet, and the lines of
/// both stray.
constexpr Hand k_known_hand{0.02, 1.3};

}  // namespace

base::Result<DrawingRead> read_drawing(const FaceView& face, const Drawing& drawing) {
  if (drawing.lines.empty()) return base::Error{"the drawing has no lines", "", "draw the features of the face"};
  if (!drawing.given.empty() && drawing.given.size() != drawing.lines.size())
    return base::Error{"there are other numbers of labels than of lines", "given", "give one a line"};
  const auto on_sheet = [&](std::span<const DrawnLine> lines, const char* name) {
    auto sheet = sheet_of(lines, name);
    if (sheet && drawing.in_view) *sheet = {face.middle(), face.scale()};
    return sheet;
  };
  const auto sheet = on_sheet(drawing.lines, "drawing");
  if (!sheet) return sheet.error();
  const Hand hand = drawing.in_view ? k_drawn_over : Hand{};
  const auto lines = traces_of(drawing.lines, *sheet);
  DrawingRead out;
  std::optional<FaceView> own;
  if (!drawing.neutral.empty()) {
    const auto neutral = on_sheet(drawing.neutral, "neutral drawing");
    if (!neutral) return neutral.error();
    const auto traces = traces_of(drawing.neutral, *neutral);
    SheetReader reader(face, traces, {Hand{}, drawing.in_view, true, drawing.given_neutral});
    const Reading reading = reader.read();
    out.neutral = lines_of(reader.stretches(), reading);
    own = face.drawn_as(rest_of(face, reader.stretches(), reading, traces), true);
  }
  const bool known = own.has_value();
  const Sketching drawn{known ? k_known_hand : hand, drawing.in_view, false, drawing.given};
  SheetReader reader(known ? *own : face, lines, drawn);
  Reading reading = reader.read();
  if (known) {
    out.lines = lines_of(reader.stretches(), reading);
  } else {
    // What controls do is drawn in the same proportions.
    own = face.drawn_as(rest_of(face, reader.stretches(), reading, {}), false);
    SheetReader again(*own, lines, drawn);
    reading = again.read_from(reading, reader.stretches());
    out.lines = lines_of(again.stretches(), reading);
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
