"""Dead reckoning: reads a CARMEN log, writes where the wheels say the robot was (TUM)."""
import math
import sys


def poses(lines):
    for line in lines:
        word = line.split()
        if not word or not word[0].startswith("ROBOTLASER"):
            continue
        ranges = int(word[8])  # behind them: remissions, then the laser's pose, then the robot's
        behind = 10 + ranges + int(word[9 + ranges])
        x, y, theta = map(float, word[behind + 3:behind + 6])
        yield word[-3], x, y, theta


with open(sys.argv[1]) as log, open(sys.argv[2], "w") as trajectory:
    for time, x, y, theta in poses(log):
        trajectory.write(f"{time} {x} {y} 0 0 0 {math.sin(theta / 2)} {math.cos(theta / 2)}\n")
