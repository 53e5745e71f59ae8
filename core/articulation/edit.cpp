#include "core/articulation/edit.h"

#include "core/articulation/mirror.h"

namespace penpose::articulation {
namespace {

using Deformers = std::vector<std::shared_ptr<const Deformer>>;

Deformers all_of(const SketchedDeformers& set) { return {set.deformers().begin(), set.deformers().end()}; }

std::optional<base::Error> check_index(const SketchedDeformers& set, std::size_t index) {
  if (index < set.size()) return std::nullopt;
  return base::Error{"there is no control " + std::to_string(index), "",
                     "the set has " + std::to_string(set.size()) + ", numbered from 0"};
}

auto place_of(Deformers& deformers, std::size_t index) {
  return deformers.begin() + static_cast<std::ptrdiff_t>(index);
}

}  // namespace

base::Result<SketchedDeformers::Shared> with_added(const SketchedDeformers& set,
                                                   std::shared_ptr<const Deformer> deformer) {
  Deformers deformers = all_of(set);
  deformers.push_back(std::move(deformer));
  return SketchedDeformers::make(std::move(deformers));
}

base::Result<SketchedDeformers::Shared> with_sketch(const SketchedDeformers& set, std::size_t index,
                                                    const Sketch& sketch, const Canvas& canvas) {
  if (auto error = check_index(set, index)) return *error;
  Deformers deformers = all_of(set);
  auto built = build_deformer(sketch, canvas, deformers[index]->reference().size());
  if (!built) return built.error();
  deformers[index] = std::move(built).value();
  return SketchedDeformers::make(std::move(deformers));
}

base::Result<SketchedDeformers::Shared> without(const SketchedDeformers& set, std::size_t index) {
  if (auto error = check_index(set, index)) return *error;
  Deformers deformers = all_of(set);
  deformers.erase(place_of(deformers, index));
  return SketchedDeformers::make(std::move(deformers));
}

base::Result<SketchedDeformers::Shared> with_name(const SketchedDeformers& set, std::size_t index, std::string name) {
  if (auto error = check_index(set, index)) return *error;
  Deformers deformers = all_of(set);
  auto named = deformers[index]->renamed(std::move(name));
  if (!named) return named.error();
  deformers[index] = std::move(named).value();
  return SketchedDeformers::make(std::move(deformers));
}

base::Result<SketchedDeformers::Shared> with_range(const SketchedDeformers& set, std::size_t index, double minimum,
                                                   double maximum) {
  if (auto error = check_index(set, index)) return *error;
  Deformers deformers = all_of(set);
  auto ranged = deformers[index]->with_range(minimum, maximum);
  if (!ranged) return ranged.error();
  deformers[index] = std::move(ranged).value();
  return SketchedDeformers::make(std::move(deformers));
}

base::Result<SketchedDeformers::Shared> moved(const SketchedDeformers& set, std::size_t from, std::size_t to) {
  if (auto error = check_index(set, from)) return *error;
  if (auto error = check_index(set, to)) return *error;
  Deformers deformers = all_of(set);
  auto taken = deformers[from];
  deformers.erase(place_of(deformers, from));
  deformers.insert(place_of(deformers, to), std::move(taken));
  return SketchedDeformers::make(std::move(deformers));
}

base::Result<SketchedDeformers::Shared> with_mirrored(const SketchedDeformers& set, std::size_t index,
                                                      const Canvas& canvas, const std::string& name) {
  if (auto error = check_index(set, index)) return *error;
  auto mirror = mirror_deformer(*set.deformers()[index], canvas);
  if (!mirror) return mirror.error();
  if (!name.empty()) {
    auto named = (*mirror)->renamed(name);
    if (!named) return named.error();
    mirror = std::move(named);
  }
  return with_added(set, std::move(mirror).value());
}

base::Result<Sketch> redrawn(const Sketch& sketch, CurveRole role, std::vector<PxPoint> points,
                             const geometry::CameraPose& camera) {
  Sketch other = sketch;
  const auto own = [&](std::optional<geometry::CameraPose>& place) {
    place = camera == other.camera ? std::nullopt : std::optional(camera);
  };
  switch (role) {
    case CurveRole::general:
    case CurveRole::specific:
      if (!(camera == sketch.camera)) {
        return base::Error{"the two regions were not drawn under one camera", "camera",
                           "look from where the regions were drawn, or draw a new deformer"};
      }
      (role == CurveRole::general ? other.general : other.specific) = std::move(points);
      return other;
    case CurveRole::reference:
      own(other.reference_camera);
      if (points.empty()) other.reference_camera.reset();
      other.reference = std::move(points);
      other.other_sheet = false;
      return other;
    case CurveRole::target:
      own(other.target_camera);
      other.target = std::move(points);
      return other;
  }
  return other;
}

std::optional<std::size_t> find_deformer(const SketchedDeformers& set, std::string_view name) {
  for (std::size_t i = 0; i < set.size(); ++i) {
    if (set.parameters()[i].name == name) return i;
  }
  return std::nullopt;
}

}  // namespace penpose::articulation
