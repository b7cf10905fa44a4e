"""Shows that scripts/compile_commands gives each source of a batch the command of its batch."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

COMPILE_COMMANDS = pathlib.Path(__file__).resolve().parents[1] / "compile_commands"


class CompileCommands(unittest.TestCase):
    def written(self, folder, entries):
        tree = pathlib.Path(folder) / "tree"
        tree.mkdir()
        (tree / "compile_commands.json").write_text(json.dumps(entries))
        subprocess.run([sys.executable, COMPILE_COMMANDS, tree, folder], check=True)
        return [(entry["file"], entry["command"])
                for entry in json.loads((pathlib.Path(folder) / "compile_commands.json").read_text())]

    def test_takes_batches_apart_and_leaves_out_what_gcc_alone_knows(self):
        with tempfile.TemporaryDirectory() as folder:
            batch = pathlib.Path(folder) / "Unity" / "unity_0_cxx.cxx"
            batch.parent.mkdir()
            batch.write_text('/* made */\n\n#include "/a/one.cpp"\n\n#include "/a/two.cpp"\n')
            gcc = "c++ -Iinclude -include /build/cmake_pch.hxx --param=ggc-min-heapsize=9 -c "
            entries = [{"directory": "/build", "file": str(batch), "command": gcc + str(batch)},
                       {"directory": "/build", "file": "/a/alone.cpp", "command": "c++ -c /a/alone.cpp"}]
            self.assertEqual(self.written(folder, entries), [("/a/one.cpp", "c++ -Iinclude -c /a/one.cpp"),
                                                             ("/a/two.cpp", "c++ -Iinclude -c /a/two.cpp"),
                                                             ("/a/alone.cpp", "c++ -c /a/alone.cpp")])


if __name__ == "__main__":
    unittest.main()
