#pragma once

namespace mapbed {

// What a robot touches: an entity of the world, or who was added.
struct Touch {
  int entity = -1;
  int mover = -1;
};

}  // namespace mapbed
