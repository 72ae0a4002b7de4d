"""The wheel carries a static program and a library: it is for one machine and any Python 3."""
import platform

from setuptools import Distribution, setup
from wheel.bdist_wheel import bdist_wheel


class WithProgram(Distribution):
    def has_ext_modules(self):
        return True


class AnyPython(bdist_wheel):
    def get_tag(self):
        machine = platform.machine()
        libc = platform.libc_ver()[1].replace(".", "_") or "2_17"
        return ("py3", "none", f"manylinux_{libc}_{machine}")


setup(distclass=WithProgram, cmdclass={"bdist_wheel": AnyPython})
