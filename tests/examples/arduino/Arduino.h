// What the examples use of Arduino's library, for a program that runs on this machine.
#pragma once

#include <stddef.h>
#include <stdint.h>

const uint8_t A0 = 14, A1 = 15, A2 = 16, A3 = 17, A4 = 18, A5 = 19;  // as on an Uno

int analogRead(uint8_t pin);
uint32_t micros();

struct Line {
  void begin(unsigned long baud);
  size_t write(uint8_t byte);
  size_t write(const uint8_t *bytes, size_t length);
  size_t print(const char *text);
  size_t print(char letter);
  size_t print(int number);
  size_t println();
};
extern Line Serial;

void setup();
void loop();
