#!/usr/bin/env bash
# rosbags-dtype: rosbags writes the bytes of a numpy array as they lie in memory, whatever its dtype, so an array of
# whole numbers in a float64 field comes back as denormals near zero.
#
# Version: PyPI rosbags 0.11.9 with numpy 2.2.6.
# Guess: np.array([1, 2]) in a float64[] field is written as 1.0 and 2.0, or refused; and a string<=3 or int32[<=2]
#   field holds no more than it may.
# Behaviour: an int64 array is written bit for bit and read back as 5e-324 and 1e-323, a big-endian array as noise,
#   both with no error. Bounds are not checked either way. A single number in a float64 field, in contrast, is
#   converted, and a list instead of an array is refused.
# Why it matters: goals, joint values and laser ranges built from whole numbers are logged as about zero.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
python3 -m venv "$tmp/venv"
"$tmp/venv/bin/pip" install -q --disable-pip-version-check rosbags==0.11.9 numpy==2.2.6

seen=$("$tmp/venv/bin/python" - <<'PY'
import numpy as np
from rosbags.typesys import Stores, get_types_from_msg, get_typestore
store = get_typestore(Stores.ROS2_HUMBLE)
store.register(get_types_from_msg("float64 one\nfloat64[] many\nstring<=3 name\nint32[<=2] few\n", "demo/msg/Goal"))
Goal = store.types["demo/msg/Goal"]
few = np.array([1, 2, 3], dtype=np.int32)
for title, many in (
    ("float64", np.array([1.0, 2.0])),
    ("int64", np.array([1, 2], dtype=np.int64)),
    ("big-endian float64", np.array([1.0, 2.0], dtype=">f8")),
    ("list", [1.0, 2.0]),
):
    try:
        raw = store.serialize_cdr(Goal(one=1, many=many, name="block", few=few), "demo/msg/Goal")
        back = store.deserialize_cdr(raw, "demo/msg/Goal")
        print(f"{title}: {back.many.tolist()}, one {back.one}, name {back.name}, few {back.few.tolist()}")
    except Exception as error:
        print(f"{title}: {type(error).__name__}")
PY
)
expected=$(cat <<'EOF'
float64: [1.0, 2.0], one 1.0, name block, few [1, 2, 3]
int64: [5e-324, 1e-323], one 1.0, name block, few [1, 2, 3]
big-endian float64: [3.03865e-319, 3.16e-322], one 1.0, name block, few [1, 2, 3]
list: AttributeError
EOF
)
printf '%s\n' "$seen"
if [ "$seen" != "$expected" ]; then
  printf 'rosbags-dtype: this has changed; it was:\n%s\n' "$expected" >&2
  exit 1
fi
