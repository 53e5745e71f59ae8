#include "ui/capi/from_c.h"

using namespace penpose;        // NOLINT(google-build-using-namespace): functions of C have no namespace of their own
using namespace penpose::capi;  // NOLINT(google-build-using-namespace)

namespace {

articulation::Mode mode_of(std::int32_t mode) {
  using articulation::Mode;
  return meaning_of<Mode>(mode,
                          {{PENPOSE_MODE_AUTO, Mode::automatic},
                           {PENPOSE_MODE_TRANSLATE, Mode::translate},
                           {PENPOSE_MODE_ROTATE, Mode::rotate}},
                          "mode", "give one of PENPOSE_MODE_...");
}

articulation::Sketch sketch_of(const penpose_sketch& sketch) {
  articulation::Sketch out;
  if (sketch.name != nullptr) out.name = sketch.name;
  const document::View view = view_of(sketch.view);
  out.camera = view.camera;
  out.viewport = view.viewport;
  if (sketch.target_view != nullptr) {
    const document::View seen = view_of(*sketch.target_view);
    if (!(seen.viewport == view.viewport))
      fail_argument("the target's picture has another size", "target_view", "draw it on one as large");
    if (!(seen.camera == view.camera)) out.target_camera = seen.camera;
  }
  out.general = line_of(sketch.general, sketch.general_count, "general");
  out.specific = line_of(sketch.specific, sketch.specific_count, "specific");
  out.reference = line_of(sketch.reference, sketch.reference_count, "reference");
  out.target = line_of(sketch.target, sketch.target_count, "target");
  out.mode = mode_of(sketch.mode);
  out.minimum = sketch.minimum;
  out.maximum = sketch.maximum;
  return out;
}

}  // namespace

int32_t penpose_sketch_deformer(penpose_library* library, penpose_handle character, const penpose_sketch* sketch,
                                penpose_error* error) {
  return call_character(library, character, error, [&](character::Character& one, CharacterObject&) {
    done(one.sketch(sketch_of(needed(sketch, "sketch"))));
  });
}
