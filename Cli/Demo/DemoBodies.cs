using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Simulation.Work;

namespace Nowpose.Cli.Demo;

/// <summary>The displayed poses of the cell's objects in all frames. Written during the run, read afterwards.</summary>
sealed class DemoBodies
{
    readonly ForwardKinematics _kinematics;
    readonly RobotModel _robot;
    readonly RigidTransform[] _heldLinks;
    readonly IReadOnlyList<string> _names;
    readonly FrameTransform?[] _newest;
    readonly List<Shown> _shown = [];
    CompensationSession _followed;

    public DemoBodies(RobotModel robot, CellWork work)
    {
        _names = work.Names;
        _newest = new FrameTransform?[_names.Count];
        _robot = robot;
        _kinematics = new ForwardKinematics(robot);
        _heldLinks = new RigidTransform[robot.Links.Count];
    }

    /// <summary>Gets what a frame showed of an object; the default before its first sample.</summary>
    public Shown At(int frame, int body) => _shown[frame * _names.Count + body];

    /// <summary>Gets whether samples of all objects had arrived.</summary>
    public bool AreKnown(int frame) => Enumerable.Range(0, _names.Count).All(body => At(frame, body).IsKnown);

    /// <summary>Shows the objects in a session from now on.</summary>
    public void Follow(CompensationSession session)
    {
        if (session == null || session == _followed) return;
        _followed = session;
        Array.Clear(_newest);
        session.Frames.Judged += Take;
        for (var body = 0; body < _names.Count; body++) session.Frames.Need(_names[body]);
    }

    /// <summary>Records the objects in the newest frame.</summary>
    /// <param name="frame">Null before the robot is known.</param>
    public void Add(DisplayFrame frame)
    {
        if (frame != null) _kinematics.Compute(frame.HeldJoints, _heldLinks);
        for (var body = 0; body < _names.Count; body++)
        {
            var found = frame == null ? null : _followed?.Frames.Find(_names[body]);
            _shown.Add(found == null || HeldOf(body) is not { } held ? default : new Shown(true, found.World, held, found.Parent));
        }
    }

    // A display without compensation shows the newest sample in its parent, which is a link of the held robot or stationary.
    RigidTransform? HeldOf(int body)
    {
        if (_newest[body] is not { } sample) return null;
        var link = _robot.IndexOfLink(sample.Parent);
        var parent = link >= 0 ? _heldLinks[link] : _followed.Frames.Find(sample.Parent)?.World;
        return parent is { } pose ? pose * sample.ToPose() : null;
    }

    void Take(in FrameTransform pose, bool isStationary, HeadsetTime arrival, DropReason reason)
    {
        if (reason != DropReason.None) return;
        for (var body = 0; body < _newest.Length; body++)
            if (pose.Child == _names[body] && !(pose.Stamp <= _newest[body]?.Stamp)) _newest[body] = pose;
    }

    /// <param name="IsKnown">Whether a sample had arrived.</param>
    /// <param name="Displayed">Pose of the object in the robot's base frame.</param>
    /// <param name="Held">The same without compensation.</param>
    /// <param name="Parent">Parent of the displayed pose.</param>
    public readonly record struct Shown(bool IsKnown, RigidTransform Displayed, RigidTransform Held, string Parent);
}
