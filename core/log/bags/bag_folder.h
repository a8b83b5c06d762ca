#pragma once

#include <string>
#include <vector>

namespace mapbed {

// The folder of a bag as ROS 2 records it: metadata.yaml, and one file or several.
struct BagFolder {
  std::vector<std::string> files;  // paths, in their order
  std::string remark;              // what is odd; empty: nothing
};

// Without metadata.yaml, as after a crash, the files are taken by the numbers at the ends of their
// names. No files: it is no such folder. Throws InputError where they are several bags.
BagFolder bag_folder(const std::string& path);

}  // namespace mapbed
