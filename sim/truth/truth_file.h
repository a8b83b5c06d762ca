#pragma once

#include <functional>
#include <memory>
#include <string>

#include "sim/recording.h"
#include "sim/truth/truth.h"

// Truth as a gzip file: lines that a person can read ("gzip -dc FILE | head"), then binary blocks.
//
//   MAPBED TRUTH 2
//   WORLD name
//   ROBOT name
//   MATERIAL index name
//   ENTITY id kind name
//   PART entity index name
//   TAG id x y z qx qy qz qw material    (an RFID tag; material -1: it sticks on nothing)
//   BLOCKS
//
// A block is a name of four letters, the number of bytes that follow (uint32) and so many bytes;
// all numbers are little-endian. The last one is "END ", empty. A reader passes over blocks whose
// name it does not know. A block holds one column after the other, for n moments:
//
//   STAT   n, m: moving parts (uint32); time, x, y, theta of the robot (float64[n] each);
//          entity[m], part[m], motion[m][n], pose[7][m][n]
//   BEAM   n, k: beams of a scan, laser (uint32); time (float64[n]);
//          range[k][n], entity[k][n], part[k][n], material[k][n], motion[k][n]
//
//   READ   n: reads of RFID tags (uint32); time (float64[n]); antenna[n], tag[n], mechanism[n]
//
// Tags count from 0 as their lines stand; a mechanism is 0 direct, 1 reflection, 2 ghost, 3 wrong
// antenna. Motion is 0 still, 1 waiting, 2 moving; entity, part, material and range are -1 where
// nothing was hit. Every column behind the float64 is in planes: a byte that says how many (1 to
// 4), then the lowest bytes of all its numbers, the next ones, and so on; the highest bit is the
// sign. Range [1 um] and pose (x, y, z [0.1 mm], then x, y, z, w of a unit quaternion, times 1e5)
// are differences from the moment before, but for the first of the n. sim/README.md has a reader of
// some 20 lines in Python.

namespace mapbed {

// Writes a truth while it comes to be; memory stays near one block.
class TruthWriter {
 public:
  TruthWriter(const std::string& path, const TruthHeader& header);
  ~TruthWriter();  // without finish(): as if nothing had been written
  TruthWriter(const TruthWriter&) = delete;
  TruthWriter& operator=(const TruthWriter&) = delete;

  void add(const StampedStates& states);   // by time
  void add(const BeamTruthOfScan& beams);  // by time
  void add(const TruthRead& read);         // by time
  void finish();                           // once, in the end

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Who takes what is read, block by block: states by time, beams of each laser by time.
struct TruthSink {
  std::function<void(const TruthHeader&)> header = {};
  std::function<void(StampedStates&&)> states = {};
  std::function<void(BeamTruthOfScan&&)> beams = {};
  std::function<void(TruthRead&&)> reads = {};
};

// Throw InputError with the place: the line of the header, or block and byte; the second one also
// where that takes more than `max_bytes` of memory.
void read_truth(const std::string& path, const TruthSink& sink);
Truth load_truth(const std::string& path, std::size_t max_bytes = kMostRecorded);
void write_truth(const std::string& path, const Truth& truth);

}  // namespace mapbed
