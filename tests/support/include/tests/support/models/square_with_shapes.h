#pragma once

#include <string>
#include <vector>

#include "core/io/surface/read_obj.h"
#include "core/io/surface/shape_list.h"

namespace penpose::tests {

/// A square with a blend shape of each name; all move the same corner.
inline document::Model square_with_shapes(const std::vector<std::string>& names) {
  const auto square = [](const char* text) { return io::read_obj(base::as_bytes(text)).value(); };
  std::vector<io::ShownShape> shapes;
  for (const std::string& name : names)
    shapes.push_back({name, square("v 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4\n")});
  return io::with_shapes(square("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"), shapes).value();
}

}  // namespace penpose::tests
