#pragma once

#include "sim/render/render_world.h"
#include "sim/simulation.h"

namespace mapbed {

// A simulation as it stands: doors, people in shirts of several colours, the robot, and what its
// first laser sees. A reach without a center is that of the robot. Works on the simulation's scene,
// changes nothing that happens in it.
RgbImage render_simulation(Painter& painter, Simulation& simulation,
                           const RenderOptions& options = {});

// The robot as it looks: body, wheels, lasers. `body` and `dark` are materials of the world.
Entity robot_entity(const Robot& robot, const Pose2& world_from_robot, int body, int dark);

}  // namespace mapbed
