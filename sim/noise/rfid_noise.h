#pragma once

#include <vector>

#include "core/random.h"
#include "core/sensor/rfid_detections.h"
#include "robots/robot.h"
#include "sim/sensors/ideal_rfid.h"
#include "sim/truth/true_read.h"

namespace mapbed {

// That a tag answers which receives so much, shadowing included [dBm]:
//   threshold: Phi((power - threshold) / read_sigma)
//   rice:      Q_1(sqrt(2 K), sqrt(2 (K + 1) threshold / power))  (Marcum)
double answer_probability(const RfidModel& model, double power);

// A round with its truth, read by read.
struct RfidRound {
  RfidDetections detections;
  std::vector<TruthRead> reads;
};

// What the reader of a robot tells. For each round, in this order:
//   shadowing   N(0, shadowing) for each tag and square that the antenna is in: the same whenever
//               it is there again
//   fading      of the power of this read
//   collisions  framed slotted ALOHA: each tag with power enough takes one of the slots; of several
//               in one, one is read that is stronger than the sum of the others by `capture`
//   wrong antenna  the read is told in another antenna's next round instead
//   ghosts      Poisson: a tag of the world, wherever it is
//   RSSI        P_tag - modulation + (P_tag - EIRP) + antenna_gain + N(0, sigma), by steps
//   phase       of there and back + N(0, sigma), by thousandths
//
// Every tag draws from a stream of its own, keyed by antenna, round and tag: it draws the same
// numbers whatever the others do, and whatever mechanisms are switched on.
class RfidReader {
 public:
  RfidReader(const Robot& robot, const Rng& rng);

  RfidRound read(const IdealRfid& ideal);  // in order of time

 private:
  struct Answer;
  std::vector<Answer> answers(const IdealRfid& ideal, const RfidModel& model) const;
  double shadowing(const IdealRfid& ideal, int tag, const RfidNoise& noise) const;
  void tell(RfidRound& round, const IdealRfid& ideal, int tag, ReadMechanism mechanism,
            const RfidRead& read) const;

  struct Stray {  // a read for another antenna's next round
    int tag;
    RfidRead read;
  };
  std::vector<MountedAntenna> antennas_;
  std::vector<std::vector<Stray>> strays_;  // of each antenna
  Rng rng_;
};

}  // namespace mapbed
