#include "ui/app/view/draw_thread.h"

#include <SDL2/SDL.h>
#include <backends/imgui_impl_opengl3.h>
#include <condition_variable>
#include <imgui.h>
#include <mutex>
#include <new>
#include <optional>
#include <thread>
#include <utility>

#include "ui/app/view/drawable_size.h"
#include "ui/app/view/picture.h"
#include "ui/app/window/timings.h"

namespace penpose::app {
namespace {

/// Draw lists of ImGui that stay as they are while the next ones are made. ImGui counts its memory without a lock: made
/// and destroyed on one thread.
class HeldPanels {
 public:
  HeldPanels() = default;
  explicit HeldPanels(const ImDrawData& data) : data_(data) {
    for (int i = 0; i < data.CmdListsCount; ++i) lists_.push_back(data.CmdLists[i]->CloneOutput());
    data_.CmdLists = lists_.data();
  }
  ~HeldPanels() {
    for (ImDrawList* list : lists_) IM_DELETE(list);
  }
  HeldPanels(const HeldPanels&) = delete;
  HeldPanels& operator=(const HeldPanels&) = delete;
  [[nodiscard]] ImDrawData* data() { return &data_; }

 private:
  ImDrawData data_;
  std::vector<ImDrawList*> lists_;
};

}  // namespace

struct DrawThread::State {
  enum class Job : std::uint8_t { none, start, frame, letters, stop };

  SDL_Window* window = nullptr;
  void* context = nullptr;
  std::function<void()> drawn;
  std::thread thread;
  DrawFrame frame;
  std::unique_ptr<HeldPanels> panels;

  mutable std::mutex mutex;  // guards what follows
  std::condition_variable changed;
  Job job = Job::none;
  base::Status status{base::Done{}};
  bool refining = false;
  std::vector<std::int64_t> times_us;
  std::optional<geometry::Viewport> drawable;
  Undrawn undrawn;

  /// Waits until the job before is done, and gives the next.
  void give(Job next) {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return job == Job::none; });
    job = next;
    changed.notify_all();
  }
  void wait() {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return job == Job::none; });
  }

  base::Status begin(std::unique_ptr<Picture>& picture) const {
    if (SDL_GL_MakeCurrent(window, context) != 0) {
      return base::Error{"OpenGL could not be used on another thread", "", "try another driver"};
    }
    SDL_GL_SetSwapInterval(1);
    auto made = Picture::make();
    if (!made) return made.error();
    if (!ImGui_ImplOpenGL3_Init("#version 140")) {
      return base::Error{"the panels could not be started", "", "install libgl1 and libgl1-mesa-dri"};
    }
    ImGui_ImplOpenGL3_NewFrame();
    picture = std::move(*made);
    return base::Done{};
  }

  base::Status show(Picture& picture) {
    const auto done = picture.draw(frame);
    if (!done) return done;
    ImGui_ImplOpenGL3_RenderDrawData(panels->data());
    return done;
  }

  void run() {
    std::unique_ptr<Picture> picture;
    while (true) {
      Job now = Job::none;
      {
        std::unique_lock lock(mutex);
        changed.wait(lock, [&] { return job != Job::none; });
        now = job;
      }
      const std::int64_t before = thread_cpu_us();
      base::Status result{base::Done{}};
      try {
        if (now == Job::start) result = begin(picture);
        if (now == Job::frame) result = show(*picture);
      } catch (const std::bad_alloc&) {
        result = base::Error{"the memory does not suffice for the picture", "", "make the window or the model smaller"};
      }
      if (now == Job::letters) {
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui_ImplOpenGL3_CreateFontsTexture();
      }
      if (now == Job::stop) {
        if (picture) ImGui_ImplOpenGL3_Shutdown();
        picture.reset();
        SDL_GL_MakeCurrent(window, nullptr);
      }
      const std::int64_t took = thread_cpu_us() - before;
      std::optional<geometry::Viewport> size;
      Undrawn undrawn_now;
      if (now == Job::frame && result) undrawn_now = {frame.model->look, picture->take_undrawn()};
      if (now == Job::frame && result) {
        SDL_GL_SwapWindow(window);
        size = drawable_size();
      }
      {
        const std::scoped_lock lock(mutex);
        job = Job::none;
        if (!result) status = result;
        if (now == Job::frame && result) {
          times_us.push_back(took);
          drawable = size;
          refining = picture->refining();
          if (!undrawn_now.names.empty()) undrawn = std::move(undrawn_now);
        }
        changed.notify_all();
      }
      if (now == Job::stop) return;
      if (now == Job::frame) drawn();
    }
  }
};

DrawThread::DrawThread(std::unique_ptr<State> state) : state_(std::move(state)) {}

base::Result<std::unique_ptr<DrawThread>> DrawThread::start(SDL_Window* window, void* context,
                                                            std::function<void()> drawn) {
  auto state = std::make_unique<State>();
  state->window = window;
  state->context = context;
  state->drawn = std::move(drawn);
  SDL_GL_MakeCurrent(window, nullptr);
  State* const here = state.get();
  state->thread = std::thread([here] { here->run(); });
  std::unique_ptr<DrawThread> made(new DrawThread(std::move(state)));
  made->state_->give(State::Job::start);
  made->state_->wait();
  if (const auto status = made->status(); !status) return status.error();
  return made;
}

DrawThread::~DrawThread() {
  state_->give(State::Job::stop);
  state_->thread.join();
}

bool DrawThread::busy() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->job != State::Job::none;
}

void DrawThread::draw(DrawFrame frame, const ImDrawData& panels) {
  state_->frame = std::move(frame);
  state_->panels = std::make_unique<HeldPanels>(panels);
  state_->give(State::Job::frame);
}

void DrawThread::send_letters() {
  state_->give(State::Job::letters);
  state_->wait();
}

bool DrawThread::refining() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->refining;
}

Undrawn DrawThread::take_undrawn() {
  const std::scoped_lock lock(state_->mutex);
  return std::exchange(state_->undrawn, {});
}

std::optional<geometry::Viewport> DrawThread::drawable() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->drawable;
}

base::Status DrawThread::status() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->status;
}

std::size_t DrawThread::drawn_count() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->times_us.size();
}

std::vector<std::int64_t> DrawThread::times_us() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->times_us;
}

}  // namespace penpose::app
