#include "core/io/fbx/write/fbx_pictures.h"

#include "core/document/look.h"

namespace penpose::io {

const std::string& FbxPictures::name_of(std::size_t image) {
  const auto [at, is_new] = names_.try_emplace(image);
  const document::Image& picture = model_.look->images[image];
  const auto bytes = picture.bytes.view();
  if (!is_new || bytes.empty()) return at->second;
  const std::string ending = picture.mime_type == "image/jpeg"   ? ".jpg"
                             : picture.mime_type == "image/webp" ? ".webp"
                             : picture.mime_type == "image/ktx2" ? ".ktx2"
                                                                 : ".png";
  at->second = (options_.stem.empty() ? "model" : options_.stem) + "_" + std::to_string(image) + ending;
  report_.files[at->second] = {bytes.begin(), bytes.end()};
  return at->second;
}

}  // namespace penpose::io
