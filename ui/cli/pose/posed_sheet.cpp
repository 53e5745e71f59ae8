#include "ui/cli/pose/posed_sheet.h"

#include <algorithm>
#include <cmath>

#include "core/document/features/drawing_start.h"
#include "core/portrait/contour/pose_from_contours.h"
#include "core/portrait/pose_from_drawing.h"
#include "ui/render/framing.h"

namespace penpose::cli {
namespace {

/// Every so many points of a feature that was read hold the contours' pose.
constexpr std::size_t k_kept_step = 3;

/// The views in which contours may be drawn: as `penpose render` frames the whole model, and its face.
std::vector<geometry::Camera> views_of(const document::Model& model, const io::PictureLines& drawn,
                                       double yaw_degrees) {
  const bool sized = drawn.width > 0.0 && drawn.height > 0.0;
  const double width = sized ? std::clamp(1000.0 * drawn.width / drawn.height, 50.0, 20000.0) : 1000.0;
  const geometry::Viewport viewport{static_cast<int>(std::round(width)), 1000};
  document::Model rest = model;
  rest.pose = rig::rest_pose(*model.rig);
  const auto places = document::posed_positions(rest);
  const std::vector<glm::vec3> points(places.begin(), places.end());
  std::vector<geometry::Camera> views{render::frame_points(points, viewport, {yaw_degrees, 0})};
  std::vector<glm::vec3> face;
  for (const std::uint32_t v : render::face_vertices(model)) face.push_back(points[v]);
  if (!face.empty()) views.push_back(render::frame_points(face, viewport, {yaw_degrees, 0}));
  return views;
}

/// What is read of a face's features, and the camera that sees them so.
struct Seen {
  portrait::DrawnPose posed;
  geometry::Camera camera;
};

/// Returns whether a sheet lies in a view as a picture from there does, so that it is one or was drawn over one.
bool is_picture_of(const io::PictureLines& drawn, const portrait::Placement& sheet, const geometry::Camera& view) {
  constexpr double k_apart = 0.05;  // of the sheet's size
  if (!(drawn.width > 0.0 && drawn.height > 0.0)) return false;
  const double scale = view.viewport().height / drawn.height;
  const geometry::PxPoint middle{0.5 * drawn.width, 0.5 * drawn.height};
  return std::abs(sheet.along / scale - 1.0) + std::abs(sheet.across / scale) < k_apart &&
         geometry::distance(sheet(middle), middle * scale) < k_apart * view.viewport().height;
}

/// Reads features as a drawing sees them, from afar, and as a picture of the program shows them, from near, where the
/// sheet lies as such a picture and its lines fit better. Errors: those of portrait::pose_from_drawing.
base::Result<Seen> read_features(const SheetReading& reading, const io::PictureLines& drawn,
                                 const portrait::Drawing& drawing, const document::DrawingStart& start) {
  const document::Model& model = *reading.document.model;
  const auto read = [&](const portrait::Drawing& sheet, const geometry::Camera& camera) {
    return portrait::pose_from_drawing(*model.rig, reading.whole, reading.curves, sheet, camera, start.pose,
                                       start.free);
  };
  const auto far = portrait::camera_of_drawing(*model.rig, reading.curves, start.pose, reading.yaw_degrees);
  auto posed = read(drawing, far);
  if (!posed) return posed.error();
  Seen best{std::move(*posed), far};
  portrait::Drawing traced = drawing;
  traced.traced = true;
  for (const geometry::Camera& view : views_of(model, drawn, reading.yaw_degrees)) {
    auto near = read(traced, view);
    if (!near || !near->read.of_this_face || !is_picture_of(drawn, near->sheet, view)) continue;
    if (best.posed.read.of_this_face && near->read.energy >= best.posed.read.energy) continue;
    best = {std::move(*near), view};
  }
  return best;
}

portrait::ContourDrawing contours_of(const io::PictureLines& drawn, bool all) {
  portrait::ContourDrawing out;
  out.width = drawn.width;
  out.height = drawn.height;
  for (const io::PictureLine& line : drawn.lines) {
    if (all || is_contour(line)) out.lines.push_back(line.points);
  }
  return out;
}

/// Moves the pose by the contour lines of a sheet.
void take(const portrait::ContourPose& posed, PosedSheet& sheet) {
  sheet.pose = posed.pose;
  std::size_t next = 0;
  for (LineTaken& line : sheet.lines) {
    if (line.contour) line.explained = posed.explained[next++];
  }
}

base::Result<PosedSheet> by_contours(const SheetReading& reading, const io::PictureLines& drawn) {
  const document::Model& model = *reading.document.model;
  const auto start = document::drawing_start(reading.document, reading.whole, {});
  const auto posed = portrait::pose_from_contours(*model.rig, *model.mesh, reading.whole, contours_of(drawn, true),
                                                  views_of(model, drawn, reading.yaw_degrees), start.pose, start.free);
  if (!posed) return posed.error();
  PosedSheet sheet;
  sheet.lines.assign(drawn.lines.size(), {true, false, {}});
  take(*posed, sheet);
  return sheet;
}

}  // namespace

bool is_contour(const io::PictureLine& line) { return line.name.starts_with(io::k_contour_name); }

base::Result<PosedSheet> posed_sheet(const SheetReading& reading, const io::PictureLines& drawn) {
  const bool all = reading.contours || std::all_of(drawn.lines.begin(), drawn.lines.end(), is_contour);
  if (all) return by_contours(reading, drawn);
  const document::Model& model = *reading.document.model;
  const auto start = document::drawing_start(reading.document, reading.whole, reading.curves);
  PosedSheet sheet;
  portrait::Drawing drawing;
  drawing.neutral = reading.neutral;
  for (const io::PictureLine& line : drawn.lines) {
    sheet.lines.push_back({is_contour(line), false, {}});
    if (!is_contour(line)) drawing.lines.push_back(line.points);
  }
  auto seen = read_features(reading, drawn, drawing, start);
  if (!seen) return seen.error();
  sheet.pose = std::move(seen->posed.pose);
  sheet.neutral = std::move(seen->posed.read.neutral);
  portrait::ContourDrawing contours = contours_of(drawn, false);
  std::size_t next = 0;
  for (LineTaken& line : sheet.lines) {
    if (line.contour) continue;
    line.read = seen->posed.read.lines[next++];
    if (!line.read.curve) continue;
    const auto& points = reading.curves[*line.read.curve].points;
    for (std::size_t i = 0; i < points.size(); i += k_kept_step) contours.kept.push_back(points[i]);
  }
  // Where no feature was found nothing says where the sheet lies.
  if (contours.lines.empty() || contours.kept.empty()) return sheet;
  contours.placement = seen->posed.sheet;
  const auto moved = portrait::pose_from_contours(*model.rig, *model.mesh, reading.whole, contours,
                                                  std::span(&seen->camera, 1), sheet.pose, start.free);
  if (!moved) return moved.error();
  take(*moved, sheet);
  return sheet;
}

}  // namespace penpose::cli
