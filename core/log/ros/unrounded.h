#pragma once

#include "core/geometry/pose2.h"

namespace mapbed {

struct Pose3;

// What a number was before it was stored. ROS keeps readings and bearings as 32-bit floats and
// headings as quaternions; sensors tell decimals, and bearings that people think of in degrees.
// Each of these is among the numbers that are stored as that float, so none is farther from the
// truth than it need be, and a log that was written as a bag has its own numbers again.

// The decimal with three, four or six places that the float is nearest to; else the float.
double unrounded(float value);

// [rad] The fraction of a degree, with a denominator of 720, 1000 or 1024, that the float is
// nearest to; else as above.
double unrounded_bearing(float bearing);

// The place in the plan. Of a heading by sine and cosine the last digits are lost: it is the
// decimal with nine places that it can be, else what it is.
Pose2 unrounded_plan(const Pose3& pose);

// [rad] An angle of a mount, of which no more than nine places count: the fraction of a degree that
// it is by them, else these.
double unrounded_mount_angle(double angle);

}  // namespace mapbed
