#include "core/io/model/model_formats.h"

#include "core/base/text/letters.h"

namespace penpose::io {

// Each stands at the end of its reader or, where it is not read, of its writer. A new one is that file, a line here and
// a row below. Formats of bytes come before formats of text, whose marks they may have by chance.
ModelFormat glb_format();
ModelFormat fbx_format();
ModelFormat ply_format();
ModelFormat stl_format();
ModelFormat gltf_format();
ModelFormat off_format();
ModelFormat obj_format();
ModelFormat arkit_format_of_models();
ModelFormat vrm_format();
ModelFormat vrma_format_of_models();
ModelFormat vmd_format_of_models();

std::span<const ModelFormat> model_formats() {
  static const ModelFormat formats[] = {
      glb_format(),
      fbx_format(),
      ply_format(),
      stl_format(),
      gltf_format(),
      off_format(),
      obj_format(),
      vrm_format(),
      arkit_format_of_models(),
      vrma_format_of_models(),
      vmd_format_of_models(),
  };
  return formats;
}

namespace {

std::string listed(const std::vector<std::string>& names) {
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) out += i + 1 < names.size() ? ", " : " or ";
    out += names[i];
  }
  return out;
}

}  // namespace

const ModelFormat* format_of_name(std::string_view file_name) {
  const std::size_t dot = file_name.rfind('.');
  if (dot == std::string_view::npos) return nullptr;
  const std::string extension = base::lower_case(file_name.substr(dot));
  for (const ModelFormat& format : model_formats()) {
    if (format.extension == extension) return &format;
  }
  return nullptr;
}

const ModelFormat* format_of_content(base::Bytes bytes) {
  for (const ModelFormat& format : model_formats()) {
    if (format.looks_like != nullptr && format.looks_like(bytes)) return &format;
  }
  return nullptr;
}

const ModelFormat* format_to_read(base::Bytes bytes, std::string_view file_name_hint) {
  const ModelFormat* format = format_of_content(bytes);
  if (format == nullptr) format = format_of_name(file_name_hint);
  return format == nullptr || format->read == nullptr ? nullptr : format;
}

base::Result<const ModelFormat*> format_to_write(std::string_view file_name) {
  const ModelFormat* format = format_of_name(file_name);
  if (format != nullptr && format->write != nullptr) return format;
  return base::Error{"the format is not one that can be written", "", "name the file " + extensions_to_write()};
}

std::vector<std::string> extensions_read() {
  std::vector<std::string> out;
  for (const ModelFormat& format : model_formats()) {
    if (format.read != nullptr) out.emplace_back(format.extension);
  }
  return out;
}

std::vector<std::string> extensions_written() {
  std::vector<std::string> out;
  for (const ModelFormat& format : model_formats()) {
    if (format.write != nullptr) out.emplace_back(format.extension);
  }
  return out;
}

std::string names_read() {
  std::vector<std::string> names;
  for (const ModelFormat& format : model_formats()) {
    if (format.read != nullptr) names.emplace_back(format.name);
  }
  return listed(names);
}

std::string extensions_to_write() { return listed(extensions_written()); }

bool keeps_everything(std::string_view file_name) {
  const ModelFormat* format = format_of_name(file_name);
  return format != nullptr && format->write_project != nullptr;
}

std::string extensions_that_keep_everything() {
  std::vector<std::string> out;
  for (const ModelFormat& format : model_formats()) {
    if (format.write_project != nullptr) out.emplace_back(format.extension);
  }
  return listed(out);
}

}  // namespace penpose::io
