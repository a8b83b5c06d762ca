#pragma once

#include <cstddef>
#include <vector>

#include "core/log/bearings.h"
#include "core/log/sensor_log.h"

// How well scans fit on each other under odometry's motion between them, if a laser's beams pointed
// here or there. Ranges alone do not tell where beams point; ranges from two places do.

namespace mapbed {

// Two scans of a laser with a turn or a way between them.
struct ScanPair {
  const LaserScan* before = nullptr;
  const LaserScan* after = nullptr;
  Pose2 before_from_after;  // of the robot, by odometry
};

// Up to `most`, evenly over the log, of scans with so many beams; turns and ways in equal numbers
// where there are enough of both.
std::vector<ScanPair> scan_pairs(const SensorLog& log, int laser, std::size_t beams, int most);

// The fraction of the later scan's hits within the earlier one's view that lie where that one saw
// a surface, too; NaN where fewer than ten are in view.
double agreement(const ScanPair& pair, const Bearings& bearings);

// What several bearings come to, pair by pair.
struct AgreementComparison {
  std::vector<double> mean;                // by candidate; 0 where no pair says anything
  std::vector<std::vector<double>> pairs;  // by candidate and pair
};
AgreementComparison compare(const std::vector<ScanPair>& pairs,
                            const std::vector<Bearings>& candidates);

// Whether candidate `a` is better than `b` beyond chance and by a margin that matters: five
// standard errors of the difference over ten pairs or more, which no run of luck in independent
// pairs gives (3e-7), a tenth of all beams, and most beams fit. Odometry that is wrong spoils all
// candidates alike and does not make one of them good.
bool is_clearly_better(const AgreementComparison& comparison, std::size_t a, std::size_t b);

// Whether first and last beam see the same surface as often as neighbouring beams do, as those of
// a full circle must; so too where no scan says anything.
bool ends_meet(const std::vector<ScanPair>& pairs);

}  // namespace mapbed
