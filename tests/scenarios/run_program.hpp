// SPDX-License-Identifier: MIT
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <string>
#include <vector>

#include "tests/scenarios/support.hpp"

namespace scanbed::testing {

/// What a run of the program left behind.
struct Outcome {
  int exit_code = -1;  ///< 128 + signal where a signal ended it
  std::string out;
  std::string err;
};

/// A running copy of the program, its standard output and error in files.
class Program {
 public:
  /// @param stdout_path  empty collects the output; else it goes to this file or device.
  explicit Program(const std::vector<std::string>& arguments, const std::string& stdout_path = "")
      : out_(stdout_path.empty() ? (folder_ / "out").string() : stdout_path),
        err_((folder_ / "err").string()) {
    std::vector<std::string> words = arguments;
    words.insert(words.begin(), SCANBED_PROGRAM);
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    process_ = ::fork();
    if (process_ == 0) {
      ::dup2(::open(out_.c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO);
      ::dup2(::open(err_.c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
      ::execv(argv[0], argv.data());
      ::_exit(127);
    }
  }

  void send(int signal) const { ::kill(process_, signal); }

  Outcome wait() {
    int status = 0;
    ::waitpid(process_, &status, 0);
    Outcome outcome;
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    if (out_ == (folder_ / "out").string()) outcome.out = read_file(out_);
    outcome.err = read_file(err_);
    return outcome;
  }

 private:
  TemporaryFolder folder_;
  std::string out_;
  std::string err_;
  pid_t process_ = -1;
};

inline Outcome run_program(const std::vector<std::string>& arguments, const std::string& stdout_path = "") {
  return Program(arguments, stdout_path).wait();
}

/// A CARMEN message of one laser: `ranges` are its readings.
inline std::string flaser(const std::vector<std::string>& ranges) {
  std::string line = "FLASER " + std::to_string(ranges.size());
  for (const std::string& range : ranges) line += " " + range;
  return line + " 0 0 0 0 0 0 12.5 host 12.5\n";
}

}  // namespace scanbed::testing
