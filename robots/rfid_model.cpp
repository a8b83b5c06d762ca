#include "robots/rfid_model.h"

namespace mapbed {

double RfidModel::wavelength() const {
  constexpr double kSpeedOfLight = 299'792'458.0;  // [m/s]
  return kSpeedOfLight / frequency;
}

}  // namespace mapbed
