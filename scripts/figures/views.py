"""Which portal a frame of a walk looks at, by what `enfilade inspect --json` says of the house."""
import math


def forward(q):
    """Where a camera that looks down its -z looks; q is x, y, z, w."""
    x, y, z, w = q
    return [-2 * (x * z + w * y), -2 * (y * z - w * x), -(1 - 2 * (x * x + y * y))]


def contains(cell, point):
    box = cell["bounds"]
    return box is not None and all(lo <= p <= hi for lo, p, hi in zip(box["min"], point, box["max"]))


def cell_of(facts, point):
    """The smallest room whose box holds the point; the outside if none does."""
    rooms = [c for c in facts["cells"] if not c["exterior"] and contains(c, point)]
    return min(rooms, key=lambda room: room["volume_m3"], default=facts["cells"][0])


def middle_of(portal):
    return [sum(along) / len(along) for along in zip(*portal["polygon"])]


def prominence(portal, point, direction):
    """How much of the view the portal fills, roughly: its area over its distance squared, less to the sides."""
    to = [a - b for a, b in zip(middle_of(portal), point)]
    distance = math.hypot(*to)
    ahead = sum(a * b for a, b in zip(to, direction)) / distance
    return portal["area_m2"] / distance ** 2 * ahead ** 4 if ahead > 0 else 0


def portal_in_view(facts, frame):
    """(portal, side) of the most prominent portal of the room that the frame stands in."""
    point, direction = frame["p"], forward(frame["q"])
    cell = cell_of(facts, point)
    portals = [facts["portals"][p] for p in cell["portals"]]
    best = max(portals, key=lambda portal: prominence(portal, point, direction))
    return best["id"], "front" if best["front"] == cell["id"] else "back"


def looks_into_a_room(facts, frame):
    """Whether what the frame looks at is a room behind a portal that shows an image."""
    portal, side = portal_in_view(facts, frame)
    portal = facts["portals"][portal]
    beyond = facts["cells"][portal["back" if side == "front" else "front"]]
    away = math.dist(middle_of(portal), frame["p"])
    return not beyond["exterior"] and away > facts["switch_distance_m"] + 0.1
