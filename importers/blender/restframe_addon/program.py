"""Runs restframe without Blender waiting for it."""

import pathlib
import subprocess
import tempfile

import bpy

from .preferences import program_name

NOT_FOUND = "there is no program {}: say where restframe is in the preferences of its add-on"
running = []


class Job:
    """One call; what it says goes to a file, so that no pipe can fill up."""

    def __init__(self, arguments, folder):
        self.said = tempfile.TemporaryFile(mode="w+", encoding="utf-8", errors="replace")
        name = bpy.path.abspath(program_name())
        try:
            self.process = subprocess.Popen([name, *map(str, arguments)], cwd=folder, text=True,
                                            stdin=subprocess.DEVNULL, stdout=self.said,
                                            stderr=subprocess.STDOUT)
        except OSError as error:
            self.said.close()
            raise RuntimeError(NOT_FOUND.format(f'"{name}"')) from error
        self.lines = None
        running.append(self)

    def is_done(self):
        return self.process.poll() is not None

    def stop(self):
        """restframe takes its hands off what is unfinished, and ends, within a second or so."""
        self.process.terminate()

    def finish(self):
        """Its exit code and the lines it said; again, the same."""
        code = self.process.wait()
        if self.lines is None:
            running.remove(self)
            self.said.seek(0)
            self.lines = self.said.read().splitlines()
            self.said.close()
        return code, self.lines


def stop_all():
    for job in list(running):
        job.stop()
        job.finish()


def complaint(code, lines):
    """The one line that says what is wrong."""
    errors = [line for line in lines if line.startswith("error: ")]
    if errors:
        more = f" (and {len(errors) - 1} more)" if len(errors) > 1 else ""
        return "restframe: " + errors[0][len("error: "):] + more
    return f"restframe ended with {code}: " + (lines[-1] if lines else "it said nothing")


def new_folder():
    """Goes when Blender does."""
    return pathlib.Path(tempfile.mkdtemp(prefix="restframe_", dir=bpy.app.tempdir))
