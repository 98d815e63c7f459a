using Nowpose.Kinematics;
using Nowpose.Simulation.Work;

namespace Nowpose.Prefabs;

/// <summary>Creates the virtual peripherals and workpieces of a cell whose robot has a task.</summary>
static class WorkObjects
{
    /// <summary>Width of the belt; thickness of belt and fixture, m.</summary>
    const float Width = 0.05f, Thickness = 0.01f;

    /// <summary>Thickness of the stop and height of its stroke, m. Raised, it is lower than a workpiece.</summary>
    const float StopThickness = 0.005f, StopStroke = 0.02f;

    /// <summary>Stroke time of the stop, ms. It is lowered before the gripper arrives.</summary>
    const float StopStrokeMs = 200;

    /// <summary>Distance of the stack light from the middle of the belt, height and width of its post, and edge length of a lamp, m.</summary>
    const float LightDistance = 0.07f, PostHeight = 0.08f, PostWidth = 0.01f, LampSize = 0.02f;

    /// <summary>Number of points on each straight section of the belt.</summary>
    const int PointsPerSection = 2;

    public static GameObject Build(PackageAssets assets, MrilSession session, CellWork work)
    {
        var (virtualPart, workpiece) = (assets.Load<Material>(PackagePaths.Hologram), assets.Load<Material>(PackagePaths.Workpiece));
        var uncompensated = assets.Load<Material>(PackagePaths.Ghost);
        var root = new GameObject("Cell Objects");
        var conveyor = Shown<StationaryObject>(CellWork.Conveyor, CellWork.Conveyor, root, session, virtualPart);
        // White, so that a lit lamp does not look like a workpiece.
        var lit = assets.Load<Material>(PackagePaths.Timestamp);
        for (var i = 0; i < work.Robots.Count; i++)
        {
            AddBelt(conveyor, work, i, virtualPart);
            AddStop(conveyor, work, i, session, virtualPart);
            AddStackLight(conveyor, work, i, session, virtualPart, lit);
        }
        var below = RigidTransform.FromXyzRpy(0, 0, -Thickness / 2, 0, 0, 0);
        foreach (var robot in work.Robots)
        {
            var fixture = Shown<StationaryObject>(robot.Fixture, robot.Fixture, root, session, virtualPart);
            AddCube(fixture, "Plate", below, new Vector3(2 * Width, Thickness, 2 * Width), virtualPart);
        }
        foreach (var name in work.Names)
        {
            AddWorkpiece(Shown<TrackedObject>(name, name, root, session, virtualPart), workpiece);
            var ghost = Shown<TrackedObject>("ghost of " + name, name, root, session, uncompensated);
            Fields.Set(ghost.GetComponent<TrackedObject>(), "_shows", RigPose.Held);
            AddWorkpiece(ghost, uncompensated);
        }

        TransformRounding.Apply(root.transform);
        return root;
    }

    // Adds no labels, because six labels would hide the objects. The status panel names the objects that are not current.
    static GameObject Shown<T>(string name, string frame, GameObject parent, MrilSession session, Material substitute)
        where T : Component
    {
        var made = Children.Add(name, parent.transform);
        var shown = made.AddComponent<T>();
        Fields.Set(shown, "_session", session);
        if (frame != name) Fields.Set(shown, "_frame", frame);
        var appearance = made.GetComponent<PoseAppearance>();
        Fields.Set(appearance, "_session", session);
        Fields.Set(appearance, "_substitute", substitute);
        return made;
    }

    static void AddWorkpiece(GameObject parent, Material material) =>
        AddCube(parent, "Cube", RigidTransform.Identity, Vector3.one * (float)CellWork.Size, material);

    // Draws straight sections between points on the upper side of the belt that leads to a robot.
    static void AddBelt(GameObject conveyor, CellWork work, int robot, Material material)
    {
        var points = BeltTo(work, robot).Select(point => work.ConveyorPose.Inverse * point).Where((_, i) => i % PointsPerSection == 0).ToArray();
        for (var i = 1; i < points.Length; i++)
        {
            var (from, to) = (points[i - 1], points[i]);
            var (x, y, z) = (to.X - from.X, to.Y - from.Y, to.Z - from.Z);
            var length = Math.Sqrt(x * x + y * y + z * z);
            var middle = RigidTransform.FromXyzRpy(
                from.X + x / 2, from.Y + y / 2, from.Z + z / 2 - Thickness / 2, 0, -Math.Asin(z / length), Math.Atan2(y, x));
            AddCube(conveyor, NameOf(work, robot, "Section") + " " + i, middle, new Vector3(Width, Thickness, (float)length), material);
        }
    }

    // Adds the stop at the end of the belt. It is up while the belt runs, and holds the workpiece that arrives.
    static void AddStop(GameObject conveyor, CellWork work, int robot, MrilSession session, Material material)
    {
        var arriving = (BeltEnd(work, robot).Inverse * BeltTo(work, robot).SkipLast(1).Last()).Y;
        var ahead = -Math.Sign(arriving) * (CellWork.Size + StopThickness) / 2;
        var stop = AtBeltEnd("Stop", conveyor, work, robot, RigidTransform.FromXyzRpy(0, ahead, 0, 0, 0, 0));
        var part = stop.AddComponent<ActuatedPart>();
        Fields.Set(part, "_session", session);
        Fields.Set(part, "_signal", CellWork.BeltRunning);
        Fields.Set(part, "_wayMetres", new Vector3(0, StopStroke, 0));
        Fields.Set(part, "_strokeMs", StopStrokeMs);
        // Unity's right is along the belt, and forward is away from the robot.
        var below = RigidTransform.FromXyzRpy(0, 0, -StopStroke / 2, 0, 0, 0);
        AddCube(stop, "Plate", below, new Vector3(StopThickness, StopStroke, (float)CellWork.Size), material);
    }

    // Adds the stack light beside the end of the belt. It shows the signals of the robot.
    static void AddStackLight(GameObject conveyor, CellWork work, int robot, MrilSession session, Material off, Material on)
    {
        var light = AtBeltEnd("Stack Light", conveyor, work, robot, RigidTransform.FromXyzRpy(LightDistance, 0, 0, 0, 0, 0));
        var post = RigidTransform.FromXyzRpy(0, 0, PostHeight / 2, 0, 0, 0);
        AddCube(light, "Post", post, new Vector3(PostWidth, PostHeight, PostWidth), off);
        AddLamp(light, work.Robots[robot].PartPresent, PostHeight + LampSize / 2, session, off, on);
        AddLamp(light, work.Robots[robot].GripperClosed, PostHeight + 2 * LampSize, session, off, on);
    }

    // The lit lamp is slightly larger and hides the dark lamp, so that a single call switches between both.
    static void AddLamp(GameObject light, string signal, float height, MrilSession session, Material off, Material on)
    {
        var lamp = Children.Add(signal, light.transform, new Vector3(0, height, 0));
        AddCube(lamp, "Dark", RigidTransform.Identity, Vector3.one * LampSize, off);
        var lit = AddCube(lamp, "Lit", RigidTransform.Identity, Vector3.one * (1.1f * LampSize), on);
        lit.SetActive(false);
        var component = lamp.AddComponent<CellSignal>();
        Fields.Set(component, "_session", session);
        Calls.AddDynamic(component, "_onState", lit, nameof(GameObject.SetActive));
    }

    // Returns points of the belt that leads to a robot, in the world. A single robot's belt leads back to itself.
    static IEnumerable<RigidTransform> BeltTo(CellWork work, int robot) => work.BeltBehind((robot + work.Robots.Count - 1) % work.Robots.Count);

    // Returns the world pose of the point of the belt's surface where a robot takes workpieces. The x axis points away from the robot.
    static RigidTransform BeltEnd(CellWork work, int robot)
    {
        var (taken, from) = (work.Robots[robot].Taken, work.Robots[robot].Base);
        return RigidTransform.FromXyzRpy(taken.X, taken.Y, work.ConveyorPose.Z, 0, 0, Math.Atan2(taken.Y - from.Y, taken.X - from.X));
    }

    // Numbers the parts only if there are several robots.
    static string NameOf(CellWork work, int robot, string name) => work.Robots.Count == 1 ? name : name + " " + (robot + 1);

    /// <param name="offset">Pose relative to <see cref="BeltEnd"/>.</param>
    static GameObject AtBeltEnd(string name, GameObject conveyor, CellWork work, int robot, in RigidTransform offset)
    {
        var place = UnityPoses.ToWorld(work.ConveyorPose.Inverse * BeltEnd(work, robot) * offset);
        var made = Children.Add(NameOf(work, robot, name), conveyor.transform, place.position);
        made.transform.localRotation = place.rotation;
        return made;
    }

    /// <param name="pose">Pose in the parent's frame, in right-handed coordinates.</param>
    /// <param name="size">Size in metres along Unity's axes: right, up, forward.</param>
    static GameObject AddCube(GameObject parent, string name, in RigidTransform pose, Vector3 size, Material material)
    {
        var place = UnityPoses.ToWorld(pose);
        var cube = Children.AddPrimitive(PrimitiveType.Cube, name, parent.transform, place.position, size, material);
        cube.transform.localRotation = place.rotation;
        return cube;
    }
}
