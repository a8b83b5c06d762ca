#include "bench/cli/certificate_report.h"

#include <fmt/format.h>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

std::string why_not(const Certificate& certificate) {
  if (!certificate.stationary) return "no stationary poses of it were found";
  return fmt::format("the bound leaves {:.3g} of f = {:.6g}, smallest eigenvalue {:.3g}",
                     certificate.gap, certificate.objective, certificate.min_eigenvalue);
}

}  // namespace

std::string certificate_text(const Certificate& certificate) {
  const bool is_own = certificate.problem == CertifiedProblem::own;
  const std::string problem =
      is_own ? "this graph"
             : fmt::format(
                   "the graph with isotropic noise in place of its own (which is up to "
                   "{:.0f} % from it)",
                   100.0 * certificate.anisotropy);
  if (!certificate.certified) {
    return fmt::format("not certified as the global optimum of {}: {}", problem,
                       why_not(certificate));
  }
  const std::string text =
      fmt::format("certified as the global optimum of {}: f = {:.9g}, {:.2g} above the bound",
                  problem, certificate.objective, certificate.gap);
  if (is_own) return text;
  return fmt::format(
      "{}; its poses are up to {:.2g} m and {:.2g} deg from those written; chi2 of "
      "any poses is at least {:.6g}",
      text, certificate.moved, certificate.turned * 180.0 / kPi, certificate.own_lower_bound);
}

}  // namespace mapbed
