// SPDX-License-Identifier: MIT
#include "core/detect/robust/arc_moments.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

using testing::IdealScene;
using testing::with_noise;

struct Column {
  Echoes echoes;
  Stretch all;
};

Column column(double sigma_m) {
  IdealScene scene;
  scene.cylinder({3.0, 1.0}, 0.3);
  Column column;
  EchoReader().read(with_noise(scene.scan(), sigma_m, 3), {}, column.echoes);
  column.all = {0, column.echoes.size() - 1};
  return column;
}

// Least squares on x^2 + y^2 + d x + e y + f = 0 by a matrix, in coordinates of the sensor.
double chi2_by_matrix(const Column& c, Stretch places) {
  Eigen::MatrixXd rows(places.size(), 3);
  Eigen::VectorXd right(places.size());
  for (int i = 0; i < places.size(); ++i) {
    const Eigen::Vector2d p = c.echoes.point_m(places.first + i);
    const double root_weight = 1.0 / c.echoes.sigma_m(places.first + i);
    rows.row(i) = root_weight * Eigen::RowVector3d(p.x(), p.y(), 1.0);
    right[i] = -root_weight * p.squaredNorm();
  }
  const Eigen::Vector3d def = rows.colPivHouseholderQr().solve(right);
  const Eigen::Vector2d center_m = -0.5 * def.head<2>();
  const double radius2 = center_m.squaredNorm() - def.z();
  return (rows * def - right).squaredNorm() / (4.0 * radius2);
}

TEST(ArcMomentsTest, AgreesWithALeastSquaresSolution) {
  const Column c = column(0.005);
  ArcMoments moments;
  moments.begin(c.echoes);
  ASSERT_GE(c.all.size(), 15);
  for (const Stretch places :
       {c.all, Stretch{0, 9}, Stretch{3, c.all.last - 2}, Stretch{6, c.all.last}, Stretch{1, 8}}) {
    const double expected = chi2_by_matrix(c, places);
    const auto arc = moments.arc(places);
    ASSERT_TRUE(arc);
    EXPECT_NEAR(arc->chi2, expected, 1e-6 * expected);
  }
}

TEST(ArcMomentsTest, AnExactColumnCostsNothing) {
  const Column c = column(0.0);
  ArcMoments moments;
  moments.begin(c.echoes);
  const auto arc = moments.arc(c.all);
  ASSERT_TRUE(arc);
  EXPECT_NEAR(arc->chi2, 0.0, 1e-4);
  EXPECT_NEAR((arc->cylinder.center_m - Eigen::Vector2d(3.0, 1.0)).norm(), 0.0, 1e-6);
  EXPECT_NEAR(arc->cylinder.radius_m, 0.3, 1e-6);
}

TEST(ArcMomentsTest, HollowsAndStraightRunsAreNoArcs) {
  IdealScene wall;
  wall.wall({2.0, -0.5}, {2.0, 0.5});
  LaserScan hollow;
  for (int i = 0; i < 41; ++i) hollow.range_m.push_back(2.0 + 0.5 * std::cos((i - 20) * 0.05));
  for (const LaserScan& scan : {wall.scan(), hollow}) {
    Echoes echoes;
    EchoReader().read(scan, {}, echoes);
    ArcMoments moments;
    moments.begin(echoes);
    EXPECT_FALSE(moments.arc({0, echoes.size() - 1}));
  }
}

TEST(ArcMomentsTest, TwoStretchesAreSummedAsOne) {
  const Column c = column(0.005);
  ArcMoments whole;
  whole.begin(c.echoes);
  ArcMoments halves;
  halves.begin(c.echoes);
  const double expected = whole.arc(c.all)->chi2;
  EXPECT_NEAR(halves.arc_of_both({0, 8}, {9, c.all.last})->chi2, expected, 1e-6 * expected);
}

}  // namespace
}  // namespace scanbed
