// SPDX-License-Identifier: MIT
#include "scenarios/command/standard_streams.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

namespace scanbed::scenarios {
namespace {

// Closes the streams in a process of its own and tells whether nothing can take their place or be written.
void close_and_keep(int stream) {
  ::close(stream);
  keep_standard_streams();
  const int next = ::open("/dev/null", O_RDWR);
  const char byte = 0;
  char read = 0;
  const bool is_dead = stream == STDIN_FILENO ? ::read(stream, &read, 1) < 0 : ::write(stream, &byte, 1) < 0;
  std::exit(next > STDERR_FILENO && is_dead ? 0 : 1);
}

TEST(StandardStreamsTest, NothingTakesThePlaceOfAClosedOne) {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    EXPECT_EXIT(close_and_keep(stream), ::testing::ExitedWithCode(0), "") << stream;
  }
}

TEST(StandardStreamsTest, OpenOnesStayAsTheyAre) {
  const int flags = ::fcntl(STDOUT_FILENO, F_GETFL);
  keep_standard_streams();
  EXPECT_EQ(::fcntl(STDOUT_FILENO, F_GETFL), flags);
}

}  // namespace
}  // namespace scanbed::scenarios
