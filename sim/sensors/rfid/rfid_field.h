#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robots/robot.h"
#include "sim/scene/scene.h"
#include "sim/sensors/ideal_rfid.h"
#include "sim/sensors/rfid/link_budget.h"

namespace mapbed {

// The waves of a robot's antennas in a world, see link_budget.h for one way:
//   P = budget + 20 log10 |sum of the ways' fields|
// Each way is weakened by what it goes through where it does so. Mirrors are faces of what stands
// still; what moves only stands in the way. A way that is too weak to matter is left out.
class RfidField {
 public:
  RfidField(const World& world, const std::vector<MountedAntenna>& antennas);

  // Of all tags within reach, but for those so weak (25 dB below the threshold) that chance brings
  // none of them back. The scene is the world's, as it stands now.
  IdealRfid round(const Scene& scene, int antenna, const Pose2& world_from_robot) const;

  // What one tag receives there; none where it is out of reach. `world_from_tag` is anywhere:
  // mirrors are looked for anew.
  std::optional<IdealTag> at(const Scene& scene, int antenna, const Pose3& world_from_antenna,
                             const RfidTag& tag) const;

 private:
  struct Mirrors {
    MirrorFaceOptions options;
    int most = 0;
    double reach = 0.0;
    std::vector<MirrorFace> faces;
    std::vector<std::vector<MirrorImage>> images;  // of each tag
  };
  struct Antenna {
    MountedAntenna mounted;
    RfidDevice device;
    std::shared_ptr<const Mirrors> mirrors;  // of antennas of one kind the same
  };

  std::shared_ptr<const Mirrors> mirrors_for(const World& world, const RfidModel& model) const;
  std::optional<IdealTag> receive(const Scene& scene, const Antenna& antenna,
                                  const PlacedAntenna& placed, const RfidTag& tag,
                                  const std::vector<MirrorImage>& images,
                                  const std::vector<bool>& is_before) const;

  std::vector<RfidTag> tags_;
  std::vector<Material> materials_;
  std::vector<Antenna> antennas_;
  std::shared_ptr<const std::vector<std::string>> names_;
};

}  // namespace mapbed
