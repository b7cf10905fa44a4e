"""Shows that scripts/loose_claims finds what is loose, and nothing else."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

LOOSE_CLAIMS = pathlib.Path(__file__).resolve().parents[1] / "loose_claims"


def claim(**changes):
    return {"suite": "closed_forms", "test": "Bar", "what": "u at the end", "comparison": "relative", "difference": 1e-6,
            "allowed": 9e-6, "reason": "", "verdict": "holds", **changes}


class LooseClaims(unittest.TestCase):
    def run_on(self, *claims):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "verify.json"
            file.write_text(json.dumps({"claims": claims}))
            done = subprocess.run([sys.executable, LOOSE_CLAIMS, file], capture_output=True, text=True)
            return done.returncode, done.stdout

    def test_accepts_what_is_within_a_factor_of_ten(self):
        self.assertEqual(self.run_on(claim()), (0, ""))

    def test_names_what_allows_more(self):
        code, output = self.run_on(claim(), claim(allowed=1.1e-5))
        self.assertEqual(code, 1)
        self.assertEqual(output, "closed_forms.Bar: u at the end: found 1e-06, allowed 1.1e-05, 11 times as much\n")
        self.assertEqual(self.run_on(claim(comparison="absolute", difference=0))[0], 1)

    def test_accepts_reasons_limits_and_what_must_be_equal(self):
        self.assertEqual(self.run_on(claim(allowed=1, reason="round-off"), claim(comparison="at most", allowed=0),
                                     claim(comparison="at least", allowed=0), claim(difference=0, allowed=0),
                                     claim(verdict="reported", allowed=None), {"verdict": "not run", "what": "needs x"}),
                         (0, ""))


if __name__ == "__main__":
    unittest.main()
