using Nowpose.Latency;
using Nowpose.Session;
using Nowpose.Simulation;

namespace Nowpose.Cli.Demo;

/// <summary>Stores the displayed values of all frames. Filled during the run without allocations, read after it.</summary>
sealed class DemoFrames
{
    const double MinLateMs = 0.5 * 1000 / DemoDisplay.FramesPerSecond;

    readonly int _joints;
    readonly List<double> _displayed;
    readonly List<double> _held;

    /// <param name="capacity">Expected number of frames. More frames can be added.</param>
    public DemoFrames(int joints, int capacity)
    {
        _joints = joints;
        _displayed = new List<double>(joints * capacity);
        _held = new List<double>(joints * capacity);
        Rows = new List<Row>(capacity);
    }

    public List<Row> Rows { get; }

    /// <param name="displayed">Displayed joint positions; empty before the robot is known.</param>
    /// <param name="held">Joint positions without compensation; empty before the robot is known.</param>
    public void Add(ReadOnlySpan<double> displayed, ReadOnlySpan<double> held, in Row row)
    {
        Rows.Add(row);
        for (var joint = 0; joint < _joints; joint++)
        {
            _displayed.Add(displayed.IsEmpty ? 0 : displayed[joint]);
            _held.Add(held.IsEmpty ? 0 : held[joint]);
        }
    }

    /// <summary>Gets the name of the first value that is not finite, with its frame; null if all are finite.</summary>
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

    /// <summary>Gets the frames after the warm-up that this machine started late, by half a frame interval or more.</summary>
    /// <remarks>A late frame shows the pose for its actual start time. Samples and sync exchanges can also be late; this is not measured.</remarks>
    public LateFrames Late()
    {
        var warm = Rows.Where(row => row.Elapsed >= DemoScore.WarmUp).ToList();
        var delays = warm.Select(row => row.Delay.TotalMilliseconds).Where(delay => delay > MinLateMs).ToList();
        return new LateFrames(delays.Count, warm.Count, delays.DefaultIfEmpty().Max());
    }

    /// <summary>Gets the displayed position of a joint.</summary>
    public double Displayed(int frame, int joint) => _displayed[frame * _joints + joint];

    /// <summary>Gets the position of a joint without compensation.</summary>
    public double Held(int frame, int joint) => _held[frame * _joints + joint];

    /// <param name="Elapsed">Time since the start of the session.</param>
    /// <param name="TrueLight">True display time of the frame, in control time.</param>
    /// <param name="AssumedLight">The runtime's estimate of the display time; null while the control time is unknown.</param>
    /// <param name="Clock">The runtime's clock model at the start of the frame.</param>
    /// <param name="OffsetErrorUs">Estimated minus true offset, µs; NaN while unknown.</param>
    /// <param name="Tool">Displayed position of the tool, in the base frame of the robot.</param>
    /// <param name="HeldTool">Position of the tool without compensation, in the base frame of the robot. It comes from the scene's ghost.</param>
    /// <param name="Range">The runtime's state relative to the constant-latency range.</param>
    /// <param name="Rendered">Timing of the frame in the display pipeline; all values are 0 without a load.</param>
    /// <param name="Delay">Time by which this machine started the frame too late because it was busy.</param>
    public readonly record struct Row(
        TimeSpan Elapsed, HeadsetTime Start, ControlTime TrueLight, ControlTime? AssumedLight, ClockModel Clock,
        PoseState State, double OffsetErrorUs, ToolPosition Tool, ToolPosition HeldTool, double CpuUs, long AllocatedBytes,
        RangeState Range = RangeState.Unknown, PipelineFrame Rendered = default, TimeSpan Delay = default);
}

/// <summary>The frames of a run that this machine started late.</summary>
/// <param name="All">Number of all frames among which they were counted.</param>
/// <param name="MaxMs">Maximum delay, ms; 0 without late frames.</param>
readonly record struct LateFrames(int Count, int All, double MaxMs)
{
    /// <summary>Share above which late frames are reported. A smaller share does not change the results.</summary>
    const double MinShare = 0.01;

    public bool AreMany => Count > MinShare * All;
}
