using System.Text.RegularExpressions;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway.Disturbances;

/// <summary>
/// Runs a gateway in virtual time with sources and clients that disturb it. Checks at all times that it publishes, counts, records and shows what the
/// manual states, and that it keeps nothing of sources that have left.
/// </summary>
sealed partial class DisturbedGatewayRun
{
    const int Sources = 4, Readers = 4;

    /// <summary>Time in which the clients disturb the gateway and each other, and the time in which sources only publish valid messages, s.</summary>
    const double DisturbedSeconds = 20, CalmSeconds = 3;

    /// <summary>Time in which a throttled client receives what waits for it, s.</summary>
    const double EmptyingSeconds = 6;

    readonly Random _random;
    readonly List<string> _faults = [];
    readonly DisturbedGateway _gateway = new();
    readonly Ledger _ledger;
    readonly StatusLaws _status;
    readonly List<DisturbedSource> _sources = [];
    readonly List<DisturbedReader> _readers = [];
    readonly int _topics;

    DisturbedGatewayRun(int seed)
    {
        _random = new Random(seed);
        _ledger = new Ledger(_gateway, _faults);
        _status = new StatusLaws(_gateway, _ledger, _faults);
        _topics = _gateway.Hub.Topics;
    }

    VirtualLoop Loop => _gateway.Loop;

    /// <summary>Returns what was wrong.</summary>
    public static IReadOnlyList<string> Run(int seed)
    {
        var run = new DisturbedGatewayRun(seed);
        run.Loop.Enter(run.Run);
        run.Finish();
        return run._faults;
    }

    void Run()
    {
        for (var i = 0; i < Sources; i++) _sources.Add(new DisturbedSource(_gateway, _ledger, _faults, _random.Next()));
        for (var i = 0; i < Readers; i++) _readers.Add(new DisturbedReader(_gateway, _ledger, _faults, _random.Next()));
        _gateway.Recorder.SwitchOn();
        while (Loop.Seconds < DisturbedSeconds) Disturb();
        CheckReaders();
        for (var end = Loop.Seconds + CalmSeconds; Loop.Seconds < end; Loop.RunUntil(Loop.Seconds + 0.1))
        {
            foreach (var source in _sources) source.Calm();
            _status.Check();
        }

        CheckReaders();
        foreach (var reader in _readers) reader.Close(isClean: true);
        foreach (var source in _sources) source.Close(isClean: true);
        Loop.RunUntil(Loop.Seconds + 1);
        _status.Check();
        CheckForgotten();
    }

    // Checks that the hub has nothing of the clients but descriptions and stationary frames.
    void CheckForgotten()
    {
        var hub = _gateway.Hub;
        if (hub.Topics != _topics) _faults.Add($"{hub.Topics} instead of {_topics} topics have subscribers");
        string[] topics = [.. _ledger.All.Select(one => one.Topic).Distinct()];
        foreach (var topic in topics.Where(topic => hub.Samples.On(topic).Count > 0)) _faults.Add($"the hub has samples on {topic}");
        if (hub.ReadLatched(RosTopics.Signals, () => 0).Any()) _faults.Add("the hub has signals");
        foreach (var topic in topics.Where(topic => topic.EndsWith(RosTopics.JointTrajectory, StringComparison.Ordinal)))
            hub.Subscribe(topic, _ => _faults.Add($"the hub has set-points on {topic}")).Dispose();
    }

    void Disturb()
    {
        Loop.RunUntil(Loop.Seconds + 0.03 * _random.NextDouble());
        if (_random.Next(5) > 0) _sources[_random.Next(Sources)].Act();
        if (_random.Next(40) == 0) _readers[_random.Next(Readers)].Act();
        if (_random.Next(600) == 0) _gateway.Own.Set(Step());
        if (_random.Next(600) == 0) Loop.Correct(Step());
        if (_random.Next(60) == 0) _gateway.Comparison.Look();
        Loop.Settle();
        if (_random.Next(40) == 0) _status.Check();
    }

    TimeSpan Step() => TimeSpan.FromSeconds((_random.Next(2) == 0 ? 20 : 2) * (_random.NextDouble() - 0.5));

    void CheckReaders()
    {
        foreach (var reader in _readers) reader.Calm();
        Loop.RunUntil(Loop.Seconds + EmptyingSeconds);
        foreach (var reader in _readers)
        {
            reader.CheckNewest();
            reader.CheckComplete();
        }
    }

    void Finish()
    {
        CheckRecording(_gateway.End());
        _ledger.Dispose();
        foreach (var failure in _sources.Select(source => source.Failure).Concat(_readers.Select(reader => reader.Failure)).OfType<Exception>())
            _faults.Add(failure.ToString());
        _faults.AddRange(_gateway.Logged.Where(line => line.Contains("Exception", StringComparison.Ordinal)));
    }

    void CheckRecording(IReadOnlyCollection<string> lines)
    {
        var samples = lines.Count(line => line.StartsWith("""{"kind":"sample",""", StringComparison.Ordinal));
        var states = _ledger.Messages.GetValueOrDefault(RosTopics.JointStates) + _ledger.Messages.GetValueOrDefault("/*" + RosTopics.JointStates);
        if (samples != states) _faults.Add($"{samples} of {states} samples are recorded");
        CheckRecorded("pose", one => Ledger.KindOf(one.Topic) == RosTopics.Tf);
        CheckRecorded("signal", one => one.Topic == RosTopics.Signals);

        // The next file repeats kept values, and a source may send a message twice.
        void CheckRecorded(string kind, Predicate<Published> isOfKind)
        {
            var recorded = lines.Where(line => line.StartsWith($$"""{"kind":"{{kind}}",""", StringComparison.Ordinal))
                .Select(line => Arrival().Replace(line, "")).Distinct().Count();
            var published = _ledger.All.FindAll(isOfKind).Select(one => (one.Topic, one.Name, one.Value)).Distinct().Count();
            if (recorded != published) _faults.Add($"{recorded} of {published} records of the kind {kind}");
        }
    }

    [GeneratedRegex("\"[a-z_0-9]*arrival[a-z_0-9]*\":\\d+,?")]
    private static partial Regex Arrival();
}
