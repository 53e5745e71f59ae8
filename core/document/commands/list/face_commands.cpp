#include "core/document/commands/list/face_commands.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/text/closest_name.h"
#include "core/curve/polyline.h"
#include "core/document/commands/apply_parts.h"
#include "core/document/commands/list/posing_commands.h"
#include "core/document/features/feature_near.h"

namespace penpose::document {
namespace {

/// Whether a line of this view goes on with the drawing that is there.
bool goes_on(const Document& document, const View& view) {
  return document.face && document.face->time_s == document.time_s && same_side(document.face->view, view);
}

/// Returns whether a line replaces an older one: most of the older line lies beside it, and not beyond its ends.
bool runs_again(const FaceLine& older, const FaceLine& newer) {
  constexpr double k_most = 0.5;
  const auto& along = newer.line;
  double beside = 0;
  for (const PxPoint& p : older.line) {
    const auto nearest = std::min_element(along.begin(), along.end(), [&](const PxPoint& a, const PxPoint& b) {
      return geometry::distance(a, p) < geometry::distance(b, p);
    });
    if (nearest != along.begin() && nearest != along.end() - 1) beside += 1;
  }
  return beside > k_most * static_cast<double>(older.line.size());
}

PxPoint middle_of(std::span<const PxPoint> line) {
  PxPoint sum{0, 0};
  for (const PxPoint& p : line) sum = sum + p;
  return sum * (1.0 / static_cast<double>(line.size()));
}

/// Returns the line with its middle at that of a feature, as the drawing's view showed it before the drawing. Nothing:
/// the view does not see it.
std::optional<std::vector<PxPoint>> moved_to(const Document& document, const FaceDrawing& drawing,
                                             const portrait::FeatureCurve& feature, std::vector<PxPoint> line) {
  const auto camera = geometry::Camera::make(drawing.view.camera, drawing.view.viewport);
  if (!camera || line.empty()) return std::nullopt;
  const bool known = drawing.base.size() == document.pose.size();
  std::vector<PxPoint> seen;
  for (const auto& point : positions_of(*document.model, known ? drawing.base : document.pose, feature)) {
    const auto px = camera->project(point);
    if (!px) return std::nullopt;
    seen.push_back(*px);
  }
  if (seen.empty()) return std::nullopt;
  const PxPoint by = middle_of(seen) - middle_of(line);
  for (PxPoint& p : line) p = p + by;
  return line;
}

/// The document with a line more, which takes the place of one of the same feature that it runs along again.
Changed with_line(const Document& document, FaceDrawing drawing, Parts& work) {
  auto changed = with_face_read(document, drawing, work);
  if (!changed || !changed->face) return changed;
  const std::vector<FaceLine>& read = changed->face->lines;
  const FaceLine& last = read.back();
  std::vector<CurveId> replaced;
  for (const FaceLine& one : read) {
    if (one.id != last.id && !last.feature.empty() && one.feature == last.feature && runs_again(one, last))
      replaced.push_back(one.id);
  }
  if (replaced.empty()) return changed;
  std::erase_if(drawing.lines, [&](const FaceLine& one) {
    return std::find(replaced.begin(), replaced.end(), one.id) != replaced.end();
  });
  return with_face_read(document, std::move(drawing), work);
}

}  // namespace

Changed with_face_read(const Document& document, FaceDrawing drawing, Parts& work) {
  Document changed = document;
  if (drawing.lines.empty()) {
    changed.face = nullptr;
    return changed;
  }
  auto read = work.face.read(document, std::move(drawing), work.whole_of(document));
  if (!read) return read.error();
  changed.pose = std::move(read->pose);
  changed.face = std::make_shared<const FaceDrawing>(std::move(read->drawing));
  return changed;
}

std::span<const portrait::FeatureCurve> features_of(const Document& document, ApplyWorkspace& work) {
  return all_features_of(document, work).curves;
}

const FeatureCurves& all_features_of(const Document& document, ApplyWorkspace& work) {
  static const FeatureCurves none;
  Parts& parts = work.parts();
  const auto& features = parts.face.features(document, parts.whole_of(document));
  return features ? *features : none;
}

Changed run(const Document& document, const DrawFaceLine& command, Parts& work) {
  if (const auto camera = geometry::Camera::make(command.view.camera, command.view.viewport); !camera)
    return at("view", camera.error());
  if (!work.face.features(document, work.whole_of(document))) {
    if (const auto curve = waiting_reference(document))
      return run(document, DrawTarget{*curve, command.view, command.line, {}}, work);
    return run(document, DrawReference{{command.view, command.line}}, work);
  }
  FaceDrawing drawing;
  drawing.view = command.view;
  drawing.time_s = document.time_s;
  drawing.middle = work.face.middle(document);
  std::vector<PxPoint> line = command.line;
  if (goes_on(document, command.view)) {
    drawing = *document.face;
    auto there = line_in(drawing.view, command.view, line, drawing.middle);
    if (!there) return base::Error{"the line cannot be seen in this view", "view", "look at the face"};
    line = std::move(*there);
  }
  if (drawing.lines.size() >= k_most_face_lines) {
    return base::Error{"the drawing has 60 lines, which is all that are read together", "line",
                       "erase some, or clear the drawing"};
  }
  const auto even = curve::resample<PxPoint>(line, k_line_points);
  if (!even) return at("line", even.error());
  if (document.last_curve == std::numeric_limits<std::uint32_t>::max())
    return base::Error{"all numbers of curves are used up", "", "draw on in a new document"};
  Document changed = document;
  drawing.lines.push_back({CurveId{++changed.last_curve}, *even, std::nullopt, {}});
  return with_line(changed, std::move(drawing), work);
}

Changed run(const Document& document, const NameFaceLine& command, Parts& work) {
  FaceDrawing drawing = document.face ? *document.face : FaceDrawing{};
  const auto line = std::find_if(drawing.lines.begin(), drawing.lines.end(),
                                 [&](const FaceLine& one) { return one.id == command.curve; });
  if (line == drawing.lines.end()) {
    return base::Error{"there is no line " + std::to_string(command.curve.value) + " of a face", "curve",
                       "it may have been deleted"};
  }
  const auto& features = work.face.features(document, work.whole_of(document));
  if (!features) return features.error();
  if (command.nothing) {
    line->said = std::string();
  } else if (command.feature.empty()) {
    line->said = std::nullopt;
  } else {
    const std::vector<std::string> names = names_of(features->curves);
    const auto name = std::find(names.begin(), names.end(), command.feature);
    if (name == names.end()) {
      const auto close = base::closest_name(command.feature, names);
      return base::Error{"the face has no feature \"" + command.feature + "\"", "feature",
                         close ? "did you mean " + *close + "?" : "take one of those that it has"};
    }
    line->said = command.feature;
    if (command.form) {
      auto moved =
          moved_to(document, drawing, features->curves[static_cast<std::size_t>(name - names.begin())], line->line);
      if (!moved) return base::Error{"the drawing does not see the feature", "feature", "draw it where it is seen"};
      line->line = std::move(*moved);
    }
  }
  return with_face_read(document, std::move(drawing), work);
}

Changed run(const Document& document, const SetNeutral& command, Parts&) {
  Document changed = document;
  if (!command.on) {
    if (!document.neutral) return base::Error{"no neutral drawing is kept", "on", "draw the face at rest and keep it"};
    changed.neutral = nullptr;
    return changed;
  }
  if (!document.face) return base::Error{"no face is drawn", "on", "draw the face at rest first"};
  FaceDrawing neutral = *document.face;
  if (neutral.rig == document.model->rig && neutral.base.size() == document.pose.size()) changed.pose = neutral.base;
  neutral.rig = nullptr;
  neutral.base.clear();
  neutral.posed.clear();
  changed.neutral = std::make_shared<const FaceDrawing>(std::move(neutral));
  changed.face = nullptr;
  return changed;
}

}  // namespace penpose::document
