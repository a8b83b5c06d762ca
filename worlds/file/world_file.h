#pragma once

#include <string>

#include "core/config/configured.h"
#include "core/config/settings.h"
#include "worlds/world.h"

namespace mapbed {

// A world as a file: starts from a builder, from a plan or from nothing, and adds to it. All keys
// may be left out.
//
//   about: The lab with a crate in the way
//   start: office                          # a builder, with its options
//   options: {size: 24 m, seed: 3}
//   plan: {file: lab.yaml, height: 2.5 m, material: brick}       # instead of start
//   floor: {from: [0 m, 0 m], to: [10 m, 8 m], material: carpet}
//   ceiling: 2.5 m
//   materials:
//     velvet: {like: fabric, reflectivity: 0.05, color: [0.4, 0.1, 0.1]}
//   walls:
//     - {name: wall, from: [0 m, 3 m], to: [8 m, 3 m], thickness: 12 cm,   # at: from -> its middle
//        openings: [{kind: door, at: 2 m, width: 0.9 m, open: true}]}
//   shapes:
//     - {name: crate, box: [1 m, 0.5 m, 0.8 m], at: [3 m, 4 m], heading: 30 deg, material: wood}
//     - {name: pole, cylinder: {radius: 5 cm, height: 2 m}, at: [5 m, 4 m, 0 m]}
//     - {name: stage, outline: [[1 m, 1 m], [3 m, 1 m], [2 m, 2 m]], height: 20 cm}
//   movables:
//     - {name: seat, piece: office_chair, at: [4 m, 6 m], to: [[5 m, 6 m]], mean_rest: 20 s}
//   paths:
//     across: {points: [[1 m, 1 m], [7 m, 1 m]], clearance: 0.3 m, speed: 0.4 m/s}
//   tags:
//     - {id: tag_1, at: [1 m, 2 m, 1.4 m], facing: 90 deg, roll: 0 deg, material: wood}
//   crowd:
//     walkers: 4
//     routes: [{name: to and fro, points: [[1 m, 2 m], [7 m, 2 m]]}]
//     places: [{at: [3 m, 2 m], heading: 90 deg, radius: 0.5 m}]
//
// Paths in it are relative to its folder. `settings` change the builder's options, which are the
// complete configuration. The world is made as it is in the files now, which are told, for as long
// as it is asked for. Throws InputError with file, line and remedy; also for a path or route
// through a wall.
Configured<World()> configure_world_file(const std::string& yaml_path,
                                         const Settings& settings = {});

}  // namespace mapbed
