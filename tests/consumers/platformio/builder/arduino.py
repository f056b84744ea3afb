"""Nothing is added for Arduino: the test gives its core. PlatformIO reads sketches for Arduino alone."""
