#pragma once

namespace mapbed {

// A grid keeps a list of all tiles in its bounding box, so that two places far from each other cost
// memory for all that lies between. Throws InputError where that list would be longer than 2^25.
void check_grid_size(int tiles_x, int tiles_y);

}  // namespace mapbed
