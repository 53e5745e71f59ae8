#include "core/io/gltf/write/write_vrma.h"

#include "core/io/gltf/write/vrma/vrma_bones.h"
#include "core/io/gltf/write/vrma/vrma_builder.h"
#include "core/io/gltf/write/vrma/vrma_expressions.h"
#include "core/io/model/model_formats.h"

namespace penpose::io {

base::Result<VrmaFile> write_vrma(const document::Model& model) {
  const document::Animation* animation = model.animations.empty() ? nullptr : &model.animations.front();
  VrmaBuilder file;
  VrmaBones bones(model, animation, file);
  bones.write();
  if (auto status = write_vrma_expressions(model, animation, file); !status) return status.error();
  if (file.moves_nothing()) {
    return base::Error{"the model has neither an animation nor a pose that a VRM animation holds", "",
                       "pose or animate bones of a human figure or blend shapes"};
  }
  bones.note_left_out();
  auto bytes = file.finish(animation != nullptr ? animation->name : std::string());
  if (!bytes) return bytes.error();
  return VrmaFile{std::move(bytes).value(), std::move(file.notes)};
}

ModelFormat vrma_format_of_models() {
  return {.name = "VRM animation",
          .extension = ".vrma",
          .write = [](const document::Model& model, const WriteOptions&, WriteReport& report) -> ModelFormat::Written {
            auto file = write_vrma(model);
            if (!file) return file.error();
            report.notes = std::move(file->notes);
            return std::move(file->bytes);
          },
          .holds = "The motion alone",
          .detail = "Bones and expressions over time, for any VRM avatar"};
}

}  // namespace penpose::io
