"""Builds and runs a program of the tests on the package."""

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout


class Move(ConanFile):
    settings = "os", "arch", "compiler", "build_type"

    def requirements(self):
        self.requires(self.tested_reference_str)

    def layout(self):
        cmake_layout(self, src_folder="../../../tests/consumers")

    def generate(self):
        CMakeDeps(self).generate()
        package = self.dependencies["atraj"].cpp_info
        toolchain = CMakeToolchain(self)
        toolchain.user_presets_path = False
        toolchain.cache_variables["SOURCE"] = "move.c"
        toolchain.cache_variables["PACKAGE"] = package.get_property("cmake_file_name")
        toolchain.cache_variables["LIBRARY"] = package.get_property("cmake_target_name")
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def test(self):
        self.run(f"{self.cpp.build.bindir}/move", env="conanrun")
