# Writes the reference poses of FrameReferenceTests, computed by Orocos KDL 1.5.1 in double precision:
#   apt-get install python3-pykdl
#   /usr/bin/python3 make-frame-reference.py ../../Packages/com.nowpose.mril/Runtime/Robots/ur5.urdf OUT.json
# A vehicle moves in the world. The arm is mounted on the vehicle at an angle, its tool carries a gripper, a part moves in the gripper, and a
# label is on the part.
# Tracked frames move and turn at constant rates about all axes, so their poses at the display time are known exactly.
import json
import random
import re
import sys
import xml.etree.ElementTree as xml
import PyKDL as kdl

SEED, CASES, SAMPLES, INTERVAL, DISPLAY = 20261125, 6, 5, 0.05, 0.33
random.seed(SEED)


def vector(reach):
    return kdl.Vector(*(random.uniform(-reach, reach) for _ in range(3)))


def turn(v):
    return kdl.Rotation.Rot(v, v.Norm())


def pose(reach):
    return kdl.Frame(turn(vector(2.5)), vector(reach))


def numbers(frame, sign=1):
    return [*frame.p, *(sign * c for c in frame.M.GetQuaternion())]


def matrix(frame):
    return [frame[i, j] for i in range(3) for j in range(4)] + [0, 0, 0, 1]


class Moving:
    def __init__(self, reach):
        self.start, self.velocity, self.rate = pose(reach), vector(reach), vector(2)

    def at(self, t):
        return kdl.Frame(turn(self.rate * t) * self.start.M, self.start.p + self.velocity * t)


class Arm:
    def __init__(self, file, tool):
        joints = {j.find("child").get("link"): j for j in xml.parse(file).getroot().iter("joint")}
        way = [joints[tool]]
        while (parent := way[0].find("parent").get("link")) in joints:
            way.insert(0, joints[parent])
        self.root, self.names, self.chain = parent, [], kdl.Chain()
        for joint in way:
            origin = joint.find("origin")
            number = lambda name: [float(x) for x in (origin.get(name, "0 0 0") if origin is not None else "0 0 0").split()]
            frame = kdl.Frame(kdl.Rotation.RPY(*number("rpy")), kdl.Vector(*number("xyz")))
            kind = kdl.Joint(joint.get("name"), kdl.Joint.Fixed)
            if joint.get("type") == "revolute":
                axis = kdl.Vector(*(float(x) for x in joint.find("axis").get("xyz").split()))
                kind = kdl.Joint(joint.get("name"), frame.p, frame.M * axis, kdl.Joint.RotAxis)
                self.names.append(joint.get("name"))
            self.chain.addSegment(kdl.Segment(joint.get("name"), kind, frame))

    def tool_at(self, positions):
        q, tool = kdl.JntArray(len(positions)), kdl.Frame()
        for i, position in enumerate(positions):
            q[i] = position
        kdl.ChainFkSolverPos_recursive(self.chain).JntToCart(q, tool)
        return tool


def tracked(parent, child, moving):
    samples = [[k * INTERVAL, *numbers(moving.at(k * INTERVAL), random.choice([-1, 1]))] for k in range(SAMPLES)]
    return {"parent": parent, "child": child, "samples": samples}


def case(arm):
    q = [random.uniform(-3, 3) for _ in arm.names]
    vehicle, part, mount, gripper, label = Moving(2), Moving(0.1), pose(0.5), pose(0.2), pose(0.05)
    base = "arm/" + arm.root
    world = {"vehicle": vehicle.at(DISPLAY)}
    world[base] = world["vehicle"] * mount
    world["gripper"] = world[base] * arm.tool_at(q) * gripper
    world["part"] = world["gripper"] * part.at(DISPLAY)
    world["label"] = world["part"] * label
    return {
        "joints": dict(zip(arm.names, q)),
        "stationary": [
            {"parent": "vehicle", "child": base, "pose": numbers(mount)},
            {"parent": "arm/tool0", "child": "gripper", "pose": numbers(gripper)},
            {"parent": "part", "child": "label", "pose": numbers(label)},
        ],
        "tracked": [tracked("world", "vehicle", vehicle), tracked("gripper", "part", part)],
        "world": {name: matrix(frame) for name, frame in world.items()},
    }


arm = Arm(sys.argv[1], "tool0")
result = {"made_with": "make-frame-reference.py: Orocos KDL 1.5.1", "robot": "ur5", "display_s": DISPLAY, "cases": [case(arm) for _ in range(CASES)]}
# One line per list of numbers.
text = re.sub(r"\[\s+(-?[\d.][^\[\]{}]*?)\s+\]", lambda m: "[" + re.sub(r"\s+", " ", m[1]) + "]", json.dumps(result, indent=1))
with open(sys.argv[2], "w") as out:
    out.write(text + "\n")
