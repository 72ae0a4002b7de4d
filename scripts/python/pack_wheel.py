"""Packs the wheel (PEP 427, 517) with Python's standard library alone: `pip install scripts/python` needs no network.
The wheel carries a program and a library, for one machine and any Python 3: the static ones that `make wheel` puts into
the package, else those of build/, which need this machine's GSL and FFTW."""
import base64
import hashlib
import os
import platform
import re
import subprocess
import sys
import sysconfig
import time
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
PACKED = (HERE / "heatladder/bin/heatladder").is_file()
VERSION = re.search('^__version__ = "(.*)"', (HERE / "heatladder/__init__.py").read_text(), re.M)[1]
METADATA = f"""Metadata-Version: 2.1
Name: heatladder
Version: {VERSION}
Summary: Verification of transient heat conduction codes: ladders against exact solutions, from Python and pytest
License: GPL-3.0-or-later
Requires-Python: >=3.9
Provides-Extra: arrays
Requires-Dist: numpy; extra == "arrays"
Description-Content-Type: text/markdown

"""


def _tag():
    libc = platform.libc_ver()[1].replace(".", "_") or "2_17"
    here = re.sub("[-.]", "_", sysconfig.get_platform())
    return "py3-none-" + (f"manylinux_{libc}_{platform.machine()}" if PACKED else here)


def _digest(data):
    return base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()


def _files():
    """Names in the wheel and their bytes."""
    files = {f"heatladder/{f.name}": f.read_bytes() for f in sorted((HERE / "heatladder").glob("*")) if f.is_file()}
    build = HERE / "heatladder" if PACKED else HERE.parents[1] / "build"
    if not PACKED:
        subprocess.run(["make", "-C", str(build.parent), "build/heatladder", "build/libheatladder.so"], check=True)
    files["heatladder/bin/heatladder"] = (build / ("bin/heatladder" if PACKED else "heatladder")).read_bytes()
    files["heatladder/lib/libheatladder.so"] = (build / ("lib" if PACKED else "") / "libheatladder.so").read_bytes()
    info = f"heatladder-{VERSION}.dist-info"
    files[f"{info}/METADATA"] = (METADATA + (HERE / "README.md").read_text(encoding="utf-8")).encode()
    wheel = f"Wheel-Version: 1.0\nGenerator: heatladder\nRoot-Is-Purelib: false\nTag: {_tag()}\n"
    files[f"{info}/WHEEL"] = wheel.encode()
    files[f"{info}/entry_points.txt"] = b"[pytest11]\nheatladder = heatladder.pytest_plugin\n"
    record = f"{info}/RECORD"
    lines = [f"{name},sha256={_digest(data)},{len(data)}\n" for name, data in files.items()]
    return {**files, record: "".join([*lines, f"{record},,\n"]).encode()}


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    name = f"heatladder-{VERSION}-{_tag()}.whl"
    date = time.gmtime(int(os.environ.get("SOURCE_DATE_EPOCH", 946684800)))[:6]
    with zipfile.ZipFile(Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, data in _files().items():
            entry = zipfile.ZipInfo(path, date)
            entry.external_attr = (0o100755 if "/bin/" in path else 0o100644) << 16
            wheel.writestr(entry, data, zipfile.ZIP_DEFLATED)
    return name


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    sys.exit("heatladder: `pip install -e` has no program to carry; to use the checkout itself, set "
             f"PYTHONPATH={HERE} HEATLADDER={HERE.parents[1]}/build/heatladder "
             f"HEATLADDER_LIBRARY={HERE.parents[1]}/build/libheatladder.so")


if __name__ == "__main__":
    os.makedirs(sys.argv[1], exist_ok=True)
    build_wheel(sys.argv[1])
