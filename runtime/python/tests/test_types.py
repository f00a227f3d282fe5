"""The stubs describe the module that there is."""

import subprocess
import sys

import pytest

# The extension inside the package, which nobody imports by that name.
NOT_PUBLIC = "nearfield.nearfield\n"


def test_the_stubs_match_the_module(tmp_path):
    pytest.importorskip("mypy")
    (tmp_path / "allowed").write_text(NOT_PUBLIC)
    command = [sys.executable, "-m", "mypy.stubtest", "nearfield", "--allowlist", str(tmp_path / "allowed")]
    checked = subprocess.run(command, capture_output=True, text=True, check=False)
    assert checked.returncode == 0, checked.stdout + checked.stderr
