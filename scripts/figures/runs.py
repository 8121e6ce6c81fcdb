"""Reads what the runs of the figures left behind: the reports of `enfilade play`, `enfilade inspect --json`."""
import csv
import json
import os
import statistics

from views import looks_into_a_room


def read_json(file):
    with open(file) as text:
        return json.load(text)


def read_seconds(file):
    with open(file) as text:
        return int(text.read())


def size_of(folder):
    """The bytes of all files under `folder`."""
    return sum(os.path.getsize(os.path.join(at, name))
               for at, _, names in os.walk(folder) for name in names)


class Play:
    """A report folder: its summary, and its frames by method and column."""

    def __init__(self, folder):
        self.summary = read_json(os.path.join(folder, "summary.json"))
        self.methods = list(self.summary["methods"])
        with open(os.path.join(folder, "frames.csv"), newline="") as text:
            self.rows = list(csv.DictReader(text))

    def column(self, method, name):
        """[(frame, value)] of the frames that have one."""
        return [(int(row["frame"]), float(row[name])) for row in self.rows
                if row["method"] == method and row[name] != ""]

    def values(self, method, name):
        return [value for _, value in self.column(method, name)]

    def total(self, method, name):
        return sum(self.values(method, name))

    def median_ms(self, method):
        return statistics.median(self.values(method, "frametime_ms"))

    def clipped_share(self, method):
        """Of all samples of the images that were shown, the share that was left out before the warp."""
        clipped, warped = self.total(method, "samples_clipped"), self.total(method, "samples")
        return clipped / (clipped + warped)


class House:
    """What `play_house` left of a house."""

    def __init__(self, folder):
        self.folder = folder
        self.name = os.path.basename(folder)
        self.facts = read_json(os.path.join(folder, "house.json"))
        self.paper_facts = read_json(os.path.join(folder, "paper.json"))
        self.play = Play(os.path.join(folder, "play"))
        self.paper_play = Play(os.path.join(folder, "play-paper"))
        self.tour = read_json(os.path.join(folder, "tour.json"))
        self.seconds = read_seconds(os.path.join(folder, "house.seconds"))
        self.bytes = size_of(os.path.join(folder, "house"))

    def rooms(self):
        return sum(1 for cell in self.facts["cells"] if not cell["exterior"])

    def colour_frame(self):
        """Of the frames that look into a room, that in which one reference image leaves most of the picture uncovered:
        what layered depth images are for."""
        seen = set.intersection(*({frame for frame, _ in self.play.column(method, "psnr_portals_db")}
                                  for method in ("warp", "warp2", "ldi")))
        uncovered = [at for at in self.play.column("warp", "uncovered_percent") if at[0] in seen]
        inside = [at for at in uncovered if looks_into_a_room(self.facts, self.tour["frames"][at[0]])]
        return max(inside or uncovered, key=lambda at: at[1])[0]


class Growth:
    """What `grow` left: a play for each number of triangles, the fewest first."""

    def __init__(self, folder):
        runs = sorted((int(name) for name in os.listdir(folder) if name.isdigit()))
        self.plays = [Play(os.path.join(folder, str(run), "play")) for run in runs]
        self.seconds = [read_seconds(os.path.join(folder, str(run), "house.seconds")) for run in runs]
        self.methods = self.plays[0].methods

    def triangles(self):
        return [play.summary["house"]["triangles"] for play in self.plays]

    def medians(self, method):
        return [play.median_ms(method) for play in self.plays]


def layer_shares(facts):
    """Of all layered depth images of a house, the percent of samples in layers 1, 2, 3 and beyond."""
    layers = facts["layers"]["all"]["per_layer"]
    grouped = (layers + [0, 0, 0])[:3] + [sum(layers[3:])]
    return [100 * count / sum(layers) for count in grouped]
