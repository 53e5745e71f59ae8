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
  const auto camera = portrait::camera_of_drawing(*model.rig, reading.curves, start.pose, reading.yaw_degrees);
  PosedSheet sheet;
  portrait::Drawing drawing;
  drawing.neutral = reading.neutral;
  for (const io::PictureLine& line : drawn.lines) {
    sheet.lines.push_back({is_contour(line), false, {}});
    if (!is_contour(line)) drawing.lines.push_back(line.points);
  }
  auto posed =
      portrait::pose_from_drawing(*model.rig, reading.whole, reading.curves, drawing, camera, start.pose, start.free);
  if (!posed) return posed.error();
  sheet.pose = std::move(posed->pose);
  sheet.neutral = std::move(posed->read.neutral);
  portrait::ContourDrawing contours = contours_of(drawn, false);
  std::size_t next = 0;
  for (LineTaken& line : sheet.lines) {
    if (line.contour) continue;
    line.read = posed->read.lines[next++];
    if (!line.read.curve) continue;
    const auto& points = reading.curves[*line.read.curve].points;
    for (std::size_t i = 0; i < points.size(); i += k_kept_step) contours.kept.push_back(points[i]);
  }
  // Where no feature was found nothing says where the sheet lies.
  if (contours.lines.empty() || contours.kept.empty()) return sheet;
  contours.placement = posed->sheet;
  const auto moved = portrait::pose_from_contours(*model.rig, *model.mesh, reading.whole, contours,
                                                  std::span(&camera, 1), sheet.pose, start.free);
  if (!moved) return moved.error();
  take(*moved, sheet);
  return sheet;
}

}  // namespace penpose::cli
