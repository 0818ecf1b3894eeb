// SPDX-License-Identifier: MIT
#include "sim/planar/floor_physics.hpp"

#include <box2d/box2d.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "sim/world/solid_geometry.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr double kGravity_m_per_s2 = 9.81;
constexpr int kVelocityIterations = 8;
constexpr int kPositionIterations = 3;

b2Vec2 to_box2d(const Vector2d& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y())};
}

Vector2d from_box2d(const b2Vec2& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

// Filter: scripted things only meet cylinders.
constexpr std::uint16_t kScripted = 0x0002;
constexpr std::uint16_t kCylinder = 0x0004;

void add_still(b2Body& ground, const Solid& solid) {
  b2FixtureDef fixture;
  fixture.filter.categoryBits = kScripted;
  fixture.filter.maskBits = kCylinder;
  if (const auto* cylinder = std::get_if<Cylinder>(&solid.shape)) {
    b2CircleShape circle;
    circle.m_p = to_box2d(cylinder->center_m);
    circle.m_radius = static_cast<float>(cylinder->radius_m);
    fixture.shape = &circle;
    ground.CreateFixture(&fixture);
  }
  for (const Edge& edge : outline(solid.shape)) {
    b2EdgeShape shape;
    shape.SetTwoSided(to_box2d(edge.a_m), to_box2d(edge.b_m));
    fixture.shape = &shape;
    ground.CreateFixture(&fixture);
  }
}

/// A disc that follows the script.
b2Body* create_scripted(b2World& world, double radius_m, const Vector2d& center_m) {
  b2BodyDef definition;
  definition.type = b2_kinematicBody;
  definition.position = to_box2d(center_m);
  b2Body* body = world.CreateBody(&definition);
  b2CircleShape circle;
  circle.m_radius = static_cast<float>(radius_m);
  b2FixtureDef fixture;
  fixture.shape = &circle;
  fixture.filter.categoryBits = kScripted;
  fixture.filter.maskBits = kCylinder;
  body->CreateFixture(&fixture);
  return body;
}

void follow(b2Body& body, const Vector2d& target_m, float per_step) {
  body.SetLinearVelocity(per_step * (to_box2d(target_m) - body.GetPosition()));
}

void appear_at(b2Body& body, const Vector2d& center_m) {
  body.SetTransform(to_box2d(center_m), 0.0F);
  body.SetLinearVelocity(b2Vec2_zero);
  body.SetEnabled(true);
}

b2Body* create_cylinder(b2World& world, const Tow& tow) {
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  b2Body* body = world.CreateBody(&definition);
  b2CircleShape circle;
  circle.m_radius = static_cast<float>(tow.radius_m);
  b2FixtureDef fixture;
  fixture.shape = &circle;
  fixture.density = static_cast<float>(tow.mass_kg / (kPi * tow.radius_m * tow.radius_m));
  fixture.filter.categoryBits = kCylinder;
  fixture.filter.maskBits = kScripted | kCylinder;
  body->CreateFixture(&fixture);
  return body;
}

// A disc that presses evenly on the floor resists turning with 2/3 mu m g r.
void add_floor_friction(b2World& world, b2Body* ground, b2Body* cylinder, const Tow& tow) {
  const double force_n = tow.friction * tow.mass_kg * kGravity_m_per_s2;
  b2FrictionJointDef friction;
  friction.bodyA = ground;
  friction.bodyB = cylinder;
  friction.maxForce = static_cast<float>(force_n);
  friction.maxTorque = static_cast<float>(2.0 / 3.0 * force_n * tow.radius_m);
  friction.collideConnected = true;
  world.CreateJoint(&friction);
}

// A pulled disc turns its rope's end towards the puller, so the rope points at its centre.
void add_rope(b2World& world, b2Body* pelvis, b2Body* cylinder, const Tow& tow) {
  b2DistanceJointDef rope;
  rope.bodyA = pelvis;
  rope.bodyB = cylinder;
  rope.minLength = 0.0F;
  rope.maxLength = static_cast<float>(tow.taut_m());
  rope.length = rope.maxLength;
  world.CreateJoint(&rope);
}

}  // namespace

struct FloorPhysics::Impl {
  struct Person {
    bool present = false;
    b2Body* left_leg = nullptr;
    b2Body* right_leg = nullptr;
  };
  struct Pull {
    int walker = 0;
    double taut_m = 0.0;  ///< from pelvis to the cylinder's centre
    b2Body* pelvis = nullptr;
    b2Body* cylinder = nullptr;
  };

  Impl(const World& description, const WorldState& start);
  void set_present(const WalkerState& state);
  void steer(const WorldState& next, float per_step);

  b2World world{b2Vec2_zero};
  b2Body* robot = nullptr;
  std::vector<Person> people;
  std::vector<Pull> pulls;
  double time_s = 0.0;
};

FloorPhysics::Impl::Impl(const World& description, const WorldState& start) : time_s(start.time_s) {
  double reach_m = 0.0;
  for (const Walker& walker : description.walkers) {
    if (walker.tow) reach_m = std::max(reach_m, walker.tow->height_m);
  }
  const b2BodyDef still;
  b2Body* ground = world.CreateBody(&still);
  for (const Solid& solid : description.solids) {
    if (solid.bottom_m < reach_m && solid.top_m > 0.0) add_still(*ground, solid);
  }
  robot = create_scripted(world, description.robot.radius_m, start.X_WR.p_m);
  for (std::size_t i = 0; i < description.walkers.size(); ++i) {
    const Walker& walker = description.walkers[i];
    const WalkerState& state = start.walkers[i];
    Person person;
    person.left_leg = create_scripted(world, walker.leg_radius_m, state.left_leg_m);
    person.right_leg = create_scripted(world, walker.leg_radius_m, state.right_leg_m);
    if (walker.tow) {
      b2BodyDef pelvis;
      pelvis.type = b2_kinematicBody;
      const Pull pull{static_cast<int>(i), walker.tow->taut_m(), world.CreateBody(&pelvis),
                      create_cylinder(world, *walker.tow)};
      add_floor_friction(world, ground, pull.cylinder, *walker.tow);
      add_rope(world, pull.pelvis, pull.cylinder, *walker.tow);
      pull.pelvis->SetEnabled(false);
      pull.cylinder->SetEnabled(false);
      pulls.push_back(pull);
    }
    person.left_leg->SetEnabled(false);
    person.right_leg->SetEnabled(false);
    people.push_back(person);
    set_present(state);
  }
}

// Who appears brings the cylinder along; who leaves takes it away.
void FloorPhysics::Impl::set_present(const WalkerState& state) {
  Person& person = people[state.walker];
  if (person.present == state.present) return;
  person.present = state.present;
  if (state.present) {
    appear_at(*person.left_leg, state.left_leg_m);
    appear_at(*person.right_leg, state.right_leg_m);
  } else {
    person.left_leg->SetEnabled(false);
    person.right_leg->SetEnabled(false);
  }
  for (Pull& pull : pulls) {
    if (pull.walker != state.walker) continue;
    if (state.present) {
      appear_at(*pull.pelvis, state.X_WP.p_m);
      appear_at(*pull.cylinder, state.X_WP * Vector2d(-pull.taut_m, 0.0));
    } else {
      pull.pelvis->SetEnabled(false);
      pull.cylinder->SetEnabled(false);
    }
  }
}

void FloorPhysics::Impl::steer(const WorldState& next, float per_step) {
  follow(*robot, next.X_WR.p_m, per_step);
  for (const WalkerState& state : next.walkers) {
    set_present(state);
    if (!state.present) continue;
    follow(*people[state.walker].left_leg, state.left_leg_m, per_step);
    follow(*people[state.walker].right_leg, state.right_leg_m, per_step);
  }
  for (const Pull& pull : pulls) {
    if (people[pull.walker].present) follow(*pull.pelvis, next.walkers[pull.walker].X_WP.p_m, per_step);
  }
}

FloorPhysics::FloorPhysics(const World& world, const WorldState& start)
    : impl_(std::make_unique<Impl>(world, start)) {}

FloorPhysics::~FloorPhysics() = default;

void FloorPhysics::step_to(WorldState& next) {
  const double step_s = next.time_s - impl_->time_s;
  if (step_s > 0.0) {
    impl_->steer(next, static_cast<float>(1.0 / step_s));
    impl_->world.Step(static_cast<float>(step_s), kVelocityIterations, kPositionIterations);
    impl_->time_s = next.time_s;
  }
  next.tows.resize(impl_->pulls.size());
  for (std::size_t i = 0; i < impl_->pulls.size(); ++i) {
    const Impl::Pull& pull = impl_->pulls[i];
    next.tows[i] = {pull.walker, impl_->people[pull.walker].present,
                    from_box2d(pull.cylinder->GetPosition())};
  }
}

}  // namespace scanbed::sim
