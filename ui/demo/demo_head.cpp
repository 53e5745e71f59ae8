#include "ui/demo/demo_head.h"

#include <utility>

#include "core/head/head.h"
#include "core/model_io/sketch_file.h"
#include "ui/demo/embedded_files.h"

namespace penpose::demo {

base::Result<document::Model> articulate(document::Model model, std::string_view sketch_file) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(sketch_file.data());
  const auto file = model_io::read_sketch_file({bytes, sketch_file.size()});
  if (!file) return file.error();
  const auto canvas = document::make_canvas(model);
  if (!canvas) return canvas.error();
  auto deformers = articulation::SketchedDeformers::build(file->sketches, **canvas);
  if (!deformers) return deformers.error();
  return document::with_deformers(std::move(model), std::move(deformers).value());
}

base::Result<document::Model> make_demo_head() { return articulate(head::make_head(), embedded_sketch()); }

base::Result<ExpressionFile> demo_expressions() { return read_expressions(embedded_expressions()); }

std::size_t stroke_count(const articulation::Sketch& sketch) { return sketch.reference.empty() ? 3 : 4; }

}  // namespace penpose::demo
