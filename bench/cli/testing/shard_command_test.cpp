#include "bench/cli/testing/shard_command_test.h"

#include <fmt/format.h>

namespace mapbed {

ShardCommand::ShardCommand(int seeds) {
  write("held.yaml",
        fmt::format("about: odometry\nprogram: sh\nshell: |\n"
                    "  hold={0}/hold_$SLURM_ARRAY_TASK_ID\n"
                    "  if [ {{seed}} -ge 6 ] && [ -e $hold ]; then\n"
                    "    echo held >> {0}/held_$SLURM_ARRAY_TASK_ID\n"
                    "    while [ -e $hold ]; do sleep 0.05; done\n"
                    "  fi\n"
                    "  awk '/^ROBOTLASER/ {{print $(NF-2), $(NF-10), $(NF-9), $(NF-8)}}' {{log}} "
                    ">trajectory.tum\n",
                    path()));
  write("sweep.yaml",
        fmt::format("about: short drives\nworld: corridor\nrobot: pioneer\npeople: 0\n"
                    "recorder.longest: 2 s\nseries_step: 1 s\nseed: 1\nseeds: {}\n"
                    "sweep: {{robot.odometry.rotation_sigma: [0 deg, 3 deg]}}\n"
                    "compare: {{raw: {{estimator: odometry}}, held: {{estimator: ./held.yaml}}}}\n"
                    "metrics: [translation_error, failures, position_error]\n"
                    "plots: [{{y: translation_error}}, {{kind: series, y: position_error}}]\n"
                    "claims: [{{metric: failures, of: raw, at_most: held}}]\n",
                    seeds));
}

}  // namespace mapbed
