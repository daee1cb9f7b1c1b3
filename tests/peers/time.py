"""What a task over time costs against its parts: `time.py GROUNDLING` plans "a, then b, never c" in worlds of four rooms
with one object, and "a" from the start and "b" from the middle of a, with and without chance. Prints a line a kind of
world: states and milliseconds of the whole and of both parts, and their ratios."""

import copy
import json
import subprocess
import sys

GROUNDLING = sys.argv[1]
KINDS = [
    (9, {}),
    (9, {"slip_probability": 0.1}),
    (12, {"slip_probability": 0.1}),
    (9, {"slip_probability": 0.1, "lock_probability": 0.3}),
]


def ask(arguments, lines=()):
    text = "\n".join(map(json.dumps, lines))
    # Where one line cannot be planned for (the robot on an object) its answer says so, and so does the exit.
    done = subprocess.run([GROUNDLING, *arguments], input=text, capture_output=True, text=True, check=False)
    return [json.loads(line) for line in done.stdout.splitlines()]


def inside(color):
    room = f"(the:<<e,t>,e> (lambda $0:e (and:<t*,t> (room:<e,t> $0) ({color}:<e,t> $0))))"
    return f"(in:<e,<e,t>> (the:<<e,t>,e> agent:<e,t>) {room})"


def until(color, rest):
    return f"(until:<t,<t,<p,p>>> true:t {inside(color)} {rest})"


def tasks(world, chances):
    """The whole and its parts, where three rooms have a colour of their own."""
    colors = [room["color"] for room in world["rooms"]]
    a, b, c, *_ = [*(color for color in colors if colors.count(color) == 1), None, None, None]
    if c is None:
        return None
    if "lock_probability" in chances:
        for door in world["doors"]:
            door["lock"] = "unknown"
    there = copy.deepcopy(world)
    room = next(room for room in world["rooms"] if room["color"] == a)
    there["agent"].update(x=(room["left"] + room["right"]) // 2, y=(room["bottom"] + room["top"]) // 2)
    whole = f'(all:<p*,p> (always:<t,p> (not:<t,t> {inside(c)})) {until(a, until(b, "done:p"))})'
    goals = [(whole, world), (inside(a), world), (inside(b), there)]
    return [{"goal": goal, "initial": state, "pull": True, **chances} for goal, state in goals]


for size, chances in KINDS:
    worlds = ask(["generate", "--worlds", "60", "--rooms", "4", "--columns", str(size), "--rows", str(size)])
    asked = [lines for world in worlds if (lines := tasks(world, chances))]
    answers = iter(ask(["plan"], [line for lines in asked for line in lines]))
    planned = [[next(answers) for _ in lines] for lines in asked]
    # Where c lies between, or an object in the middle of a, there is nothing to compare.
    planned = [plans for plans in planned if all(plan.get("states") and not plan.get("reason") for plan in plans)]
    said = [f"{size} x {size} {chances}: {len(planned)} worlds"]
    for key, unit, scale in [("states", "states", 1), ("seconds", "ms", 1000)]:
        whole, *parts = [sum(plan[key] for plan in part) * scale / len(planned) for part in zip(*planned)]
        said.append(f"{unit} {whole:.2f} of {sum(parts):.2f}, {whole / sum(parts):.2f} x")
    print("; ".join(said))
