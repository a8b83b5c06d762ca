#pragma once

#include <map>
#include <mutex>
#include <string>
#include <variant>

#include "bench/experiments/false_loops/lattice_drive.h"

namespace mapbed {

using AnyKnownGraph = std::variant<KnownGraph<Pose2>, KnownGraph<Pose3>>;

// Graphs in files, each read once for all runs. What is true is not known: the optimum of the
// file's own constraints stands for it. The graph's nodes are where odometry alone has them.
class GraphFiles {
 public:
  // For several threads at a time. Throws InputError.
  const AnyKnownGraph& at(const std::string& path);

 private:
  std::mutex mutex_;
  std::map<std::string, AnyKnownGraph> by_path_;
};

}  // namespace mapbed
