using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Figures.Swing;
using Nowpose.Gateway.Options;

namespace Nowpose.Cli.Demo.Paper;

/// <summary>Runs <c>demo --paper</c>: calibrates and simulates each repeat, evaluates the paper's claims and writes the results.</summary>
static class PaperSession
{
    public const int PicturesPerLoad = 8;

    /// <param name="given">Settings of the user, see <see cref="PaperScenario.Of"/>.</param>
    /// <param name="repeats">Number of repeats. Each has its own seed, calibration and connection.</param>
    public static async Task<int> RunAsync(DemoSettings given, int repeats, string folder, CancellationToken cancel)
    {
        using var output = DemoOutput.At(folder, isPaper: true);
        var swing = new YoubotSwing(isCold: true);
        var scenario = PaperScenario.Of(given, swing);
        PaperCalibration firstCalibration = null;
        var runs = new List<PaperRun>();
        var complete = 0;
        for (var repeat = 1; repeat <= repeats && !cancel.IsCancellationRequested; repeat++)
        {
            if (repeats > 1) await Console.Error.WriteLineAsync(ConsoleMessages.Repeat(repeat, repeats));
            var settings = scenario with { Seed = given.Seed + repeat - 1 };
            var calibration = await Task.Run(() => PaperCalibration.Of(settings, PicturesPerLoad, cancel), CancellationToken.None);
            if (cancel.IsCancellationRequested)
            {
                if (repeat == 1 && calibration != null) WriteInterrupted(calibration, output);
                break;
            }
            firstCalibration ??= calibration;
            if (repeat == 1) output.RemoveEarlier();
            // Records the first repeat only. The plots of the report show the same repeat.
            var run = await DemoStage.PlayAsync(settings with { Profile = calibration.Profile }, repeat == 1 ? output.SessionPath : null, cancel);
            // A clock that was never synchronised is a valid result: its claim does not hold.
            if (!cancel.IsCancellationRequested && run.Failure(needsClock: false) is string failure) throw new DemoFailedException(failure);
            if (!cancel.IsCancellationRequested) complete++;
            // Judging needs complete repeats. If the first repeat was interrupted, it is kept for the demo's own results.
            if (repeat == 1 || !cancel.IsCancellationRequested) runs.Add(new PaperRun(repeat, run, swing));
        }
        if (runs.Count > 0) Finish(runs, complete, repeats, firstCalibration, output);
        return cancel.IsCancellationRequested ? ExitStatus.Interrupted : ExitStatus.Done;
    }

    /// <summary>Writes the page of a calibration that the user interrupted. The profile is not written, because no run has used it.</summary>
    internal static void WriteInterrupted(PaperCalibration calibration, DemoOutput output)
    {
        output.RemoveEarlier();
        var files = CalibrationOutput.At(output.Folder);
        files.Write(profile: null, calibration.Page);
        Console.Error.WriteLine(ConsoleMessages.CalibrationInterrupted(files.PagePath));
    }

    /// <summary>Writes and prints the results.</summary>
    /// <param name="runs">The repeats; only the first one if it was interrupted.</param>
    /// <param name="complete">Number of complete repeats.</param>
    /// <param name="repeats">Number of requested repeats.</param>
    internal static void Finish(IReadOnlyList<PaperRun> runs, int complete, int repeats, PaperCalibration calibration, DemoOutput output)
    {
        var claims = PaperClaims.Of([.. runs.Take(complete).Select(PaperMeasures.Of)]);
        var figures = PaperFigures.Of(runs, claims);
        var score = new DemoScore(runs[0].Run);
        var result = score.Result() with
        {
            Claims = claims,
            Notes = runs[0].Run.Notes(
                complete == repeats ? null : DemoMessages.RepeatsInterrupted(complete, repeats),
                runs.Skip(1).Select(each => each.Run.LateNote is { } note ? DemoMessages.OfRepeat(each.Repeat, note) : null)),
        };
        // The result and the report are written first, because they exist even if another file cannot be written.
        output.Write(score, runs[0].Run, result, figures);
        PaperOutput.Write(output.Folder, runs, calibration, figures);
        DemoTable.Print(runs[0].Run, score, result, output);
        PaperTable.Print(claims);
    }
}
