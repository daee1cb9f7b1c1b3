# The frames of roslibpy, the usual client in Python: the same as the page's, and it reads what the crate writes. Run by
# `make check-roslibpy`; against the rosbridge of the tests' own. Ends with "N passed, N failed".

import json
import subprocess
import sys
import threading
import time

import roslibpy


def shape(frame):
    """What a frame is made of: its fields with the kinds of their values, and what its id begins with."""
    kinds = {bool: "boolean", str: "string", int: "number", float: "number", dict: "object"}
    # roslibpy says with every message that it is not kept, which is what a missing word means.
    rest = {k: v for k, v in frame.items() if k != "id" and not (frame["op"] == "publish" and k == "latch")}
    return sorted(f"{k}:{kinds[type(v)]}" for k, v in rest.items()) + [frame["id"].rsplit(":", 1)[0]]


class Peer:
    def __init__(self, binary):
        self.child = subprocess.Popen([binary], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.address = json.loads(self.child.stdout.readline())["listening"]
        self.frames = []
        threading.Thread(target=self.listen, daemon=True).start()

    def listen(self):
        for line in self.child.stdout:
            said = json.loads(line)
            if "frame" in said:
                self.frames.append(said["frame"])


def until(look, seconds=10):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        found = look()
        if found:
            return found
        time.sleep(0.02)
    return look()


def main(binary, expected):
    ours = [json.loads(line) for line in open(expected, encoding="utf-8")]
    velocity = next(frame["msg"] for frame in ours if frame["op"] == "publish")
    peer = Peer(binary)
    host, port = peer.address.removeprefix("ws://").split(":")
    ros = roslibpy.Ros(host=host, port=int(port))
    ros.run()
    failed = []

    def check(what, found, wanted):
        print("ok    " if found == wanted else "FAILED", what)
        if found != wanted:
            failed.append(what)
            print(f"       {found}\n       wanted {wanted}")

    service = roslibpy.Service(ros, "/rosapi/topic_type", "rosapi/TopicType")
    for topic, kind in (("/cmd_vel", "geometry_msgs/msg/TwistStamped"), ("/odom", "nav_msgs/msg/Odometry")):
        check(f"the type of {topic}", service.call(roslibpy.ServiceRequest({"topic": topic}))["type"], kind)
    heard = []
    odometry = roslibpy.Topic(ros, "/odom", "nav_msgs/msg/Odometry", queue_length=1)
    odometry.subscribe(heard.append)
    pose = until(lambda: heard and heard[0]["pose"]["pose"]["position"])
    check("a pose", bool(pose) and abs(pose["x"] - 3) < 0.2, True)
    topic = roslibpy.Topic(ros, "/cmd_vel", "geometry_msgs/msg/TwistStamped", queue_size=1)
    topic.advertise()
    topic.publish(roslibpy.Message(velocity))
    topic.unadvertise()
    until(lambda: len(peer.frames) >= len(ours))
    check("its frames", [shape(frame) for frame in peer.frames], [shape(frame) for frame in ours])
    check("a velocity, as it came in", [f["msg"] for f in peer.frames if f["op"] == "publish"], [velocity])
    read = []
    roslibpy.Topic(ros, "/told", "geometry_msgs/msg/TwistStamped").subscribe(read.append)
    until(lambda: any(frame.get("topic") == "/told" for frame in peer.frames))
    ours_sent = json.dumps({**next(f for f in ours if f["op"] == "publish"), "topic": "/told"})
    peer.child.stdin.write(f"say {ours_sent}\n")
    peer.child.stdin.flush()
    until(lambda: read)
    check("a velocity that the crate wrote", read, [velocity])
    passed = 6 - len(failed)
    print(f"{passed} passed, {len(failed)} failed")
    ros.close()
    peer.child.kill()
    sys.exit(1 if failed else 0)


main(*sys.argv[1:])
