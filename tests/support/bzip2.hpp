// SPDX-License-Identifier: MIT
#pragma once

#include <bzlib.h>
#include <gtest/gtest.h>

#include <string>

namespace scanbed::tests {

/// Packs as the program bzip2 does; links BZip2::BZip2.
inline std::string bzip2(std::string bytes) {
  std::string packed(bytes.size() + 1000, '\0');
  auto num_packed = static_cast<unsigned>(packed.size());
  EXPECT_EQ(BZ2_bzBuffToBuffCompress(packed.data(), &num_packed, bytes.data(),
                                     static_cast<unsigned>(bytes.size()), 9, 0, 0),
            BZ_OK);
  packed.resize(num_packed);
  return packed;
}

}  // namespace scanbed::tests
