#include "ui/capi/from_c.h"

using namespace penpose;        // NOLINT(google-build-using-namespace): functions of C have no namespace of their own
using namespace penpose::capi;  // NOLINT(google-build-using-namespace)

namespace {

std::vector<portrait::DrawnLine> lines_of(const penpose_line* lines, std::size_t count, const char* name) {
  std::vector<portrait::DrawnLine> out;
  for (const penpose_line& line : array(lines, count, name)) out.push_back(line_of(line.px, line.count, name));
  return out;
}

penpose_line_read read_to_c(const portrait::LineRead& line, const std::vector<portrait::FeatureCurve>& curves) {
  penpose_line_read out{};
  if (!line.curve) return out;
  copy_text(curves[*line.curve].name, out.curve);
  out.from = line.from;
  out.to = line.to;
  out.reversed = line.reversed ? 1 : 0;
  return out;
}

}  // namespace

int32_t penpose_draw_face(penpose_library* library, penpose_handle character, const penpose_view* view,
                          const penpose_line* lines, size_t count, const penpose_line* neutral, size_t neutral_count,
                          penpose_line_read* read, penpose_error* error) {
  return call_character(library, character, error, [&](character::Character& one, CharacterObject&) {
    const portrait::Drawing drawing{lines_of(lines, count, "lines"), lines_of(neutral, neutral_count, "neutral")};
    const auto drawn = taken(one.draw_face(drawing, view == nullptr ? std::nullopt : std::optional(view_of(*view))));
    if (read == nullptr) return;
    for (const auto* sheet : {&drawn.read.lines, &drawn.read.neutral}) {
      for (const portrait::LineRead& line : *sheet) *read++ = read_to_c(line, drawn.features.curves);
    }
  });
}
