// The memory that outlives a start: one number.
#pragma once

#include <stdint.h>

struct Memory {
  void get(int place, uint32_t &number);
  void put(int place, uint32_t number);
};
extern Memory EEPROM;
