#include "core/document/drawing/face_reader.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/document/features/drawing_start.h"
#include "core/portrait/pose_from_drawing.h"
#include "core/portrait/sketch/pose_over_face.h"

namespace penpose::document {
namespace {

/// A control moves what is drawn where it moves a line of it by this share of what it moves most.
constexpr double k_moves_drawn = 0.3;

double way_of(const portrait::Stretch& curve, std::size_t control) {
  double sum = 0;
  for (const double v : curve.ways[control]) sum += v * v;
  return std::sqrt(sum);
}

/// Whether each control moves a curve that was drawn.
std::vector<bool> move_drawn(const portrait::FaceView& face, const std::vector<portrait::LineRead>& lines) {
  std::vector<bool> drawn(face.curve_count(), false);
  for (const portrait::LineRead& line : lines) {
    if (line.curve) drawn[*line.curve] = true;
    if (line.lower) drawn[*line.lower] = true;
  }
  std::vector<bool> out;
  for (std::size_t j = 0; j < face.controls().size(); ++j) {
    double most = 0, most_drawn = 0;
    for (std::size_t c = 0; c < face.curve_count(); ++c) {
      const double way = way_of(face.curve(c), j);
      most = std::max(most, way);
      if (drawn[c]) most_drawn = std::max(most_drawn, way);
    }
    out.push_back(most_drawn > 0.0 && most_drawn >= k_moves_drawn * most);
  }
  return out;
}

struct Lines {
  std::vector<portrait::DrawnLine> lines;
  std::vector<portrait::GivenLabel> given;
};

/// Lines as another view of the same side shows them. What is said to be a feature that the model does not have is
/// found.
std::optional<Lines> lines_in(const View& view, const FaceDrawing& drawing, const std::vector<std::string>& names) {
  Lines out;
  for (const FaceLine& one : drawing.lines) {
    auto line = line_in(view, drawing, one);
    if (!line) return std::nullopt;
    out.lines.push_back(std::move(*line));
    portrait::GivenLabel given;
    if (one.said && one.said->empty()) {
      given = portrait::k_nothing;
    } else if (one.said) {
      const auto at = std::find(names.begin(), names.end(), *one.said);
      if (at != names.end()) given = static_cast<std::size_t>(at - names.begin());
    }
    out.given.push_back(given);
  }
  return out;
}

}  // namespace

const base::Result<FeatureCurves>& FaceReader::features(const Document& document, const intent::WholeModel& whole) {
  if (!features_ || model_ != document.model) {
    features_ = feature_curves_of(*document.model, whole, {});
    model_ = document.model;
    seen_.reset();
  }
  return *features_;
}

geometry::ModelPoint FaceReader::middle(const Document& document) const {
  std::vector<std::uint32_t> vertices;
  std::vector<double> weights;
  for (const portrait::FeatureCurve& curve : (*features_)->curves) {
    for (const posing::CurvePoint& point : curve.points) {
      vertices.insert(vertices.end(), point.vertex.begin(), point.vertex.end());
      weights.insert(weights.end(), point.weight.begin(), point.weight.end());
    }
  }
  std::vector<geometry::ModelPoint> places(vertices.size());
  document.model->rig->bind(vertices)->evaluate(document.pose, places);
  geometry::ModelPoint sum(0);
  double count = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    sum += places[i] * weights[i];
    count += weights[i];
  }
  return sum / count;
}

base::Result<const portrait::FaceView*> FaceReader::seen(const Document& document, const FeatureCurves& features,
                                                         const View& view, const intent::WholeModel& whole) {
  DrawingStart start = drawing_start(document, whole, features.curves);
  if (seen_ && seen_->view == view && seen_->start == start.pose && seen_->free == start.free) return &seen_->face;
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  if (!camera) return camera.error();
  auto face = portrait::FaceView::make(*document.model->rig, whole, features.curves, start.pose, start.free, *camera);
  if (!face) return face.error();
  seen_.emplace(Seen{view, std::move(start.pose), std::move(start.free), std::move(*face)});
  return &seen_->face;
}

base::Result<FaceReader::Read> FaceReader::read(const Document& document, FaceDrawing drawing,
                                                const intent::WholeModel& whole) {
  const auto& known = features(document, whole);
  if (!known) return known.error();
  const auto face = seen(document, *known, drawing.view, whole);
  if (!face) return face.error();
  const auto names = names_of(known->curves);
  auto lines = lines_in(drawing.view, drawing, names);
  if (!lines) return base::Error{"the drawing cannot be seen in this view", "view", "look at the face"};
  portrait::Drawing asked{std::move(lines->lines), {}, true, std::move(lines->given), {}};
  if (document.neutral) {
    if (auto neutral = lines_in(drawing.view, *document.neutral, names)) {
      asked.neutral = std::move(neutral->lines);
      asked.given_neutral = std::move(neutral->given);
    }
  }
  auto read = portrait::read_drawing(**face, asked);
  if (!read) return read.error();
  rig::Pose posed = portrait::pose_of(*document.model->rig, **face, seen_->start, read->shares);
  if (asked.neutral.empty()) {
    const auto camera = geometry::Camera::make(drawing.view.camera, drawing.view.viewport);
    if (!camera) return camera.error();
    auto over = portrait::pose_over_face(*document.model->rig, whole, known->curves, asked, *read, *camera,
                                         seen_->start, seen_->free);
    if (!over) return over.error();
    posed = std::move(*over);
  }
  Read out{std::move(drawing), document.pose};
  // What was set since the last reading stays.
  const bool goes_on = out.drawing.rig == document.model->rig && out.drawing.base.size() == document.pose.size() &&
                       out.drawing.posed.size() == document.pose.size();
  for (std::size_t p = 0; goes_on && p < out.pose.size(); ++p) {
    if (document.pose[p] == out.drawing.posed[p]) {
      out.pose[p] = out.drawing.base[p];
    } else {
      out.drawing.base[p] = document.pose[p];
    }
  }
  if (!goes_on) out.drawing.base = document.pose;
  out.drawing.rig = document.model->rig;
  const auto parameters = document.model->rig->parameters();
  const auto drawn = move_drawn(**face, read->lines);
  for (std::size_t j = 0; j < (*face)->controls().size(); ++j) {
    const std::size_t p = (*face)->controls()[j].parameter;
    if (drawn[j]) out.pose[p] = std::clamp(posed[p], parameters[p].minimum, parameters[p].maximum);
  }
  out.drawing.posed = out.pose;
  for (std::size_t i = 0; i < read->lines.size(); ++i) {
    const auto& curve = read->lines[i].curve;
    out.drawing.lines[i].feature = curve ? names[*curve] : std::string();
  }
  return out;
}

}  // namespace penpose::document
