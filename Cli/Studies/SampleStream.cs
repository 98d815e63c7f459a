using Nowpose.Prediction;
using Nowpose.Simulation;

namespace Nowpose.Cli.Studies;

/// <summary>Samples a motion and delivers each sample to a predictor after its delay.</summary>
sealed class SampleStream(AxisMotion motion, StudySettings settings, Random random)
{
    readonly PriorityQueue<JointSample, (double, int)> _underWay = new();
    readonly double _firstSample = random.NextDouble() * settings.SamplingInterval;
    int _next;
    double _newestArrival = double.NegativeInfinity;

    /// <param name="displayed">Newest displayed time, s; NaN before the first frame.</param>
    public void Deliver(double until, JointPredictor predictor, double displayed)
    {
        while (_firstSample + _next * settings.SamplingInterval - settings.SamplingJitter - settings.StampedJitter + settings.Latency <= until)
            Send(_next++);
        while (_underWay.TryPeek(out var sample, out var arrival) && arrival.Item1 <= until)
        {
            _underWay.Dequeue();
            predictor.Add(sample, displayed);
        }
    }

    // Draws the same number of random values for each sample, so that changing one condition does not change the random values of another.
    void Send(int index)
    {
        var stamp = _firstSample + index * settings.SamplingInterval + settings.StampedJitter * Uniform();
        var time = stamp + settings.SamplingJitter * Uniform();
        var stated = stamp + settings.StampError * Uniform();
        var noise = settings.Noise * random.NextNormal();
        var delay = Math.Min(settings.DelayMaximum, settings.DelayMedian * Math.Exp(random.NextNormal()));
        _newestArrival = Math.Max(_newestArrival, time + settings.Latency);
        if (random.NextDouble() < settings.Loss) return;
        var sample = new JointSample(
            stated, motion.At(time) + noise, time, settings.HasVelocity ? motion.VelocityAt(time) : double.NaN,
            settings.HasAcceleration ? motion.AccelerationAt(time) : double.NaN);
        _underWay.Enqueue(sample, (_newestArrival + delay, index));
    }

    double Uniform() => 2 * random.NextDouble() - 1;
}
