// SPDX-License-Identifier: MIT
// Feeds a fuzz target the files of a folder, where libFuzzer does not.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/fuzz/fuzz_target.hpp"

namespace {

void replay(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

int replay_folder(const std::filesystem::path& folder) {
  int num_files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    // Told beforehand: a crash leaves no chance to say it afterwards.
    std::printf("%s\n", entry.path().c_str());
    std::fflush(stdout);
    replay(entry.path());
    ++num_files;
  }
  return num_files;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
    return 2;
  }
  try {
    if (replay_folder(argv[1]) > 0) return 0;
    std::fprintf(stderr, "%s: no seed in this folder\n", argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "escaped: %s\n", error.what());
  }
  return 1;
}
