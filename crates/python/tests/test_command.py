"""The command of the package."""

import shlex
import shutil
import signal
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

from conftest import CORNER, PEG, command


def test_the_command_is_installed() -> None:
    program = Path(sys.executable).with_name("assembly-plan")
    run = subprocess.run([program, "--version"], capture_output=True, text=True, check=True)
    assert run.stdout == f"assembly-plan {version('assembly-plan')}\n"
    assert run.stdout == command("--version").stdout


def test_exit_codes_are_those_of_the_program(tmp_path: Path) -> None:
    assert command("check", CORNER).returncode == 0
    limited = tmp_path / "limited.toml"
    limited.write_text("[ipopt]\nmax_iter = 2\n")
    assert command("solve", CORNER, "--homotopy", limited, "--out", tmp_path / "plan").returncode == 1
    assert command("check", tmp_path / "missing.toml").returncode == 2
    usage = command("solve")
    assert usage.returncode == 2 and "Usage: assembly-plan solve" in usage.stderr


def test_a_batch_starts_its_cells(tmp_path: Path) -> None:
    shutil.copy(CORNER, tmp_path)
    run = command("batch", tmp_path / "corner.toml", "--starts", "1,2", "--out", tmp_path / "runs", "--jobs", "2")
    assert run.returncode == 0, run.stderr
    assert len(list((tmp_path / "runs").rglob("result.json"))) == 2
    assert command("batch", "submit", "--slurm", tmp_path / "runs").returncode == 0
    script = (tmp_path / "runs" / "submit.sh").read_text()
    assert f"exec {shlex.join([sys.executable, '-P', '-m', 'assembly_plan'])} batch run" in script


def test_ctrl_c_ends_the_command(tmp_path: Path) -> None:
    words = [sys.executable, "-m", "assembly_plan", "solve", str(PEG), "--verbose", "--out", str(tmp_path / "plan")]
    with subprocess.Popen(words, stderr=subprocess.PIPE, text=True) as process:
        assert process.stderr is not None
        # The head of the solver's table: the first homotopy step has begun.
        assert any("inf_pr" in line for line in process.stderr)
        process.send_signal(signal.SIGINT)
        assert process.wait(600) == 130
        assert "interrupted in homotopy step 1, of which nothing is kept" in process.stderr.read()
    assert not (tmp_path / "plan").exists()
