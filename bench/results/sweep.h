#pragma once

#include <string>
#include <vector>

#include "core/input_error.h"

namespace mapbed {

// What a sweep varies: one option, by its path.
struct SweepAxis {
  std::string path;                // "robot.odometry.rotation_sigma"
  std::vector<std::string> texts;  // as written: "2 deg"
  std::vector<double> numbers;     // 2 for "2 deg"; empty where one of the texts is not a number
  std::string unit;                // "deg"; empty where there is none or they differ
  SourceLocation place = {};       // in the scenario
};

// A level is one combination of the axes' values; its number counts the last axis fastest.
struct Level {
  std::vector<int> choice;  // of each axis, index into SweepAxis::texts
};

// An axis of these values; with their numbers where they are numbers of one unit.
SweepAxis axis_of(const std::string& path, std::vector<std::string> texts);

// Every combination of the axes' values, the last axis fastest. InputError for more than a million.
std::vector<Level> levels_of(const std::vector<SweepAxis>& axes);

// "rotation sigma" of "robot.odometry.rotation_sigma": a name as people read it.
std::string words_of(const std::string& path);

}  // namespace mapbed
