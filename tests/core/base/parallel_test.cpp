#include "core/base/parallel.h"

#include <atomic>
#include <gtest/gtest.h>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

namespace penpose::base {
namespace {

TEST(Parallel, VisitsEveryIndexOnce) {
  for (const std::size_t count : {0U, 1U, 2U, 7U, 64U, 1001U}) {
    for (const std::size_t threads : {0U, 1U, 2U, 3U, 8U, 64U}) {
      std::vector<int> visits(count, 0);
      parallel_for(count, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      EXPECT_EQ(visits, std::vector<int>(count, 1)) << count << " on " << threads;
    }
  }
}

TEST(Parallel, UsesAtMostTheThreadsAskedForAndNeverAnEmptyPiece) {
  std::mutex mutex;
  std::set<std::thread::id> threads;
  std::size_t pieces = 0;
  parallel_for(10, 4, [&](std::size_t begin, std::size_t end) {
    const std::scoped_lock lock(mutex);
    EXPECT_LT(begin, end);
    threads.insert(std::this_thread::get_id());
    ++pieces;
  });
  EXPECT_EQ(pieces, 4U);
  EXPECT_LE(threads.size(), 4U);

  pieces = 0;
  parallel_for(3, 16, [&](std::size_t begin, std::size_t end) {
    const std::scoped_lock lock(mutex);
    EXPECT_EQ(end, begin + 1);
    ++pieces;
  });
  EXPECT_EQ(pieces, 3U);
}

// On a thread of its own it would end the program without a word.
TEST(Parallel, WhatAPieceThrowsReachesTheCaller) {
  for (const std::size_t bad : {0U, 5U, 7U}) {
    std::atomic<int> done{0};
    try {
      parallel_for(8, 8, [&](std::size_t begin, std::size_t) {
        if (begin == bad) throw std::bad_alloc();
        ++done;
      });
      ADD_FAILURE() << "nothing came";
    } catch (const std::bad_alloc&) {
      EXPECT_EQ(done, 7) << "the others are done by then";
    }
  }
}

TEST(Parallel, OneThreadIsTheCallersOwn) {
  const auto caller = std::this_thread::get_id();
  int calls = 0;
  parallel_for(100, 1, [&](std::size_t begin, std::size_t end) {
    ++calls;
    EXPECT_EQ(std::this_thread::get_id(), caller);
    EXPECT_EQ(begin, 0U);
    EXPECT_EQ(end, 100U);
  });
  EXPECT_EQ(calls, 1);
}

}  // namespace
}  // namespace penpose::base
