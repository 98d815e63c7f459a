namespace Nowpose.Cli.Replay;

/// <summary>The true positions of all joints of a recorded session, for each run of their sources separately.</summary>
sealed class SessionTruth
{
    // The runs of each joint, and the index of the first value of each run among all values of the session.
    readonly (List<int> Starts, List<RecordedTruth> Runs)[] _joints;

    public SessionTruth(RecordedSession session)
    {
        var prediction = session.Header.Prediction;
        var isEndless = session.Header.Joints.Select(joint => joint.BoundedBy(prediction).IsEndless).ToArray();
        _joints = [.. isEndless.Select(_ => (new List<int>(), new List<RecordedTruth>()))];
        foreach (var sample in session.Events)
        {
            if (sample.Kind != RecordedSession.EventKind.Sample) continue;
            foreach (var value in session.ValuesOf(sample))
            {
                var (starts, runs) = _joints[value.Joint];
                if (runs.Count == 0 || !runs[^1].Includes(sample.TimeLine, sample.At))
                {
                    starts.Add(sample.First);
                    runs.Add(new RecordedTruth(sample.TimeLine, prediction.MaximumGap, isEndless[value.Joint]));
                }
                runs[^1].Add(sample.At, value.Position);
            }
        }
        foreach (var (_, runs) in _joints)
            foreach (var run in runs) run.Complete();
    }

    /// <summary>Gets the true positions of a joint in the run to which a sample belongs.</summary>
    public RecordedTruth Of(int joint, in RecordedSession.Event sample)
    {
        var (starts, runs) = _joints[joint];
        var run = starts.BinarySearch(sample.First);
        return runs[run >= 0 ? run : ~run - 1];
    }
}
