"""A wheel carries a program and a library: it is for one machine and any Python 3.  `make wheel` puts static ones into the
package; `pip install scripts/python` in a checkout builds and takes those of build/, which need this machine's GSL and
FFTW."""
import platform
import shutil
import subprocess
from pathlib import Path

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:
    from wheel.bdist_wheel import bdist_wheel

PACKAGE = Path(__file__).resolve().parent / "heatladder"
TREE = PACKAGE.parents[2]
PACKED = (PACKAGE / "bin" / "heatladder").is_file()


class WithProgram(Distribution):
    def has_ext_modules(self):
        return True


class FromCheckout(build_py):
    def run(self):
        super().run()
        if PACKED:
            return
        subprocess.run(["make", "-C", str(TREE), "build/heatladder", "build/libheatladder.so"], check=True)
        for name, folder in ("heatladder", "bin"), ("libheatladder.so", "lib"):
            into = Path(self.build_lib) / "heatladder" / folder
            into.mkdir(parents=True, exist_ok=True)
            shutil.copy2(TREE / "build" / name, into / name)


class AnyPython(bdist_wheel):
    def get_tag(self):
        libc = platform.libc_ver()[1].replace(".", "_") or "2_17"
        return ("py3", "none", f"manylinux_{libc}_{platform.machine()}" if PACKED else super().get_tag()[2])


setup(distclass=WithProgram, cmdclass={"bdist_wheel": AnyPython, "build_py": FromCheckout})
