/* What a sketch needs of the core of a board, for tests/release.sh. */
struct { void begin(long) {} template <typename T> void println(T) {} } Serial;
inline void delay(int) {}
void setup();
void loop();
int main() { setup(); for (;;) { loop(); } }
