#include "ui/render/cpu/shading/srgb_tables.h"

#include "ui/render/picture/color.h"

namespace penpose::render {

SrgbTables::SrgbTables() {
  for (std::size_t i = 0; i < linear_.size(); ++i) linear_[i] = decode_srgb(static_cast<float>(i) / 255.0F);
  for (std::size_t i = 0; i < display_.size(); ++i) {
    const float root = static_cast<float>(i) / (k_steps - 1);
    display_[i] = encode_srgb(root * root);
  }
}

const SrgbTables& SrgbTables::get() {
  static const SrgbTables tables;
  return tables;
}

}  // namespace penpose::render
