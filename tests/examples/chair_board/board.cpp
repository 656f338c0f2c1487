// A board whose loop takes 1 ms. Arguments: the count of starts in its memory, the number of loops, and from when to when
// (ms) the converter of the address in the last argument does not answer.
// Standard input: what the receiver sends, each with its time: u32 ms, u8 length, bytes; the lower byte first.
// Standard output: what the board sends. Standard error, a line each with its time in ms: "relay LEVEL", "mode MODE",
// "dac ADDRESS STEPS", "refused ADDRESS", "watchdog LIMIT", "memory NUMBER", "baud RATE"; at the end "resets COUNT".
#include <Arduino.h>
#include <EEPROM.h>
#include <Wire.h>
#include <avr/wdt.h>

#include <cstdio>
#include <cstdlib>
#include <deque>
#include <vector>

Line Serial;
TwoWires Wire;
Memory EEPROM;

static uint32_t now, memory, failsFrom, failsUntil, resets;
static uint8_t failing, address;
static std::vector<uint8_t> message;
static std::deque<uint8_t> coming;

static void note(const char *what, unsigned long number) {
  fprintf(stderr, "%lu %s %lu\n", (unsigned long)now, what, number);
}

uint32_t millis() { return now; }
void pinMode(uint8_t, uint8_t mode) { note("mode", mode); }
void digitalWrite(uint8_t, uint8_t level) { note("relay", level); }

void Line::begin(unsigned long baud) { note("baud", baud); }
int Line::available() { return (int)coming.size(); }
int Line::read() {
  int byte = coming.front();
  coming.pop_front();
  return byte;
}
size_t Line::write(const uint8_t *bytes, size_t length) { return fwrite(bytes, 1, length, stdout); }

void TwoWires::begin() {}
void TwoWires::setWireTimeout(uint32_t, bool) {}
void TwoWires::beginTransmission(uint8_t to) {
  address = to;
  message.clear();
}
void TwoWires::write(uint8_t byte) { message.push_back(byte); }
uint8_t TwoWires::endTransmission() {
  if (address == failing && now >= failsFrom && now < failsUntil) {
    note("refused", address);
    return 2;
  }
  fprintf(stderr, "%lu dac %d %d\n", (unsigned long)now, address, message[0] << 8 | message[1]);
  return 0;
}

void Memory::get(int, uint32_t &number) { number = memory; }
void Memory::put(int, uint32_t number) {
  memory = number;
  note("memory", number);
}

void wdt_enable(int limit) { note("watchdog", (unsigned long)limit); }
void wdt_disable() { note("watchdog", 0); }
void wdt_reset() { resets++; }

static bool readNumber(uint32_t &number) {
  uint8_t bytes[4];
  if (fread(bytes, 1, 4, stdin) != 4) {
    return false;
  }
  number = (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
  return true;
}

int main(int, char **arguments) {
  memory = (uint32_t)strtoul(arguments[1], nullptr, 10);
  long loops = strtol(arguments[2], nullptr, 10);
  failsFrom = (uint32_t)strtoul(arguments[3], nullptr, 10);
  failsUntil = (uint32_t)strtoul(arguments[4], nullptr, 10);
  failing = (uint8_t)strtoul(arguments[5], nullptr, 10);
  uint32_t due = 0;
  bool isLeft = readNumber(due);
  setup();
  while (loops-- > 0) {
    now++;
    while (isLeft && now >= due) {
      int length = getchar();
      for (int i = 0; i < length; i++) {
        coming.push_back((uint8_t)getchar());
      }
      isLeft = readNumber(due);
    }
    loop();
  }
  note("resets", resets);
}
