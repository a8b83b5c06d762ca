#pragma once

#include "core/testing/test_room.h"

namespace mapbed {

// 12 m x 9 m, different in all directions.
inline TestRoom furnished_room() {
  TestRoom room = rectangular_room(12.0, 9.0);
  room.add_box({-4.0, 3.2}, 1.5, 0.8);
  room.add_box({4.8, -2.0}, 0.8, 2.0);
  room.add_box({1.5, 3.8}, 0.6, 0.6);
  room.add_box({-5.2, -2.5}, 0.7, 1.2);
  room.add_box({0.5, -4.0}, 2.2, 0.5, 0.3);
  return room;
}

}  // namespace mapbed
