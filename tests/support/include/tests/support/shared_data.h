#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace penpose::tests {

/// The folder of shared real data; tests in suites whose names start with "Shared" use it and skip where it is missing.
inline std::filesystem::path shared_dir() { return PENPOSE_SHARED_DIR; }
inline bool has_shared() { return std::filesystem::is_directory(shared_dir() / "meshes"); }

inline std::vector<std::uint8_t> read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace penpose::tests
