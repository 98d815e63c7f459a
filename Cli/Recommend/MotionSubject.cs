using Nowpose.Cli.Replay;
using Nowpose.Gateway.MotionRecordings;

namespace Nowpose.Cli.Recommend;

/// <summary>A recorded motion that is sampled and delayed as in <c>replay</c>.</summary>
sealed class MotionSubject : ISubject
{
    const double MsPerSecond = 1000;

    /// <summary>
    /// Number of phases unless the recording is too long. With one phase, the samples have only three different ages in the frames, at 60 fps and
    /// a sampling interval of 50 ms.
    /// </summary>
    const int MaxPhases = 5;

    readonly string _path;
    readonly MotionRecording _motion;
    readonly long _middle;

    public MotionSubject(string path, MotionRecording motion, double samplingMs, double latencyMs)
    {
        _path = path;
        _motion = motion;
        SamplingMs = samplingMs;
        LatencyMs = latencyMs;
        _middle = Ticks.Of(motion.Times[MotionHalves.MiddleOf(WaysOf(motion))]);
        Phases = Math.Clamp(ReplayLoop.MaxPhases(motion.Duration, motion.Names.Count, Settings(null, null, 1)), 1, MaxPhases);
    }

    public double? SamplingMs { get; }

    public double? LatencyMs { get; }

    public double? Fps { get; } = new ReplaySettings().FrameRateHz;

    public int? Phases { get; }

    public Trial Try(string predictor, double? blendMs, CancellationToken cancellation)
    {
        var halves = new HalfErrors(ReplayRun.AxesOf(_motion));
        new ReplayRun(_path, _motion, Settings(predictor, blendMs, Phases.Value))
            .Score(value => halves.Add(value.Ticks <= _middle ? Half.First : Half.Second, value), cancellation: cancellation);
        return halves.Trial(_path, predictor, cancellation);
    }

    ReplaySettings Settings(string predictor, double? blendMs, int phases) => new()
    {
        SamplingInterval = SamplingMs.Value / MsPerSecond, Latency = LatencyMs.Value / MsPerSecond, Predictor = predictor,
        Blend = blendMs / MsPerSecond, Phases = phases, FrameRateHz = Fps.Value,
    };

    static double[] WaysOf(MotionRecording motion)
    {
        var ways = new double[motion.Times.Count - 1];
        for (var joint = 0; joint < motion.Names.Count; joint++)
        {
            var positions = motion.PositionsOf(joint);
            for (var i = 0; i < ways.Length; i++) ways[i] += Math.Abs(positions[i + 1] - positions[i]);
        }
        return ways;
    }
}
