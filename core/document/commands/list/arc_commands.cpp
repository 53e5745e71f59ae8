#include "core/document/commands/list/arc_commands.h"

#include <algorithm>
#include <cmath>

#include "core/document/commands/apply_parts.h"
#include "core/document/time/arc.h"

namespace penpose::document {
namespace {

/// An arc of a minute at 60 frames a second.
constexpr double k_most_frames = 3600;

std::optional<base::Error> check_arc(const RedrawArc& arc) {
  const bool moments = arc.from_s >= 0 && arc.to_s <= k_latest_key_s && arc.to_s > arc.from_s;
  if (!moments)
    return base::Error{"the moments do not follow each other on the timeline", "from_s",
                       "give seconds from 0 to 36000"};
  const double frames = (arc.to_s - arc.from_s) * arc.rate;
  if (!(frames >= 1) || !(frames <= k_most_frames))
    return base::Error{"the arc has no frames, or too many", "rate", "choose moments from 1 frame to 3600 apart"};
  if (arc.line.size() < 2) return base::Error{"the line has fewer than two points", "line", "draw a line"};
  if (arc.shares.empty()) return std::nullopt;
  const bool ascend =
      std::is_sorted(arc.shares.begin(), arc.shares.end()) && arc.shares.front() >= 0 && arc.shares.back() <= 1 &&
      std::all_of(arc.shares.begin(), arc.shares.end(), [](double share) { return std::isfinite(share); });
  if (arc.shares.size() != arc.line.size() || !ascend)
    return base::Error{"there is not one share of the time for each point", "shares",
                       "give them from 0 to 1, ascending"};
  return std::nullopt;
}

}  // namespace

Changed run(const Document& document, const RedrawArc& command, Parts&) {
  if (auto error = check_arc(command)) return *error;
  const auto triangles = document.model->mesh->triangles();
  if (!(command.point.triangle < triangles.size()))
    return base::Error{"the mesh has no such triangle", "point", "name one that it has"};
  const auto camera = geometry::Camera::make(command.view.camera, command.view.viewport);
  if (!camera) return at("view", camera.error());
  const auto steps = static_cast<std::size_t>(std::ceil((command.to_s - command.from_s) * command.rate - 1e-6));
  std::vector<double> moments;
  for (std::size_t i = 0; i < steps; ++i) moments.push_back(command.from_s + static_cast<double>(i) / command.rate);
  moments.push_back(command.to_s);
  const posing::CurvePoint point = posing::at_mesh_point(command.point, triangles);
  const auto now = arc_of(document, point, *camera, poses_of_timeline(document, moments));
  auto timeline = with_arc(document, point, *camera, target_along(command.line, command.shares, moments, now));
  if (!timeline) return timeline.error();
  Document changed = document;
  changed.timeline = std::make_shared<const Timeline>(std::move(timeline).value());
  changed.pose = pose_at(changed, document.time_s);
  return changed;
}

}  // namespace penpose::document
