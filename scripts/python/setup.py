"""The wheel carries a static program: it is for one machine, for any C library and for any Python 3."""
import platform

from setuptools import Distribution, setup
from wheel.bdist_wheel import bdist_wheel


class WithProgram(Distribution):
    def has_ext_modules(self):
        return True


class AnyPython(bdist_wheel):
    def get_tag(self):
        machine = platform.machine()
        return ("py3", "none", f"manylinux2014_{machine}.musllinux_1_1_{machine}")


setup(distclass=WithProgram, cmdclass={"bdist_wheel": AnyPython})
