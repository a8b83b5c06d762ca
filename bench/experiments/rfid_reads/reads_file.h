#pragma once

#include <array>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace mapbed {

// One answer of a tag to a reader with two receive ports, the tags standing at a known place.
struct PlacedRead {
  int place = 0;                     // index into PlacedReads::places
  int antenna = 0;                   // from 0
  int tag = 0;                       // index into PlacedReads::tags
  std::optional<double> frequency;   // [Hz]
  std::array<double, 2> strength{};  // [dBm] by port
  std::array<double, 2> phase{};     // [rad] by port
};

struct PlacedReads {
  std::vector<Eigen::Vector3d> places;  // [m] sorted by x, y, z
  std::vector<std::string> tags;        // sorted
  int antennas = 0;
  std::vector<PlacedRead> reads;
};

// A table of reads: a line of column names, then
//   tag_x,tag_y,tag_z [m],time [ms],ANTn,frequency [MHz] or None,tag,RSSI;RSSI [dBm],phase;phase
//   [degrees]
// Throws InputError with `name` and line.
PlacedReads parse_reads(const std::string& name, std::string_view text);
PlacedReads load_reads(const std::string& path);

// Files, each read once for all runs.
class ReadsFiles {
 public:
  const PlacedReads& at(const std::string& path);  // for several threads at a time

 private:
  std::mutex mutex_;
  std::map<std::string, PlacedReads> by_path_;
};

}  // namespace mapbed
