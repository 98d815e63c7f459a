using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Prediction;
using Nowpose.Prediction.Mixing;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Sync;

namespace Nowpose.Benchmarks;

/// <summary>A session of the seven-joint arm in virtual time, with a synchronised clock and a sample every 50 ms.</summary>
sealed class VirtualSession
{
    public const double SampleSeconds = 0.05;

    static readonly PredictionSettings Quadratic = new("quadratic");
    static readonly ClockOffset Offset = new(TimeSpan.FromSeconds(-1234.5));
    static readonly TimeSpan ApplicationLatency = TimeSpan.FromMilliseconds(35);

    public static readonly VisualisationLatency Visualisation = new(TimeSpan.FromMilliseconds(40));

    readonly double[][] _positions =
        [.. Enumerable.Range(0, 128).Select(sample => SevenJointArm.PositionsAt(sample * SampleSeconds))];
    readonly RosbridgeReader _reader = new();
    readonly StampedText[] _texts;
    long _samples;

    public VirtualSession() : this(Quadratic) { }

    public VirtualSession(PredictionSettings prediction)
    {
        Session = new CompensationSession(
            new SessionSettings(new ConnectionSettings("127.0.0.1"), Visualisation, prediction),
            SevenJointArm.Model, new StopwatchHeadsetClock());
        _texts = [.. _positions.Select(positions => new StampedText(positions))];
        for (var exchange = 0; exchange < 50; exchange++) Exchange(HeadsetTime.FromSeconds(exchange * 0.2));
        NewestSample = HeadsetTime.FromSeconds(10);
        Session.Tick(NewestSample);
    }

    public CompensationSession Session { get; }

    /// <summary>t_k of the newest sample, converted to headset time.</summary>
    public HeadsetTime NewestSample { get; private set; }

    /// <summary>Creates quadratic predictors like those of the session, so that they can be measured separately.</summary>
    public static JointPredictor[] CreatePredictors() => CreatePredictors(Quadratic);

    public static JointPredictor[] CreatePredictors(PredictionSettings prediction)
    {
        var forecasters = Predictors.ForecastersOfJoints();
        return [.. SevenJointArm.Model.MovingJoints.Select(joint => prediction.Create(joint.Limits, forecasters))];
    }

    /// <summary>Creates a session whose default predictor has a full history.</summary>
    public static VirtualSession Experienced()
    {
        var session = new VirtualSession(PredictionSettings.Default);
        for (var sample = 0; sample * SampleSeconds < SampledJoint.SecondsSeen; sample++) session.Session.Tick(session.Sample());
        return session;
    }

    /// <summary>Delivers the next sample.</summary>
    /// <returns>Arrival time of the sample.</returns>
    public HeadsetTime Sample()
    {
        var positions = _positions[Next(out var arrival)];
        Session.Listener.Received(new JointStateMessage(Offset.ToControl(NewestSample), SevenJointArm.JointNames, positions), arrival);
        return arrival;
    }

    /// <summary>Delivers the next sample as the bytes of a message, as from a socket.</summary>
    /// <returns>Arrival time of the sample.</returns>
    public HeadsetTime ReceiveSample()
    {
        var text = _texts[Next(out var arrival)];
        text.Stamp(Offset.ToControl(NewestSample));
        if (!_reader.TryRead(text.Utf8, out var message, out var reason)) throw new InvalidOperationException("the message is refused: " + reason);
        Session.Listener.Received(message.JointState, arrival);
        return arrival;
    }

    long Next(out HeadsetTime arrival)
    {
        NewestSample += TimeSpan.FromSeconds(SampleSeconds);
        arrival = NewestSample + ApplicationLatency;
        return _samples++ % _positions.Length;
    }

    void Exchange(HeadsetTime start)
    {
        var there = Offset.ToControl(start + TimeSpan.FromMilliseconds(1));
        Session.Clock.Add(new SyncExchange(start, there, there, start + TimeSpan.FromMilliseconds(2)), out _);
    }
}
