// An axis goes to a target, and on the way to another one. The loop plans; a timer of your board calls `tick` every millisecond. Here
// the loop calls it.
#include <atraj.h>

const a_float PERIOD = 0.001f; // s
const unsigned LEAD = 4;       // ticks: as long as a plan takes, and one more

atraj_axis axis;
atraj_limits limits;
atraj_state now = {0, 0, 0}; // m, m/s, m/s^2
unsigned long ticks = 0;

void tick() {
  atraj_axis_tick(&axis, &now);
  ++ticks;
}

void go(a_float position) {
  const atraj_state target = {position, 0, 0};
  if (atraj_axis_go(&axis, &limits, &target, LEAD) < 0) {
    Serial.println("no plan");
  }
}

void setup() {
  Serial.begin(115200);
  atraj_limits_init(&limits, 30, 10, 5); // m/s^3, m/s^2, m/s
  atraj_axis_init(&axis, PERIOD, &now);
  go(10);
}

void loop() {
  delay(1);
  tick();
  if (ticks == 700) {
    go(-2); // while it moves
  }
  if (ticks % 100 == 0) {
    Serial.println(now.p);
  }
}
