// SPDX-License-Identifier: MIT
#include "scenarios/command/interrupt.hpp"

#include <signal.h>

namespace scanbed::scenarios {
namespace {

volatile sig_atomic_t interrupted = 0;

extern "C" void mark_interrupt(int) {
  interrupted = 1;
}

}  // namespace

void watch_signals() {
  interrupted = 0;
  struct sigaction on_interrupt {};
  on_interrupt.sa_handler = mark_interrupt;
  on_interrupt.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&on_interrupt.sa_mask);
  sigaction(SIGINT, &on_interrupt, nullptr);
  ::signal(SIGPIPE, SIG_IGN);
}

bool is_interrupted() {
  return interrupted != 0;
}

}  // namespace scanbed::scenarios
