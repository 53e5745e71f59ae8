// corpora TARGET FOLDER: feeds every file of a folder to a fuzz target, so that ordinary test runs keep what the fuzzer
// has seen.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#define PENPOSE_FUZZER(name) extern "C" int fuzz_##name(const std::uint8_t* data, std::size_t size);
#include "tests/fuzz/targets.inc"
#undef PENPOSE_FUZZER

int main(int argc, char** argv) {
#define PENPOSE_FUZZER(name) {#name, &fuzz_##name},
  const std::map<std::string, int (*)(const std::uint8_t*, std::size_t)> targets = {
#include "tests/fuzz/targets.inc"
  };
#undef PENPOSE_FUZZER
  const auto target = argc == 3 ? targets.find(argv[1]) : targets.end();
  if (target == targets.end() || !std::filesystem::is_directory(argv[2])) {
    std::fprintf(stderr, "usage: %s TARGET CORPUS_FOLDER\n", argv[0]);
    return 2;
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(argv[2])) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    std::ifstream stream(file, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    target->second(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }
  std::printf("%zu files\n", files.size());
  return files.empty() ? 1 : 0;
}
