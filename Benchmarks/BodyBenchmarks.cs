using BenchmarkDotNet.Attributes;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Prediction;

namespace Nowpose.Benchmarks;

/// <summary>Measures one tracked frame with the default predictor and a sample every 20 ms.</summary>
public class BodyBenchmarks
{
    const int Frames = 64;
    const double Interval = 0.02;

    readonly double[] _horizons = [.. Enumerable.Range(0, Frames).Select(frame => 0.1 + Interval * frame / Frames)];
    BodyPredictor _predictor;
    long _samples;
    int _next;

    [GlobalSetup]
    public void Prepare()
    {
        _predictor = new BodyPredictor(Predictors.Default, new PredictionLimits());
        // Adds two minutes of samples, which fill the history of template matching.
        for (var k = 0; k < 6000; k++) Add();
    }

    [Benchmark(Description = "Sample: one tracked frame, adaptive, every 20 ms")]
    public DropReason Add()
    {
        var t = ++_samples * Interval;
        var rotation = UnitQuaternion.Exp(new Vector3D(0.3 * Math.Sin(1.3 * t), 0.2 * Math.Cos(2.1 * t), 0.5 * Math.Sin(0.7 * t)));
        var position = new Vector3D(0.2 * Math.Sin(1.1 * t), 0.3 * Math.Cos(1.7 * t), 0.1 * Math.Sin(3.1 * t));
        return _predictor.Add(new PoseSample(t, position, rotation), t + 0.11);
    }

    [Benchmark(Description = "Frame: one tracked frame, adaptive")]
    public double At()
    {
        _next = (_next + 1) % Frames;
        return _predictor.At(_samples * Interval + _horizons[_next]).X;
    }
}
