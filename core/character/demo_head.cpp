#include "core/character/demo_head.h"

#include <memory>
#include <utility>
#include <vector>

#include "core/articulation/deformer.h"
#include "core/articulation/sketched_deformers.h"
#include "core/character/embedded_sketches.h"
#include "core/head/head.h"
#include "core/io/project/sketch_file.h"

namespace penpose::character {

base::Result<document::Model> make_demo_head() {
  document::Model head = head::make_head();
  const auto file = io::read_sketch_file(base::as_bytes(embedded_sketches()));
  if (!file) return file.error();
  const auto canvas = articulation::Canvas::make(head.mesh, nullptr);
  if (!canvas) return canvas.error();
  std::vector<std::shared_ptr<const articulation::Deformer>> deformers;
  for (const articulation::Sketch& sketch : file->sketches) {
    auto deformer = articulation::build_deformer(sketch, **canvas);
    if (!deformer) return deformer.error();
    deformers.push_back(std::move(deformer).value());
  }
  auto set = articulation::SketchedDeformers::make(std::move(deformers));
  if (!set) return set.error();
  return document::with_deformers(std::move(head), std::move(set).value());
}

}  // namespace penpose::character
