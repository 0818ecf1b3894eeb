// SPDX-License-Identifier: MIT
#include "core/track/moving_point.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace scanbed {
namespace {

// The textbook's recursion on the whole state (x, y, vx, vy), with matrices and in Joseph's form.
struct TextbookFilter {
  Eigen::Vector4d state = Eigen::Vector4d::Zero();
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();

  void predict(double dt_s, double psd) {
    Eigen::Matrix4d transition = Eigen::Matrix4d::Identity();
    transition.topRightCorner<2, 2>() = dt_s * Eigen::Matrix2d::Identity();
    Eigen::Matrix2d noise;
    noise << dt_s * dt_s * dt_s / 3.0, dt_s * dt_s / 2.0, dt_s * dt_s / 2.0, dt_s;
    Eigen::Matrix4d process = Eigen::Matrix4d::Zero();
    for (int axis = 0; axis < 2; ++axis) {
      for (int i = 0; i < 2; ++i) {
        for (int k = 0; k < 2; ++k) process(axis + 2 * i, axis + 2 * k) = psd * noise(i, k);
      }
    }
    state = transition * state;
    covariance = transition * covariance * transition.transpose() + process;
  }

  void correct(const Eigen::Vector2d& measured_m, double sigma_m) {
    Eigen::Matrix<double, 2, 4> measurement = Eigen::Matrix<double, 2, 4>::Zero();
    measurement.leftCols<2>().setIdentity();
    const Eigen::Matrix2d noise = sigma_m * sigma_m * Eigen::Matrix2d::Identity();
    const Eigen::Matrix2d innovation = measurement * covariance * measurement.transpose() + noise;
    const Eigen::Matrix<double, 4, 2> gain = covariance * measurement.transpose() * innovation.inverse();
    state += gain * (measured_m - measurement * state);
    const Eigen::Matrix4d rest = Eigen::Matrix4d::Identity() - gain * measurement;
    covariance = rest * covariance * rest.transpose() + gain * noise * gain.transpose();
  }
};

TEST(MovingPointTest, AgreesWithTheTextbooksMatrices) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> dt_s(0.01, 0.5);
  std::uniform_real_distribution<double> place_m(-3.0, 3.0);
  MovingPoint point{.p_m = {1.0, -2.0}, .v_m_per_s = {0.3, 0.4}, .var_p_m2 = 0.02, .var_v_m2_per_s2 = 1.0};
  TextbookFilter textbook;
  textbook.state << 1.0, -2.0, 0.3, 0.4;
  textbook.covariance.diagonal() << 0.02, 0.02, 1.0, 1.0;
  for (int i = 0; i < 200; ++i) {
    const double step_s = dt_s(random);
    point.predict(step_s, 2.5);
    textbook.predict(step_s, 2.5);
    if (i % 3 == 2) continue;  // some scans see nothing
    const Eigen::Vector2d measured_m(place_m(random), place_m(random));
    point.correct(measured_m, 0.07);
    textbook.correct(measured_m, 0.07);
  }
  constexpr double kRounding = 1e-9;  // of some hundred steps in doubles
  EXPECT_NEAR((point.p_m - textbook.state.head<2>()).norm(), 0.0, kRounding);
  EXPECT_NEAR((point.v_m_per_s - textbook.state.tail<2>()).norm(), 0.0, kRounding);
  EXPECT_NEAR(point.var_p_m2, textbook.covariance(0, 0), kRounding);
  EXPECT_NEAR(point.cov_pv_m2_per_s, textbook.covariance(0, 2), kRounding);
  EXPECT_NEAR(point.var_v_m2_per_s2, textbook.covariance(3, 3), kRounding);
  EXPECT_NEAR(textbook.covariance(0, 1), 0.0, kRounding);
}

TEST(MovingPointTest, LearnsAConstantVelocity) {
  MovingPoint point{.var_p_m2 = 1.0, .var_v_m2_per_s2 = 1.0};
  for (int i = 1; i <= 100; ++i) {
    point.predict(0.1, 1e-6);
    point.correct(0.1 * i * Eigen::Vector2d(0.8, -0.6), 0.01);
  }
  EXPECT_NEAR((point.v_m_per_s - Eigen::Vector2d(0.8, -0.6)).norm(), 0.0, 0.01);
}

TEST(MovingPointTest, NoTimeChangesNothing) {
  MovingPoint point{.p_m = {1.0, 2.0}, .v_m_per_s = {3.0, 4.0}, .var_p_m2 = 0.1, .var_v_m2_per_s2 = 0.2};
  point.predict(0.0, 5.0);
  EXPECT_EQ(point.p_m, Eigen::Vector2d(1.0, 2.0));
  EXPECT_EQ(point.var_p_m2, 0.1);
  EXPECT_EQ(point.var_v_m2_per_s2, 0.2);
}

}  // namespace
}  // namespace scanbed
