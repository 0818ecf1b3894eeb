// SPDX-License-Identifier: MIT
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <ios>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

#include "bench/train_legs/leg_training.hpp"

// scanbed_train_legs RECORDINGS OUT: trains the forest that tells legs and writes it as C++ source.
namespace scanbed::bench {
namespace {

std::string literal(float value) {
  std::ostringstream text;
  text.precision(std::numeric_limits<float>::max_digits10);
  text << std::showpoint << value << 'F';
  return text.str();
}

template <typename Values, typename Write>
std::string braces(const Values& values, const Write& write) {
  std::string text = "{";
  for (const auto& value : values) text += (text.size() == 1 ? "" : ", ") + write(value);
  return text + "}";
}

std::string source_of(const OwnedLegForest& forest) {
  std::ostringstream out;
  out << "// SPDX-License-Identifier: MIT\n"
         "// Made by `./dev train-legs`; not to be edited.\n"
         "// clang-format off\n"
         "#include \"core/detect/leg/leg_forest.hpp\"\n\n"
         "namespace scanbed {\n"
         "namespace {\n\n"
         "constexpr LegTree kTrees[] = {\n";
  for (const LegTree& tree : forest.trees) {
    out << "  {{" << braces(tree.feature, [](auto f) { return std::to_string(f); }) << "}, {"
        << braces(tree.threshold, literal) << "},\n   {" << braces(tree.value, literal) << "}},\n";
  }
  out << "};\n\nconstexpr LegForest::Checkpoint kCheckpoints[] = {\n";
  for (const auto& checkpoint : forest.checkpoints) {
    out << "  {" << checkpoint.num_trees << ", " << literal(checkpoint.min_sum) << "},\n";
  }
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "};\n\n}  // namespace\n\n"
         "const LegForest& trained_leg_forest() {\n"
      << "  static constexpr LegForest kForest{kTrees, kCheckpoints, " << forest.num_alone << ", "
      << std::showpoint << forest.slope << ", " << forest.offset
      << "};\n  return kForest;\n}\n\n}  // namespace scanbed\n";
  return out.str();
}

void train(const std::filesystem::path& recordings, const std::filesystem::path& out) {
  const std::string source = source_of(train_detector(read_leg_corpus(recordings)));
  std::ofstream file(out, std::ios::binary);
  file << source;
  file.close();
  if (!file) throw std::runtime_error("cannot write " + out.string());
}

}  // namespace
}  // namespace scanbed::bench

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: scanbed_train_legs RECORDINGS OUT\n");
    return 2;
  }
  try {
    scanbed::bench::train(argv[1], argv[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "train-legs: %s\n", error.what());
    return 2;
  }
  return 0;
}
