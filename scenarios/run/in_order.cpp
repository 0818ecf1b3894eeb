// SPDX-License-Identifier: MIT
#include "scenarios/run/in_order.hpp"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace scanbed::scenarios {
namespace {

class Workers {
 public:
  explicit Workers(const OrderedJobs& jobs) : jobs_(jobs), states_(jobs.num_jobs) {
    const int num_threads = std::min(jobs.num_workers, jobs.num_jobs);
    for (int i = 0; i < num_threads && start_thread(); ++i) {
    }
  }

  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  ~Workers() {
    {
      const std::lock_guard lock(mutex_);
      next_ = jobs_.num_jobs;
    }
    for (std::thread& thread : threads_) thread.join();
  }

  void wait_for(int job) {
    std::unique_lock lock(mutex_);
    is_done_.wait(lock, [&] { return states_[job].is_done; });
    if (states_[job].error) std::rethrow_exception(states_[job].error);
  }

 private:
  struct State {
    bool is_done = false;
    std::exception_ptr error;
  };

  // Whether there is one more. Where a machine has no room for as many as are wanted, fewer do the work.
  bool start_thread() {
    try {
      threads_.emplace_back([this] { serve(); });
    } catch (const std::system_error&) {
      if (threads_.empty()) throw;
      return false;
    }
    return true;
  }

  void serve() {
    while (true) {
      std::unique_lock lock(mutex_);
      if (next_ >= jobs_.num_jobs) return;
      const int job = next_++;
      lock.unlock();
      std::exception_ptr error;
      try {
        jobs_.work(job);
      } catch (...) {
        error = std::current_exception();
      }
      lock.lock();
      states_[job] = {true, error};
      is_done_.notify_one();
    }
  }

  const OrderedJobs& jobs_;
  std::mutex mutex_;
  std::condition_variable is_done_;
  std::vector<State> states_;
  int next_ = 0;
  std::vector<std::thread> threads_;
};

}  // namespace

void do_in_order(const OrderedJobs& jobs) {
  Workers workers(jobs);
  for (int job = 0; job < jobs.num_jobs; ++job) {
    workers.wait_for(job);
    if (!jobs.finish(job)) return;
  }
}

}  // namespace scanbed::scenarios
