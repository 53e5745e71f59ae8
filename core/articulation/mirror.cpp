#include "core/articulation/mirror.h"

#include <array>
#include <cmath>

#include "core/base/text/letters.h"
#include "core/geometry/closest_point.h"

namespace penpose::articulation {
namespace {

constexpr double k_symmetric = 0.02;        // share of the diagonal
constexpr std::size_t k_most_probes = 600;  // vertices that are tried; enough to tell, few enough to be quick

using base::lower;
using base::upper;
bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_separator(char c) { return c == '_' || c == '.' || c == '-' || c == ' '; }

bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_letter(char c) { return is_lower(c) || is_upper(c); }

/// Whether a word of the name, as people write names, begins at `at` and is this one: "lid_left" and "LidLeft" say
/// "left", "cleft" and "leftover" do not.
bool says(std::string_view name, std::size_t at, std::string_view word) {
  if (name.size() - at < word.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (lower(name[at + i]) != word[i]) return false;
  }
  const char before = at > 0 ? name[at - 1] : ' ';
  if (is_letter(before) && (is_upper(before) || !is_upper(name[at]))) return false;
  const std::size_t end = at + word.size();
  const char after = end < name.size() ? name[end] : ' ';
  return !is_letter(after) || (is_upper(after) && is_lower(name[end - 1]));
}

/// `word` written like the text it replaces: LEFT, Left or left.
std::string written_like(std::string_view model, std::string_view word) {
  std::string written(word);
  if (is_upper(model[0])) written[0] = upper(written[0]);
  if (is_upper(model[1])) {
    for (char& c : written) c = upper(c);
  }
  return written;
}

void reflect(ModelPoint& p, const SymmetryPlane& plane) { p = reflected(p, plane); }

void reflect(geometry::CameraPose& camera, const SymmetryPlane& plane) {
  reflect(camera.eye, plane);
  reflect(camera.look_at, plane);
  camera.up.x = -camera.up.x;
}

void reflect(std::vector<PxPoint>& curve, geometry::Viewport viewport) {
  for (PxPoint& p : curve) p.x = viewport.width - p.x;
}

}  // namespace

base::Result<SymmetryPlane> find_symmetry_plane(const Canvas& canvas) {
  const base::Error asymmetric{"the model is not symmetric about a plane across x", "",
                               "draw the other side's control by hand"};
  const auto positions = canvas.positions();
  if (canvas.mesh().triangle_count() == 0) return asymmetric;
  geometry::Box box;
  for (const ModelPoint& p : positions) box.add(p);
  const geometry::ClosestPointTree tree(positions, canvas.mesh().triangles());
  const std::size_t stride = positions.size() / k_most_probes + 1;
  const auto miss = [&](const SymmetryPlane& plane) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t v = 0; v < positions.size(); v += stride, ++count) {
      ModelPoint p = positions[v];
      reflect(p, plane);
      sum += tree.closest(p).distance;
    }
    return sum / static_cast<double>(count);
  };
  const SymmetryPlane at_zero{0.0};
  const SymmetryPlane at_middle{box.center().x};
  const double miss_zero = miss(at_zero);
  const double miss_middle = miss(at_middle);
  // A hair's worth is given to 0, where models are modelled, because the box of a scan is never quite even.
  const bool zero = miss_zero <= miss_middle + 1e-3 * box.diagonal();
  if ((zero ? miss_zero : miss_middle) > k_symmetric * box.diagonal()) return asymmetric;
  return zero ? at_zero : at_middle;
}

std::string mirrored_name(std::string_view name) {
  for (std::size_t i = 0; i < name.size(); ++i) {
    for (const auto& [from, to] : {std::array<std::string_view, 2>{"left", "right"}, {"right", "left"}}) {
      if (!says(name, i, from)) continue;
      return std::string(name.substr(0, i)) + written_like(name.substr(i), to) +
             std::string(name.substr(i + from.size()));
    }
    const char side = lower(name[i]);
    const bool stands_alone = i > 0 && is_separator(name[i - 1]) && (i + 1 == name.size() || is_separator(name[i + 1]));
    if (!stands_alone || (side != 'l' && side != 'r')) continue;
    std::string other(name);
    other[i] = side == 'l' ? 'r' : 'l';
    if (is_upper(name[i])) other[i] = upper(other[i]);
    return other;
  }
  return std::string(name) + "_mirrored";
}

Sketch mirrored(const Sketch& sketch, const SymmetryPlane& plane) {
  Sketch other = sketch;
  other.name = mirrored_name(sketch.name);
  reflect(other.camera, plane);
  if (other.reference_camera) reflect(*other.reference_camera, plane);
  if (other.target_camera) reflect(*other.target_camera, plane);
  for (auto* curve : {&other.general, &other.specific, &other.reference, &other.target}) {
    reflect(*curve, sketch.viewport);
  }
  for (Between& one : other.betweens) {
    reflect(one.target, sketch.viewport);
    if (one.camera) reflect(*one.camera, plane);
  }
  other.surface = of_surface(sketch.surface, Surface(), [&](const auto& one) { return Surface(one.mirrored(plane)); });
  return other;
}

base::Result<std::shared_ptr<const Deformer>> mirror_deformer(const Deformer& deformer, const Canvas& canvas) {
  const auto plane = find_symmetry_plane(canvas);
  if (!plane) return plane.error();
  return build_deformer(mirrored(deformer.sketch(), *plane), canvas, deformer.reference().size());
}

}  // namespace penpose::articulation
