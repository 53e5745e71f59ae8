#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/articulation/measure/strain.h"
#include "core/articulation/motion/curve_skin.h"
#include "core/articulation/region/canvas.h"
#include "core/articulation/sketch.h"
#include "core/base/result.h"
#include "core/rig/rig.h"

namespace penpose::articulation {

/// One sketched control of a mesh: a parameter that moves the vertices of a region along with a curve, from a reference
/// to a target (method, section 3). Immutable; made by build_deformer.
class Deformer {
 public:
  [[nodiscard]] const Sketch& sketch() const { return sketch_; }
  [[nodiscard]] rig::Parameter parameter() const { return {sketch_.name, 0.0, sketch_.minimum, sketch_.maximum}; }
  /// Translate or rotate, also where the sketch has `Mode::automatic`.
  [[nodiscard]] Mode mode() const { return built_->skin.motion().mode(); }
  /// True when the reference was inferred.
  [[nodiscard]] bool inferred() const { return sketch_.reference.empty(); }
  /// True when the target was drawn against a drawn reference and was therefore reversed (method, section 1). A
  /// deformer that rotates is torn if the target's far end is nearer only by chance, so the user must be warned.
  [[nodiscard]] bool turned_round() const { return built_->turned_round; }

  /// The worst strain of the surface within its range; nothing for deformers of the paper.
  [[nodiscard]] const Strain& strain() const { return built_->strain; }

  /// The share of a drawn reference that is on one sheet of the surface; the remainder was cut off.
  [[nodiscard]] double kept_of_reference() const { return built_->kept; }

  /// Where the region of specific interest extends beyond the other on the model ("on its left"), or empty.
  [[nodiscard]] const std::string& reaches_beyond() const { return built_->reaches_beyond; }

  /// The curves in world space at rest, with the same number of points.
  [[nodiscard]] std::span<const ModelPoint> reference() const { return built_->skin.motion().reference(); }
  [[nodiscard]] std::span<const ModelPoint> target() const { return built_->skin.motion().target(); }
  /// The curve at an amount: the reference at 0, the target at 1, its other targets at their values. Without the
  /// surface.
  [[nodiscard]] std::vector<ModelPoint> curve_at(double amount) const;
  /// Its other targets, one for each of Sketch::betweens, with as many points as the reference.
  [[nodiscard]] const std::vector<std::vector<ModelPoint>>& betweens() const { return built_->betweens; }
  /// How many pieces of the model the first lasso encloses; 1 for deformers of the paper.
  [[nodiscard]] std::uint32_t pieces() const { return built_->pieces; }
  /// Why an inferred reference is doubtful; empty if it is not, or was drawn.
  [[nodiscard]] const std::string& doubtful_reference() const { return built_->doubtful; }

  /// The vertices that it moves (weight above 0; with other targets all of its region), ascending, and their weights.
  [[nodiscard]] std::span<const std::uint32_t> vertices() const { return built_->vertices; }
  [[nodiscard]] std::span<const double> weights() const { return built_->weights; }
  /// Their displacements at an amount.
  [[nodiscard]] std::vector<ModelVector> displacements(double amount) const;
  /// Computes the same without allocating.
  [[nodiscard]] const CurveSkin& skin() const { return built_->skin; }

  /// The same deformer under another name or range.
  [[nodiscard]] base::Result<std::shared_ptr<const Deformer>> renamed(std::string name) const;
  [[nodiscard]] base::Result<std::shared_ptr<const Deformer>> with_range(double minimum, double maximum) const;

 private:
  friend base::Result<std::shared_ptr<const Deformer>> build_deformer(const Sketch&, const Canvas&, std::size_t);

  // Precondition: the sketch is checked.
  static base::Result<std::shared_ptr<const Deformer>> by_paper(const Sketch& sketch, const Canvas& canvas,
                                                                std::size_t points);
  static base::Result<std::shared_ptr<const Deformer>> measured(const Sketch& sketch, const Canvas& canvas,
                                                                std::size_t points);

  /// The large part. Name and range are not in it, so that deformers which differ only in these share it.
  struct Built {
    CurveSkin skin;
    std::vector<std::uint32_t> vertices;
    std::vector<double> weights;
    bool turned_round = false;
    Strain strain;
    std::string reaches_beyond;
    double kept = 1;
    std::vector<std::vector<ModelPoint>> betweens;
    std::uint32_t pieces = 1;
    std::string doubtful;
  };

  Sketch sketch_;
  std::shared_ptr<const Built> built_ = std::make_shared<const Built>();
};

/// Points of a deformer's two curves.
inline constexpr std::size_t k_curve_points = 32;

/// Builds a deformer from strokes on the model at rest. `points` is the number of points of its curves, at least
/// two. An inferred reference starts at the end that the target moves less, so that a trunk bends from its root
/// in whichever order its vertices are; a drawn one starts where its line starts. Errors carry the key of the
/// sketch at fault as their place: those of check_sketch, of the cameras, of the regions, of the curves and of the
/// surface, and "general" for a vertex whose joints flatten it.
[[nodiscard]] base::Result<std::shared_ptr<const Deformer>> build_deformer(const Sketch& sketch, const Canvas& canvas,
                                                                           std::size_t points = k_curve_points);

}  // namespace penpose::articulation
