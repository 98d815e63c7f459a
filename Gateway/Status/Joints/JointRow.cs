namespace Nowpose.Gateway.Status.Joints;

/// <summary>One joint of one source. Derives the joint's state from the adapter's report and the received samples.</summary>
sealed class JointRow(string joint, string source, TimeProvider time)
{
    JointDataState? _last;
    DateTimeOffset _since;
    AdapterReport _report;
    long _reportedAt;
    long _refusedAt;
    string _refusal;
    string _refusalWord;

    public string Source { get; } = source;

    /// <summary>Whether an adapter has this joint in its configuration.</summary>
    public bool IsConfigured { get; private set; }

    /// <summary>Whether the gateway has recently refused a sample of the joint.</summary>
    public bool IsRefused => _refusal != null && time.GetElapsedTime(_refusedAt) < JointBoard.StaleAfter;

    /// <summary>
    /// Time at which the source last reported or sent a refused sample; the maximum value if its report is still valid or its samples are being
    /// refused.
    /// </summary>
    public long LastPresent => IsReportFresh || IsRefused ? long.MaxValue : Math.Max(_reportedAt, _refusedAt);

    bool IsReportFresh => IsConfigured && time.GetElapsedTime(_reportedAt) < AdapterReport.Validity;

    public void Report(in AdapterReport report)
    {
        (_report, _reportedAt, IsConfigured) = (report.After(_report), time.GetTimestamp(), true);
    }

    /// <summary>Records that the adapter no longer reports the joint.</summary>
    /// <returns>Whether the adapter had been reporting the joint.</returns>
    public bool EndReports()
    {
        var had = IsConfigured;
        IsConfigured = false;
        return had;
    }

    /// <summary>Records that the gateway refused a sample of the joint.</summary>
    /// <param name="word">One of <see cref="JointFaultReasons"/>.</param>
    public void Refuse(string reason, string word) => (_refusal, _refusalWord, _refusedAt) = (reason, word, time.GetTimestamp());

    /// <summary>Determines the current state of the joint.</summary>
    /// <param name="samples">The joint's samples; null if they come from another source.</param>
    public JointSnapshot Judge(JointSamples samples)
    {
        var (state, since, reason, word) = StateOf(samples);
        var now = time.GetUtcNow();
        if (since is { } known && known <= now) _since = known;
        else if (_last != state) _since = now;
        _last = state;
        return new JointSnapshot(joint, Source, state, _since, samples?.Age, Math.Round(samples?.RateHz ?? 0, 2), reason)
        {
            Uncertainty = state == JointDataState.Rest ? _report.Uncertainty : "",
            ReasonWord = state.IsGood() ? null : word,
        };
    }

    (JointDataState State, DateTimeOffset? Since, string Reason, string Word) StateOf(JointSamples samples)
    {
        var isFlowing = samples is { IsFlowing: true };
        if (IsRefused && !isFlowing) return (JointDataState.Refused, null, _refusal, _refusalWord);
        var isReportFresh = IsReportFresh;
        // An adapter can report rest although the gateway has not received or has refused its newest sample. Then no position of the joint at rest is known.
        if (isReportFresh && _report.State == JointDataState.Rest)
        {
            if (_refusal != null && !(samples?.ArrivedAt > _refusedAt)) return (JointDataState.Refused, null, _refusal, _refusalWord);
            // The gateway no longer has the samples of a source that has ended, so a headset that connects now does not receive them.
            if (samples is not { HasAny: true } || samples.Source is { IsEnded: true })
                return (JointDataState.Missing, null, JointReasons.NoSampleAtRest, JointFaultReasons.NoSample);
        }

        if (isReportFresh && _report.State != JointDataState.Live)
            return (_report.State, _report.Since, _report.Reason, JointFaultReasons.Of(_report.Word));
        if (isFlowing) return (JointDataState.Live, null, "", null);
        if (samples is not { HasAny: true })
            return isReportFresh
                ? (JointDataState.Missing, null, JointReasons.NoSample, JointFaultReasons.NoSample)
                : (JointDataState.Missing, null, JointReasons.NoReport, JointFaultReasons.AdapterSilent);
        if (samples.StampFault is { } fault) return (JointDataState.Stale, samples.LastUtc, fault.Reason, fault.Word);
        if (IsConfigured && !isReportFresh)
            return (JointDataState.Stale, samples.LastUtc, JointReasons.Silent(Source), JointFaultReasons.AdapterSilent);
        var reason = isReportFresh ? JointReasons.SamplesStopped : "samples stopped arriving";
        return (JointDataState.Stale, samples.LastUtc, reason, JointFaultReasons.SamplesStopped);
    }
}
