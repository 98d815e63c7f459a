namespace Nowpose.Cli.Replay;

/// <summary>The true positions of all joints of a recorded session, for each time line separately.</summary>
sealed class SessionTruth
{
    readonly Dictionary<(int Joint, int TimeLine), RecordedTruth> _truths = [];

    public SessionTruth(RecordedSession session)
    {
        foreach (var sample in session.Events)
        {
            if (sample.Kind != RecordedSession.EventKind.Sample) continue;
            foreach (var value in session.ValuesOf(sample)) Of(value.Joint, sample.TimeLine, session).Add(sample.At, value.Position);
        }
        foreach (var truth in _truths.Values) truth.Complete();
    }

    /// <returns>True if the position is known at that time.</returns>
    public bool TryAt(int joint, in RecordedSession.Event frame, out double position)
    {
        position = 0;
        return _truths.TryGetValue((joint, frame.TimeLine), out var truth) && truth.TryAt(frame.At, out position);
    }

    RecordedTruth Of(int joint, int timeLine, RecordedSession session)
    {
        if (!_truths.TryGetValue((joint, timeLine), out var truth))
            _truths.Add((joint, timeLine), truth = new RecordedTruth(session.Header.Prediction.MaximumGap));
        return truth;
    }
}
