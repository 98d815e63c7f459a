using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Session;
using Nowpose.Simulation.Work;

namespace Nowpose.Cli.Demo;

/// <summary>Stores the displayed poses of the cell's objects for every frame. Filled during the run, read after it.</summary>
sealed class DemoBodies(CellWork work)
{
    readonly IReadOnlyList<string> _names = work.Names;
    readonly List<Shown> _shown = [];
    CompensationSession _followed;

    public CellWork Work => work;

    /// <summary>Gets the displayed values of an object in a frame; <c>default</c> before the object's first sample.</summary>
    public Shown At(int frame, int body) => _shown[frame * _names.Count + body];

    /// <summary>Gets whether samples of all objects had arrived before a frame.</summary>
    public bool AreKnown(int frame) => Enumerable.Range(0, _names.Count).All(body => At(frame, body).IsKnown);

    /// <summary>Gets the message about the first pose that is not finite; null if all are finite.</summary>
    public string FirstNotFinite()
    {
        for (var i = 0; i < _shown.Count; i++)
        {
            var (frame, name) = (i / _names.Count, _names[i % _names.Count]);
            if (!IsFinite(_shown[i].Displayed)) return DemoMessages.BodyNotFinite(frame, name);
            if (!IsFinite(_shown[i].Held)) return DemoMessages.GhostBodyNotFinite(frame, name);
        }

        return null;
    }

    /// <summary>Requests the frames of all objects in a session and records them from now on.</summary>
    public void Follow(CompensationSession session)
    {
        if (session == null || session == _followed) return;
        _followed = session;
        foreach (var name in _names) session.Frames.Need(name);
        // Also requests the conveyor and the fixtures, because they later become parents of the objects.
        session.Frames.Need(CellWork.Conveyor);
        foreach (var robot in work.Robots) session.Frames.Need(robot.Fixture);
    }

    /// <summary>Records the poses of all objects in the newest frame.</summary>
    /// <param name="frame">The frame; null before the robot is known.</param>
    public void Add(DisplayFrame frame)
    {
        foreach (var name in _names)
        {
            var tree = frame == null ? null : _followed?.Frames.Tree;
            var index = tree == null ? -1 : tree.IndexOf(name);
            Add(index < 0 || tree[index].State == FrameState.Missing ? default
                : new Shown(true, tree[index].World, tree.HeldOf(index), tree[index].Parent));
        }
    }

    /// <summary>Records the pose of the next object.</summary>
    internal void Add(in Shown shown) => _shown.Add(shown);

    static bool IsFinite(in RigidTransform pose) => Array.TrueForAll(pose.ToRowMajor16(), double.IsFinite);

    /// <param name="IsKnown">Whether a pose of the object had arrived before the frame.</param>
    /// <param name="Displayed">Displayed pose of the object in the frame world.</param>
    /// <param name="Held">Pose of the object in the frame world without compensation.</param>
    /// <param name="Parent">Parent frame of the displayed pose.</param>
    public readonly record struct Shown(bool IsKnown, RigidTransform Displayed, RigidTransform Held, string Parent);
}
