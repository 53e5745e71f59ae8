#include "ui/app/window/stop_watch.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <sys/eventfd.h>
#include <thread>
#include <unistd.h>

namespace penpose::app {
namespace {

constexpr std::array k_signals{SIGINT, SIGTERM, SIGHUP};

std::atomic<bool> g_asked{false};
std::atomic<int> g_event{-1};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void note(int /*number*/) {
  const int before = errno;
  g_asked = true;
  const std::uint64_t one = 1;
  static_cast<void>(!::write(g_event, &one, sizeof one));
  errno = before;
}

}  // namespace

struct StopWatch::State {
  int event = -1;
  std::array<struct sigaction, k_signals.size()> before{};
  std::thread thread;
  std::atomic<bool> ends{false};
};

StopWatch::StopWatch(std::function<void()> wake) : state_(std::make_unique<State>()) {
  state_->event = ::eventfd(0, EFD_CLOEXEC);
  g_asked = false;
  g_event = state_->event;
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < k_signals.size(); ++i) sigaction(k_signals[i], &action, &state_->before[i]);
  state_->thread = std::thread([this, wake = std::move(wake)] {
    while (!state_->ends) {
      std::uint64_t count = 0;
      const ssize_t got = ::read(state_->event, &count, sizeof count);
      if (got < 0 && errno != EINTR) return;
      if (g_asked && !state_->ends) wake();
    }
  });
}

StopWatch::~StopWatch() {
  for (std::size_t i = 0; i < k_signals.size(); ++i) sigaction(k_signals[i], &state_->before[i], nullptr);
  state_->ends = true;
  const std::uint64_t one = 1;
  static_cast<void>(!::write(state_->event, &one, sizeof one));
  state_->thread.join();
  g_event = -1;
  ::close(state_->event);
}

bool StopWatch::asked() { return g_asked; }

}  // namespace penpose::app
