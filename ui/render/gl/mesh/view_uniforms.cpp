#include "ui/render/gl/mesh/view_uniforms.h"

#include <glm/gtc/type_ptr.hpp>

namespace penpose::render {

void use_with_view(const GlProgram& program, const View& view) {
  program.use();
  program.set("middle", view.middle.x, view.middle.y, view.middle.z);
  program.set("scale", view.scale);
  program.set_matrix("to_view", glm::value_ptr(view.to_view));
  program.set_matrix("to_clip", glm::value_ptr(view.to_clip));
}

}  // namespace penpose::render
