#include <cstddef>
#include <cstdint>

#include "core/model_io/case_file.h"
#include "core/model_io/read_obj.h"

namespace {

using namespace penpose;

const document::Model& square() {
  static const document::Model model =
      model_io::read_obj(base::as_bytes("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")).value();
  return model;
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto cases = model_io::read_cases({data, size});
  if (!cases) return 0;
  (void)model_io::check_cases(*cases, square(), model_io::TargetForm::points);
  (void)model_io::check_cases(*cases, square(), model_io::TargetForm::drawn);
  return 0;
}
