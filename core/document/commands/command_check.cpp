#include "core/document/commands/command_check.h"

#include <cmath>
#include <type_traits>

#include "core/base/text/utf8.h"
#include "core/document/commands/command_visit.h"
#include "core/document/commands/text_form.h"
#include "core/geometry/lasso.h"

namespace penpose::document {
namespace {

const char* wrong(double value) {
  return std::abs(value) <= k_largest_number ? nullptr : "a number that is not finite or too large";
}
const char* wrong(const std::string& text) {
  return base::valid_utf8(text) == text ? nullptr : "a text that is not valid UTF-8";
}
const char* wrong(const PxPoint& p) {
  const bool is_near = std::abs(p.x) <= geometry::k_largest_px && std::abs(p.y) <= geometry::k_largest_px;
  return is_near ? nullptr : "a place that is not finite or farther out than a million px";
}
const char* wrong(const geometry::ModelPoint& p) {
  for (const double value : {p.x, p.y, p.z}) {
    if (const char* what = wrong(value)) return what;
  }
  return nullptr;
}
const char* wrong(const mesh::MeshPoint& point) {
  for (const double value : point.barycentric) {
    if (const char* what = wrong(value)) return what;
  }
  return nullptr;
}
const char* wrong(const NamedValue& one) {
  const char* what = wrong(one.name);
  return what != nullptr ? what : wrong(one.value);
}
const char* wrong(const View& view) {
  for (const auto& p : {view.camera.eye, view.camera.look_at, view.camera.up}) {
    if (const char* what = wrong(p)) return what;
  }
  const auto is_side = [](int px) { return px >= 1 && px <= k_largest_side_px; };
  if (!is_side(view.viewport.width) || !is_side(view.viewport.height))
    return "a picture whose sides are not 1 to 32768 px";
  return wrong(view.camera.vertical_fov_degrees);
}
const char* wrong(const articulation::Surface& surface) {
  return of_surface(surface, static_cast<const char*>(nullptr), [](const auto& one) {
    const char* what = nullptr;
    base::each_member(one, [&](std::string_view, const auto& value) {
      if (what == nullptr) what = wrong(value);
    });
    return what;
  });
}
template <typename T>
requires(std::is_enum_v<T> || std::is_same_v<T, bool> || std::is_same_v<T, std::uint32_t> ||
         std::is_same_v<T, CurveId> || std::is_same_v<T, base::Hash128>) const char* wrong(const T&) {
  return nullptr;
}
template <typename T>
const char* wrong(const std::optional<T>& value) {
  return value ? wrong(*value) : nullptr;
}
template <typename T>
const char* wrong(const std::vector<T>& values) {
  if (values.size() > articulation::k_most_points) return "more than 100000 entries";
  for (const T& value : values) {
    if (const char* what = wrong(value)) return what;
  }
  return nullptr;
}

}  // namespace

base::Status check_command(const Command& command) {
  base::Status status{base::Done{}};
  visit(
      [&](const auto& one) {
        base::each_member(one, [&](std::string_view member, const auto& value) {
          const char* what = wrong(value);
          if (what != nullptr && status)
            status = base::Error{std::string("there is ") + what, std::string(member), "give what a session can hold"};
        });
      },
      command);
  return status;
}

}  // namespace penpose::document
