#include "tests/judges/rigs/parts.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "tests/judges/rigs/sculpt.h"

namespace penpose::judges {
namespace {

/// A rig of the project that asks for what is not there is a mistake of its source.
[[noreturn]] void missing(const char* what, std::string_view name) {
  std::fprintf(stderr, "tests/judges/rigs: there is no %s %.*s\n", what, static_cast<int>(name.size()), name.data());
  std::abort();
}

}  // namespace

const char* group_name(Group group) {
  return group == Group::seen ? "seen" : group == Group::held_out ? "held_out" : "shared";
}

const FaceLine* Rig::line(std::string_view called) const {
  const auto found = std::find_if(lines.begin(), lines.end(), [&](const FaceLine& l) { return l.name == called; });
  return found == lines.end() ? nullptr : &*found;
}

const std::vector<std::uint32_t>& Parts::line(std::string_view name) const {
  const auto found = std::find_if(lines.begin(), lines.end(), [&](const FaceLine& l) { return l.name == name; });
  if (found == lines.end()) missing("line", name);
  return found->vertices;
}

const Field& Parts::field(const std::string& name) const {
  const auto found = fields.find(name);
  if (found == fields.end()) missing("muscle", name);
  return found->second;
}

Parts reshaped(const Parts& parts, const std::function<ModelPoint(const ModelPoint&)>& where) {
  Parts out = parts;
  mesh::MeshSource source;
  for (const ModelPoint& p : parts.rest()) source.positions.push_back(where(p));
  source.triangles.assign(parts.mesh->triangles().begin(), parts.mesh->triangles().end());
  source.parts.assign(parts.mesh->parts().begin(), parts.mesh->parts().end());
  out.mesh = mesh::TriangleMesh::build(std::move(source)).value();
  for (auto& [name, field] : out.fields) {
    for (std::size_t v = 0; v < field.size(); ++v) {
      if (field[v] != ModelVector{0}) field[v] = where(parts.rest()[v] + field[v]) - where(parts.rest()[v]);
    }
  }
  const auto& lip = out.line("lip_upper");
  out.mouth = 0.5 * geometry::distance(out.rest()[lip.front()], out.rest()[lip.back()]);
  return out;
}

ModelPoint toon(const ModelPoint& p) {
  ModelPoint q = p;
  for (const double side : {-1.0, 1.0}) {
    const ModelPoint eye{side * 0.03, 0, 0.075};
    const double near = around(std::span(&p, 1), eye, {0.03, 0.032, 0.05})[0];
    q += (p - eye) * ModelVector{0.55, 0.75, 0.1} * near;
  }
  const ModelPoint mouth{0, -0.064, 0.09};
  const double near = around(std::span(&p, 1), mouth, {0.05, 0.035, 0.06})[0];
  q += ((p - mouth) * ModelVector{-0.25, -0.1, 0} + ModelVector{0, -0.006, 0}) * near;
  q.y += 0.012 * smooth_step(-0.07, -0.13, p.y);
  return q;
}

ModelPoint other_person(const ModelPoint& p) {
  const double low = smooth_step(0.02, -0.12, p.y);
  return {p.x * (0.94 - 0.08 * low) + 0.04 * p.y * low, p.y * 1.12, p.z * (1 + 0.06 * low) + 0.03 * p.x};
}

ModelPoint broad_person(const ModelPoint& p) {
  const double low = smooth_step(0.0, -0.1, p.y);
  return {p.x * (1.08 + 0.12 * low), p.y * 0.92, p.z * 0.96};
}

}  // namespace penpose::judges
