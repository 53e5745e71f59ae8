// play_golden LIBRARY HASHES SESSION...: replays sessions through a C library, as who loads it at run time does, and
// compares the states at their ends with golden hashes. Fails where one differs, is not known, or cannot be played.
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

#include "ui/capi/penpose.h"

namespace {

/// A function of the library.
template <typename Function>
Function* found(void* library, const char* name) {
#ifdef _WIN32
  return reinterpret_cast<Function*>(reinterpret_cast<void*>(GetProcAddress(static_cast<HMODULE>(library), name)));
#else
  return reinterpret_cast<Function*>(dlsym(library, name));
#endif
}

void* loaded(const char* path) {
#ifdef _WIN32
  return LoadLibraryA(path);
#else
  return dlopen(path, RTLD_NOW | RTLD_LOCAL);
#endif
}

/// Whether the system has taken the library out of memory.
bool unloaded(void* library, const char* path) {
#ifdef _WIN32
  return FreeLibrary(static_cast<HMODULE>(library)) != 0 && GetModuleHandleA(path) == nullptr;
#else
  return dlclose(library) == 0 && dlopen(path, RTLD_NOW | RTLD_NOLOAD) == nullptr;
#endif
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fputs("usage: play_golden LIBRARY HASHES SESSION...\n", stderr);
    return 2;
  }
  std::map<std::string, std::string> golden;
  std::ifstream hashes(argv[2]);
  for (std::string name, hash; hashes >> name >> hash;) golden[name] = hash;
  void* const library = loaded(argv[1]);
  if (library == nullptr) {
    std::fprintf(stderr, "%s cannot be loaded\n", argv[1]);
    return 1;
  }
  const auto open = found<decltype(penpose_open)>(library, "penpose_open");
  const auto close = found<decltype(penpose_close)>(library, "penpose_close");
  const auto play = found<decltype(penpose_session_play)>(library, "penpose_session_play");
  const auto parameter = found<decltype(penpose_set_parameter)>(library, "penpose_set_parameter");
  if (open == nullptr || close == nullptr || play == nullptr || parameter == nullptr) {
    std::fprintf(stderr, "%s lacks functions of penpose.h\n", argv[1]);
    return 1;
  }
  int wrong = 0;
  penpose_library* penpose = nullptr;
  penpose_error error{};
  if (open(&penpose, &error) != PENPOSE_OK) return 1;
  for (int i = 3; i < argc; ++i) {
    const std::string path = argv[i];
    const std::string name = path.substr(path.find_last_of("/\\") + 1);
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    penpose_handle character = 0;
    penpose_playback playback{};
    if (play(penpose, text.data(), text.size(), 0, &character, &playback, &error) != PENPOSE_OK) {
      std::fprintf(stderr, "%s: %s\n", name.c_str(), error.message);
      ++wrong;
    } else if (golden[name] != playback.state) {
      std::fprintf(stderr, "%s: %s, golden is %s\n", name.c_str(), playback.state, golden[name].c_str());
      ++wrong;
    } else if (parameter(penpose, character, "there is no such control", 0, &error) == PENPOSE_OK ||
               error.message[0] == 0) {
      // Exceptions of the library end in it, with their words.
      std::fprintf(stderr, "%s: a control that there is not was set\n", name.c_str());
      ++wrong;
    }
  }
  close(&penpose);
  if (!unloaded(library, argv[1])) {
    std::fputs("the library stays in memory\n", stderr);
    ++wrong;
  }
  std::printf("%d sessions, %d wrong\n", argc - 3, wrong);
  return wrong == 0 ? 0 : 1;
}
