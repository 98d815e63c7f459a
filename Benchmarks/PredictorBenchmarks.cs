using BenchmarkDotNet.Attributes;
using MathNet.Numerics;
using Nowpose.Benchmarks.Comparison;
using Nowpose.Prediction;

namespace Nowpose.Benchmarks;

/// <summary>Measures the cost of each compared predictor for one joint with a sample every 50 ms.</summary>
public class PredictorBenchmarks
{
    const int Frames = 64;
    const int Joint = 0;

    readonly double[] _horizons = [.. Enumerable.Range(0, Frames).Select(frame => 0.1 + 0.05 * frame / Frames)];
    SampledJoint _joint;
    int _next;

    public static IEnumerable<string> Names => ComparedPredictors.All.Select(candidate => candidate.Name);

    [ParamsSource(nameof(Names))]
    public string Predictor { get; set; }

    [GlobalSetup]
    public void Prepare()
    {
        // With several threads, MathNet takes ten times as long for three equations.
        Control.UseSingleThread();
        _joint = new SampledJoint(ComparedPredictors.Named(Predictor).Create(), Joint, VirtualSession.SampleSeconds);
    }

    [Benchmark(Description = "Predictor: a sample of one joint")]
    public DropReason Add() => _joint.Add();

    [Benchmark(Description = "Predictor: a frame of one joint")]
    public double At()
    {
        _next = (_next + 1) % Frames;
        return _joint.At(_horizons[_next]);
    }
}
