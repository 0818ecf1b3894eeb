// SPDX-License-Identifier: MIT
#include "sim/render/gl_context.hpp"

#include <GL/osmesa.h>
#include <gtest/gtest.h>

#include <thread>

namespace scanbed::sim {
namespace {

TEST(GlContextTest, IsCurrentOnceMade) {
  GlContext context;
  EXPECT_NE(OSMesaGetCurrentContext(), nullptr);
}

TEST(GlContextTest, SeveralTakeTurns) {
  GlContext first;
  const OSMesaContext of_first = OSMesaGetCurrentContext();
  GlContext second;
  const OSMesaContext of_second = OSMesaGetCurrentContext();
  EXPECT_NE(of_first, of_second);
  first.make_current();
  EXPECT_EQ(OSMesaGetCurrentContext(), of_first);
  second.make_current();
  EXPECT_EQ(OSMesaGetCurrentContext(), of_second);
}

TEST(GlContextTest, DoesNotLingerWhenGone) {
  { const GlContext context; }
  EXPECT_EQ(OSMesaGetCurrentContext(), nullptr);
}

TEST(GlContextTest, EachThreadHasItsOwn) {
  const GlContext here;
  const OSMesaContext of_here = OSMesaGetCurrentContext();
  OSMesaContext of_there = nullptr;
  std::thread([&of_there] {
    const GlContext there;
    of_there = OSMesaGetCurrentContext();
  }).join();
  EXPECT_NE(of_there, nullptr);
  EXPECT_NE(of_there, of_here);
  EXPECT_EQ(OSMesaGetCurrentContext(), of_here);
}

}  // namespace
}  // namespace scanbed::sim
