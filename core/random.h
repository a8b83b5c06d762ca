#pragma once

#include <cstdint>
#include <string_view>

namespace mapbed {

// Counter-based random numbers (Philox4x32-10): the n-th number of a stream is a pure function of
// the stream's key and n, so results depend neither on threads nor on what other streams were used
// for.
//
//   Rng rng(seed);
//   Rng laser = rng.stream("laser");            // adding another consumer changes nothing here
//   Rng leg   = rng.stream("person", 7, tick);  // by entity and tick
class Rng {
 public:
  explicit Rng(std::uint64_t seed);

  // A stream of its own, by name and up to two numbers; independent of how much of this one was
  // used.
  Rng stream(std::string_view name, std::uint64_t a = 0, std::uint64_t b = 0) const;

  std::uint64_t bits();                      // 64 random bits
  double uniform();                          // in [0, 1)
  double uniform(double low, double high);   // in [low, high)
  double normal();                           // mean 0, standard deviation 1 (Box-Muller, our own)
  double normal(double mean, double sigma);  // sigma >= 0
  std::uint64_t index(std::uint64_t count);  // in [0, count), unbiased; count > 0

 private:
  std::uint64_t key_;
  std::uint64_t counter_ = 0;
  std::uint64_t spare_ = 0;  // the second half of the last block
  bool has_spare_ = false;
  double spare_normal_ = 0.0;
  bool has_spare_normal_ = false;
};

}  // namespace mapbed
