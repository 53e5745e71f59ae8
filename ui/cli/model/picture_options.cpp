#include "ui/cli/model/picture_options.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/numbers.h"
#include "core/io/project/camera_file.h"
#include "ui/files/files.h"
#include "ui/render/appearance.h"
#include "ui/render/framing.h"

namespace penpose::cli {
namespace {

constexpr int k_largest_side_px = 8192;
constexpr int k_most_px = 4096 * 4096;

std::optional<geometry::Viewport> parse_size(const std::string& text) {
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos) return std::nullopt;
  const auto width = base::parse_int(std::string_view(text).substr(0, cross));
  const auto height = base::parse_int(std::string_view(text).substr(cross + 1));
  if (!width || !height || *width < 1 || *height < 1) return std::nullopt;
  if (*width > k_largest_side_px || *height > k_largest_side_px || *width * *height > k_most_px) return std::nullopt;
  return geometry::Viewport{static_cast<int>(*width), static_cast<int>(*height)};
}

std::string check_size(const std::string& text) {
  if (parse_size(text)) return {};
  return "write WIDTHxHEIGHT in px, at most 8192 a side and 4096x4096 in all, not \"" + text + "\"";
}

}  // namespace

void add_picture_options(const Command& command, PictureOptions& options) {
  command.add_option("--size", options.size, "WIDTHxHEIGHT of the picture in px")
      .check(check_size, "WxH")
      .show_default();
  const Option camera =
      command.add_option("--camera", options.camera, R"(JSON file: {"eye", "look_at", "up", "vertical_fov_degrees"})");
  std::vector<std::string> views{"front", "side", "three-quarter", "back", "top", "face"};
  // A view of its own that a command has.
  if (std::find(views.begin(), views.end(), options.view) == views.end()) views.push_back(options.view);
  command.add_option("--view", options.view, "where to look from").one_of(views).show_default().excludes(camera);
}

geometry::Viewport size_of(const PictureOptions& options) { return *parse_size(options.size); }

base::Result<geometry::Camera> make_camera(const PictureOptions& options, const document::Model& model, bool as_posed) {
  const geometry::Viewport viewport = size_of(options);
  if (options.camera.empty()) {
    document::Model rest = model;
    if (!as_posed) rest.pose = rig::rest_pose(*model.rig);
    std::vector<glm::vec3> points = render::posed_mesh(rest).positions;
    const bool face = options.view == "face";
    render::Viewpoint from = *render::find_viewpoint(face ? "front" : options.view);
    from.yaw_degrees += model.front_yaw_degrees;
    const auto of_face = face ? render::face_vertices(model) : std::vector<std::uint32_t>();
    if (!of_face.empty()) {
      std::vector<glm::vec3> seen;
      for (const std::uint32_t v : of_face) seen.push_back(points[v]);
      points = std::move(seen);
    }
    return render::frame_points(points, viewport, from);
  }
  const auto bytes = files::read_file(options.camera, files::k_most_text_bytes);
  if (!bytes) return bytes.error();
  const auto pose = io::read_camera(*bytes);
  if (!pose) return pose.error();
  return geometry::Camera::make(*pose, viewport);
}

}  // namespace penpose::cli
