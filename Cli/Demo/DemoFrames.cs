using Nowpose.Latency;
using Nowpose.Session;
using Nowpose.Simulation;

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

    /// <param name="displayed">Joint positions as displayed; empty before there is a robot.</param>
    /// <param name="held">Joint positions as a headset without compensation would have shown them; empty before there is a robot.</param>
    public void Add(ReadOnlySpan<double> displayed, ReadOnlySpan<double> held, in Row row)
    {
        Rows.Add(row);
        for (var joint = 0; joint < _joints; joint++)
        {
            _displayed.Add(displayed.IsEmpty ? 0 : displayed[joint]);
            _held.Add(held.IsEmpty ? 0 : held[joint]);
        }
    }

    /// <summary>Names the first frame that holds something that is no number; null when none does.</summary>
    public string FirstNotFinite()
    {
        for (var frame = 0; frame < Rows.Count; frame++)
        {
            if (!Rows[frame].Tool.IsFinite) return $"frame {frame}: the displayed tool is not at a finite position";
            if (!Rows[frame].HeldTool.IsFinite) return $"frame {frame}: the ghost's tool is not at a finite position";
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

    /// <param name="Elapsed">Since the session was started.</param>
    /// <param name="TrueLight">True control time of the frame's light.</param>
    /// <param name="AssumedLight">The runtime's; null before it knows a control time.</param>
    /// <param name="Clock">The runtime's model at the frame's start.</param>
    /// <param name="OffsetErrorUs">Estimated minus true offset, µs; NaN while unknown.</param>
    /// <param name="Tool">Where the scene shows the tool.</param>
    /// <param name="HeldTool">Where the scene's ghost, which is not compensated, shows it.</param>
    /// <param name="Range">As the runtime judged it.</param>
    /// <param name="Rendered">How the frame passed through the display; all zero without a load.</param>
    /// <param name="Delay">How much later it began than the display asked for it: this machine had no time for it.</param>
    public readonly record struct Row(
        TimeSpan Elapsed, HeadsetTime Start, ControlTime TrueLight, ControlTime? AssumedLight, ClockModel Clock,
        PoseState State, double OffsetErrorUs, ToolPosition Tool, ToolPosition HeldTool, double CpuUs, long AllocatedBytes,
        RangeState Range = RangeState.Unknown, PipelineFrame Rendered = default, TimeSpan Delay = default);
}
