#pragma once

#include <string>

#include "core/config/option.h"

namespace mapbed {

// What a beam returns whose spot lies on surfaces at several distances.
enum class MixedPixels : int {
  off,       // the surface that the beam's axis meets
  weighted,  // the mean of the distances, weighted by the reflected power
  either,    // one of the distances, drawn by the reflected power
  pulse,     // weighted where the echoes overlap (closer than pulse_length), else either
};

// Which moment of a sweep its stamp tells.
enum class SweepStamp : int {
  first_beam,  // as LaserScan has it: methods take the beams one after the other from there on
  middle,      // of a sweep that is over at once, nearly
};

// How a laser's readings differ from the true ranges. Zero switches a mechanism off.
struct LaserNoise {
  double sigma_near = 0.005;            // [m] statistical error up to near_range
  double sigma_far = 0.010;             // [m] statistical error from far_range on; linear between
  double near_range = 8.0;              // [m]
  double far_range = 20.0;              // [m]
  double bias = 0.0;                    // [m] systematic error, added to every reading
  double bias_spread = 0.0;             // [m] sigma of a further one, drawn once a device ...
  double scale_spread = 0.0;            // ... and of a relative one of all ranges
  double step = 0.01;                   // [m] readings are whole multiples of this
  double dark_range = 10.0;             // [m] a 10 % reflector, met head on, is seen half the time
  double dark_softness = 0.1;           // sigma of that limit, as a fraction of it
  double miss_probability = 0.0001;     // a beam returns nothing for no reason
  double short_probability = 0.0001;    // something tiny in the way: dust, a fly, a reflection
  double random_probability = 0.00001;  // a reading anywhere in the measuring range
  MixedPixels mixed_pixels = MixedPixels::pulse;
  double pulse_length = 0.45;  // [m] echoes closer than this merge into one (3 ns pulse: c t / 2)
  bool glass = true;           // panes let beams through by chance; false: they are walls
};

// A planar laser range finder: geometry, timing, beam, noise.
struct LaserModel {
  std::string about;
  std::string source;  // where the values are from, and which document was not opened; no option
  int beams = 180;
  double first_bearing = -1.5707963267948966;  // [rad] of beam 0, in the laser frame
  double bearing_step = 0.017453292519943295;  // [rad]
  double min_range = 0.0;                      // [m] what is nearer is not seen: the beam fails
  double max_range = 8.19;                     // [m] a reading of this means: nothing was hit
  double scan_rate = 5.0;                      // [Hz] sweeps that are reported
  double mirror_rate = 75.0;                   // [Hz] turns of the mirror; 0: all beams at once
  int interlace = 1;  // turns of the mirror for one sweep; beam k belongs to turn k % interlace
  SweepStamp stamp = SweepStamp::first_beam;  // where beam_period() is 0 it is the middle, too
  double divergence = 0.0044;  // [rad] full opening angle of the beam; 0 with aperture 0: a line
  double aperture = 0.02;      // [m] the beam's width where it leaves the sensor
  int sub_rays = 15;           // rays across the beam's width; few leave gaps between the readings
                               // of an edge
  LaserNoise noise;

  double beam_delay(int beam) const;  // [s] after the first beam of its sweep
  double beam_period() const;  // [s] from each beam to the next; 0: all at once, or interlaced
  double sweep_time() const;   // [s] from the first to the last beam in time
  double stamp_delay() const;  // [s] of the sweep's stamp after its first beam
};

template <class Visitor>
void visit_fields(LaserNoise& o, Visitor&& visit) {
  visit("sigma_near", o.sigma_near, Unit::meter, kNotNegative, "error up to near_range");
  visit("sigma_far", o.sigma_far, Unit::meter, kNotNegative, "error from far_range on");
  visit("near_range", o.near_range, Unit::meter, kNotNegative, "the error grows from here");
  visit("far_range", o.far_range, Unit::meter, kNotNegative, "the error stops growing here");
  visit("bias", o.bias, Unit::meter, "systematic error, added to every reading");
  visit("bias_spread", o.bias_spread, Unit::meter, between(0.0, 10.0),
        "sigma of a further one, drawn once a device");
  visit("scale_spread", o.scale_spread, between(0.0, 0.5),
        "relative sigma of the scale of all ranges, drawn once a device");
  visit("step", o.step, Unit::meter, between(0.0, 10.0), "readings are multiples of this");
  visit("dark_range", o.dark_range, Unit::meter, kNotNegative,
        "a 10 % reflector met head on is seen half the time here; 0: everything is seen");
  visit("dark_softness", o.dark_softness, between(0.0, 100.0), "relative sigma of that limit");
  visit("miss_probability", o.miss_probability, kFraction, "a beam returns nothing");
  visit("short_probability", o.short_probability, kFraction, "a reading before the surface");
  visit("random_probability", o.random_probability, kFraction, "a reading anywhere");
  visit("mixed_pixels", o.mixed_pixels, {"off", "weighted", "either", "pulse"},
        "what a beam on an edge returns");
  visit("pulse_length", o.pulse_length, Unit::meter, between(0.0, 100.0),
        "closer echoes merge into one");
  visit("glass", o.glass, "panes let beams through by chance; no: they are walls");
}

template <class Visitor>
void visit_fields(LaserModel& o, Visitor&& visit) {
  visit("about", o.about, "what it is");
  visit("beams", o.beams, between(1, 100'000), "readings of one sweep");
  visit("first_bearing", o.first_bearing, Unit::radian, "direction of the first reading");
  visit("bearing_step", o.bearing_step, Unit::radian, between(1e-6, 6.3),
        "from one reading to the next");
  visit("min_range", o.min_range, Unit::meter, between(0.0, 100.0),
        "what is nearer is not seen: the beam fails and reads 0");
  visit("max_range", o.max_range, Unit::meter, between(0.01, 1000.0),
        "the reading that means nothing");
  visit("scan_rate", o.scan_rate, Unit::hertz, between(0.001, 10'000.0),
        "sweeps reported per second");
  visit("mirror_rate", o.mirror_rate, Unit::hertz, between(0.0, 100'000.0),
        "turns of the mirror per second; 0: all beams at once");
  visit("interlace", o.interlace, between(1, 64), "turns of the mirror for one sweep");
  visit("stamp", o.stamp, {"first_beam", "middle"},
        "moment of a sweep that its stamp tells; the middle is for sweeps of 10 ms at most");
  visit("divergence", o.divergence, Unit::radian, between(0.0, 1.0), "opening angle of the beam");
  visit("aperture", o.aperture, Unit::meter, between(0.0, 1.0), "width of the beam at the sensor");
  visit("sub_rays", o.sub_rays, between(1, 15), "rays across the beam's width");
  visit("noise", o.noise, "how the readings differ from the truth");
}

}  // namespace mapbed
