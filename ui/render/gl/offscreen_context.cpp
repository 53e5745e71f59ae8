#include "ui/render/gl/offscreen_context.h"

#include <SDL2/SDL.h>
#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <string>
#include <sys/mman.h>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "ui/render/gl/gl_dialect.h"

namespace penpose::render {
namespace {

base::Error no_gl(DrawWay way, const std::string& why) {
  return {needs_of(way) + " could not be started (" + why + ")", "",
          "install the packages libegl1, libgl1 and libgl1-mesa-dri, or draw with --draw cpu"};
}

std::string sdl_error() {
  const std::string text = SDL_GetError();
  return text.empty() ? "no reason given" : text.substr(0, text.find('\n'));
}

}  // namespace

base::Status check_room_for_gl() {
  // Of addresses, and of what may be written to: each has a limit of its own.
  constexpr std::pair<std::size_t, int> k_rooms[] = {{std::size_t{576} << 20, PROT_NONE},
                                                     {std::size_t{64} << 20, PROT_READ | PROT_WRITE}};
  for (const auto& [size, access] : k_rooms) {
    void* room = ::mmap(nullptr, size, access, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (room == MAP_FAILED) {
      return base::Error{"pictures need more memory than the program may take", "",
                         "raise its limit (ulimit -v, ulimit -d)"};
    }
    ::munmap(room, size);
  }
  return base::Done{};
}

base::Status check_threads_for_gl() {
  // As many as llvmpipe starts; those that compile and keep shaders are done without.
  constexpr unsigned k_most = 32;
  const unsigned wanted = std::min(std::max(std::thread::hardware_concurrency(), 1U), k_most);
  std::vector<std::thread> started;
  std::mutex all;
  bool refused = false;
  {
    // None of them ends before all are there.
    const std::scoped_lock waiting(all);
    try {
      for (unsigned i = 0; i < wanted; ++i) started.emplace_back([&all] { const std::scoped_lock until_all(all); });
    } catch (const std::system_error&) {
      refused = true;
    }
  }
  for (std::thread& one : started) one.join();
  if (!refused) return base::Done{};
  return base::Error{"pictures need more threads than the program may start", "", "raise its limit (ulimit -u)"};
}

base::Result<std::unique_ptr<OffscreenContext>> OffscreenContext::make(DrawWay way) {
  if (const auto room = check_room_for_gl(); !room) return room.error();
  if (const auto threads = check_threads_for_gl(); !threads) return threads.error();
  std::unique_ptr<OffscreenContext> made(new OffscreenContext);
  if (SDL_WasInit(SDL_INIT_VIDEO) != 0) {
    const char* driver = SDL_GetCurrentVideoDriver();
    if (driver == nullptr || std::string(driver) != "offscreen") return no_gl(way, "a window is open in this program");
  }
  // Mesa would print its search for drivers before the one line that says what to do.
  ::setenv("EGL_LOG_LEVEL", "fatal", 0);
  // The environment's own choice of a driver is for windows; this one never has any.
  SDL_SetHintWithPriority(SDL_HINT_VIDEODRIVER, "offscreen", SDL_HINT_OVERRIDE);
  // What ends the program ends it at once.
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
  const int started = SDL_InitSubSystem(SDL_INIT_VIDEO);
  SDL_ResetHint(SDL_HINT_VIDEODRIVER);
  if (started != 0) return no_gl(way, sdl_error());
  made->video_ = true;
  bool refused = false;
  for (const GlVersion& version : versions_of(way)) {
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, version.profile);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, version.major);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, version.minor);
    SDL_Window* window = SDL_CreateWindow("penpose", 0, 0, 16, 16, SDL_WINDOW_OPENGL | SDL_WINDOW_HIDDEN);
    if (window == nullptr) continue;
    SDL_GLContext context = SDL_GL_CreateContext(window);
    if (context == nullptr) {
      SDL_DestroyWindow(window);
      refused = true;
      continue;
    }
    made->window_ = window;
    made->context_ = context;
    return made;
  }
  // Where there is a window there is a driver.
  return refused ? less_than(way, sdl_error()) : no_gl(way, sdl_error());
}

OffscreenContext::~OffscreenContext() {
  if (context_ != nullptr) SDL_GL_DeleteContext(context_);
  if (window_ != nullptr) SDL_DestroyWindow(static_cast<SDL_Window*>(window_));
  if (video_) SDL_QuitSubSystem(SDL_INIT_VIDEO);
}

void OffscreenContext::make_current() {
  if (SDL_GL_GetCurrentContext() != context_) SDL_GL_MakeCurrent(static_cast<SDL_Window*>(window_), context_);
}

}  // namespace penpose::render
