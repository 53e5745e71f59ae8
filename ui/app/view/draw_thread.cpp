#include "ui/app/view/draw_thread.h"

#include <condition_variable>
#include <imgui.h>
#include <mutex>
#include <new>
#include <optional>
#include <thread>
#include <utility>

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

  std::unique_ptr<Presenter> presenter;
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

  void run() {
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
        if (now == Job::start) result = presenter->begin();
        if (now == Job::frame) result = presenter->draw(frame, *panels->data());
      } catch (const std::bad_alloc&) {
        result = base::Error{"there is not enough memory for the picture", "", "make the window or the model smaller"};
      }
      if (now == Job::letters) presenter->send_letters();
      if (now == Job::stop) presenter->end();
      const std::int64_t took = thread_cpu_us() - before;
      std::optional<geometry::Viewport> size;
      Undrawn undrawn_now;
      if (now == Job::frame && result) undrawn_now = {frame.model->look, presenter->take_undrawn()};
      if (now == Job::frame && result) {
        presenter->show();
        size = presenter->drawable();
      }
      {
        const std::scoped_lock lock(mutex);
        job = Job::none;
        if (!result) status = result;
        if (now == Job::frame && result) {
          times_us.push_back(took);
          drawable = size;
          refining = presenter->refining();
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

base::Result<std::unique_ptr<DrawThread>> DrawThread::start(std::unique_ptr<Presenter> presenter,
                                                            std::function<void()> drawn) {
  auto state = std::make_unique<State>();
  state->presenter = std::move(presenter);
  state->drawn = std::move(drawn);
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
