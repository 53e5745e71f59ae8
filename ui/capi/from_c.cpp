#include "ui/capi/from_c.h"

namespace penpose::capi {
namespace {

geometry::ModelPoint point_of(const double* xyz) { return {xyz[0], xyz[1], xyz[2]}; }

void write(const geometry::ModelPoint& p, double* xyz) {
  xyz[0] = p.x;
  xyz[1] = p.y;
  xyz[2] = p.z;
}

}  // namespace

std::size_t numbers_of(std::size_t count, std::size_t each, const char* name) {
  if (count > static_cast<std::size_t>(-1) / 64) fail_argument("a count that no memory holds", name, "give the number");
  return count * each;
}

document::View view_of(const penpose_view& view) {
  return {{point_of(view.eye), point_of(view.look_at), point_of(view.up), view.vertical_fov_degrees},
          {view.width, view.height}};
}

penpose_view view_to_c(const document::View& view) {
  penpose_view out{};
  write(view.camera.eye, out.eye);
  write(view.camera.look_at, out.look_at);
  write(view.camera.up, out.up);
  out.vertical_fov_degrees = view.camera.vertical_fov_degrees;
  out.width = view.viewport.width;
  out.height = view.viewport.height;
  return out;
}

std::vector<geometry::PxPoint> line_of(const double* px, std::size_t count, const char* name) {
  const auto numbers = array(px, numbers_of(count, 2, name), name);
  std::vector<geometry::PxPoint> line;
  line.reserve(count);
  for (std::size_t i = 0; i < numbers.size(); i += 2) line.push_back({numbers[i], numbers[i + 1]});
  return line;
}

std::vector<geometry::ModelPoint> points_of(const double* xyz, std::size_t count, const char* name) {
  const auto numbers = array(xyz, numbers_of(count, 3, name), name);
  std::vector<geometry::ModelPoint> points;
  points.reserve(count);
  for (std::size_t i = 0; i < numbers.size(); i += 3) points.push_back(point_of(&numbers[i]));
  return points;
}

}  // namespace penpose::capi
