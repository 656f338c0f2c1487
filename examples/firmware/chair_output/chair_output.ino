// Two voltages in place of a joystick's, for the interface that a wheelchair's maker sells for other input devices.
// bodydrive's receiver commands them over USB. For boards of the Arduino class with 5 V and an AVR, such as an Uno.
//
// What to buy, how to connect it, whom to ask before: docs/chairs.md
// Every byte:                                         docs/protocols.md, section 9

#include <EEPROM.h>
#include <Wire.h>
#include <avr/wdt.h>
#include <string.h>

// ---------------------------------------------------------------- What you must set

// The 64 hex digits in the chair's key file, behind the number. Without them the board drives nothing.
const char *const KEY = "";

// The voltages in the manual of the chair's interface, in steps of 5 V / 4096: 2048 are 2.5 V, 819 are 1.0 V.
const int16_t CENTRE = 2048;
const int16_t SWING = 819;  // from the centre to full deflection
const bool FORWARD_IS_HIGHER = true;
const bool RIGHT_IS_HIGHER = true;

// The I2C addresses of the two converters (MCP4725), and the pin of the relay.
const uint8_t FORWARD_DAC = 0x60;
const uint8_t RIGHT_DAC = 0x61;
const uint8_t RELAY_PIN = 7;

// ---------------------------------------------------------------- The program

static_assert(SWING >= 0 && CENTRE - SWING >= 0 && CENTRE + SWING <= 4095, "the voltages must lie between 0 and 5 V");

const uint32_t BAUD_RATE = 115200;
const uint32_t STATUS_PERIOD = 20;  // ms
const uint32_t SILENCE = 45;        // ms without a command, after which the chair stands; with the loop at most 50 ms
const uint32_t FRESH = 100;         // ms: a command answers a status that is no older
const int16_t FULL = 1000;          // per mille
const uint8_t VERSION = 1;
const uint8_t DRIVE = 1;  // flag of a command

const uint8_t COMMAND_LENGTH = 38, COMMAND_BODY = 22;  // bytes; behind the body stands the tag
const uint8_t STATUS_LENGTH = 20;
const uint8_t BLOCK = 64, HASH = 32;  // bytes of SHA-256

// In states other than DRIVING the relay is open: then two resistors hold the chair's inputs at their centre.
enum State : uint8_t { WAITING = 0, STANDING = 1, DRIVING = 2, NO_KEY = 3, BROKEN = 4 };

State state = WAITING;              // WAITING: for a command to stand, at the start and after each silence
uint8_t received[COMMAND_LENGTH];   // the last bytes that came, the newest last
uint32_t lastNumber = 0;            // of the last command that was obeyed, 0 after a silence
uint32_t lastCommandTime = 0;       // ms
uint32_t lastStatusTime = 0;        // ms
uint32_t bootNumber = 0;            // counts the starts of this board
uint32_t innerHash[8], outerHash[8];  // HMAC: the hash of the key's two blocks

// ---------------------------------------------------------------- Numbers, the lower byte first

uint16_t get16(const uint8_t *place) { return (uint16_t)(place[0] | (uint16_t)(place[1] << 8)); }

uint32_t get32(const uint8_t *place) { return get16(place) | (uint32_t)get16(place + 2) << 16; }

void put16(uint8_t *place, uint16_t number) {
  place[0] = (uint8_t)(number & 0xFF);
  place[1] = (uint8_t)(number >> 8);
}

void put32(uint8_t *place, uint32_t number) {
  put16(place, (uint16_t)(number & 0xFFFF));
  put16(place + 2, (uint16_t)(number >> 16));
}

// The checksum CRC-16/CCITT-FALSE.
uint16_t checksum(const uint8_t *bytes, uint8_t length) {
  uint16_t crc = 0xFFFF;
  for (uint8_t i = 0; i < length; i++) {
    crc = (uint16_t)(crc ^ ((uint16_t)bytes[i] << 8));
    for (uint8_t bit = 0; bit < 8; bit++) {
      bool carry = (crc & 0x8000) != 0;
      crc = (uint16_t)(crc << 1);
      if (carry) {
        crc = (uint16_t)(crc ^ 0x1021);
      }
    }
  }
  return crc;
}

// ---------------------------------------------------------------- The tag: HMAC-SHA-256 (FIPS 180-4, RFC 2104)

const uint32_t HASH_START[8] = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
const uint32_t HASH_ROUNDS[64] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

uint32_t rotated(uint32_t word, uint8_t places) { return (word >> places) | (word << (32 - places)); }

// Takes a block of 64 bytes into a hash.
void takeBlock(uint32_t *hash, const uint8_t *block) {
  uint32_t words[16];
  for (uint8_t i = 0; i < 16; i++) {
    const uint8_t *place = block + 4 * i;
    words[i] = (uint32_t)place[0] << 24 | (uint32_t)place[1] << 16 | (uint32_t)place[2] << 8 | place[3];
  }
  uint32_t h[8];
  memcpy(h, hash, sizeof h);
  for (uint8_t i = 0; i < 64; i++) {
    if (i >= 16) {
      uint32_t a = words[(i + 1) % 16], b = words[(i + 14) % 16];
      words[i % 16] += words[(i + 9) % 16] + (rotated(a, 7) ^ rotated(a, 18) ^ a >> 3) +
                       (rotated(b, 17) ^ rotated(b, 19) ^ b >> 10);
    }
    uint32_t first = h[7] + (rotated(h[4], 6) ^ rotated(h[4], 11) ^ rotated(h[4], 25)) +
                     ((h[4] & h[5]) ^ (~h[4] & h[6])) + HASH_ROUNDS[i] + words[i % 16];
    uint32_t second = (rotated(h[0], 2) ^ rotated(h[0], 13) ^ rotated(h[0], 22)) +
                      ((h[0] & h[1]) ^ (h[0] & h[2]) ^ (h[1] & h[2]));
    for (uint8_t j = 7; j > 0; j--) {
      h[j] = h[j - 1];
    }
    h[4] += first;
    h[0] = first + second;
  }
  for (uint8_t i = 0; i < 8; i++) {
    hash[i] += h[i];
  }
}

// Writes the hash of one block, of which `first` is the hash, and of a content of less than 56 bytes behind it.
void finishHash(const uint32_t *first, const uint8_t *content, uint8_t length, uint8_t *result) {
  uint32_t hash[8];
  memcpy(hash, first, sizeof hash);
  uint8_t block[BLOCK];
  memset(block, 0, sizeof block);
  memcpy(block, content, length);
  block[length] = 0x80;
  uint16_t bits = (uint16_t)(8 * (BLOCK + length));
  block[BLOCK - 2] = (uint8_t)(bits >> 8);
  block[BLOCK - 1] = (uint8_t)(bits & 0xFF);
  takeBlock(hash, block);
  for (uint8_t i = 0; i < HASH; i++) {
    result[i] = (uint8_t)(hash[i / 4] >> (24 - 8 * (i % 4)) & 0xFF);
  }
}

// Begins the hash with the key, each byte of it combined with `pad`.
void beginHash(uint32_t *hash, const uint8_t *key, uint8_t pad) {
  uint8_t block[BLOCK];
  memset(block, pad, sizeof block);
  for (uint8_t i = 0; i < HASH; i++) {
    block[i] = (uint8_t)(key[i] ^ pad);
  }
  memcpy(hash, HASH_START, sizeof HASH_START);
  takeBlock(hash, block);
}

int8_t hexDigit(char letter) {
  if (letter >= '0' && letter <= '9') {
    return (int8_t)(letter - '0');
  }
  char small = (char)(letter | 0x20);
  return small >= 'a' && small <= 'f' ? (int8_t)(small - 'a' + 10) : (int8_t)-1;
}

// Takes the key over from KEY; says whether it is one.
bool readKey() {
  if (strlen(KEY) != 2 * HASH) {
    return false;
  }
  uint8_t key[HASH];
  for (uint8_t i = 0; i < HASH; i++) {
    int8_t high = hexDigit(KEY[2 * i]), low = hexDigit(KEY[2 * i + 1]);
    if (high < 0 || low < 0) {
      return false;
    }
    key[i] = (uint8_t)(16 * high + low);
  }
  beginHash(innerHash, key, 0x36);
  beginHash(outerHash, key, 0x5C);
  return true;
}

bool tagIsRight() {
  uint8_t inner[HASH], tag[HASH];
  finishHash(innerHash, received, COMMAND_BODY, inner);
  finishHash(outerHash, inner, HASH, tag);
  uint8_t difference = 0;
  for (uint8_t i = COMMAND_BODY; i < COMMAND_LENGTH; i++) {
    difference = (uint8_t)(difference | (received[i] ^ tag[i - COMMAND_BODY]));
  }
  return difference == 0;
}

// ---------------------------------------------------------------- The voltages

// Sets a converter, a number from 0 to 4095; says whether it answered.
bool setVoltage(uint8_t converter, int16_t steps) {
  Wire.beginTransmission(converter);
  Wire.write((uint8_t)(steps >> 8 & 0x0F));
  Wire.write((uint8_t)(steps & 0xFF));
  return Wire.endTransmission() == 0;
}

// Opens the relay, then sets both converters to the centre.
void stand(State next) {
  digitalWrite(RELAY_PIN, LOW);
  bool forwardAnswers = setVoltage(FORWARD_DAC, CENTRE);
  bool rightAnswers = setVoltage(RIGHT_DAC, CENTRE);
  state = forwardAnswers && rightAnswers ? next : BROKEN;
}

int16_t stepsOf(int16_t perMille, bool isHigher) {
  int32_t limited = perMille > FULL ? FULL : perMille < -FULL ? -FULL : perMille;
  int32_t swing = SWING * limited / FULL;
  return (int16_t)(isHigher ? CENTRE + swing : CENTRE - swing);
}

// Sets both converters, then closes the relay.
void drive(int16_t forward, int16_t right) {
  bool forwardAnswers = setVoltage(FORWARD_DAC, stepsOf(forward, FORWARD_IS_HIGHER));
  bool rightAnswers = setVoltage(RIGHT_DAC, stepsOf(right, RIGHT_IS_HIGHER));
  if (forwardAnswers && rightAnswers) {
    digitalWrite(RELAY_PIN, HIGH);
    state = DRIVING;
  } else {
    stand(BROKEN);
  }
}

// ---------------------------------------------------------------- Commands and statuses

// Obeys the bytes that came last when they are a command: signed, new, and an answer to a status of this start.
void obeyCommand(uint32_t now) {
  if (memcmp(received, "BMIC", 4) != 0 || received[4] != VERSION || state == NO_KEY || state == BROKEN) {
    return;
  }
  uint32_t number = get32(received + 10), answered = get32(received + 14), boot = get32(received + 18);
  if (boot != bootNumber || now - answered > FRESH || number <= lastNumber || !tagIsRight()) {
    return;
  }
  bool isDriven = (received[5] & DRIVE) != 0;
  if (isDriven && state == WAITING) {
    return;
  }
  lastNumber = number;
  lastCommandTime = now;
  if (isDriven) {
    drive((int16_t)get16(received + 6), (int16_t)get16(received + 8));
  } else {
    stand(STANDING);
  }
}

void takeByte(uint8_t value) {
  memmove(received, received + 1, COMMAND_LENGTH - 1);
  received[COMMAND_LENGTH - 1] = value;
}

void sendStatus(uint32_t now) {
  uint8_t status[STATUS_LENGTH];
  memcpy(status, "BMIB", 4);
  status[4] = VERSION;
  status[5] = state;
  put32(status + 6, lastNumber);
  put32(status + 10, now);
  put32(status + 14, bootNumber);
  put16(status + 18, checksum(status, STATUS_LENGTH - 2));
  Serial.write(status, STATUS_LENGTH);
}

uint32_t countStart() {
  uint32_t count;
  EEPROM.get(0, count);
  count++;
  EEPROM.put(0, count);
  return count;
}

void setup() {
  wdt_disable();  // it still runs after a reset by itself
  digitalWrite(RELAY_PIN, LOW);
  pinMode(RELAY_PIN, OUTPUT);
  Wire.begin();
  Wire.setWireTimeout(3000, true);  // microseconds: a wire that is torn must not hold up the program
  stand(WAITING);
  bootNumber = countStart();
  if (!readKey()) {
    state = NO_KEY;
  }
  Serial.begin(BAUD_RATE);
  lastStatusTime = millis();
  wdt_enable(WDTO_60MS);  // resets a program that hangs: all pins are inputs then, and the relay opens
}

void loop() {
  wdt_reset();
  uint32_t now = millis();
  while (Serial.available() > 0) {
    takeByte((uint8_t)Serial.read());
    obeyCommand(now);
  }
  if (lastNumber != 0 && now - lastCommandTime > SILENCE) {
    lastNumber = 0;
    stand(WAITING);
  }
  if (now - lastStatusTime >= STATUS_PERIOD) {
    lastStatusTime = now;
    if (state == BROKEN) {
      stand(WAITING);  // tries whether the converters answer again
    }
    sendStatus(now);
  }
}
