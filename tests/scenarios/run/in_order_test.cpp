// SPDX-License-Identifier: MIT
#include "scenarios/run/in_order.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <barrier>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace scanbed::scenarios {
namespace {

TEST(InOrderTest, FinishesInOrderWhateverTheNumberOfWorkers) {
  std::vector<int> all(100);
  std::iota(all.begin(), all.end(), 0);
  for (const int num_workers : {1, 2, 7, 200}) {
    std::vector<int> squares(all.size(), -1);
    std::vector<int> finished;
    do_in_order({.num_jobs = 100,
                 .num_workers = num_workers,
                 .work = [&](int job) { squares[job] = job * job; },
                 .finish =
                     [&](int job) {
                       EXPECT_EQ(squares[job], job * job);
                       finished.push_back(job);
                       return true;
                     }});
    EXPECT_EQ(finished, all);
  }
}

TEST(InOrderTest, WorksAtTheSameTime) {
  // Either would wait for ever were there not two of them.
  std::barrier meet(2);
  do_in_order({.num_jobs = 2,
               .num_workers = 2,
               .work = [&](int) { meet.arrive_and_wait(); },
               .finish = [](int) { return true; }});
}

TEST(InOrderTest, ThrowsWhatWorkThrowsInItsPlace) {
  std::vector<int> finished;
  const auto run = [&] {
    do_in_order({.num_jobs = 10,
                 .num_workers = 3,
                 .work =
                     [](int job) {
                       if (job >= 4) throw std::runtime_error("job " + std::to_string(job));
                     },
                 .finish =
                     [&](int job) {
                       finished.push_back(job);
                       return true;
                     }});
  };
  try {
    run();
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "job 4");
  }
  EXPECT_EQ(finished, (std::vector<int>{0, 1, 2, 3}));
}

TEST(InOrderTest, EndsEarlyWhereItIsTold) {
  std::atomic<int> num_begun = 0;
  int num_finished = 0;
  do_in_order({.num_jobs = 1'000'000,
               .num_workers = 2,
               .work = [&](int) { ++num_begun; },
               .finish = [&](int) { return ++num_finished < 3; }});
  EXPECT_EQ(num_finished, 3);
  EXPECT_GE(num_begun, 3);
}

// Threads reserve room for their stacks; in a process of its own, since the limit stays.
TEST(InOrderTest, DoesWithTheThreadsThatThereIsRoomFor) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers reserve more than any limit";
#endif
  const auto run = [] {
    std::ifstream statm("/proc/self/statm");
    rlim_t num_pages = 0;
    statm >> num_pages;
    const rlim_t bytes = num_pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) + (rlim_t{64} << 20U);
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_AS, &limit);
    std::atomic<int> num_done = 0;
    do_in_order({.num_jobs = 1000,
                 .num_workers = 1000,
                 .work = [&](int) { ++num_done; },
                 .finish = [](int) { return true; }});
    std::exit(num_done == 1000 ? 0 : 1);
  };
  EXPECT_EXIT(run(), ::testing::ExitedWithCode(0), "");
}

TEST(InOrderTest, HasNothingToDoForNoJobs) {
  do_in_order({.num_jobs = 0, .num_workers = 4, .work = {}, .finish = {}});
}

}  // namespace
}  // namespace scanbed::scenarios
