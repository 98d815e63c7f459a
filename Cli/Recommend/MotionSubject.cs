using Nowpose.Cli.Messages;
using Nowpose.Cli.Replay;
using Nowpose.Gateway.MotionRecordings;

namespace Nowpose.Cli.Recommend;

/// <summary>A recorded motion that is sampled and delayed as in <c>replay</c>.</summary>
sealed class MotionSubject : ISubject
{
    const double MsPerSecond = 1000;

    readonly string _path;
    readonly MotionRecording[] _halves;

    /// <exception cref="InputException">The recording cannot be divided into two halves.</exception>
    public MotionSubject(string path, MotionRecording motion, double samplingMs, double latencyMs)
    {
        _path = path;
        SamplingMs = samplingMs;
        LatencyMs = latencyMs;
        var middle = motion.Times[MotionHalves.MiddleOf(WaysOf(motion))];
        _halves = [motion.Between(0, middle), motion.Between(middle, motion.Duration)];
        if (_halves.Any(half => half == null))
            throw new InputException(RecommendMessages.TooFewRows(path));
    }

    public double? SamplingMs { get; }

    public double? LatencyMs { get; }

    public ReplayResult Try(string predictor, Half half, double? blendMs, CancellationToken cancellation)
    {
        var settings = new ReplaySettings
        {
            SamplingInterval = SamplingMs.Value / MsPerSecond, Latency = LatencyMs.Value / MsPerSecond, Predictor = predictor,
            Blend = blendMs / MsPerSecond,
        };
        return new ReplayRun(_path, _halves[(int)half], settings).Run(cancellation: cancellation);
    }

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
