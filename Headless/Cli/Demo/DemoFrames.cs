using Nowpose.Session;

namespace Nowpose.Cli.Demo;

/// <summary>What was displayed, frame after frame, as numbers: written while the run lasts without disturbing it, read afterwards.</summary>
sealed class DemoFrames
{
    readonly int _joints;
    readonly List<double> _displayed;
    readonly List<double> _held;

    /// <param name="capacity">Frames expected; more are taken too.</param>
    public DemoFrames(int joints, int capacity)
    {
        _joints = joints;
        _displayed = new List<double>(joints * capacity);
        _held = new List<double>(joints * capacity);
        Rows = new List<Row>(capacity);
    }

    public List<Row> Rows { get; }

    public void Add(DisplayFrame frame, in Row row)
    {
        Rows.Add(row);
        foreach (var joint in frame.Joints) _displayed.Add(joint);
        foreach (var joint in frame.HeldJoints) _held.Add(joint);
    }

    /// <summary>One joint's displayed position.</summary>
    public double Displayed(int frame, int joint) => _displayed[frame * _joints + joint];

    /// <summary>All joints as a headset without compensation would have shown them.</summary>
    public void CopyHeld(int frame, Span<double> into) =>
        System.Runtime.InteropServices.CollectionsMarshal.AsSpan(_held).Slice(frame * _joints, _joints).CopyTo(into);

    /// <param name="Elapsed">Since the session was started.</param>
    /// <param name="TrueLight">True control time of the frame's light.</param>
    /// <param name="AssumedLight">The runtime's; null before it knows a control time.</param>
    /// <param name="Clock">The runtime's model at the frame's start.</param>
    /// <param name="OffsetErrorUs">Estimated minus true offset, µs; NaN while unknown.</param>
    /// <param name="Tool">Displayed position of the tool, metres in the base frame.</param>
    public readonly record struct Row(
        TimeSpan Elapsed, HeadsetTime Start, ControlTime TrueLight, ControlTime? AssumedLight, ClockModel Clock,
        PoseState State, double OffsetErrorUs, ToolPosition Tool, double CpuUs, long AllocatedBytes);
}
