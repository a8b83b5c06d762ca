#include "robots/laser_model.h"

#include <algorithm>

#include "core/geometry/angle.h"

namespace mapbed {

double LaserModel::beam_delay(int beam) const {
  if (mirror_rate <= 0.0) return 0.0;
  const double turns = beam % interlace + beam * bearing_step / (2.0 * kPi);
  return turns / mirror_rate;
}

double LaserModel::beam_period() const {
  return interlace == 1 ? beam_delay(1) : 0.0;
}

double LaserModel::sweep_time() const {
  double last = 0.0;
  for (int beam = std::max(0, beams - interlace); beam < beams; ++beam) {
    last = std::max(last, beam_delay(beam));
  }
  return last;
}

double LaserModel::stamp_delay() const {
  const bool is_one_instant = stamp == SweepStamp::middle || beam_period() == 0.0;
  return is_one_instant ? sweep_time() / 2.0 : 0.0;
}

}  // namespace mapbed
