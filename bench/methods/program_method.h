#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/config/settings.h"
#include "core/file/input_file.h"

namespace mapbed {

// A method that is a program of somebody else's. Its file, scenarios/methods/NAME.yaml or any
// other:
//
//   about: Dead reckoning, in Python
//   command: [python3, "{script}", "{log}", trajectory.tum]
//   files: {script: ./odometry.py}        # that it reads besides; a placeholder each
//   log: carmen                           # how {log} is written: 'mapbed list formats'
//   trajectory: trajectory.tum            # what it writes: lines `t x y z qx qy qz qw` or
//                                         # `t x y theta`, by the stamps of the log
//   keep: [map.pgm, map.yaml]             # what else of its files stands beside the results
//   options: {step: 0.1}                  # with defaults, a placeholder each; set as NAME.step
//   limit: 10 min                         # of wall time; set as NAME.limit; 1 h where left out
//   version: [python3, --version]         # the first line that it prints is the version
//   install: apt-get install python3      # said where the program is not there
//
// `shell: TEXT` takes the place of `command` for a script of sh, which ends at the first command
// that fails; `program` then names the program that it is about. A command's words are the
// program's as they are, no shell sees them.
//
// It runs in an empty folder of its own, which goes afterwards. Placeholders:
//
//   {log}       the log that the run works on, with noise and faults, one for each run
//   {geometry}  of its lasers, as JSON: mounts, bearings, ranges
//   {stamps}    the time of each scan of the log, a line each
//   {out}       the folder in which it runs
//   {seed}      of the run
struct ProgramMethod {
  std::string name = {};  // its file's, without .yaml
  std::string about = {};
  std::vector<std::string> command = {};  // of one word where is_shell: the script
  bool is_shell = false;
  std::string log_format = "carmen";
  std::string trajectory = "trajectory.tum";        // below its folder
  std::vector<std::string> keep = {};               // the same
  std::map<std::string, std::string> files = {};    // absolute paths, by their placeholders
  std::map<std::string, std::string> options = {};  // by their placeholders
  double limit = 3600.0;                            // [s]
  std::string version = {};                         // empty: it tells none
  InputFiles input_files = {};                      // with the method's file and the program itself

  std::string complete_yaml() const;  // what can be set of it, and its version
  std::string description() const;    // the same, and the files that it is made of
};

// Whether a name stands for one: a path, or a name in scenarios/methods.
bool is_program_method(const std::string& name_or_path);
std::string program_method_name(const std::string& name_or_path);  // "my" of "./my.yaml"
std::vector<std::string> program_method_names();                   // in scenarios/methods

// Whether a file has the form above.
bool is_program_file(const std::string& path);

// Reads its file, with settings of its options and limit; asks the program for its version. Throws
// InputError where something is wrong, or the program not there.
ProgramMethod load_program_method(const std::string& name_or_path, const Settings& settings = {});

}  // namespace mapbed
