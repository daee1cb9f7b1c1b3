"""Storm's value iteration on an explicit model (.drn) or a PRISM program: CPU seconds to build and to solve, by method.

  storm.py MODEL [RUNS] [METHOD,…]
Discounted rewards natively (Cdiscount), and the same as reachability with a sink (weights γ; P / γ is the value).
"""
import sys, time, statistics, tempfile, re
import stormpy
from stormpy import environments as env

M = env.MinMaxMethod
METHODS = {
    "vi": M.VALUE_ITERATION, "ovi": M.OPTIMISTIC_VALUE_ITERATION, "svi": M.SOUND_VALUE_ITERATION,
    "ii": M.INTERVAL_ITERATION, "topo": M.TOPOLOGICAL, "pi": M.POLICY_ITERATION,
}


def environment(method, sound):
    e = env.Environment()
    m = e.solver().min_max()
    m.method = METHODS[method]
    m.precision = stormpy.Rational("1/1000000")
    m.relative_termination_criterion = False
    if sound:
        e.solver().force_soundness = True
    return e


def main():
    path, runs = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 3
    methods = sys.argv[3].split(",") if len(sys.argv) > 3 else list(METHODS)
    t = time.process_time()
    if path.endswith(".drn"):
        model = stormpy.build_model_from_drn(path)
    else:
        program = stormpy.parse_prism_model(path) if hasattr(stormpy, "parse_prism_model") else stormpy.parse_prism_program(path)
        model = stormpy.build_model(program)
    built = time.process_time() - t
    print(f"{path}: states {model.nr_states} choices {model.nr_choices} build {built:.3f} s", flush=True)
    initial = model.initial_states[0]
    for text, scale in [('R{"r"}max=? [ Cdiscount=0.99 ]', 1), ('Pmax=? [ F "goal" ]', 1 / 0.99)]:
        if text.startswith("P") and "sink" not in path:
            continue
        if text.startswith("R") and "sink" in path:
            continue
        formula = stormpy.parse_properties(text)
        formula = formula[0] if isinstance(formula, list) else formula
        for method in methods:
            for sound in (False, True):
                times = []
                try:
                    for _ in range(runs):
                        t = time.process_time()
                        result = stormpy.model_checking(model, formula, environment=environment(method, sound))
                        times.append(time.process_time() - t)
                    value = result.get_value(initial) if hasattr(result, "get_value") else result.at(initial)
                    print(f"  {text[:8]} {method:5} sound={int(sound)} {statistics.median(times):.4f} s ({min(times):.4f}-{max(times):.4f}) "
                          f"value {float(value) * scale:.9f}", flush=True)
                except Exception as e:
                    print(f"  {text[:8]} {method:5} sound={int(sound)} {type(e).__name__}: {str(e).splitlines()[0][:150]}", flush=True)


main()
