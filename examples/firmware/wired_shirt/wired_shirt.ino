// A shirt on a cable: reads stretch sensors and sends their values to bodydrive over USB.
//
// What to buy, how to connect it, what to press: docs/hardware.md
// Every byte that this program sends:            docs/protocols.md, section 14

// ---------------------------------------------------------------- What you may want to change

// The inputs of the sensors, in the order of the layout file (wired_shirt.layout.json).
const uint8_t SENSOR_PINS[] = {A0, A1, A2, A3, A4, A5};

// false: frames with a checksum. bodydrive leaves out what arrives damaged: use this for driving.
// true:  lines of numbers. You can read them in the serial monitor: use this to test the sensors.
const bool PLAIN_LINES = false;

// The Shirt page of bodydrive must have the same two numbers.
const uint32_t BAUD_RATE = 115200;
const uint32_t FRAMES_PER_SECOND = 100;

// ---------------------------------------------------------------- The program

const uint8_t SENSOR_COUNT = sizeof(SENSOR_PINS) / sizeof(SENSOR_PINS[0]);
static_assert(SENSOR_COUNT <= 64, "bodydrive reads at most 64 sensors");

// A value is the sum of 8 readings of its input. The sum shows smaller movements than one reading, and a little noise,
// by which bodydrive tells a sensor at rest from a broken one. 8 readings of 10 or 12 bits fit into an int16_t.
const uint8_t READINGS = 8;

const uint32_t FRAME_PERIOD = 1000000 / FRAMES_PER_SECOND;  // microseconds

uint16_t frameNumber = 0;    // after 65,535 comes 0
uint32_t lastFrameTime = 0;  // microseconds

int16_t readSensor(uint8_t pin) {
  int sum = 0;
  for (uint8_t i = 0; i < READINGS; i++) {
    sum += analogRead(pin);
  }
  return (int16_t)sum;
}

// Writes a number of 16 bits, the lower byte first.
void put16(uint8_t *place, uint16_t number) {
  place[0] = (uint8_t)(number & 0xFF);
  place[1] = (uint8_t)(number >> 8);
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

// Sends bytes so that none of them is 0, and a 0 behind them: the receiver sees where a frame ends (COBS encoding).
// Each 0 is replaced by the number of bytes up to the next one. Right for up to 254 bytes.
void sendEncoded(const uint8_t *bytes, uint8_t length) {
  uint8_t start = 0;
  while (true) {
    uint8_t end = start;
    while (end < length && bytes[end] != 0) {
      end++;
    }
    Serial.write((uint8_t)(end - start + 1));
    Serial.write(bytes + start, (size_t)(end - start));
    if (end == length) {
      break;
    }
    start = (uint8_t)(end + 1);
  }
  Serial.write((uint8_t)0);
}

void sendFrame(uint32_t time, const int16_t *values) {
  const uint8_t length = 6 + 2 * SENSOR_COUNT;
  uint8_t body[length + 2];
  put16(body, frameNumber);
  put16(body + 2, (uint16_t)(time & 0xFFFF));
  put16(body + 4, (uint16_t)(time >> 16));
  for (uint8_t i = 0; i < SENSOR_COUNT; i++) {
    put16(body + 6 + 2 * i, (uint16_t)values[i]);
  }
  put16(body + length, checksum(body, length));
  sendEncoded(body, length + 2);
  frameNumber++;
}

void sendHeader() {
  for (uint8_t i = 0; i < SENSOR_COUNT; i++) {
    Serial.print(i == 0 ? "sensor_" : ",sensor_");
    Serial.print(i + 1);
  }
  Serial.println();
}

void sendLine(const int16_t *values) {
  for (uint8_t i = 0; i < SENSOR_COUNT; i++) {
    if (i > 0) {
      Serial.print(',');
    }
    Serial.print(values[i]);
  }
  Serial.println();
}

void setup() {
  Serial.begin(BAUD_RATE);
  if (PLAIN_LINES) {
    sendHeader();
  } else {
    Serial.write((uint8_t)0);  // ends whatever stood on the line before
  }
  lastFrameTime = micros();
}

void loop() {
  uint32_t now = micros();
  if (now - lastFrameTime < FRAME_PERIOD) {  // also right when micros() begins at 0 again, every 71 minutes
    return;
  }
  lastFrameTime += FRAME_PERIOD;
  if (now - lastFrameTime >= FRAME_PERIOD) {  // the board is too slow for FRAMES_PER_SECOND: make up for nothing
    lastFrameTime = now;
  }
  int16_t values[SENSOR_COUNT];
  for (uint8_t i = 0; i < SENSOR_COUNT; i++) {
    values[i] = readSensor(SENSOR_PINS[i]);
  }
  if (PLAIN_LINES) {
    sendLine(values);
  } else {
    sendFrame(now, values);
  }
}
