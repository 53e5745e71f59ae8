#include "core/portrait/read_drawing.h"

#include <algorithm>
#include <cmath>

#include "core/curve/polyline.h"
#include "core/portrait/reader.h"

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

std::vector<LineRead> lines_of(const FaceView& face, const Reading& reading) {
  std::vector<LineRead> out;
  for (const Label& label : reading.labels) {
    const Stretch& stretch = face.stretches()[label.stretch];
    out.push_back({stretch.curve, stretch.from, stretch.to, label.reversed});
  }
  return out;
}

}  // namespace

base::Result<DrawingRead> read_drawing(const FaceView& face, const Drawing& drawing) {
  if (drawing.lines.empty()) return base::Error{"the drawing has no lines", "", "draw the features of the face"};
  const auto frame = sheet_of(drawing.lines, "drawing");
  if (!frame) return frame.error();
  const auto lines = traces_of(drawing.lines, *frame);
  SheetReader reader(face, lines, false);
  const Reading reading = reader.read();
  DrawingRead out;
  out.shares = reading.pose.shares;
  out.lines = lines_of(face, reading);
  out.proportions = reading.proportions;
  out.energy = reading.energy;
  const Placement& p = reading.placement;
  out.placement = {p.along * frame->scale, p.across * frame->scale, PxPoint{0, 0}};
  out.placement.shift = p.shift - out.placement(frame->middle);
  return out;
}

}  // namespace penpose::portrait
