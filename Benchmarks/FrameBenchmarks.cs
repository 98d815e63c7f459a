using BenchmarkDotNet.Attributes;
using MathNet.Numerics;
using Nowpose.Kinematics;
using Nowpose.Prediction;
using Nowpose.Session;

namespace Nowpose.Benchmarks;

/// <summary>
/// Measures one frame of the seven-joint arm, 75 to 125 ms after the newest sample. The naive method for comparison solves Schnierle &amp;
/// Röck 2022, Eq. (8), for each joint in each frame, without kinematics. By default, MathNet solves even three equations on several
/// threads. Most of the naive method's time is the cost of these threads, which is several times higher while other programs run.
/// </summary>
public class FrameBenchmarks
{
    const int Samples = 3;
    const int Frames = 64;

    readonly VirtualSession _virtual = new();
    readonly ForwardKinematics _kinematics = new(SevenJointArm.Model);
    readonly RigidTransform[] _linkPoses = new RigidTransform[SevenJointArm.Model.Links.Count];
    readonly JointPredictor[] _predictors = VirtualSession.CreatePredictors();
    readonly double[] _positions = new double[SevenJointArm.JointNames.Length];

    // Data of the naive method: the newest samples, oldest first. Times are relative to the newest sample.
    readonly double[] _sampleTimes = [-2 * VirtualSession.SampleSeconds, -VirtualSession.SampleSeconds, 0];
    readonly double[][] _samplesOfJoint = [.. SevenJointArm.JointNames.Select(_ => new double[Samples])];

    readonly HeadsetTime[] _starts = new HeadsetTime[Frames];
    readonly double[] _horizons = new double[Frames];
    VirtualSession _experienced;
    int _next;

    [GlobalSetup(Targets = [nameof(Tick), nameof(Predict), nameof(Solve)])]
    public void Prepare()
    {
        for (var i = 0; i < Samples; i++) Sample(i);
        SetFrames(_virtual);
        for (var i = 0; i < Frames; i++) RequireAgreement(i);
    }

    [GlobalSetup(Target = nameof(SolveOnOneThread))]
    public void PrepareOneThread()
    {
        Control.UseSingleThread();
        Prepare();
    }

    [GlobalSetup(Target = nameof(TickDefault))]
    public void PrepareDefault()
    {
        _experienced = VirtualSession.Experienced();
        SetFrames(_experienced);
        if (TickDefault().State != PoseState.Current) throw new InvalidOperationException("the default predictor's pose is not current");
    }

    [Benchmark(Description = "Frame: session tick, 7 quadratic joints and all link poses")]
    public DisplayFrame Tick() => _virtual.Session.Tick(_starts[NextFrame()]);

    [Benchmark(Description = "– the same with adaptive predictors")]
    public DisplayFrame TickDefault() => _experienced.Session.Tick(_starts[NextFrame()]);

    [Benchmark(Description = "– share of predictors and forward kinematics")]
    public double Predict()
    {
        var horizon = _horizons[NextFrame()];
        for (var i = 0; i < _predictors.Length; i++) _positions[i] = _predictors[i].At(horizon).Position;
        _kinematics.Compute(_positions, _linkPoses);
        return _linkPoses[^1].X;
    }

    [Benchmark(Baseline = true, Description = "Naive frame: Fit.Polynomial for 7 joints, no link poses")]
    public double Solve()
    {
        var horizon = _horizons[NextFrame()];
        for (var i = 0; i < _positions.Length; i++)
            _positions[i] = Polynomial.Evaluate(horizon, Fit.Polynomial(_sampleTimes, _samplesOfJoint[i], 2));
        return _positions[0];
    }

    [Benchmark(Description = "– the same with MathNet limited to one thread")]
    public double SolveOnOneThread() => Solve();

    void SetFrames(VirtualSession session)
    {
        for (var i = 0; i < Frames; i++)
        {
            _horizons[i] = 0.075 + 0.05 * i / (Frames - 1);
            _starts[i] = session.NewestSample + TimeSpan.FromSeconds(_horizons[i]) - VirtualSession.Visualisation.Length;
        }
    }

    int NextFrame() => _next = (_next + 1) % Frames;

    void Sample(int index)
    {
        _virtual.Sample();
        var positions = SevenJointArm.PositionsAt(index * VirtualSession.SampleSeconds);
        for (var i = 0; i < positions.Length; i++)
        {
            _samplesOfJoint[i][index] = positions[i];
            _predictors[i].Add(new JointSample(_sampleTimes[index], positions[i]));
        }
    }

    // Checks that all three methods compute the same joint positions. Otherwise, the ratio of their times would be meaningless.
    void RequireAgreement(int frame)
    {
        var displayed = _virtual.Session.Tick(_starts[frame]);
        if (displayed.State != PoseState.Current) throw new InvalidOperationException("the frame's pose is " + displayed.State);
        _next = frame - 1;
        Predict();
        RequireSame(displayed.Joints, _positions);
        _next = frame - 1;
        Solve();
        RequireSame(displayed.Joints, _positions);
    }

    static void RequireSame(ReadOnlySpan<double> expected, ReadOnlySpan<double> actual)
    {
        for (var i = 0; i < expected.Length; i++)
            // The tolerance is the maximum speed times a few ticks (100 ns) of the time types.
            if (!(Math.Abs(expected[i] - actual[i]) < 1e-6))
                throw new InvalidOperationException($"joint {i + 1}: {actual[i]} rad instead of {expected[i]} rad");
    }
}
