"""Tests of what `make figures` makes of the program's reports, on reports made by hand.
usage: figures_test.py FIGURES-FOLDER"""
import json
import os
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv.pop(1))
import markdown  # noqa: E402
import runs  # noqa: E402

FRAMES = """method,frame,frametime_ms,warp_ms,portals_as_images,samples,samples_clipped
culling,0,4,,,,
culling,1,8,,,,
ldi,0,3,1,1,100,300
ldi,1,5,,0,0,0
"""


class Figures(unittest.TestCase):
    def play(self):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "frames.csv"), "w") as text:
                text.write(FRAMES)
            with open(os.path.join(folder, "summary.json"), "w") as text:
                json.dump({"methods": {"culling": {}, "ldi": {}}}, text)
            return runs.Play(folder)

    def test_a_column_has_no_value_of_a_frame_that_has_none(self):
        self.assertEqual(self.play().column("ldi", "warp_ms"), [(0, 1.0)])
        self.assertEqual(self.play().column("culling", "warp_ms"), [])

    def test_medians_are_of_one_method(self):
        self.assertEqual(self.play().median_ms("culling"), 6)
        self.assertEqual(self.play().median_ms("ldi"), 4)

    def test_the_clipped_share_is_of_all_samples_that_the_images_had(self):
        self.assertEqual(self.play().clipped_share("ldi"), 0.75)

    def test_layers_beyond_the_third_are_one(self):
        facts = {"layers": {"all": {"per_layer": [70, 20, 5, 3, 2]}}}
        self.assertEqual(runs.layer_shares(facts), [70, 20, 5, 5])
        facts = {"layers": {"all": {"per_layer": [3, 1]}}}
        self.assertEqual(runs.layer_shares(facts), [75, 25, 0, 0])

    def test_numbers_keep_three_digits_and_all_thousands(self):
        self.assertEqual([markdown.number(v) for v in (0, 0.012345, 1.5, 99.96, 167295)],
                         ["0", "0.0123", "1.5", "100", "167,000"])

    def test_speeds_say_which_is_faster(self):
        self.assertEqual(markdown.speed(2, 5), "2.5 times as fast as")
        self.assertEqual(markdown.speed(5, 2), "0.4 times as fast as")
        self.assertEqual(markdown.speed(5, 5.1), "as fast, within 5 %, as")


if __name__ == "__main__":
    unittest.main()
