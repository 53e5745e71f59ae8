#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/articulation/region.h"
#include "core/document/document.h"
#include "core/drawing/tool.h"

namespace penpose::app {

/// What a deformer that is being drawn would be: its weights in colour while the regions are drawn, and the face with
/// it while the target is drawn. Strokes for deformers are drawn on the model at rest, so that is what is shown.
class SketchPreview {
 public:
  /// The tool is in hand and no stroke is being drawn.
  void show(const document::Document& document);
  /// A stroke goes on.
  void follow(const document::Document& document, const drawing::Tool& tool, const document::View& view,
              const curve::Stroke& stroke);
  void stroke_ended();
  /// Another tool was taken.
  void end();

  /// Null: the document's own model is shown.
  [[nodiscard]] const std::shared_ptr<const document::Model>& model() const { return model_; }
  /// Of `model`, or of the document's model: at rest, with the deformer that is drawn at `amount`.
  [[nodiscard]] const rig::Pose* pose() const { return pose_ ? &*pose_ : nullptr; }
  /// One a vertex, -1 outside of the region; empty when there is nothing to show.
  [[nodiscard]] const std::vector<float>& weights() const { return weights_; }
  /// Grows when the weights change.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// How far the deformer that is drawn is shown, as a share of its range.
  void set_amount(double amount) { amount_ = amount; }
  [[nodiscard]] double amount() const { return amount_; }

 private:
  bool set_region(const document::Document& document, const articulation::Sketch& sketch);
  void show_weights(std::size_t vertex_count, const std::vector<double>* weights);
  void build(const document::Document& document, articulation::Sketch sketch);

  std::shared_ptr<const document::Model> rested_;  ///< whose rest pose `pose_` is
  std::shared_ptr<const document::Model> canvas_of_;
  std::shared_ptr<const articulation::Canvas> canvas_;
  std::shared_ptr<const document::PendingSketch> region_of_;
  std::vector<geometry::PxPoint> region_lasso_;
  articulation::Region region_;
  std::vector<float> weights_;
  std::uint64_t revision_ = 0;
  std::shared_ptr<const document::Model> model_;
  std::optional<rig::Pose> pose_;
  double amount_ = 1;
};

}  // namespace penpose::app
