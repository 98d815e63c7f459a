using Nowpose.Kinematics;
using Nowpose.Motion;
using Nowpose.Simulation.Work;
using Nowpose.Unity;
using UnityEngine;

namespace Nowpose.Prefabs;

/// <summary>Creates the virtual peripherals and workpieces of a cell whose robot has a task.</summary>
static class WorkObjects
{
    /// <summary>Width of the belt; thickness of belt and fixture, m.</summary>
    const float Width = 0.05f, Thickness = 0.01f;

    /// <summary>Number of points on each straight section of the belt.</summary>
    const int PointsPerSection = 2;

    public static GameObject Build(PackageAssets assets, MrilSession session, RobotModel robot)
    {
        var work = new CellWork(robot, new PickAndPlaceMotion(robot));
        var (virtualPart, workpiece) = (assets.Load<Material>(PackagePaths.Hologram), assets.Load<Material>(PackagePaths.Workpiece));
        var uncompensated = assets.Load<Material>(PackagePaths.Ghost);
        var root = new GameObject("Cell Objects");
        var conveyor = Shown<StationaryObject>(CellWork.Conveyor, CellWork.Conveyor, root, session, virtualPart);
        AddBelt(conveyor, work, virtualPart);
        var fixture = Shown<StationaryObject>(work.Robots[0].Fixture, work.Robots[0].Fixture, root, session, virtualPart);
        var below = RigidTransform.FromXyzRpy(0, 0, -Thickness / 2, 0, 0, 0);
        AddCube(fixture, "Plate", below, new Vector3(2 * Width, Thickness, 2 * Width), virtualPart);
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

    // Adds no text, because six texts would hide the objects. The status panel names the objects that are not current.
    static GameObject Shown<T>(string name, string frame, GameObject parent, MrilSession session, Material substitute)
        where T : Component
    {
        var made = new GameObject(name);
        made.transform.SetParent(parent.transform, worldPositionStays: false);
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

    // Draws straight sections between points on the upper side of the belt.
    static void AddBelt(GameObject conveyor, CellWork work, Material material)
    {
        var points = work.BeltBehind(0).Select(point => work.ConveyorPose.Inverse * point).Where((_, i) => i % PointsPerSection == 0).ToArray();
        for (var i = 1; i < points.Length; i++)
        {
            var (from, to) = (points[i - 1], points[i]);
            var (x, y, z) = (to.X - from.X, to.Y - from.Y, to.Z - from.Z);
            var length = Math.Sqrt(x * x + y * y + z * z);
            var middle = RigidTransform.FromXyzRpy(
                from.X + x / 2, from.Y + y / 2, from.Z + z / 2 - Thickness / 2, 0, -Math.Asin(z / length), Math.Atan2(y, x));
            AddCube(conveyor, "Section " + i, middle, new Vector3(Width, Thickness, (float)length), material);
        }
    }

    /// <param name="pose">Pose in the parent's frame, in right-handed coordinates.</param>
    /// <param name="size">Size in metres along Unity's axes: right, up, forward.</param>
    static void AddCube(GameObject parent, string name, in RigidTransform pose, Vector3 size, Material material)
    {
        var cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
        cube.name = name;
        cube.transform.SetParent(parent.transform, worldPositionStays: false);
        var place = UnityPoses.ToWorld(pose);
        cube.transform.localPosition = place.position;
        cube.transform.localRotation = place.rotation;
        cube.transform.localScale = size;
        cube.GetComponent<MeshRenderer>().sharedMaterial = material;
    }
}
