#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "core/document/model_hash.h"
#include "core/io/project/feature_file.h"

namespace {

std::shared_ptr<const penpose::mesh::TriangleMesh> two_triangles() {
  static const auto mesh = [] {
    penpose::mesh::MeshSource source;
    source.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    source.triangles = {{0, 1, 2}, {2, 1, 3}};
    return penpose::mesh::TriangleMesh::build(std::move(source)).value();
  }();
  return mesh;
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace penpose;  // NOLINT(google-build-using-namespace)
  static const mesh::TriangleMesh& mesh = *two_triangles();
  (void)io::read_features({data, size}, mesh);
  // The rest of a file, behind a hash that no fuzzer guesses.
  std::string text =
      R"({"penpose_features": 1, "mesh": ")" + document::hash_topology(mesh).hex() + R"(", "features": )";
  text.append(reinterpret_cast<const char*>(data), size).append("}");
  const auto file = io::read_features(base::as_bytes(text), mesh);
  if (!file) return 0;
  const auto again = io::read_features(base::as_bytes(io::write_features(*file)), mesh);
  if (!again || again->features.size() != file->features.size()) __builtin_trap();
  return 0;
}
