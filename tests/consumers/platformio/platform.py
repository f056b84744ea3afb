from platformio.platform.base import PlatformBase


class DeskPlatform(PlatformBase):
    pass
