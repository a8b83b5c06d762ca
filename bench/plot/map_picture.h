#pragma once

#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "algorithms/grid/occupancy_map.h"
#include "algorithms/scan/beam.h"
#include "core/geometry/trajectory.h"
#include "core/image/image.h"
#include "core/labels/beam_labels.h"
#include "core/labels/tracks.h"
#include "core/time_interval.h"

namespace mapbed {

struct DrawnPath {
  std::string name;  // in the legend
  Trajectory map_from_robot;
  std::vector<TimeInterval> left_out = {};  // of the log; there the line breaks off
};

// Places that no map shows: where beams met what moves.
struct DrawnPoints {
  std::string name = {};  // in the legend
  std::vector<Eigen::Vector2d> points = {};
};

struct PictureOptions {
  int longest_side = 1600;  // [pixels] of the map, at most; a cell is a whole number of them, or
                            // where there are more cells, a pixel is a whole number of cells
};

// A map for people, as it could stand in a paper: free is white, occupied black, unknown grey-blue;
// the far ends of the few beams that went out of a window are left out;
// the paths in colours that the colour-blind tell apart, the first one widest, so that where they
// agree all are seen; a disc where each begins, and in the legend how many of its poses lie so far
// out that the picture does not show them; below, a scale bar and a legend. Where a pixel holds
// several cells, thin walls stay visible. Points are orange, a cell wide, below the paths.
// Tracks are thin, faint where nothing was seen, each with its number at its end.
RgbImage picture_of(const OccupancyMap& map, const std::vector<DrawnPath>& paths,
                    const PictureOptions& options = {}, const DrawnPoints& points = {},
                    const Tracks& tracks = {});

// Where the dynamic beams of a log ended; none where there are no labels. Labels as build_map()
// takes them.
DrawnPoints dynamic_points(const SensorLog& log, const Trajectory& map_from_robot,
                           std::span<const ScanLabels> labels, const BeamLimits& limits = {});

}  // namespace mapbed
