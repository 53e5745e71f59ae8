#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/io/gltf/read/read_gltf.h"
#include "core/io/model/write_model.h"
#include "core/io/tracks/motion_track.h"

namespace {

/// Whatever can be read can be written and is the same again.
void expect_back(const penpose::document::Model& model, const penpose::io::WriteOptions& options) {
  using namespace penpose;  // NOLINT(google-build-using-namespace): a program of one file
  const auto bytes = io::write_glb(model, options);
  if (!bytes) return;
  const auto again = io::read_gltf(*bytes);
  if (!again || document::state_hash(*again) != document::state_hash(model)) std::abort();
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace penpose;  // NOLINT(google-build-using-namespace): a program of one file
  // Motions are glTF too.
  (void)io::read_vrma({data, size});
  auto model = io::read_gltf({data, size});
  if (!model) return 0;
  expect_back(*model, {.bare = true});
  expect_back(*model, {});
  // The file with a pose of its weights.
  for (std::size_t i = 0; i < document::weight_count(*model); ++i) {
    model->pose[i] = 0.5 * (model->pose[i] + model->rig->parameters()[i].maximum);
  }
  const auto posed = io::write_glb(*model);
  if (posed && !io::read_gltf(*posed)) std::abort();
  // The file with a target more for all of its meshes.
  std::vector<rig::BlendShape> shapes;
  if (model->shapes) shapes.assign(model->shapes->shapes().begin(), model->shapes->shapes().end());
  rig::BlendShape& made = shapes.emplace_back();
  made.parameter.name = "made by the fuzzer";
  for (std::uint32_t v = 0; v < model->mesh->vertex_count(); ++v) {
    made.vertices.push_back(v);
    made.deltas.push_back({0, 0.5F, 0});
  }
  auto all = rig::BlendShapes::make(std::move(shapes), model->mesh->vertex_count());
  if (!all) return 0;
  const auto more = document::with_controls(std::move(model).value(), std::move(all).value(), nullptr);
  const auto written = more ? io::write_glb(*more) : base::Result<std::vector<std::uint8_t>>(more.error());
  if (written && !io::read_gltf(*written)) std::abort();
  return 0;
}
