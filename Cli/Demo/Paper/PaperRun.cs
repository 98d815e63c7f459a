using Nowpose.Cli.Figures.Clocks;
using Nowpose.Cli.Figures.Swing;
using Nowpose.Cli.Studies;

namespace Nowpose.Cli.Demo.Paper;

/// <summary>One repeat: the scored frames, the swings and the sync exchanges of a run.</summary>
sealed class PaperRun
{
    static readonly TimeSpan SettledAfter = TimeSpan.FromSeconds(ClockErrors.SettledAfter);

    /// <summary>Frames are shown from this time before the start of a swing onwards, s.</summary>
    const double Before = 0.2;

    /// <summary>Maximum time between the last frame and the end of a whole swing, s.</summary>
    const double Gap = 0.1;

    /// <summary>Maximum time between two frames of a whole swing, s. A longer pause is a stall of this machine.</summary>
    const double MaxStall = 0.25;

    readonly YoubotSwing _swing;
    readonly ToolKinematics _kinematics;

    /// <param name="repeat">Number of the repeat, from 1.</param>
    /// <param name="run">A run whose motion is <paramref name="swing"/>.</param>
    public PaperRun(int repeat, DemoRun run, YoubotSwing swing)
    {
        (Repeat, Run, _swing) = (repeat, run, swing);
        _kinematics = new ToolKinematics(swing.Robot);
        Scored = [.. run.Frames.Rows.Where(row => row.Elapsed >= SettledAfter && row.AssumedLight.HasValue)];
        Steps = SyncSteps.Of(run.Exchanges, run.Settings.Estimator);
        Swings = SwingsOf();
    }

    /// <summary>Number of the repeat, from 1.</summary>
    public int Repeat { get; }

    public DemoRun Run { get; }

    /// <summary>All frames with a display time, from 10 s on.</summary>
    public IReadOnlyList<DemoFrames.Row> Scored { get; }

    /// <summary>The clock estimate after each exchange.</summary>
    public IReadOnlyList<SyncStep> Steps { get; }

    /// <summary>Gets the errors of the exchanges relative to the true offset, from 10 s on, ms. They do not depend on the estimator.</summary>
    public double[] ExchangeErrorsMs =>
        Steps.Count == 0 ? [] : FitErrors.OfExchanges(Steps, Run.Exchanges[0].Offset, at => Run.Truth.OffsetAt(at));

    /// <summary>The complete swings in the scored frames; null if there are none.</summary>
    public SwingFrames Swings { get; }

    /// <summary>Gets ε_L, the assumed minus the true display time of a frame, ms.</summary>
    public static double LightErrorMs(in DemoFrames.Row row) => (row.AssumedLight.Value - row.TrueLight).TotalMilliseconds;

    /// <summary>Gets the index of the swing at a frame's display time, from 0, and the time since the start of that swing, s.</summary>
    public (int Swing, double Time) TimeOf(in DemoFrames.Row row)
    {
        var motion = Run.Truth.MotionSecondsAt(row.TrueLight);
        var swing = (int)Math.Floor(motion / _swing.Motion.Seconds);
        return (swing, motion - swing * _swing.Motion.Seconds - _swing.Start);
    }

    /// <summary>Gets the true position of the tool at a frame's display time.</summary>
    public ToolPosition TruthOf(in DemoFrames.Row row) => _kinematics.TrueAt(Run.Truth, row.TrueLight);

    /// <summary>Reason why values of the clock are missing; unused if none is missing.</summary>
    public string ClockProblem
    {
        get
        {
            var known = Run.Frames.Rows.FindIndex(row => row.Clock.IsKnown);
            if (known < 0) return PaperClaimTexts.ClockUnknown;
            var since = Run.Frames.Rows[known].Elapsed;
            return since < SettledAfter ? PaperClaimTexts.TooShort : PaperClaimTexts.ClockKnownFrom(since.TotalSeconds);
        }
    }

    /// <summary>Reason why values of the swings are missing; unused if none is missing.</summary>
    public string SwingProblem => Scored.Count == 0 ? ClockProblem : PaperClaimTexts.NoSwing(SettledAfter.TotalSeconds, LongestPause(), MaxStall);

    double LongestPause() => Scored.Zip(Scored.Skip(1)).Select(pair => (pair.Second.Elapsed - pair.First.Elapsed).TotalSeconds).DefaultIfEmpty(0).Max();

    SwingFrames SwingsOf()
    {
        StudyFrame[][] whole = [.. Scored.Select(row => (Row: row, Seen: TimeOf(row)))
            .GroupBy(each => each.Seen.Swing, each => FrameOf(each.Row, each.Seen.Time))
            .Where(frames => IsWhole([.. frames]))
            .Select(frames => frames.Where(frame => frame.Time >= -Before).ToArray())];
        var scenario = new SwingScenario($"repeat {Repeat}", IsCold: true);
        return whole.Length == 0 ? null : new SwingFrames(Run.Settings.Predictor, scenario, _swing, whole);
    }

    bool IsWhole(StudyFrame[] frames) => frames[0].Time <= -Before && frames[^1].Time >= _swing.Motion.Seconds - _swing.Start - Gap
        && frames.Zip(frames.Skip(1)).All(pair => pair.Second.Time - pair.First.Time <= MaxStall);

    // Uses the displayed tool in the scene instead of the joints, so that the whole processing chain is measured.
    StudyFrame FrameOf(DemoFrames.Row row, double time)
    {
        double AngleOf(ToolPosition tool) => _swing.AngleOf(tool.X, tool.Y);
        return new StudyFrame(time, AngleOf(TruthOf(row)), AngleOf(row.HeldTool), AngleOf(row.Tool));
    }
}
