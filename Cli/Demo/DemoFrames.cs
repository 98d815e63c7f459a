using Nowpose.Cli.Messages;
using Nowpose.Latency;
using Nowpose.Session;
using Nowpose.Simulation;

namespace Nowpose.Cli.Demo;

/// <summary>The displayed values of all frames. Written during the run without allocations, read afterwards.</summary>
sealed class DemoFrames
{
    readonly int _joints;
    readonly List<double> _displayed;
    readonly List<double> _held;

    /// <param name="capacity">Expected number of frames; more are accepted.</param>
    public DemoFrames(int joints, int capacity)
    {
        _joints = joints;
        _displayed = new List<double>(joints * capacity);
        _held = new List<double>(joints * capacity);
        Rows = new List<Row>(capacity);
    }

    public List<Row> Rows { get; }

    /// <param name="displayed">Displayed joint positions; empty before the robot is known.</param>
    /// <param name="held">Joint positions as shown by a headset without compensation; empty before the robot is known.</param>
    public void Add(ReadOnlySpan<double> displayed, ReadOnlySpan<double> held, in Row row)
    {
        Rows.Add(row);
        for (var joint = 0; joint < _joints; joint++)
        {
            _displayed.Add(displayed.IsEmpty ? 0 : displayed[joint]);
            _held.Add(held.IsEmpty ? 0 : held[joint]);
        }
    }

    /// <summary>Gets the name of the first frame with a value that is not finite; null if there is none.</summary>
    public string FirstNotFinite()
    {
        for (var frame = 0; frame < Rows.Count; frame++)
        {
            if (!Rows[frame].Tool.IsFinite) return DemoMessages.ToolNotFinite(frame);
            if (!Rows[frame].HeldTool.IsFinite) return DemoMessages.GhostNotFinite(frame);
            for (var joint = 0; joint < _joints; joint++)
                if (!double.IsFinite(_displayed[frame * _joints + joint] + _held[frame * _joints + joint]))
                    return DemoMessages.JointNotFinite(frame, joint);
            if (Rows[frame].Clock.IsKnown && !double.IsFinite(Rows[frame].OffsetErrorUs)) return DemoMessages.ClockNotFinite(frame);
        }
        return null;
    }

    /// <summary>Gets one joint's displayed position.</summary>
    public double Displayed(int frame, int joint) => _displayed[frame * _joints + joint];

    /// <summary>Gets one joint's position as shown by a headset without compensation.</summary>
    public double Held(int frame, int joint) => _held[frame * _joints + joint];

    /// <param name="Elapsed">Time since the session was started.</param>
    /// <param name="TrueLight">True control time of the frame's light.</param>
    /// <param name="AssumedLight">The runtime's estimate of the same; null before it has a control time.</param>
    /// <param name="Clock">The runtime's clock model at the frame's start.</param>
    /// <param name="OffsetErrorUs">Estimated minus true offset, µs; NaN while unknown.</param>
    /// <param name="Tool">Position of the tool in the scene.</param>
    /// <param name="HeldTool">Position of the tool of the scene's uncompensated ghost.</param>
    /// <param name="Range">The runtime's range state.</param>
    /// <param name="Rendered">The frame's timing in the display pipeline; all zero without a load.</param>
    /// <param name="Delay">Delay of the frame's start after the time requested by the display, because this machine was busy.</param>
    public readonly record struct Row(
        TimeSpan Elapsed, HeadsetTime Start, ControlTime TrueLight, ControlTime? AssumedLight, ClockModel Clock,
        PoseState State, double OffsetErrorUs, ToolPosition Tool, ToolPosition HeldTool, double CpuUs, long AllocatedBytes,
        RangeState Range = RangeState.Unknown, PipelineFrame Rendered = default, TimeSpan Delay = default);
}
