#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "bench/scenario/plan.h"
#include "core/testing/temporary_folder.h"

namespace mapbed {

// A folder with all files that a newcomer may write: worlds of every kind, robot, sensor, learned
// parameters and a log.
class OwnFiles : public ::testing::Test {
 protected:
  OwnFiles();

  std::string path(const std::string& name) const { return folder_.file(name); }
  std::string text(const std::string& name) const;
  std::string write(const std::string& name, const std::string& text) const;  // its path

  // Short drives in a world, by two methods at two levels of noise.
  std::string scenario(const std::string& world, const std::string& more = "") const;
  void write_log(const std::string& name) const;  // of five seconds, in the corridor

  static ScenarioPlan planned(const std::string& scenario,
                              const std::vector<std::string>& set = {});
  // Runs it into a folder of that name.
  Results run(const ScenarioPlan& plan, const std::string& folder) const;
  // Everything of a result that is the same whenever it is made: name and bytes.
  std::vector<std::pair<std::string, std::string>> bytes_of(const std::string& folder) const;

 private:
  TemporaryFolder folder_;
};

}  // namespace mapbed
