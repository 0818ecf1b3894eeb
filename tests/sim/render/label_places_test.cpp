// SPDX-License-Identifier: MIT
#include "sim/render/label_places.hpp"

#include <gtest/gtest.h>

#include <random>

namespace scanbed::sim {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

const AlignedBox2d kPicture(Vector2d(0, 0), Vector2d(960, 720));
const Vector2d kSize(80, 14);

bool overlap(const AlignedBox2d& a, const AlignedBox2d& b) {
  return a.min().x() < b.max().x() && b.min().x() < a.max().x() && a.min().y() < b.max().y() &&
         b.min().y() < a.max().y();
}

TEST(LabelPlacesTest, ALabelAloneStandsJustAbove) {
  const std::vector<Label> labels = {{{400, 300}, kSize}};
  const AlignedBox2d box = label_places(labels, kPicture).front();
  EXPECT_EQ(box.sizes(), kSize);
  EXPECT_EQ(box.center().x(), 400);
  EXPECT_LT(box.max().y(), 300);
  EXPECT_GT(box.max().y(), 300 - kSize.y());
}

TEST(LabelPlacesTest, AtTheUpperEdgeItStandsBelow) {
  const std::vector<Label> labels = {{{400, 5}, kSize}};
  EXPECT_GT(label_places(labels, kPicture).front().min().y(), 5);
}

TEST(LabelPlacesTest, InACornerItStaysInThePicture) {
  for (const Vector2d& corner_px : {Vector2d(1, 1), Vector2d(959, 1), Vector2d(1, 719), Vector2d(959, 719)}) {
    const std::vector<Label> labels = {{corner_px, kSize}};
    EXPECT_TRUE(kPicture.contains(label_places(labels, kPicture).front())) << corner_px.transpose();
  }
}

TEST(LabelPlacesTest, LabelsOfThingsCloseTogetherDoNotOverlap) {
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> near(-25.0, 25.0);
  for (int repeat = 0; repeat < 200; ++repeat) {
    std::vector<Label> labels;
    for (int i = 0; i < 6; ++i) labels.push_back({{480 + near(engine), 360 + near(engine)}, kSize});
    const std::vector<AlignedBox2d> boxes = label_places(labels, kPicture);
    ASSERT_EQ(boxes.size(), labels.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(boxes[i], boxes[j])) << repeat;
    }
  }
}

TEST(LabelPlacesTest, ALabelDoesNotCoverWhatAnotherNames) {
  const std::vector<Label> labels = {{{400, 300}, kSize}, {{400, 286}, kSize}};
  for (const AlignedBox2d& box : label_places(labels, kPicture)) {
    for (const Label& label : labels) EXPECT_FALSE(box.contains(label.anchor_px));
  }
}

TEST(LabelPlacesTest, WhereThereIsNoRoomAllAreGivenAPlace) {
  const std::vector<Label> labels(100, {{20, 20}, {200, 14}});
  EXPECT_EQ(label_places(labels, {Vector2d(0, 0), Vector2d(40, 40)}).size(), 100);
}

}  // namespace
}  // namespace scanbed::sim
