#pragma once

#include <string>

#include "core/sensor/measurement.h"

namespace mapbed {

class Estimator;
struct Estimate;
struct RunInput;

// Looks at the method of a run while it works, as a film does. One that ends the run early throws
// Interrupted.
class RunViewer {
 public:
  virtual ~RunViewer() = default;
  // The method, by its name, gets the log of `prepared`.
  virtual void begins(const RunInput& prepared, const std::string& method) = 0;
  // A program of somebody else's shows nothing between beginning and end.
  virtual void after(const Measurement& measurement, const Estimator& estimator) = 0;
  virtual void ends(const Estimate& estimate) = 0;
  // It has seen all that it wants.
  virtual bool is_complete() const = 0;
};

}  // namespace mapbed
