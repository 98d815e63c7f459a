using System.CommandLine;
using System.Globalization;
using Nowpose.Benchmarks.Comparison;
using Nowpose.Gateway.Options;
using Nowpose.Prediction;

namespace Nowpose.Benchmarks.Ablation;

/// <summary>ablation: measures how the error changes when each part of the default predictor is removed.</summary>
static class AblationVerb
{
    static readonly PredictionParts[] Parts =
    [
        PredictionParts.Repetition, PredictionParts.Profiles, PredictionParts.Process, PredictionParts.Quadratic, PredictionParts.Cubic,
        PredictionParts.QuadraticOfFive, PredictionParts.CubicOfSix, PredictionParts.QuadraticOfTen, PredictionParts.Reported,
        PredictionParts.ChangePoints, PredictionParts.Scatter, PredictionParts.DistanceLimit, PredictionParts.Jumps, PredictionParts.StampCorrection,
        PredictionParts.Thinning, PredictionParts.Interpolation,
    ];

    public static Task<int> RunAsync(string[] args)
    {
        var recordings = new Option<DirectoryInfo>("--recordings")
        {
            Description = "Folder with motions in the format of replay (*.csv, *.csv.gz). Default: simulated motions only", HelpName = "DIR",
        };
        recordings.AcceptExistingOnly();
        var command = new Command("ablation", "Compare the errors of the default predictor with and without each of its parts, in virtual time") { recordings };
        command.SetAction((parsed, stop) =>
        {
            Write(parsed.GetValue(recordings)?.FullName, stop);
            return Task.FromResult(ExitStatus.Done);
        });
        return Invocation.RunAsync(Invocation.Root("nowpose-benchmarks", "Benchmarks of Nowpose.", command), args);
    }

    static void Write(string recordings, CancellationToken stop)
    {
        var groups = AblationGroup.All(recordings);
        var whole = groups.Select(group => group.Errors(() => Without(PredictionParts.None))).ToArray();
        Console.WriteLine($"| without | {string.Join(" | ", groups.Select(group => $"{group.Name} ({group.Runs.Count} runs)"))} |");
        Console.WriteLine($"| --- | {string.Join(" | ", groups.Select(_ => "---"))} |");
        foreach (var part in Parts)
        {
            stop.ThrowIfCancellationRequested();
            var cells = groups.Select((group, i) => Cell(group.Errors(() => Without(part)), whole[i]));
            Console.WriteLine($"| {part} | {string.Join(" | ", cells)} |");
        }

        Console.WriteLine();
        Console.WriteLine("RMS error divided by that of the whole predictor: geometric mean and (maximum).");
        for (var i = 0; i < groups.Count; i++) WriteRuns(groups[i], whole[i]);
    }

    static void WriteRuns(AblationGroup group, double[] whole)
    {
        var (hold, quadratic, best) = (Fixed(group, "hold"), Fixed(group, "quadratic"), group.MinFixedErrors());
        Console.WriteLine();
        Console.WriteLine($"| {group.Name} | quadratic ÷ hold | adaptive ÷ quadratic | adaptive ÷ best fixed |");
        Console.WriteLine("| --- | ---: | ---: | ---: |");
        for (var i = 0; i < whole.Length; i++)
            Console.WriteLine(Text(
                $"| {group.Runs[i].Motion} | {quadratic[i] / hold[i]:0.00} | {whole[i] / quadratic[i]:0.00} | {whole[i] / best[i]:0.00} |"));
        var overQuadratic = Means.Geometric(whole.Zip(quadratic, (error, of) => error / of));
        Console.WriteLine(Text($"| mean; of adaptive ÷ quadratic the geometric one | | {overQuadratic:0.0000} | {whole.Zip(best, (error, least) => error / least).Average():0.0000} |"));
    }

    static double[] Fixed(AblationGroup group, string name) => group.Errors(() => Predictors.Create(name, PredictionLimits.Unlimited));

    static JointPredictor Without(PredictionParts part) => Predictors.Adaptive(PredictionLimits.Unlimited, PredictionParts.Joint & ~part);

    static string Cell(double[] errors, double[] whole)
    {
        var ratios = errors.Zip(whole, (error, of) => error / of).ToArray();
        return Text($"{Means.Geometric(ratios):0.000} ({ratios.Max():0.00})");
    }

    static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
