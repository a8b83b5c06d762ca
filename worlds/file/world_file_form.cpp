#include "worlds/file/world_file_form.h"

namespace mapbed {

std::string world_file_form() {
  return R"(about: The lab with a crate in the way  # in a line
start: office  # a builder of 'mapbed list worlds'; nothing where left out
options: {size: 28 m, seed: 0}  # of the builder, as 'mapbed describe office' shows them
# plan: {file: lab.yaml, height: 2.5 m, material: brick}  # instead of start: a map_server map
floor: {from: [0 m, 0 m], to: [28 m, 28 m], material: carpet}
ceiling: 2.5 m  # how high rooms and their walls are
materials:  # of its own; 'mapbed list materials' shows those that there are
  velvet: {like: fabric, reflectivity: 0.05, color: [0.4, 0.1, 0.1]}  # and all of 'describe glass'
walls:  # from and to are the ends of the middle line
  - {name: wall, from: [40 m, 3 m], to: [48 m, 3 m], thickness: 12 cm, material: plaster,
     openings: [  # in order from the wall's start, apart from each other
       {kind: door,  # gap (up to the ceiling), door or glass
        at: 2 m,  # the distance from the wall's start (from) to the opening's middle
        width: 0.9 m,
        # of doors alone:
        open: true,  # at the start
        hinge_at_end: false,  # of the opening, as the wall runs; else at its start
        opens_left: true,  # of the wall as it runs; else to its right
        mean_open: 0 s,  # exponential; 0 s: stays until somebody needs it
        mean_shut: 0 s,
        opens_within: 1.2 m}]}  # for a person or robot that comes so near
shapes:  # `at` is x, y and, if needed, the height of the lower side; also heading, pitch, roll
  - {name: crate, box: [1 m, 0.5 m, 0.8 m], at: [43 m, 5 m], heading: 30 deg, material: wood}
  - {name: pole, cylinder: {radius: 5 cm, height: 2 m}, at: [45 m, 5 m, 0 m]}
  - {name: stage, outline: [[41 m, 6 m], [43 m, 6 m], [42 m, 7 m]], height: 20 cm}
  # - {name: statue, mesh: statue.obj, kind: structure}  # furniture where `kind` is left out
movables:  # what is moved about, from `at` to each place of `to` and round again
  - {name: trolley, box: [0.9 m, 0.5 m, 0.8 m], at: [44 m, 6 m], to: [[46 m, 6 m]], speed: 0.5 m/s,
     mean_rest: 20 s}
  - {name: chair, piece: chair, at: [46 m, 7 m], to: [[47 m, 7 m]]}  # or office_chair
paths:  # that robots can be sent along: clear of all things, doors open
  across: {points: [[41 m, 1 m], [47 m, 1 m]], clearance: 0.3 m, speed: 0.4 m/s}
tags:  # RFID tags: where they look, and what they stick on (what is right behind if left out)
  - {id: tag_1, at: [44 m, 2.9 m, 1.4 m], facing: -90 deg, pitch: 0 deg,
     roll: 0 deg,  # 0 deg: the dipole lies level; 90 deg: it stands upright
     material: plaster}
crowd:
  walkers: 4
  standing: 1
  blockers: 0  # step into the robot's way on purpose
  pause_fraction: 0.3  # probability to pause at a point of the route
  mean_pause: 5 s
  routes: [{name: to and fro, points: [[41 m, 2 m], [47 m, 2 m]], closed: false, weight: 1}]
  places: [{at: [43 m, 2 m], heading: 90 deg, radius: 0.5 m}]  # where people stand
)";
}

}  // namespace mapbed
