// Project files: what is read as a document is written and reads back as the same document.

#include <cstdint>
#include <cstdlib>

#include "core/document/document_hash.h"
#include "core/io/project/read_document.h"
#include "core/io/project/write_document.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace penpose;  // NOLINT(google-build-using-namespace): a program of one file
  const auto first = io::read_document({data, size}, "project.glb");
  if (!first) return 0;
  const auto bytes = io::write_project(*first);
  if (!bytes) return 0;
  const auto second = io::read_document(*bytes, "project.glb");
  if (!second) std::abort();
  document::DocumentHasher hasher;
  // Animations are kept as floats, so that the first writing may round them.
  const auto again = io::write_project(*second);
  if (!again) std::abort();
  const auto third = io::read_document(*again, "project.glb");
  if (!third || !(hasher(*third) == hasher(*second))) std::abort();
  return 0;
}
