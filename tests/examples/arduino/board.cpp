// A board: runs setup() once and loop() again and again. What it sends goes to the standard output. The standard error
// says what it was asked: a line "baud RATE" once, and a line "PIN READING" for each reading.
// Arguments: the time at the start, how long a loop takes (both in microseconds), and the number of loops.
#include <cstdio>
#include <cstdlib>

static uint32_t now;
static uint32_t noise = 1;
Line Serial;

uint32_t micros() { return now; }

int analogRead(uint8_t pin) {
  noise = noise * 1664525u + 1013904223u;
  int reading = (int)(noise >> 20);  // 12 bits
  fprintf(stderr, "%d %d\n", pin, reading);
  return reading;
}

void Line::begin(unsigned long baud) { fprintf(stderr, "baud %lu\n", baud); }
size_t Line::write(uint8_t byte) { return fwrite(&byte, 1, 1, stdout); }
size_t Line::write(const uint8_t *bytes, size_t length) { return fwrite(bytes, 1, length, stdout); }
size_t Line::print(const char *text) { return (size_t)printf("%s", text); }
size_t Line::print(char letter) { return (size_t)printf("%c", letter); }
size_t Line::print(int number) { return (size_t)printf("%d", number); }
size_t Line::println() { return print("\r\n"); }

int main(int, char **arguments) {
  now = (uint32_t)strtoul(arguments[1], nullptr, 10);
  uint32_t step = (uint32_t)strtoul(arguments[2], nullptr, 10);
  setup();
  for (long loops = strtol(arguments[3], nullptr, 10); loops > 0; loops--) {
    now += step;
    loop();
  }
}
