using Nowpose.Cli.Replay;

namespace Nowpose.Cli.Recommend;

/// <summary>A recorded session that is evaluated with its own samples, arrival times and frames.</summary>
sealed class SessionSubject : ISubject
{
    readonly string _path;
    readonly RecordedSession _session;
    readonly SessionTruth _truth;
    readonly int _firstOfSecondHalf;

    public SessionSubject(string path, RecordedSession session)
    {
        _path = path;
        _session = session;
        _truth = new SessionTruth(session);
        _firstOfSecondHalf = session.Events.Take(MiddleOf(session)).Count(one => one.Kind == RecordedSession.EventKind.Frame);
    }

    public double? SamplingMs => null;

    public double? LatencyMs => null;

    public double? Fps => null;

    public int? Phases => null;

    public Trial Try(string predictor, double? blendMs, CancellationToken cancellation)
    {
        // Ignores the plan: with it, all candidates would display the same positions.
        var settings = new ReplaySettings { Predictor = predictor, Blend = blendMs / 1000, FollowPlan = false };
        var halves = new HalfErrors(SessionReplay.AxesOf(_session));
        new SessionReplay(_path, _session, _truth, settings)
            .Score(value => halves.Add(value.Frame < _firstOfSecondHalf ? Half.First : Half.Second, value), cancellation: cancellation);
        return halves.Trial(_path, predictor, cancellation);
    }

    static int MiddleOf(RecordedSession session)
    {
        var last = new double?[session.Header.Joints.Count];
        var ways = new double[session.Events.Count];
        for (var i = 0; i < ways.Length; i++)
        {
            if (session.Events[i].Kind != RecordedSession.EventKind.Sample) continue;
            foreach (var value in session.ValuesOf(session.Events[i]))
            {
                ways[i] += Math.Abs(value.Position - last[value.Joint] ?? 0);
                last[value.Joint] = value.Position;
            }
        }
        return MotionHalves.MiddleOf(ways);
    }
}
