#pragma once

#include <string>
#include <vector>

#include "core/config/option.h"

namespace mapbed {

enum class ChosenEcho : int { first, strongest };

// Which topics and frames of a bag are meant where it has several. Empty: there is one that fits.
struct BagOptions {
  std::vector<std::string> scans = {};  // a topic for each laser, the front one first
  std::string odometry;                 // a topic, "tf" or "none"
  std::string truth = "/truth/pose";    // a topic, if it is there
  std::string odometry_frame = "odom";  // in which tf tells the odometry
  std::string robot_frame;              // that odometry and mounts are of
  ChosenEcho echo = ChosenEcho::first;
};

template <class Visitor>
void visit_fields(BagOptions& o, Visitor&& visit) {
  visit("scans", o.scans,
        "topics of the lasers, the front one first; none: the only one that there is");
  visit("odometry", o.odometry,
        "its topic; tf: the transforms; none: nothing of it; empty: the only one, else tf");
  visit("truth", o.truth, "topic of the true poses, used where it is there");
  visit("odometry_frame", o.odometry_frame, "frame from which transforms tell the odometry");
  visit("robot_frame", o.robot_frame,
        "the robot's own frame; empty: that of its odometry, base_footprint or base_link");
  visit("echo", o.echo, {"first", "strongest"},
        "which one counts where a beam has several: the nearest or that of most intensity");
}

}  // namespace mapbed
