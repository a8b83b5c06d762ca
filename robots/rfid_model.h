#pragma once

#include <string>

#include "core/config/option.h"

namespace mapbed {

// By what the power at a tag differs from one read to the next.
enum class Fading : int {
  off,
  threshold,  // normal in dB: a tag answers with probability Phi((power - threshold) / read_sigma)
  rice,       // a constant part and a scattered one, rice_factor apart
};

// Chance in an inventory round. Zero switches a mechanism off.
struct RfidNoise {
  double shadowing = 2.8;        // [dB] sigma of what clutter takes or adds, frozen in space ...
  double shadowing_cell = 0.25;  // [m] ... for each tag, in squares of this side
  Fading fading = Fading::threshold;
  double read_sigma = 1.0;       // [dB] with shadowing 3 dB: sqrt(2.8^2 + 1)
  double rice_factor = 6.0;      // [dB] of the constant part over the scattered one
  bool collisions = true;        // tags that answer in the same slot are lost but for ...
  double capture = 6.0;          // [dB] ... one that is so much stronger than all others together
  double ghosts = 0.0005;        // reads a round of a tag that may be anywhere
  double wrong_antenna = 0.002;  // probability that a read is told of another antenna
  double rssi_sigma = 1.0;       // [dB]
  double rssi_step = 0.5;        // [dB]
  double phase_sigma = 0.1;      // [rad]
};

// One antenna of an RFID reader and how the reader works it: ultra-high frequency, passive tags.
// The antenna looks along its x axis; its waves are circularly polarized, tags are dipoles.
struct RfidModel {
  std::string about;
  std::string source;  // where the values are from, and which document was not opened; no option

  int device = 0;            // which specimen of its kind: decides how it differs from the sheet
  double gain_spread = 0.7;  // [dB] sigma of specimens' gain ...
  double pointing_spread = 0.05;  // [rad] ... and of the direction in which they look, up and aside

  double frequency = 915e6;                // [Hz]
  double eirp = 36.0;                      // [dBm] radiated ahead
  double antenna_gain = 6.0;               // [dBi] in it, for the way back
  double beam_width = 1.2217304763960306;  // [rad] between the directions of half the power
  double front_to_back = 15.0;             // [dB] that the antenna is weaker at most
  double tag_gain = 2.0;                   // [dBi] of a tag's antenna, broadside
  double polarization_loss = 3.0;          // [dB] a dipole takes half of a circular wave
  double threshold = -12.2;                // [dBm] at a tag that answers every second time
  double modulation_loss = 6.0;            // [dB] from what a tag receives to what it sends back

  double round_rate = 4.5;  // [Hz] inventory rounds of this antenna; a robot's antennas take turns
  int slots = 64;           // of a round, in which tags answer

  // What becomes of a wave on its way.
  double reach = 20.0;          // [m] tags that are farther off do not answer
  int reflections = 1;          // on a way, at most
  double smallest_face = 0.33;  // [m] smaller faces, less than a wavelength, do not mirror
  bool floor = true;            // it mirrors, too
  bool occlusion = true;        // what stands between takes its crossing loss
  bool backing = true;          // what a tag sticks on takes its tag loss
  bool orientation = true;      // a dipole hears less along its axis; no: in all directions alike
  bool polarization = true;     // else every tag takes all of a wave, however it is turned

  RfidNoise noise;

  double wavelength() const;  // [m]
};

template <class Visitor>
void visit_fields(RfidNoise& o, Visitor&& visit) {
  visit("shadowing", o.shadowing, between(0.0, 30.0),
        "sigma of what clutter takes or adds, frozen in space for each tag [dB]");
  visit("shadowing_cell", o.shadowing_cell, Unit::meter, between(0.001, 100.0),
        "side of the squares within which that is the same");
  visit("fading", o.fading, {"off", "threshold", "rice"},
        "how the power differs from read to read: normal in dB by read_sigma, or as Rice has it");
  visit("read_sigma", o.read_sigma, between(0.0, 30.0), "of fading threshold [dB]");
  visit("rice_factor", o.rice_factor, between(-30.0, 60.0),
        "of fading rice: the constant part over the scattered one [dB]");
  visit("collisions", o.collisions, "tags that answer in the same slot are lost");
  visit("capture", o.capture, between(0.0, 60.0),
        "but for one that is so much stronger than the others together [dB]");
  visit("ghosts", o.ghosts, between(0.0, 1.0),
        "mean number of reads a round of a tag that may be anywhere");
  visit("wrong_antenna", o.wrong_antenna, kFraction,
        "probability that a read is told of another antenna of the robot");
  visit("rssi_sigma", o.rssi_sigma, between(0.0, 30.0), "error of the answer's power [dB]");
  visit("rssi_step", o.rssi_step, between(0.0, 30.0), "powers are multiples of this [dB]");
  visit("phase_sigma", o.phase_sigma, Unit::radian, between(0.0, 10.0),
        "error of the answer's phase");
}

template <class Visitor>
void visit_fields(RfidModel& o, Visitor&& visit) {
  visit("about", o.about, "what it is");
  visit("device", o.device, between(0, 1'000'000),
        "which specimen of its kind: the same number, the same deviations");
  visit("gain_spread", o.gain_spread, between(0.0, 20.0), "sigma of specimens' gain [dB]");
  visit("pointing_spread", o.pointing_spread, Unit::radian, between(0.0, 1.0),
        "sigma of the direction in which specimens look, up and aside");
  visit("frequency", o.frequency, Unit::hertz, between(1e8, 1e10), "of the carrier");
  visit("eirp", o.eirp, between(-50.0, 80.0), "radiated ahead, as if to all sides [dBm]");
  visit("antenna_gain", o.antenna_gain, between(-20.0, 40.0),
        "that is in it, and counts again on the way back [dBi]");
  visit("beam_width", o.beam_width, Unit::radian, between(0.01, 6.3),
        "between the directions of half the power");
  visit("front_to_back", o.front_to_back, between(0.0, 60.0),
        "that the antenna is weaker behind [dB]");
  visit("tag_gain", o.tag_gain, between(-40.0, 20.0), "of a tag's antenna, broadside [dBi]");
  visit("polarization_loss", o.polarization_loss, between(0.0, 40.0),
        "of a dipole in a circular wave [dB]");
  visit("threshold", o.threshold, between(-100.0, 50.0),
        "power at which a tag answers every second time [dBm]");
  visit("modulation_loss", o.modulation_loss, between(0.0, 60.0),
        "from what a tag receives to what it sends back [dB]");
  visit("round_rate", o.round_rate, Unit::hertz, between(0.001, 1000.0),
        "inventory rounds of this antenna; a robot's antennas take turns");
  visit("slots", o.slots, between(1, 65'536), "of a round, in which tags answer");
  visit("reach", o.reach, Unit::meter, between(0.1, 200.0), "tags beyond do not answer");
  visit("reflections", o.reflections, between(0, 2), "on a wave's way, at most");
  visit("smallest_face", o.smallest_face, Unit::meter, between(0.05, 10.0),
        "narrower faces of things do not mirror waves");
  visit("floor", o.floor, "the floor mirrors waves");
  visit("occlusion", o.occlusion, "what stands in the way takes its crossing_loss");
  visit("backing", o.backing, "what a tag sticks on takes its tag_loss");
  visit("orientation", o.orientation,
        "a tag hears less along its axis; no: in all directions alike");
  visit("polarization", o.polarization,
        "a tag takes what of a wave runs along its axis, and mirrors turn waves");
  visit("noise", o.noise, "chance in a round");
}

}  // namespace mapbed
