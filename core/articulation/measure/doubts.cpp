#include "core/articulation/measure/doubts.h"

#include <algorithm>

#include "core/base/numbers.h"
#include "core/curve/polyline.h"

namespace penpose::articulation {

std::vector<std::string> doubts_of(const Deformer& deformer) {
  std::vector<std::string> doubts;
  if (deformer.sketch().paper) return doubts;
  if (!deformer.reaches_beyond().empty()) {
    doubts.push_back("the second region reaches beyond the first " + deformer.reaches_beyond() +
                     ": what lies outside of the first stays where it is");
  }
  if (deformer.kept_of_reference() < 0.98) {
    doubts.push_back("the reference leaves its sheet of the surface and was cut to its longest part, " +
                     base::format_fixed(100.0 * deformer.kept_of_reference(), 0) + " % of the line");
  }
  const double ratio =
      curve::arc_length<ModelPoint>(deformer.target()) / curve::arc_length<ModelPoint>(deformer.reference());
  if (ratio > k_told_length || ratio < 1.0 / k_told_length) {
    doubts.push_back("the target is " + base::format_fixed(ratio, 1) +
                     " times as long as the feature, and what lies along it is stretched by as much");
  }
  if (!deformer.doubtful_reference().empty()) {
    doubts.push_back("the feature was found by itself, but " + deformer.doubtful_reference() + ": draw it by hand");
  }
  if (deformer.turned_round()) {
    doubts.push_back("the target ran against the feature and was turned round: draw it the other way if it twists");
  }
  const Strain& strain = deformer.strain();
  if (strain.turned_over > 0) {
    doubts.push_back("no smooth motion reaches the target: " + std::to_string(strain.turned_over) +
                     (strain.turned_over == 1 ? " triangle turns over" : " triangles turn over") +
                     "; draw a larger first region, or a nearer target");
  } else if (strain.creased > 0) {
    doubts.push_back("the surface is creased at " + std::to_string(strain.creased) +
                     (strain.creased == 1 ? " edge" : " edges") + "; draw a larger first region, or a nearer target");
  } else if (strain.stretch > k_told_stretch * std::max(1.0, ratio)) {
    doubts.push_back("the surface is stretched up to " + base::format_fixed(strain.stretch, 1) +
                     " times; draw a larger first region, or a nearer target");
  }
  return doubts;
}

}  // namespace penpose::articulation
