"""Builds the library for this machine with make and cargo. docs/packaging.md"""

import re
from pathlib import Path

from conan import ConanFile
from conan.errors import ConanInvalidConfiguration
from conan.tools.build import cross_building
from conan.tools.files import copy, load, rm, rmdir, save


class Atraj(ConanFile):
    name = "atraj"
    description = "Motion profiles of liba and CLARAty, and the fastest moves from any state to any state, behind a C ABI"
    license = "MIT OR Apache-2.0"
    topics = ("motion", "trajectory", "s-curve", "jerk")
    settings = "os", "arch"
    package_type = "library"
    options = {"shared": [True, False], "real": ["double", "float"], "poly": ["levels", "compact"]}
    default_options = {"shared": False, "real": "double", "poly": "levels"}

    @property
    def _sources(self):
        return str(Path(self.recipe_folder).parents[1])

    @property
    def _library(self):
        """The name that `make install` gives to this ABI."""
        real = "-float" if self.options.real == "float" else ""
        poly = "-compact" if self.options.poly == "compact" else ""
        return f"atraj{real}{poly}"

    def set_version(self):
        lines = load(self, f"{self._sources}/Cargo.toml").splitlines()
        self.version = next(line for line in lines if line.startswith("version = ")).split('"')[1]

    def export_sources(self):
        for files in ("Cargo.*", "Makefile", "build.rs", "LICENSE-*", "src/*", "include/*", "docs/img/*", "packaging/*", "tests/support/*"):
            copy(self, files, self._sources, self.export_sources_folder)
        # The workspace of the recipe is the library: the packages that test it are not exported.
        manifest = f"{self.export_sources_folder}/Cargo.toml"
        save(self, manifest, re.sub(r"(?m)^members = .*$", 'members = ["tests/support"]', load(self, manifest)))

    def validate(self):
        if self.settings.os != "Linux" or cross_building(self):
            raise ConanInvalidConfiguration("atraj's recipe builds for Linux on Linux; for firmware take CMake or Meson")

    def _make(self, goal):
        poly = "compact" if self.options.poly == "compact" else ""
        self.run(f'make {goal} REAL={self.options.real} POLY={poly} PREFIX="{self.package_folder}"', cwd=self.source_folder)

    def build(self):
        self._make("dist")

    def package(self):
        self._make("install")
        copy(self, "LICENSE-*", self.source_folder, f"{self.package_folder}/licenses")
        # Conan writes files of its own for CMake and pkg-config.
        for folder in ("lib/cmake", "lib/pkgconfig", "share"):
            rmdir(self, f"{self.package_folder}/{folder}")
        rm(self, "*.a" if self.options.shared else "*.so*", f"{self.package_folder}/lib")

    def package_info(self):
        self.cpp_info.libs = [self._library]
        self.cpp_info.includedirs = ["include" if self._library == "atraj" else f"include/{self._library}"]
        self.cpp_info.system_libs = ["m"]
        self.cpp_info.set_property("pkg_config_name", self._library)
        self.cpp_info.set_property("cmake_file_name", self._library)
        self.cpp_info.set_property("cmake_target_name", f"{self._library}::{self._library if self.options.shared else 'static'}")
