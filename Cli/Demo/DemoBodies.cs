using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Session;
using Nowpose.Simulation.Work;

namespace Nowpose.Cli.Demo;

/// <summary>The displayed poses of the cell's objects in all frames. Written during the run, read afterwards.</summary>
sealed class DemoBodies(CellWork work)
{
    readonly IReadOnlyList<string> _names = work.Names;
    readonly List<Shown> _shown = [];
    CompensationSession _followed;

    /// <summary>Gets what a frame showed of an object; the default before its first sample.</summary>
    public Shown At(int frame, int body) => _shown[frame * _names.Count + body];

    /// <summary>Gets whether samples of all objects had arrived.</summary>
    public bool AreKnown(int frame) => Enumerable.Range(0, _names.Count).All(body => At(frame, body).IsKnown);

    /// <summary>Shows the objects in a session from now on.</summary>
    public void Follow(CompensationSession session)
    {
        if (session == null || session == _followed) return;
        _followed = session;
        foreach (var name in _names) session.Frames.Need(name);
        // Also requested, because the objects stand there later.
        session.Frames.Need(CellWork.Conveyor);
        foreach (var robot in work.Robots) session.Frames.Need(robot.Fixture);
    }

    /// <summary>Records the objects in the newest frame.</summary>
    /// <param name="frame">Null before the robot is known.</param>
    public void Add(DisplayFrame frame)
    {
        foreach (var name in _names)
        {
            var tree = frame == null ? null : _followed?.Frames.Tree;
            var index = tree == null ? -1 : tree.IndexOf(name);
            _shown.Add(index < 0 || tree[index].State == FrameState.Missing ? default
                : new Shown(true, tree[index].World, tree.HeldOf(index), tree[index].Parent));
        }
    }

    /// <param name="IsKnown">Whether a sample had arrived.</param>
    /// <param name="Displayed">Pose of the object in the robot's base frame.</param>
    /// <param name="Held">The same without compensation.</param>
    /// <param name="Parent">Parent of the displayed pose.</param>
    public readonly record struct Shown(bool IsKnown, RigidTransform Displayed, RigidTransform Held, string Parent);
}
