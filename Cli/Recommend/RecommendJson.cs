namespace Nowpose.Cli.Recommend;

/// <summary>Formats the recommendation as JSON, with all digits of the numbers.</summary>
static class RecommendJson
{
    /// <param name="warnings">Warnings about the reliability of the recommendation.</param>
    public static string Of(
        string path, RecordingTraits traits, IEnumerable<string> warnings, IReadOnlyList<(Recommendation Recommendation, BlendCost Blend)> results)
    {
        return JsonText.Of(new
        {
            File = path,
            Version = ProgramVersion.Text,
            Seconds = traits.Duration,
            IntervalMs = new { Median = 1e3 * traits.Interval, P5 = 1e3 * traits.IntervalP5, P95 = 1e3 * traits.IntervalP95 },
            Repeated = traits.Repeats,
            Rounding = traits.RoundingSteps.ToDictionary(joint => joint.Name, joint => joint.Step),
            Warnings = warnings,
            Conditions = results.Select(result => Condition(result.Recommendation, result.Blend)),
        });
    }

    static object Condition(Recommendation recommendation, BlendCost blend) => new
    {
        recommendation.Subject.SamplingMs,
        recommendation.Subject.LatencyMs,
        recommendation.Subject.Fps,
        recommendation.Subject.Phases,
        Recommended = recommendation.Recommended.Predictor,
        recommendation.Reason,
        recommendation.Recommended.Reduction,
        GainOverDefault = recommendation.Recommended.GainOver(recommendation.Default),
        BlendMs = blend.RecommendedMs,
        BlendCost = blend.Share,
        Candidates = recommendation.Trials.Select(trial => Candidate(recommendation, trial)),
    };

    static object Candidate(Recommendation recommendation, Trial trial) => new
    {
        trial.Predictor,
        trial.Rms,
        trial.RmsHold,
        trial.Reduction,
        GainOverDefault = trial.GainOver(recommendation.Default),
        Tie = recommendation.IsTie(trial),
        Halves = Enum.GetValues<Half>().Select(half => new
        {
            trial.On(half).Frames,
            trial.On(half).Rms,
            trial.On(half).RmsHold,
            trial.On(half).Reduction,
            GainOverDefault = trial.GainOver(recommendation.Default, half),
        }),
    };
}
