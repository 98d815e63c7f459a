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

    /// <param name="displayed">Joint positions as displayed.</param>
    /// <param name="held">Joint positions as a headset without compensation would have shown them.</param>
    public void Add(ReadOnlySpan<double> displayed, ReadOnlySpan<double> held, in Row row)
    {
        Rows.Add(row);
        foreach (var joint in displayed) _displayed.Add(joint);
        foreach (var joint in held) _held.Add(joint);
    }

    /// <summary>Names the first frame that holds something that is no number; null when none does.</summary>
    public string FirstNotFinite()
    {
        for (var frame = 0; frame < Rows.Count; frame++)
        {
            var tool = Rows[frame].Tool;
            if (!double.IsFinite(tool.X + tool.Y + tool.Z)) return $"frame {frame}: the displayed tool is not at a finite position";
            for (var joint = 0; joint < _joints; joint++)
                if (!double.IsFinite(_displayed[frame * _joints + joint] + _held[frame * _joints + joint]))
                    return $"frame {frame}: moving joint {joint} is not at a finite position";
            if (Rows[frame].Clock.IsKnown && !double.IsFinite(Rows[frame].OffsetErrorUs)) return $"frame {frame}: the clock offset is not finite";
        }
        return null;
    }

    /// <summary>One joint's displayed position.</summary>
    public double Displayed(int frame, int joint) => _displayed[frame * _joints + joint];

    /// <summary>One joint's position as a headset without compensation would have shown it.</summary>
    public double Held(int frame, int joint) => _held[frame * _joints + joint];

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
