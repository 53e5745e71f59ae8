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

/// A folder of that name with nothing in it.
inline std::filesystem::path empty_folder(const std::filesystem::path& path) {
  std::filesystem::remove_all(path);
  std::filesystem::create_directories(path);
  return path;
}

}  // namespace penpose::tests
