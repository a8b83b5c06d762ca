#pragma once

#include <string>
#include <vector>

#include "core/config/settings.h"

namespace mapbed {

class ConfigNode;

// What a sweep varies: one option, by its path, or several together, whose values have names.
struct SweepAxis {
  std::string path;                 // "robot.odometry.rotation_sigma"; of names any word
  std::vector<std::string> texts;   // as written: "2 deg"; or the names
  std::vector<double> numbers;      // 2 for "2 deg"; empty where one of the texts is not a number
  std::string unit;                 // "deg"; empty where there is none or they differ
  SourceLocation place = {};        // in the scenario
  std::vector<Settings> sets = {};  // what is set at each name; empty: texts are an option's values
};

// A level is one combination of the axes' values; its number counts the last axis fastest.
struct Level {
  std::vector<int> choice;  // of each axis, index into SweepAxis::texts
};

// An axis of these values; with their numbers where they are numbers of one unit.
SweepAxis axis_of(const std::string& path, std::vector<std::string> texts);

// Of names, a map of each to its settings: `{near: {world: hall}, far: {world: mine, people: 3}}`.
// Names may be numbers, so that plots have several options together along x:
// `{1 cm: {a.sigma: 1 cm, b.sigma: 1 cm}, 2 cm: {a.sigma: 2 cm, b.sigma: 2 cm}}`.
SweepAxis named_axis_of(const std::string& path, const ConfigNode& names);

// As named_axis_of reads it, on one line.
std::string names_text(const SweepAxis& axis);

// The axis with these of its values alone; of an option any others will do, too. Throws InputError
// for a name that it does not have.
SweepAxis with_values(const SweepAxis& axis, const std::vector<std::string>& texts,
                      const SourceLocation& place);

// What is set at the value of this index.
Settings settings_at(const SweepAxis& axis, int choice);

// Every combination of the axes' values, the last axis fastest. InputError for more than a million.
std::vector<Level> levels_of(const std::vector<SweepAxis>& axes);

// "rotation sigma" of "robot.odometry.rotation_sigma": a name as people read it.
std::string words_of(const std::string& path);

}  // namespace mapbed
