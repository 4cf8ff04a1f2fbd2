"""``python -m inbetween_animator``: the program, where its folder is not on the PATH."""

import os
import subprocess
import sys

from ._program import InbetweenError, program


def main() -> int:
    """Run the program with the arguments of this process; its exit status."""
    try:
        path = program()
    except InbetweenError as error:
        print(error, file=sys.stderr)
        return error.exit_status
    if os.name == "posix":
        os.execv(path, [str(path), *sys.argv[1:]])
    return subprocess.run([path, *sys.argv[1:]], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
