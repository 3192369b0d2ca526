// For all sketches: errors on the serial monitor, and a light that turns.
#ifndef SKETCH_H
#define SKETCH_H

// Prints why a call failed, and stops.
static void check(eigenshade_status status) {
  while (status) {
    Serial.println(eigenshade_message(status));
    delay(1000);
  }
}

// Turns a light about the vertical, once in PERIOD milliseconds.
static void turn(const eigenshade_color_light_q15_t &from, eigenshade_light_buffer_q15_t &buffer,
                 eigenshade_color_light_q15_t &to) {
  const uint32_t PERIOD = 6000;
  const float half = 3.14159265f / PERIOD * (millis() % PERIOD);  // of the angle, in radians
  const int32_t y = 16384 * sinf(half), w = 16384 * cosf(half);
  const int32_t quaternion[4] = {0, y, 0, w};
  check(eigenshade_turn_q15(&from, quaternion, &buffer, &to));
}

#endif
