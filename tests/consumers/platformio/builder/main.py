"""A program for a board of the tests, by the compiler and the flags of the board."""

from SCons.Script import Default, DefaultEnvironment

env = DefaultEnvironment()
board = env.BoardConfig()
compiler = board.get("desk.compiler")
flags = board.get("desk.flags").split()
tools = {"AR": "ar", "CC": "gcc", "CXX": "g++", "LINK": "gcc", "RANLIB": "ranlib", "SIZETOOL": "size"}
env.Replace(PROGSUFFIX=".elf", CXXFLAGS=["-fno-exceptions", "-fno-rtti"], **{name: compiler + tool for name, tool in tools.items()})
env.Append(CCFLAGS=[*flags, "-Os"], LINKFLAGS=flags)
Default(env.BuildProgram())
