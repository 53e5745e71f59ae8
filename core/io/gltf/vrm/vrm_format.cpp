#include <string>
#include <utility>

#include "core/io/gltf/read/internal/gltf_document.h"
#include "core/io/gltf/read/read_gltf.h"
#include "core/io/model/model_formats.h"
#include "core/io/model/write_model.h"
#include "core/io/project/write_document.h"

namespace penpose::io {
namespace {

/// What was written, where it has an extension of VRM: other programs take nothing else for an avatar.
ModelFormat::Written as_avatar(ModelFormat::Written written, bool bare) {
  if (!written) return written;
  const auto opened = open_gltf(*written, {});
  if (!opened) return opened.error();
  const json::Json* extensions = json::find(opened->json, "extensions");
  if (extensions != nullptr &&
      (json::find(*extensions, "VRM") != nullptr || json::find(*extensions, "VRMC_vrm") != nullptr))
    return written;
  return base::Error{bare ? "a bare file is no VRM avatar" : "the model is no VRM avatar, or cannot be kept as one", "",
                     "name the file .glb"};
}

}  // namespace

ModelFormat vrm_format() {
  return {.name = "VRM",
          .extension = ".vrm",
          .read = read_gltf,
          .read_project = read_gltf_document,
          .write = [](const document::Model& model, const WriteOptions& options,
                      WriteReport& report) { return as_avatar(write_glb(model, options, &report), options.bare); },
          .write_project =
              [](const document::Document& document, const WriteOptions& options, WriteReport& report) {
                return as_avatar(write_project(document, options, &report), options.bare);
              },
          .holds = "The avatar that it came from, changed",
          .detail = "For programs of VRM"};
}

}  // namespace penpose::io
