#pragma once

namespace mapbed {

// What the program has needed so far. For tables of cost alone: results must not depend on it.

double processor_time();  // [s] of the calling thread
double peak_memory();     // [bytes] of the program

}  // namespace mapbed
