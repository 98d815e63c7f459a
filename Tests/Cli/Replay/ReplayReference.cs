using MathNet.Numerics;

namespace Nowpose.Headless.Tests.Cli.Replay;

/// <summary>A second, slow implementation of <c>replay</c>, with decimal times, another library for the fit and no virtual time.</summary>
/// <remarks>Does not support loss, jitter or stamp errors, because they depend on the random number generator of <c>replay</c>.</remarks>
sealed class ReplayReference
{
    const int Tick = 7;

    readonly List<double>[] _held;
    readonly List<double>[] _predicted;

    public ReplayReference(MotionFile motion, decimal samplingMs, decimal latencyMs, decimal fps,
        int degree, int history, decimal latencyErrorMs)
    {
        var (interval, latency, end) = (samplingMs / 1000, latencyMs / 1000, Math.Round(motion.Times[^1], Tick));
        _held = [.. Enumerable.Range(0, motion.Joints).Select(_ => new List<double>())];
        _predicted = [.. Enumerable.Range(0, motion.Joints).Select(_ => new List<double>())];
        var samples = new List<decimal>();
        for (var k = 0; Math.Round(k * interval, Tick) <= end; k++) samples.Add(k * interval);

        for (var i = 0; Math.Round(i / fps, Tick) <= end; i++)
        {
            var frame = i / fps;
            var arrived = samples.Where(t => Math.Round(t + latency, Tick) <= Math.Round(frame, Tick)).ToArray();
            if (arrived.Length < 5) continue;
            Score(motion, arrived, frame, frame + latencyErrorMs / 1000, degree, history);
        }
    }

    public int Frames => _held[0].Count;

    public double RmsHold(int joint) => Rms(_held[joint]);

    public double Rms(int joint) => Rms(_predicted[joint]);

    public double Max(int joint) => _predicted[joint].Max(Math.Abs);

    /// <summary>Returns the 95th percentile as defined by numpy: linear interpolation between the sorted values.</summary>
    public double P95(int joint)
    {
        var sorted = _predicted[joint].Select(Math.Abs).Order().ToArray();
        var rank = 0.95m * (sorted.Length - 1);
        var below = (int)Math.Floor(rank);
        return below + 1 == sorted.Length
            ? sorted[below]
            : sorted[below] + (double)(rank - below) * (sorted[below + 1] - sorted[below]);
    }

    void Score(MotionFile motion, decimal[] arrived, decimal frame, decimal asked, int degree, int history)
    {
        var newest = arrived[^1];
        var used = arrived.TakeLast(history + 1).ToArray();
        var times = used.Select(t => (double)(t - newest)).ToArray();
        var truth = motion.At(frame);
        for (var joint = 0; joint < motion.Joints; joint++)
        {
            var positions = used.Select(t => motion.At(t)[joint]).ToArray();
            var predicted = degree == 0
                ? positions[^1]
                : Polynomial.Evaluate((double)(asked - newest), Fit.Polynomial(times, positions, degree));
            _held[joint].Add(positions[^1] - truth[joint]);
            _predicted[joint].Add(predicted - truth[joint]);
        }
    }

    static double Rms(List<double> errors) => Math.Sqrt(errors.Sum(e => e * e) / errors.Count);
}
