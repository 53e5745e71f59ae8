#include "ui/render/cpu/workers.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace penpose::render {

struct Workers::State {
  std::vector<std::thread> threads;
  std::mutex mutex;  // guards what follows
  std::condition_variable changed;
  const std::function<void(int, unsigned)>* work = nullptr;
  int count = 0;
  unsigned round = 0;
  unsigned running = 0;
  bool ends = false;

  std::atomic<int> next{0};

  void take_all(const std::function<void(int, unsigned)>& job, int until, unsigned worker) {
    for (int index = next.fetch_add(1); index < until; index = next.fetch_add(1)) job(index, worker);
  }

  void serve(unsigned worker) {
    unsigned seen = 0;
    std::unique_lock lock(mutex);
    while (true) {
      changed.wait(lock, [&] { return ends || round != seen; });
      if (ends) return;
      seen = round;
      const auto* job = work;
      const int until = count;
      lock.unlock();
      take_all(*job, until, worker);
      lock.lock();
      --running;
      changed.notify_all();
    }
  }
};

Workers::Workers(unsigned most) : state_(std::make_unique<State>()) {
  for (unsigned worker = 1; worker < most; ++worker) {
    try {
      state_->threads.emplace_back([this, worker] { state_->serve(worker); });
    } catch (const std::system_error&) {
      break;  // those that are there do it
    }
  }
}

Workers::~Workers() {
  {
    const std::scoped_lock lock(state_->mutex);
    state_->ends = true;
    state_->changed.notify_all();
  }
  for (std::thread& one : state_->threads) one.join();
}

unsigned Workers::count() const { return static_cast<unsigned>(state_->threads.size()) + 1; }

void Workers::share(int count, const std::function<void(int, unsigned)>& work) {
  State& s = *state_;
  s.next = 0;
  if (!s.threads.empty() && count > 1) {
    const std::scoped_lock lock(s.mutex);
    s.work = &work;
    s.count = count;
    s.running = static_cast<unsigned>(s.threads.size());
    ++s.round;
    s.changed.notify_all();
  }
  s.take_all(work, count, 0);
  std::unique_lock lock(s.mutex);
  s.changed.wait(lock, [&] { return s.running == 0; });
}

}  // namespace penpose::render
