#include "core/io/model/read_model.h"

#include "core/io/gltf/read/read_gltf.h"
#include "core/io/model/formats.h"
#include "core/io/surface/read_obj.h"
#include "core/io/surface/read_off.h"
#include "core/io/surface/read_ply.h"
#include "core/io/surface/read_stl.h"

namespace penpose::io {

base::Result<document::Model> read_model(base::Bytes bytes, std::string_view file_name_hint,
                                         const FileResolver& resolve) {
  if (bytes.empty()) return base::Error{"the file is empty", "byte offset 0", "choose another file"};
  auto format = format_of_content(bytes);
  if (!format) format = format_of_name(file_name_hint);
  if (!format) {
    return base::Error{"the format is not known", "byte offset 0", "use glTF (.glb, .gltf), OBJ, PLY, OFF or STL"};
  }
  switch (*format) {
    case Format::glb:
    case Format::gltf:
      return read_gltf(bytes, resolve);
    case Format::obj:
      return read_obj(bytes);
    case Format::ply:
      return read_ply(bytes);
    case Format::off:
      return read_off(bytes);
    case Format::stl:
      return read_stl(bytes);
  }
  return base::Error{"the format is not known", "byte offset 0", "choose another file"};
}

}  // namespace penpose::io
