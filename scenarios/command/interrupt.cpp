// SPDX-License-Identifier: MIT
#include "scenarios/command/interrupt.hpp"

#include <signal.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <thread>

namespace scanbed::scenarios {
namespace {

// Any thread may be the one that handles a signal.
std::atomic<int> interrupted = 0;
static_assert(std::atomic<int>::is_always_lock_free, "else no signal handler may write it");

extern "C" void mark_interrupt(int signal) {
  interrupted = signal;
}

}  // namespace

void watch_signals() {
  interrupted = 0;
  struct sigaction on_interrupt {};
  on_interrupt.sa_handler = mark_interrupt;
  on_interrupt.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&on_interrupt.sa_mask);
  sigaction(SIGINT, &on_interrupt, nullptr);
  // timeout(1) sends it twice in a row, to the program and to its group.
  on_interrupt.sa_flags = 0;
  sigaction(SIGTERM, &on_interrupt, nullptr);
  struct sigaction on_hangup {};
  sigaction(SIGHUP, nullptr, &on_hangup);
  if (on_hangup.sa_handler != SIG_IGN) sigaction(SIGHUP, &on_interrupt, nullptr);
  // Who writes to a pipe without reader, or more than a limit allows, gets an error instead.
  ::signal(SIGPIPE, SIG_IGN);
  ::signal(SIGXFSZ, SIG_IGN);
}

int interrupting_signal() {
  return interrupted;
}

bool is_interrupted() {
  return interrupting_signal() != 0;
}

void work_until_interrupted(const std::function<void(const hw::StopSignal&)>& work,
                            const std::optional<double>& duration_s) {
  using Clock = std::chrono::steady_clock;
  hw::StopSignal stop;
  std::exception_ptr failure;
  std::atomic<bool> has_ended = false;
  std::thread thread([&] {
    try {
      work(stop);
    } catch (const hw::Stopped&) {
      // As it was told to.
    } catch (...) {
      failure = std::current_exception();
    }
    has_ended = true;
  });
  const auto start = Clock::now();
  const auto is_over = [&] {
    return duration_s && Clock::now() - start >= std::chrono::duration<double>(*duration_s);
  };
  while (!is_interrupted() && !has_ended && !is_over())
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  stop.give();
  thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace scanbed::scenarios
