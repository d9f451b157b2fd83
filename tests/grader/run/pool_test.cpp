#include "grader/run/pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

namespace muelle::grader {
namespace {

TEST(Pool, RunsEverythingOnce) {
  Pool pool(3);
  std::atomic<int> sum{0};
  for (int i = 1; i <= 100; ++i) pool.append([&sum, i] { sum += i; });
  pool.run();
  EXPECT_EQ(sum, 5050);
}

TEST(Pool, FinishesWhatATaskAddsBeforeTheNextTask) {
  Pool pool(1);
  std::string order;
  pool.append([&] {
    order += 'a';
    pool.prepend([&] { order += '2'; });
    pool.prepend([&] { order += '1'; });
  });
  pool.append([&] { order += 'b'; });
  pool.run();
  EXPECT_EQ(order, "a12b");
}

TEST(Pool, RunsAloneWhatMustRunAlone) {
  Pool pool(4);
  std::atomic<int> running{0};
  std::atomic<int> mostBeside{0};
  std::atomic<int> alone{0};
  const auto shared = [&] {
    ++running;
    --running;
  };
  for (int i = 0; i < 20; ++i) {
    pool.append([&] {
      shared();
      pool.addAlone([&] {
        if (running++ > 0) mostBeside = 1;
        ++alone;
        --running;
      });
    });
  }
  pool.run();
  EXPECT_EQ(alone, 20);
  EXPECT_EQ(mostBeside, 0);
}

TEST(Pool, WhatIsAloneMayAddMore) {
  Pool pool(2);
  std::atomic<int> done{0};
  pool.addAlone([&] { pool.prepend([&] { ++done; }); });
  pool.run();
  EXPECT_EQ(done, 1);
}

TEST(Pool, ThrowsOnTheFirstFailure) {
  Pool pool(2);
  pool.append([] { throw std::runtime_error("a full disk"); });
  for (int i = 0; i < 10; ++i) pool.append([] {});
  EXPECT_THROW(pool.run(), std::runtime_error);
}

}  // namespace
}  // namespace muelle::grader
