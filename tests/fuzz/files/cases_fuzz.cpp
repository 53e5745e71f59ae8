#include <cstddef>
#include <cstdint>

#include "core/io/project/case_file.h"
#include "core/io/surface/read_obj.h"

namespace {

using namespace penpose;

const document::Model& square() {
  static const document::Model model =
      io::read_obj(base::as_bytes("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")).value();
  return model;
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto cases = io::read_cases({data, size});
  if (!cases) return 0;
  (void)io::check_cases(*cases, square(), io::TargetForm::points);
  (void)io::check_cases(*cases, square(), io::TargetForm::drawn);
  return 0;
}
