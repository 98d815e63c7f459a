using Nowpose.Cli.Figures;
using Nowpose.Cli.Figures.Model;
using Nowpose.Latency;

namespace Nowpose.Cli.Demo;

/// <summary>Collects the data of report.html. <c>Web/src/data.ts</c> declares its fields.</summary>
static class DemoReport
{
    const double MsPerSecond = 1000;
    const double SlowestShare = 0.05;

    static readonly double[] IsoErrorsMm = [5, 10, 25, 50, 100, 200];

    /// <param name="figures">The paper's figures from this run; null without <c>--paper</c>.</param>
    public static string Of(DemoScore score, DemoRun run, DemoResult result, IReadOnlyList<Figure> figures = null)
    {
        var start = run.Frames.Rows.Count > 0 ? run.Frames.Rows[0].TrueLight : default;
        return JsonText.Of(new
        {
            Title = DemoTexts.ReportTitle(run.Settings.Robot.Name),
            Subtitle = string.Join(' ', [DemoTexts.Subtitle, .. TimeNote(run.Settings), .. (result.Notes ?? []).Select(note => DemoTexts.Note(note) + ".")]),
            Settings = Pairs(DemoFacts.Settings(run.Settings)),
            Summary = Summary(score, result.ToolErrorMm),
            Facts = Pairs(DemoFacts.Results(run, score, result)),
            Error = Error(score, run, start),
            Joint = new DemoJointSeries(run, start).Busiest(),
            Field = Field(score, run),
            Clock = Clock(run, start),
            Latency = Latency(run.ApplicationLatencies),
            Range = Range(run, start),
            Claims = result.Claims?.Select(claim => new
            {
                claim.Figure, claim.Claim, Paper = claim.PaperText, Measured = claim.MeasuredText, claim.Verdict,
            }),
            Figures = figures?.Select(FiguresJson.Of),
            Playback = new DemoPlayback(score, run, start).Instants(),
        }, isIndented: false, isRounded: run.Settings.IsVirtual);
    }

    static string[] TimeNote(DemoSettings settings) => settings.IsVirtual ? [DemoTexts.VirtualSubtitle] : [];

    static object[] Summary(DemoScore score, DemoResult.ToolErrors tool) =>
    [
        new { Label = DemoTexts.Rms, Unit = "mm", Uncompensated = tool.HoldRms, Compensated = tool.Rms },
        new { Label = DemoTexts.P95, Unit = "mm", Uncompensated = score.HoldP95Mm, Compensated = tool.P95 },
        new { Label = DemoTexts.Maximum, Unit = "mm", Uncompensated = tool.HoldMax, Compensated = tool.Max },
    ];

    static IEnumerable<string[]> Pairs(IEnumerable<(string Label, string Value)> facts) => facts.Select(fact => new[] { fact.Label, fact.Value });

    static object Error(DemoScore score, DemoRun run, ControlTime start) => score.Errors.Count == 0 ? null : new
    {
        T = score.Errors.Select(e => Seconds(run.Frames.Rows[e.Frame].TrueLight, start)),
        Hold = score.Errors.Select(e => Round(e.HoldMm)),
        Compensated = score.Errors.Select(e => Round(e.Mm)),
    };

    // Fig. 18: each error as a point with the coordinates v and L. The remaining error e corresponds to an effective latency e/v.
    static object Field(DemoScore score, DemoRun run)
    {
        var speed = new ToolSpeed(run);
        var points = score.Errors.Select(e => (Error: e, Speed: speed.At(run.Frames.Rows[e.Frame].TrueLight))).ToList();
        // Excludes frames near standstill, whose latency e/v is the quotient of two small numbers.
        var slowest = SlowestShare * points.Select(p => p.Speed).DefaultIfEmpty().Max();
        var moving = points.Where(p => p.Speed > slowest).ToList();
        if (moving.Count == 0) return null;
        var speeds = moving.Select(p => Round(p.Speed)).ToList();
        return new
        {
            Hold = new { LatencyMs = moving.Select(p => Round(MsPerSecond * p.Error.HoldMm / p.Speed)), Speed = speeds },
            Compensated = new { LatencyMs = moving.Select(p => Round(MsPerSecond * p.Error.Mm / p.Speed)), Speed = speeds },
            IsoMm = IsoErrorsMm,
        };
    }

    static object Clock(DemoRun run, ControlTime start)
    {
        var known = run.Frames.Rows.Where(row => row.Clock.IsKnown).ToList();
        if (known.Count == 0) return null;
        var first = known[0].Clock.OffsetAt(known[0].Start);
        return new
        {
            T = known.Select(row => Seconds(row.TrueLight, start)),
            OffsetUs = known.Select(row => Round((row.Clock.OffsetAt(row.Start) - first).TotalMicroseconds)),
            ErrorUs = known.Select(row => Round(row.OffsetErrorUs)),
            BoundUs = known.Select(row => Round(row.Clock.ErrorBound.TotalMicroseconds)),
        };
    }

    // Fig. 10, with the runtime's range state added.
    static object Range(DemoRun run, ControlTime start)
    {
        if (run.Settings.Load == null) return null;
        var rows = run.Frames.Rows;
        var alarms = new List<double[]>();
        for (var i = 0; i < rows.Count; i++)
        {
            if (rows[i].Range != RangeState.Outside) continue;
            var from = Seconds(rows[i].TrueLight, start);
            while (i < rows.Count - 1 && rows[i].Range == RangeState.Outside) i++;
            alarms.Add([from, Seconds(rows[i].TrueLight, start)]);
        }
        return new
        {
            T = rows.Select(row => Seconds(row.TrueLight, start)),
            RenderMs = rows.Select(row => Round(row.Rendered.RenderTime.TotalMilliseconds)),
            VisuMs = rows.Select(row => Round(row.Rendered.Visualisation.TotalMilliseconds)),
            LimitMs = run.Limit?.TotalMilliseconds,
            Alarms = alarms,
        };
    }

    static object Latency(IReadOnlyList<TimeSpan> latencies)
    {
        if (latencies.Count == 0) return null;
        const double binMs = 2;
        var bins = latencies.GroupBy(l => Math.Floor(l.TotalMilliseconds / binMs)).ToDictionary(g => g.Key, g => g.Count());
        var all = Enumerable.Range((int)bins.Keys.Min(), (int)(bins.Keys.Max() - bins.Keys.Min()) + 1).ToList();
        return new
        {
            BinMs = all.Select(bin => bin * binMs),
            Count = all.Select(bin => bins.GetValueOrDefault(bin)),
            Label = DemoTexts.LatencyPlot,
        };
    }

    static double Seconds(ControlTime t, ControlTime start) => Math.Round((t - start).TotalSeconds, 5);

    static double Round(double value) => Math.Round(value, 4);
}
