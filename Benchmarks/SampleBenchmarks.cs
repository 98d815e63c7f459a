using BenchmarkDotNet.Attributes;
using Nowpose.Prediction;
using Nowpose.Protocol;
using Nowpose.Session;

namespace Nowpose.Benchmarks;

/// <summary>Measures one sample of seven joints: reading the JSON, fitting, and processing in a frame.</summary>
public class SampleBenchmarks
{
    const int Positions = 128;

    const double QuickInterval = 0.01;

    readonly VirtualSession _virtual = new();
    readonly JointPredictor[] _predictors = VirtualSession.CreatePredictors();
    readonly double[][] _positions =
        [.. Enumerable.Range(0, Positions).Select(i => SevenJointArm.PositionsAt(i * VirtualSession.SampleSeconds))];
    readonly RosbridgeReader _reader = new();
    readonly StampedText _text = new(SevenJointArm.PositionsAt(1));
    VirtualSession _experienced;
    SampledJoint[] _joints;
    long _samples;

    [GlobalSetup(Targets = [nameof(Read), nameof(Solve), nameof(Take), nameof(Receive)])]
    public void Prepare()
    {
        if (!Read()) throw new InvalidOperationException("the message is not read");
        for (var i = 0; i < 3; i++) Take();
        if (Take().State != PoseState.Current) throw new InvalidOperationException("the samples are not taken");
    }

    [GlobalSetup(Target = nameof(TakeWithDefault))]
    public void PrepareSession() => _experienced = VirtualSession.Experienced();

    [GlobalSetup(Target = nameof(SolveDefault))]
    public void PrepareDefault() => _joints = Joints(VirtualSession.SampleSeconds);

    [GlobalSetup(Target = nameof(SolveDefaultAt100Hz))]
    public void PrepareDefaultAt100Hz() => _joints = Joints(QuickInterval);

    [Benchmark(Description = "Sample: JSON of 7 joints, parsed and checked")]
    public bool Read()
    {
        var isRead = _reader.TryRead(_text.Utf8, out var message, out _);
        message.JointState.Release();
        return isRead;
    }

    [Benchmark(Description = "Sample: from its bytes to the frame that uses it, 7 quadratic predictors")]
    public DisplayFrame Receive() => _virtual.Session.Tick(_virtual.ReceiveSample());

    [Benchmark(Description = "Sample: fit of 7 quadratic predictors")]
    public DropReason Solve()
    {
        var reason = DropReason.None;
        var time = ++_samples * VirtualSession.SampleSeconds;
        var positions = _positions[_samples % Positions];
        for (var i = 0; i < _predictors.Length; i++) reason = _predictors[i].Add(new JointSample(time, positions[i]));
        return reason;
    }

    [Benchmark(Description = "Sample: fit of 7 adaptive predictors, every 50 ms")]
    public DropReason SolveDefault()
    {
        var reason = DropReason.None;
        for (var i = 0; i < _joints.Length; i++) reason = _joints[i].Add();
        return reason;
    }

    [Benchmark(Description = "Sample: fit of 7 adaptive predictors, every 10 ms")]
    public DropReason SolveDefaultAt100Hz() => SolveDefault();

    /// <summary>Includes the 48 bytes of the message object, which is created when the JSON is read.</summary>
    [Benchmark(Description = "Frame that uses a sample, 7 quadratic predictors")]
    public DisplayFrame Take() => _virtual.Session.Tick(_virtual.Sample());

    [Benchmark(Description = "– the same with adaptive predictors")]
    public DisplayFrame TakeWithDefault() => _experienced.Session.Tick(_experienced.Sample());

    static SampledJoint[] Joints(double interval) =>
    [
        .. VirtualSession.CreatePredictors(PredictionSettings.Default).Select((predictor, joint) => new SampledJoint(predictor, joint, interval))
    ];
}
