// The two wires of the converters.
#pragma once

#include <stdint.h>

struct TwoWires {
  void begin();
  void setWireTimeout(uint32_t microseconds, bool resets);
  void beginTransmission(uint8_t address);
  void write(uint8_t byte);
  uint8_t endTransmission();
};
extern TwoWires Wire;
