#include "lab/hard_cases/variants/families.h"
#include "lab/hard_cases/variants/parts.h"

#include <algorithm>
#include <numbers>

namespace muelle::hard_cases {

namespace {

Variant h17() {
  Variant v{.id = "H17", .name = "", .measured = "error of z at t = 10 s [m]", .model = bouncingBall()};
  v.duration = 10.0;
  v.bar = 1e-3;
  v.steps = {1e-4, 5e-4, 1e-3, 1e-4, 1e-9};
  v.error = coordinate(0, reference("H17", "z(10)"));
  // Eleven contacts of half a period each.
  const double omega = std::sqrt(1e5);
  v.modes = {{.stiffness = omega * omega,
              .amplitude = 0.0,
              .speed = reference("H17", "v_impact"),
              .duration = reference("H17", "n_bounces(10)") * std::numbers::pi / omega,
              .located = true}};
  v.sensitive = true;
  v.inClosedForm = true;
  v.flightAcceleration = 9.81;
  v.flightTime = 10.0;
  return v;
}

Variant h18() {
  Variant v{.id = "H18", .name = "stack", .measured = "error of the top's height after 10 s [m]"};
  v.model = stack(1e4, 1.0, 12.0);
  v.duration = 10.0;
  v.bar = 1e-6;
  v.steps = {2e-3, 2e-3, 2e-3, 2e-3, 1e-9};
  v.error = coordinate(9, reference("H18", "stack.z10"));
  v.modes = {{.stiffness = 14.9 * 14.9, .amplitude = 0.05, .drag = 12.0},
             {.stiffness = 200.0 * 200.0, .amplitude = 1e-4, .drag = 12.0}};
  v.coupled = 10;
  return v;
}

Variant h19() {
  Variant v{.id = "H19", .name = "", .measured = "error of x at t = 0.1 s [m]", .model = tunnelling()};
  v.duration = 0.1;
  v.bar = 7e-5;  // BDF2 loses (omega h)^4 / 4 a step of the speed, in 157 steps, for 0.09 s: 5.7e-5
  v.steps = {1e-6, 1e-5, 2e-5, 1e-6, 1e-9};
  v.error = coordinate(0, reference("H19", "x(0.1)"));
  // In and out, 0.005 m each; the swept bound allows a hundredth of the slab's 0.01 m a step.
  v.modes = {{.stiffness = 4e8,
              .amplitude = 0.0,
              .speed = 100.0,
              .duration = reference("H19", "t_contact"),
              .leastSteps = 100,
              .located = true}};
  v.sensitive = true;
  return v;
}

Variant h20(double degrees, double speed, const std::string& name) {
  Variant v{.id = "H20", .name = name, .measured = "error of the distance slid [m]", .model = incline(degrees, speed)};
  v.duration = speed > 0.0 ? 2.0 : 10.0;
  // Sticking, the slider's damper has h d/m = 0.63: velocity Verlet is stable up to 1.
  v.steps = {1e-4, 1e-4, 2e-4, 1e-3, 1e-9};
  return v;
}

std::function<double(const Finished&)> slid(double degrees, double expected) {
  return [=](const Finished& end) {
    return std::abs(downhill(end.x(0), end.system->position(end.system->initialState(), 0), degrees) - expected);
  };
}

Variant h20Sticks() {
  Variant v = h20(26.5, 0.0, "26.5");
  v.bar = 1e-15;  // nothing moves; the case asks for 1e-6
  v.error = slid(26.5, 0.0);
  // Along the plane the slider's stiffness with its damper, which starts balanced but for rounding. Across it the
  // ground's: that mode does not show in the distance slid.
  v.modes = {{.stiffness = 1e7, .amplitude = 0.0, .damping = 2.0 * std::sqrt(1e7), .startsAfresh = true}};
  return v;
}

/// Slides with the acceleration a: the slider yields all the time, and what is left is a flight.
Variant h20Slides() {
  Variant v = h20(26.6, 0.0, "26.6");
  v.bar = 5e-6;  // order 1 at the explicit step: h a t / 2 = 1e-4 * 0.00669 * 10 / 2 = 3.4e-6; of 0.33 m
  v.error = slid(26.6, reference("H20", "slide(26.6)"));
  // The ground's, from the rounding of the 9e-6 m that the node is pressed in: a bounce across the plane is one along
  // it.
  v.modes = {mode(1e3, 1e-21)};
  v.flightAcceleration = reference("H20", "acceleration(26.6)");
  v.flightTime = 10.0;
  return v;
}

Variant h20Stops() {
  Variant v = h20(0.0, 3.0, "flat");
  v.bar = 1e-9;  // from order 2 on exact; the case asks for 1e-4 of 0.917 m
  v.error = slid(0.0, reference("H20", "flat.distance"));
  v.flightAcceleration = -reference("H20", "flat.acceleration");
  v.flightTime = reference("H20", "flat.t_stop");
  return v;
}

Variant h21() {
  Variant v{.id = "H21", .name = "", .measured = "error of z at t = 2 s [m]", .model = overdampedContact()};
  v.duration = 2.0;
  v.bar = 1e-4;
  v.steps = {1e-4, 1e-4, 1e-4, 1.0 / 60, 1e-9};
  v.error = coordinate(0, reference("H21", "z(2)"));
  v.modes = {{.stiffness = 1e4,
              .amplitude = 0.000981,
              .speed = reference("H21", "v_touch"),
              .damping = 1e4,
              .duration = 2.0 - reference("H21", "t_touch"),
              .cannotPull = true}};
  v.linear = true;  // from the touch on
  return v;
}

}  // namespace

std::vector<Variant> contactVariants() { return {h17(), h18(), h19(), h20Sticks(), h20Slides(), h20Stops(), h21()}; }

}  // namespace muelle::hard_cases
