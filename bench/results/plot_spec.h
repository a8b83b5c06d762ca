#pragma once

#include <string>

#include "bench/results/results.h"
#include "core/config/config_node.h"

namespace mapbed {

// An entry of a scenario's `plots`:
//
//   {file: error, x: robot.odometry.rotation_sigma, y: translation_error, log_y: true,
//    title: Error over noise, variants: [raw, matched], references: {published: 0.22 m}}
//   {y: failures}                                   the variants side by side
//   {kind: points, x: path_length, y: failures}     a mark for each run
//   {kind: heat_map, x: hits, y: misses, value: occupancy, variants: [counting]}
//
//   {y: failures, at: {people: 10}}                 these levels alone; also {people: [5, 10]}
//
// x is an axis or, of points, a metric; y a metric, of a heat map an axis; lines_by a second axis.
// Also: x_label, y_label, value_label, log_x, thesis.
PlotSpec plot_of(const ConfigNode& node);

// One line, of which plot_of makes the same again.
std::string plot_text(const PlotSpec& plot);

// Throws InputError where a plot names a metric, variant, axis or unit that there is not.
void check_plot(const PlotSpec& plot, const Results& plan);

}  // namespace mapbed
