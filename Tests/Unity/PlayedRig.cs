using Nowpose.Kinematics;
using Nowpose.Unity;
using UnityEngine;

namespace Nowpose.Unity.Tests;

/// <summary>A rig with materials below a running session.</summary>
sealed class PlayedRig : IDisposable
{
    public PlayedRig()
    {
        Cell = new PlayedCell();
        Session = Cell.NewSession();
        var material = new Material((Shader)null);
        Rig = Below<RobotRig>("Robot", Session.transform).With("_armMaterial", material).With("_toolMaterial", material);
    }

    public PlayedCell Cell { get; }
    public MrilSession Session { get; }
    public RobotRig Rig { get; }

    public Ghost NewGhost()
    {
        var ghost = Below<Ghost>("Ghost", Session.transform);
        ghost.GetComponent<RobotRig>().With("_shows", RigPose.Held);
        return ghost;
    }

    public void Play(double seconds = 5)
    {
        Session.gameObject.SetActive(true);
        Cell.Run(seconds, Session);
    }

    public Vector3 ToolOf(ReadOnlySpan<double> joints)
    {
        var poses = new RigidTransform[Session.Robot.Links.Count];
        new ForwardKinematics(Session.Robot).Compute(joints, poses);
        var tool = UnityFrame.ToUnity(poses[Session.Robot.IndexOfLink(Session.Robot.ToolLink.Name)]);
        return Rig.transform.TransformPoint(new Vector3((float)tool.X, (float)tool.Y, (float)tool.Z));
    }

    public static T Below<T>(string name, Transform parent) where T : Component
    {
        var made = new GameObject(name);
        made.transform.SetParent(parent, false);
        return made.AddComponent<T>();
    }

    public void Dispose() => Cell.Dispose();
}
