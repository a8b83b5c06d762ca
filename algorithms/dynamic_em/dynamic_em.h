#pragma once

#include <functional>
#include <memory>

#include "algorithms/dynamic_em/cause_map.h"
#include "algorithms/estimator.h"
#include "core/config/option.h"

namespace mapbed {

struct DynamicEmOptions {
  double p_static = 0.9;
  int iterations = 8;
  int map_steps = 4;
  bool register_again = true;
  double improvement = 1e-4;
  double resolution = 0.05;  // [m]
  BeamLimits beams{};
};

template <class Visitor>
void visit_fields(DynamicEmOptions& o, Visitor&& visit) {
  visit("p_static", o.p_static, between(0.501, 0.9999),
        "p(c), that something static reflects a beam; what reflects less often than (1 - p) / p of "
        "the beams that reach it fades");
  visit("iterations", o.iterations, between(1, 1000), "at most");
  visit("map_steps", o.map_steps, between(1, 1000),
        "E- and M-steps of an iteration, before the scans are registered again");
  visit("register_again", o.register_again,
        "false: the path of the first iteration stays as it is");
  visit("improvement", o.improvement, between(0.0, 1.0),
        "of the marginal likelihood's logarithm, by fraction, below which the iterations end");
  visit("resolution", o.resolution, Unit::meter, between(0.005, 10.0), "side of a cell");
  visit("beams", o.beams, "which beams are used, and how far");
}

// Maps of places where things move, chapter 4, whatever they are: beams are weighed by how likely
// something static reflected them (E-step), the scans registered again with these weights and the
// map made of both (M-step), Figure 4.2, until the marginal likelihood grows no more. The path and
// labels of the iteration of the largest one are kept. Estimate::iterations begin with the map
// whose expectations are all p_static.
//
// Takes all measurements in before it works, in finish(); until then it is the method that
// registers. Memory is linear in beams.
class DynamicEm : public Estimator {
 public:
  using MakeMethod = std::function<std::unique_ptr<Estimator>()>;  // the same each time

  DynamicEm(const DynamicEmOptions& options, MakeMethod make_method);

  void add(const Measurement& measurement, std::span<const float> beam_weights = {}) override;
  void finish() override;
  Pose2 pose() const override { return method_->pose(); }
  Estimate estimate() const override;
  Trajectory path_so_far() const override { return method_->path_so_far(); }
  Hypotheses hypotheses() const override { return method_->hypotheses(); }

 private:
  Estimate registered(const BeamLabels& labels) const;

  DynamicEmOptions options_;
  MakeMethod make_method_;
  std::unique_ptr<Estimator> method_;
  SensorLog log_;
  std::vector<std::vector<float>> told_;  // beam weights of each measurement of the log
  std::optional<Estimate> found_;         // after finish()
};

}  // namespace mapbed
