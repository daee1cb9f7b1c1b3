"""Cleanup Worlds with goals, for timing: as lines of `groundling plan`, for mdpgen, as PDDL.

  worlds.py GROUNDLING OUT_FOLDER NAME --columns N --rows N --n-rooms N --objects N --moved N [--style S] [--lock P]
            [--slip P] [--loss P] [--pull] [--seed N] [--solver S]
writes NAME.jsonl, NAME.flat and, where nothing is left to chance, NAME.pddl and NAME.domain.pddl. The goal brings the first N objects each to
another room than it is in. Layouts are drawn by `groundling generate --worlds`; looks are set so that goals refer.
"""
import argparse, json, subprocess
from pathlib import Path

SHAPES = ["chair", "basket", "block", "bag", "backpack", "box"]
COLORS = ["red", "green", "blue", "yellow", "magenta", "brown", "orange", "tan", "teal"]
DIRECTIONS = ["north", "south", "east", "west"]
LOCKS = ["unknown", "locked", "unlocked"]
STEP = [(0, 1), (0, -1), (1, 0), (-1, 0)]


def inside(r, x, y):
    return r["left"] < x < r["right"] and r["bottom"] < y < r["top"]


def build(groundling, a):
    """A world, and its goal as (object or -1, room) pairs; None where the generator refuses the seed."""
    command = [groundling, "generate", "--worlds", "1", "--style", a.style, "--rooms", a.n_rooms, "--columns", a.columns,
               "--rows", a.rows, "--objects", a.objects, "--lock", "unknown" if a.lock else "unlocked", "--seed", a.seed]
    text = subprocess.run([str(c) for c in command], capture_output=True, text=True, check=False).stdout
    if not text.strip():
        return None
    world = json.loads(text.splitlines()[0])
    for i, o in enumerate(world["objects"]):
        o["shape"], o["color"] = SHAPES[i % 6], COLORS[i % 9]
    # Rooms: goals say a room by its colour; one colour each as far as colours go, the last by being the goal's.
    rooms = world["rooms"]
    parts, used = [], {}
    for i in range(a.moved):
        o = world["objects"][i]
        others = [k for k, r in enumerate(rooms) if not inside(r, o["x"], o["y"])]
        k = others[(i + a.seed) % len(others)]
        used.setdefault(k, len(used))
        parts.append((i, k))
    for k, r in enumerate(rooms):
        r["color"] = COLORS[used[k]] if k in used else "teal"
    return world, parts


def term(world, parts):
    def the(a, b):
        return f"(the:<<e,t>,e> (lambda $0:e (and:<t*,t> ({a}:<e,t> $0) ({b}:<e,t> $0))))"
    texts = []
    for i, k in parts:
        o = world["objects"][i]
        texts.append(f"(in:<e,<e,t>> {the(o['shape'], o['color'])} {the('room', world['rooms'][k]['color'])})")
    return texts[0] if len(texts) == 1 else f"(and:<t*,t> {' '.join(texts)})"


def cells(world):
    """Width, height and a grid: None wall, -1 floor, else the door."""
    w = 1 + max(r["right"] for r in world["rooms"])
    h = 1 + max(r["top"] for r in world["rooms"])
    grid = {(x, y): None for x in range(w) for y in range(h)}
    for r in world["rooms"]:
        for x in range(r["left"] + 1, r["right"]):
            for y in range(r["bottom"] + 1, r["top"]):
                grid[x, y] = -1
    for i, d in enumerate(world["doors"]):
        for x in range(d["left"], d["right"] + 1):
            for y in range(d["bottom"], d["top"] + 1):
                grid[x, y] = i
    return w, h, grid


def flat(world, parts, a):
    w, h, grid = cells(world)
    cell = lambda t: t["y"] * w + t["x"]
    rows = [f"{w} {h} {len(world['doors'])} {len(world['objects'])} {int(a.pull)} {a.slip} {a.lock} {a.loss}"]
    rows += [" ".join(str(-2 if grid[x, y] is None else grid[x, y]) for x in range(w)) for y in range(h)]
    rows.append(" ".join(str(LOCKS.index(d["lock"])) for d in world["doors"]))
    rows.append(f"{cell(world['agent'])} {DIRECTIONS.index(world['agent']['direction'])}")
    rows.append(" ".join(str(cell(o)) for o in world["objects"]))
    rows.append(str(len(parts)))
    for i, k in parts:
        r = world["rooms"][k]
        rows.append(f"{i} {r['left']} {r['bottom']} {r['right']} {r['top']}")
    return "\n".join(rows) + "\n"




MOVES = """
 (:action move :parameters (?a ?b - cell ?w - way)
  :precondition (and (robot ?a) (next ?a ?b ?w) (free ?b))
  :effect (and (not (robot ?a)) (robot ?b)))
 (:action push :parameters (?a ?b ?c - cell ?w - way ?o - thing ?y ?z - zone)
  :precondition (and (robot ?a) (next ?a ?b ?w) (at ?o ?b) (next ?b ?c ?w) (free ?c) (zone ?b ?y) (zone ?c ?z))
  :effect (and (not (robot ?a)) (robot ?b) (not (at ?o ?b)) (at ?o ?c) (free ?b) (not (free ?c))
   (not (in ?o ?y)) (in ?o ?z)))"""
# With pull the heading counts, but only in front of an object: elsewhere it is `none`, which saves states.
PULL = """
 (:action move-to-wall :parameters (?a ?b - cell ?w - way ?v - facing)
  :precondition (and (robot ?a) (next ?a ?b ?w) (free ?b) (wall ?b ?w) (faces ?v))
  :effect (and (not (robot ?a)) (robot ?b) (not (faces ?v)) (faces none)))
 (:action move-to-floor :parameters (?a ?b ?c - cell ?w - way ?v - facing)
  :precondition (and (robot ?a) (next ?a ?b ?w) (free ?b) (next ?b ?c ?w) (free ?c) (faces ?v))
  :effect (and (not (robot ?a)) (robot ?b) (not (faces ?v)) (faces none)))
 (:action move-to-object :parameters (?a ?b ?c - cell ?w - way ?v - facing ?o - thing)
  :precondition (and (robot ?a) (next ?a ?b ?w) (free ?b) (next ?b ?c ?w) (at ?o ?c) (faces ?v))
  :effect (and (not (robot ?a)) (robot ?b) (not (faces ?v)) (faces ?w)))
 (:action push :parameters (?a ?b ?c - cell ?w - way ?v - facing ?o - thing ?y ?z - zone)
  :precondition (and (robot ?a) (next ?a ?b ?w) (at ?o ?b) (next ?b ?c ?w) (free ?c) (faces ?v) (zone ?b ?y) (zone ?c ?z))
  :effect (and (not (robot ?a)) (robot ?b) (not (at ?o ?b)) (at ?o ?c) (free ?b) (not (free ?c)) (not (faces ?v)) (faces ?w)
   (not (in ?o ?y)) (in ?o ?z)))
 (:action turn-before-object :parameters (?a ?b ?c - cell ?w - way ?v - facing ?o ?p - thing)
  :precondition (and (robot ?a) (next ?a ?b ?w) (at ?o ?b) (next ?b ?c ?w) (at ?p ?c) (faces ?v))
  :effect (and (not (faces ?v)) (faces ?w)))
 (:action turn-before-wall :parameters (?a ?b - cell ?w - way ?v - facing ?o - thing)
  :precondition (and (robot ?a) (next ?a ?b ?w) (at ?o ?b) (wall ?b ?w) (faces ?v))
  :effect (and (not (faces ?v)) (faces ?w)))
 (:action pull :parameters (?a ?b - cell ?w ?v - way ?o - thing ?y ?z - zone)
  :precondition (and (robot ?a) (faces ?w) (next ?a ?b ?w) (at ?o ?b) (opposite ?w ?v) (zone ?b ?y) (zone ?a ?z))
  :effect (and (not (robot ?a)) (robot ?b) (not (at ?o ?b)) (at ?o ?a) (free ?b) (not (free ?a)) (not (faces ?w)) (faces ?v)
   (not (in ?o ?y)) (in ?o ?z)))"""


def pddl(world, parts, a):
    """Domain and problem without axioms or conditional effects, so that every heuristic applies. `zone` is the room of a
    cell, or `nowhere` for doors; `in` follows the objects."""
    _, _, grid = cells(world)
    name = lambda c: f"c{c[0]}-{c[1]}"
    free = [c for c, g in grid.items() if g is not None and not (g >= 0 and world["doors"][g]["lock"] == "locked")]
    known = set(free)
    zone = lambda c: next((f"z{k}" for k, r in enumerate(world["rooms"]) if inside(r, *c)), "nowhere")
    taken = {(o["x"], o["y"]) for o in world["objects"]}
    init = [f"(robot {name((world['agent']['x'], world['agent']['y']))})"]
    for i, o in enumerate(world["objects"]):
        init += [f"(at o{i} {name((o['x'], o['y']))})", f"(in o{i} {zone((o['x'], o['y']))})"]
    for c in free:
        init += [f"(zone {name(c)} {zone(c)})"] + [f"(free {name(c)})"] * (c not in taken)
        for d, (dx, dy) in enumerate(STEP):
            n = (c[0] + dx, c[1] + dy)
            init.append(f"(next {name(c)} {name(n)} {DIRECTIONS[d]})" if n in known else f"(wall {name(c)} {DIRECTIONS[d]})")
    if a.pull:
        d = DIRECTIONS.index(world["agent"]["direction"])
        ahead = (world["agent"]["x"] + STEP[d][0], world["agent"]["y"] + STEP[d][1])
        init.append(f"(faces {DIRECTIONS[d] if ahead in taken else 'none'})")
        init += [f"(opposite {DIRECTIONS[d]} {DIRECTIONS[[1, 0, 3, 2][d]]})" for d in range(4)]
    domain = f"""(define (domain cleanup)
 (:requirements :strips :typing)
 (:types cell thing facing zone - object way - facing)
 (:constants north south east west - way none - facing)
 (:predicates (robot ?c - cell) (at ?o - thing ?c - cell) (free ?c - cell) (next ?a ?b - cell ?w - way)
  (wall ?c - cell ?w - way) (opposite ?a ?b - way) (faces ?v - facing) (zone ?c - cell ?z - zone) (in ?o - thing ?z - zone))
{PULL if a.pull else MOVES}
)
"""
    objects = (f"{' '.join(name(c) for c in free)} - cell {' '.join(f'o{i}' for i in range(len(world['objects'])))} - thing "
               f"{' '.join(f'z{k}' for k in range(len(world['rooms'])))} nowhere - zone")
    goal = " ".join(f"(in o{i} z{k})" for i, k in parts)
    return domain, f"(define (problem p) (:domain cleanup) (:objects {objects})\n (:init {' '.join(init)})\n (:goal (and {goal})))\n"


def main():
    p = argparse.ArgumentParser()
    p.add_argument("groundling"), p.add_argument("out"), p.add_argument("name")
    for k, d in dict(columns=9, rows=9, objects=1, moved=1, seed=0).items():
        p.add_argument(f"--{k}", type=int, default=d)
    p.add_argument("--n-rooms", type=int, default=3)
    p.add_argument("--style", default="cuts"), p.add_argument("--solver", default=None)
    for k in ("lock", "slip", "loss"):
        p.add_argument(f"--{k}", type=float, default=0)
    p.add_argument("--pull", action="store_true")
    a = p.parse_args()
    built = build(a.groundling, a)
    if built is None:
        raise SystemExit("the generator refuses this seed")
    world, parts = built
    line = {"goal": term(world, parts), "initial": world, "pull": a.pull, "lock_probability": a.lock,
            "slip_probability": a.slip, "loss_probability": a.loss}
    if a.solver:
        line["solver"] = a.solver
    out = Path(a.out)
    (out / f"{a.name}.jsonl").write_text(json.dumps(line) + "\n")
    (out / f"{a.name}.flat").write_text(flat(world, parts, a))
    if not a.lock and not a.slip and not a.loss:
        domain, problem = pddl(world, parts, a)
        (out / f"{a.name}.domain.pddl").write_text(domain)
        (out / f"{a.name}.pddl").write_text(problem)


if __name__ == "__main__":
    main()
