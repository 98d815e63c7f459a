using Nowpose.Cli.Replay;

namespace Nowpose.Cli.Recommend;

/// <summary>
/// Gets the joints of a recorded session as series over their time stamps. Uses only the longest time line, because times of different time
/// lines are not comparable.
/// </summary>
static class SessionSeries
{
    public static IReadOnlyList<JointSeries> Of(RecordedSession session)
    {
        var samples = session.Events.Where(e => e.Kind == RecordedSession.EventKind.Sample).ToList();
        if (samples.Count == 0) return [];
        var longest = samples.GroupBy(sample => sample.TimeLine).MaxBy(line => line.Count()).Key;
        var start = samples.First(sample => sample.TimeLine == longest).At;
        var series = session.Header.Joints.Select(_ => new SortedList<double, double>()).ToArray();
        foreach (var sample in samples.Where(sample => sample.TimeLine == longest))
            foreach (var value in session.ValuesOf(sample)) series[value.Joint].TryAdd((sample.At - start).TotalSeconds, value.Position);
        return [.. series.Zip(session.Header.Joints, (s, joint) => new JointSeries(joint.Name, [.. s.Keys], [.. s.Values])).Where(s => s.Times.Count > 1)];
    }
}
