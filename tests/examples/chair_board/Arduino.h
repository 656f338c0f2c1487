// What the example uses of Arduino's library, for a program that runs on this machine.
#pragma once

#include <stddef.h>
#include <stdint.h>

const uint8_t LOW = 0, HIGH = 1, OUTPUT = 1;

uint32_t millis();
void pinMode(uint8_t pin, uint8_t mode);
void digitalWrite(uint8_t pin, uint8_t level);

struct Line {
  void begin(unsigned long baud);
  int available();
  int read();
  size_t write(const uint8_t *bytes, size_t length);
};
extern Line Serial;

void setup();
void loop();
